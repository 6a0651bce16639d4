/** Vertices with their cells, and an independent check of proofs: by jacdet's definition at four places, in big integers. */
import { readFileSync } from 'node:fs'
import type { BestPlace, RepairCore, Star } from '../../web/core/repair/best-place'
import type { PlaceProof } from '../../web/core/repair/place-proof'
import { loadRepairCore } from '../../web/core/repair/repair-core'
import type { Vec3 } from '../../web/model/hexahedron'
import { vertexReference } from '../../web/model/hexahedron'
import { productOf, type Rational, scaledDouble, scaledInteger, sumOf } from '../../web/model/rational'
import { type Fraction, integerHexahedron, jacdetAt } from '../property/integer-jacdet'
import { randomSource } from './random'

export const repairCore: RepairCore = await loadRepairCore(
  readFileSync(new URL('../../build/hexlens-repair.wasm', import.meta.url)),
)

export type PointStar = Extract<Star, { points: unknown }>

export const MIDDLE = 13

const gridCells = Array.from({ length: 8 }, (_, c) =>
  vertexReference.map(([x, y, z]) => (c % 2) + x + 3 * (((c >> 1) % 2) + y) + 9 * ((c >> 2) + z)),
).flat()

/** 2 x 2 x 2 cells around vertex 13; `place` gives a vertex of the grid its coordinates. */
export function starOf(place: (grid: Vec3, vertex: number) => readonly number[]): PointStar {
  const points = Array.from({ length: 27 }, (_, i) =>
    place([i % 3, Math.floor(i / 3) % 3, Math.floor(i / 9)], i),
  ).flat()
  return { points, cells: gridCells, vertex: MIDDLE }
}

/** Normal noise of all vertices, and noise of its own of the one in the middle. */
export function noisyStars(seed: number, sigma: number, thrown: number): () => PointStar {
  const random = randomSource(seed)
  const normal = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random())
  return () => starOf((grid, i) => grid.map(x => x + (i === MIDDLE ? thrown : sigma) * normal()))
}

/** The coordinates of the vertex. */
export function presentOf({ points, vertex }: PointStar): number[] {
  return [0, 1, 2].map(r => points[3 * vertex + r] as number)
}

export function bestOf(star: Star): BestPlace {
  const result = repairCore.bestPlace(star)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** The cells with the vertex at another place, 24 coordinates each. */
export function cellsAt(star: Star, place: readonly number[]): number[][] {
  if ('points' in star)
    return Array.from({ length: star.cells.length / 8 }, (_, c) =>
      Array.from({ length: 8 }, (_, v) => star.cells[8 * c + v] as number).flatMap(i =>
        i === star.vertex ? place : [0, 1, 2].map(r => star.points[3 * i + r] as number),
      ),
    )
  return star.moving.map((moving, c) =>
    Array.from({ length: 8 }, (_, v) => v).flatMap(v =>
      moving.includes(v) ? place : [0, 1, 2].map(r => star.hexahedra[24 * c + 3 * v + r] as number),
    ),
  )
}

const BITS = 26

export function exactJacdet(vertices: readonly number[], point: Vec3): Rational {
  const hexahedron = integerHexahedron(vertices)
  const fractions = point.map((x): Fraction => [BigInt(x * 2 ** BITS), 1n << BigInt(BITS)])
  return scaledInteger(jacdetAt(hexahedron, fractions), hexahedron.exponent - 6 * BITS)
}

/** Simpson's rule on each axis, which is exact for quadratics. */
export function exactVolume(vertices: readonly number[]): Rational {
  let sum: Rational = { numerator: 0n, denominator: 1n }
  for (let i = 0; i < 27; ++i) {
    const at = [Math.floor(i / 9), Math.floor(i / 3) % 3, i % 3]
    const weight = at.reduce((product, k) => product * (k === 1 ? 4n : 1n), 1n)
    const point = at.map(k => k / 2) as unknown as Vec3
    sum = sumOf(sum, productOf({ numerator: weight, denominator: 216n }, exactJacdet(vertices, point)))
  }
  return sum
}

const PLACES = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]

/** True if the weighted functions sum to the same number at four places that are in no plane, and it is not positive; no side of the box. */
export function proofHolds(
  star: Star,
  measure: BestPlace['measure'],
  proof: PlaceProof,
  scales: readonly number[],
  unit: number,
): boolean {
  if (!proof.isProved || proof.holds.some(({ weight }) => weight.numerator <= 0n)) return false
  const minusBound = { numerator: -proof.bound.numerator, denominator: proof.bound.denominator }
  const sums = PLACES.map(place => {
    const cells = cellsAt(star, place)
    return proof.holds.reduce<Rational>(
      (sum, { cell, point, weight, isBySign }, i) => {
        const vertices = cells[cell as number] as number[]
        const size = measure === 'volume' ? exactVolume(vertices) : scaledDouble(scales[i] as number, 3 * unit)
        const f = isBySign
          ? exactJacdet(vertices, point)
          : sumOf(exactJacdet(vertices, point), productOf(minusBound, size))
        return sumOf(sum, productOf(weight, f))
      },
      { numerator: 0n, denominator: 1n },
    )
  })
  const [first] = sums as [Rational]
  return (
    first.numerator <= 0n && sums.every(sum => sum.numerator * first.denominator === first.numerator * sum.denominator)
  )
}

/**
 * True if the weighted functions, sides of the limits among them, sum to the same number, which is not positive, at the present place
 * and one step away in each direction of the planes.
 */
export function limitedProofHolds(star: Star, best: BestPlace, proof: PlaceProof): boolean {
  if (!proof.isProved || proof.holds.some(({ weight }) => weight.numerator <= 0n)) return false
  const { normals = [], low, high } = star.limits ?? {}
  const scales = scalesOf(best, proof)
  const bound = best.measure === 'volume' ? proof.bound : { numerator: 0n, denominator: 1n }
  const minusBound = { numerator: -bound.numerator, denominator: bound.denominator }
  const present = presentOf(star as PointStar).map(x => scaledDouble(x, 0))
  const sums = [ZERO, ...tangentsOf(normals)].map(step => {
    const place = present.map((x, r) => sumOf(x, step[r] as Rational))
    return proof.holds.reduce<Rational>((sum, { cell, point, weight, isBySign }) => {
      if (cell === null) {
        const axis = point.findIndex(x => x !== 0)
        const side = (point[axis] as number) > 0 ? high : low
        const way = sumOf(scaledDouble(side?.[axis] as number, 0), negative(place[axis] as Rational))
        return sumOf(sum, productOf(weight, (point[axis] as number) > 0 ? way : negative(way)))
      }
      const at = (f: (vertices: readonly number[]) => Rational) => affineAt(star, cell, f, place)
      const jacdet = at(vertices => exactJacdet(vertices, point))
      const f = isBySign ? jacdet : sumOf(jacdet, productOf(minusBound, at(exactVolume)))
      return sumOf(sum, productOf(weight, f))
    }, RATIONAL_ZERO)
  })
  const [first] = sums as [Rational]
  if (!sums.every(sum => sum.numerator * first.denominator === first.numerator * sum.denominator)) return false
  if (best.measure === 'volume') return first.numerator <= 0n
  const total = proof.holds.reduce<Rational>(
    (sum, { cell, weight }, i) =>
      cell === null ? sum : sumOf(sum, productOf(weight, scaledDouble(scales[i] as number, 3 * best.unitExponent))),
    RATIONAL_ZERO,
  )
  const allowed = productOf(proof.bound, total)
  return first.numerator * allowed.denominator <= allowed.numerator * first.denominator
}

const RATIONAL_ZERO: Rational = { numerator: 0n, denominator: 1n }
const ZERO = [RATIONAL_ZERO, RATIONAL_ZERO, RATIONAL_ZERO]

function negative({ numerator, denominator }: Rational): Rational {
  return { numerator: -numerator, denominator }
}

/** An affine function of the place, from its values at four places of doubles. */
function affineAt(
  star: Star,
  cell: number,
  f: (vertices: readonly number[]) => Rational,
  place: readonly Rational[],
): Rational {
  const [origin, ...ends] = PLACES.map(at => f(cellsAt(star, at)[cell] as number[])) as [Rational, ...Rational[]]
  return ends.reduce((sum, end, r) => sumOf(sum, productOf(place[r] as Rational, sumOf(end, negative(origin)))), origin)
}

/** Steps at right angles to the normals, which are one axis or two of them, or none. */
function tangentsOf(normals: readonly Vec3[]): Rational[][] {
  return [0, 1, 2]
    .filter(r => !normals.some(n => n[r] !== 0))
    .map(r => [0, 1, 2].map(q => (q === r ? { numerator: 1n, denominator: 1n } : RATIONAL_ZERO)))
}

/** Those of the holds of the best place that the proof has. */
export function scalesOf(best: BestPlace, proof: PlaceProof): number[] {
  if (!proof.isProved) return []
  return proof.holds.map(({ cell, point }) => {
    const hold = best.holds.find(other => other.cell === cell && other.point.every((x, r) => x === point[r]))
    return hold?.scale as number
  })
}
