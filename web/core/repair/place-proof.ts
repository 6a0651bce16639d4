/**
 * Proofs that no place of a vertex is better than a bound, in exact arithmetic: docs/repair.md (R10). jacdet at a point, the volume and the
 * distance from a side of the box are affine functions of the place; with weights that are not negative their gradients cancel, and the
 * constant that is left is zero or negative.
 */
import { edgeVertices, VERTEX_COUNT, type Vec3, vertexReference } from '../../model/hexahedron'
import { dyadicOf, productOf, type Rational, scaledDouble, scaledInteger, sumOf } from '../../model/rational'
import type { BestPlace, Hold, Star } from './best-place'

/** A hold with the weight of its function, of a side that of the distance from it; over the points the weights sum to 1. */
export interface ProvedHold {
  readonly cell: number | null
  readonly point: Vec3
  readonly isBySign: boolean
  readonly weight: Rational
}

export type PlaceProof =
  | {
      readonly isProved: true
      /** No place in the box has a greater value by the measure of the best place. */
      readonly bound: Rational
      /** No place in the box makes all cells valid. */
      readonly isImpossible: boolean
      readonly holds: readonly ProvedHold[]
    }
  /** The holds do not close exactly: by volume 1 is the bound all the same. */
  | { readonly isProved: false }

/** gradient . place + constant, in integers; the place too is one, over 2^unit. */
interface ExactAffine {
  readonly gradient: readonly [bigint, bigint, bigint]
  readonly constant: bigint
}

/** Coordinates on one grid of 2^unit, cell by cell, and which vertices move. */
interface ExactStar {
  readonly unit: number
  readonly cells: readonly { readonly vertices: readonly bigint[]; readonly moving: readonly boolean[] }[]
  readonly present: Point
  /** Directions in which the vertex may move, one to three. */
  readonly tangents: readonly Point[]
  /** Coordinates on the grid; null where there is none. */
  readonly low: readonly (bigint | null)[]
  readonly high: readonly (bigint | null)[]
}

/** Points are multiples of 2^-26, as the core rounds them. */
const POINT_BITS = 26
/** jacdet at a point is an integer over 2^(3 unit - JACDET_BITS). */
const JACDET_BITS = 3 * 2 * POINT_BITS
/** Half side of the box, in units of 2^unitExponent. */
const BOX_BITS = 20

/** Takes a star that the core has answered, and its answer. */
export function provePlace(star: Star, place: BestPlace): PlaceProof {
  const one: Rational = { numerator: 1n, denominator: 1n }
  if (place.holds.length === 0)
    return place.measure === 'volume' && place.bound >= 1
      ? { isProved: true, bound: one, isImpossible: false, holds: [] }
      : { isProved: false }
  const exact = exactStar(star)
  const level = place.measure === 'volume' ? place.bound : 0
  const functions = place.holds.map(hold => fromPresent(exact, functionOf(exact, hold, level, place)))
  for (const chosen of subsets(functions.length)) {
    const weights = cancelling(chosen.map(i => (functions[i] as ExactAffine).gradient))
    if (!weights) continue
    const constant = weights.reduce(
      (sum, weight, i) => sum + weight * (functions[chosen[i] as number] as ExactAffine).constant,
      0n,
    )
    if (place.measure === 'volume' && constant > 0n) continue
    return proofOf(place, exact, chosen, weights, constant)
  }
  return { isProved: false }
}

/** The function of steps along the tangents from the present place. */
function fromPresent({ present, tangents }: ExactStar, { gradient, constant }: ExactAffine): ExactAffine {
  const along = (i: number) => (tangents[i] ? dot(gradient, tangents[i]) : 0n)
  return { gradient: [along(0), along(1), along(2)], constant: constant + dot(gradient, present) }
}

/** By scale the gradients cancel at every level, so that the bound is the constant over the scales. */
function proofOf(
  place: BestPlace,
  exact: ExactStar,
  chosen: readonly number[],
  weights: readonly bigint[],
  constant: bigint,
): PlaceProof {
  const chosenHolds = chosen.map(i => place.holds[i] as Hold)
  const total = chosenHolds.reduce((sum, { cell }, i) => (cell === null ? sum : sum + (weights[i] as bigint)), 0n)
  if (total === 0n) return { isProved: false }
  const ofSides = sideUnit(place.measure === 'volume' ? place.bound : 0, exact.unit)
  const holds = chosenHolds.map(({ cell, point, isBySign }, i) => {
    const weight = { numerator: weights[i] as bigint, denominator: total }
    return { cell, point, isBySign, weight: cell === null ? productOf(weight, ofSides) : weight }
  })
  if (place.measure === 'volume')
    return { isProved: true, bound: scaledDouble(place.bound, 0), isImpossible: false, holds }
  const scales = holds.reduce<Rational>(
    (sum, { cell, weight }, i) =>
      cell === null
        ? sum
        : sumOf(
            sum,
            productOf(weight, scaledDouble((place.holds[chosen[i] as number] as Hold).scale, 3 * place.unitExponent)),
          ),
    { numerator: 0n, denominator: 1n },
  )
  if (scales.numerator === 0n) return { isProved: false }
  const fall = productOf({ numerator: constant, denominator: total }, scaledInteger(1n, 3 * exact.unit - JACDET_BITS))
  const bound = {
    numerator: fall.numerator * scales.denominator,
    denominator: fall.denominator * scales.numerator,
  }
  return { isProved: true, bound, isImpossible: constant <= 0n, holds }
}

/** A distance as `functionOf` gives it, over what it gives of jacdet, each over its value. */
function sideUnit(level: number, unit: number): Rational {
  const ofPowers = scaledInteger(1n, 2 * unit - JACDET_BITS)
  if (level === 0) return ofPowers
  return productOf(ofPowers, { numerator: 1n, denominator: 24n << BigInt(-dyadicOf(level).exponent) })
}

/** jacdet - level * volume, times a power of two that is the same for all; of a side of the box the distance from it. */
function functionOf(
  star: ExactStar,
  { cell, point, isBySign }: Hold,
  level: number,
  { unitExponent }: BestPlace,
): ExactAffine {
  if (cell === null) return distanceFromSide(star, point, unitExponent)
  const at = point.map(x => BigInt(x * 2 ** POINT_BITS)) as unknown as Point
  const jacdet = jacdetAt(star, cell, at)
  if (level === 0) return jacdet
  const { integer, exponent } = dyadicOf(level)
  const scaled = [24n << BigInt(-exponent), jacdet] as const
  return sumOfFunctions(isBySign ? [scaled] : [scaled, [-integer, twentyFourVolumes(star, cell)]])
}

/** The side of the box or that of the limits, whichever is nearer. */
function distanceFromSide(star: ExactStar, normal: Vec3, unitExponent: number): ExactAffine {
  const axis = normal.findIndex(x => x !== 0)
  const gradient = normal.map(x => BigInt(-x)) as unknown as ExactAffine['gradient']
  const slope = gradient[axis] as bigint
  const half = scaledInteger(1n, BOX_BITS + unitExponent - star.unit)
  const ofBox = half.numerator / half.denominator - slope * (star.present[axis] as bigint)
  const limit = (slope < 0n ? star.high : star.low)[axis]
  const ofLimit = typeof limit === 'bigint' ? -slope * limit : ofBox
  return { gradient, constant: ofLimit < ofBox ? ofLimit : ofBox }
}

type Point = readonly [bigint, bigint, bigint]

function sumOfFunctions(terms: readonly (readonly [bigint, ExactAffine])[]): ExactAffine {
  const sum = (part: (f: ExactAffine) => bigint) => terms.reduce((all, [factor, f]) => all + factor * part(f), 0n)
  return {
    gradient: [sum(f => f.gradient[0]), sum(f => f.gradient[1]), sum(f => f.gradient[2])],
    constant: sum(f => f.constant),
  }
}

/** The columns of DF at a point over 2^POINT_BITS are u + alpha p and so on, (R1); products of two columns' multiples of p vanish. */
function jacdetAt({ cells }: ExactStar, cell: number, point: Point): ExactAffine {
  const { vertices, moving } = cells[cell] as ExactStar['cells'][number]
  const columns = [0, 1, 2].map(direction => {
    let factor = 0n
    const column = [0n, 0n, 0n]
    for (let v = 0; v < VERTEX_COUNT; ++v) {
      const slope = slopeOf(v, direction, point)
      if (moving[v]) factor += slope
      else for (let r = 0; r < 3; ++r) column[r] = (column[r] as bigint) + slope * (vertices[3 * v + r] as bigint)
    }
    return { factor, column: column as unknown as Point }
  })
  const [u, v, w] = columns as [Column, Column, Column]
  const crosses = [cross(v.column, w.column), cross(w.column, u.column), cross(u.column, v.column)] as const
  const gradient = [0, 1, 2].map(
    r =>
      u.factor * (crosses[0][r] as bigint) +
      v.factor * (crosses[1][r] as bigint) +
      w.factor * (crosses[2][r] as bigint),
  ) as unknown as Point
  return { gradient, constant: dot(u.column, crosses[0]) }
}

interface Column {
  readonly factor: bigint
  readonly column: Point
}

/** The derivative of a vertex's trilinear function, times 2^(2 POINT_BITS). */
function slopeOf(v: number, direction: number, point: Point): bigint {
  const one = 1n << BigInt(POINT_BITS)
  return (vertexReference[v] as Vec3).reduce((product, side, axis) => {
    const x = point[axis] as bigint
    return product * (axis === direction ? (side ? 1n : -1n) : side ? x : one - x)
  }, 1n)
}

/** The volume is a sixth of jacdet in the middles of the edges less an eighth of that at the vertices, (R2). */
function twentyFourVolumes(star: ExactStar, cell: number): ExactAffine {
  const at = (point: readonly number[]) =>
    jacdetAt(star, cell, point.map(x => BigInt(x) << BigInt(POINT_BITS - 1)) as unknown as Point)
  const reference = (v: number) => vertexReference[v] as Vec3
  return sumOfFunctions([
    ...edgeVertices.map(([a, b]) => [4n, at(reference(a).map((x, r) => x + (reference(b)[r] as number)))] as const),
    ...vertexReference.map(p => [-3n, at(p.map(x => 2 * x))] as const),
  ])
}

function exactStar(star: Star): ExactStar {
  const cells = cellsOf(star)
  const { low = [], high = [], normals = [] } = star.limits ?? {}
  const unit = gridOf([...cells.flatMap(({ vertices }) => vertices), ...[...low, ...high].filter(Number.isFinite)])
  const onGrid = (list: readonly number[]) => integersOn(unit, list)
  const limits = (list: readonly number[]) => list.map(x => (Number.isFinite(x) ? (onGrid([x])[0] as bigint) : null))
  const exact = cells.map(({ vertices, moving }) => ({ vertices: onGrid(vertices), moving }))
  const v = cells[0]?.moving.indexOf(true) as number
  const present = exact[0]?.vertices.slice(3 * v, 3 * v + 3) as unknown as Point
  return { unit, cells: exact, present, tangents: tangentsOf(normals), low: limits(low), high: limits(high) }
}

/** The exponent of a grid that has all the numbers. */
function gridOf(list: readonly number[]): number {
  const used = list.map(dyadicOf).filter(({ integer }) => integer !== 0n)
  return used.reduce((least, { exponent }) => Math.min(least, exponent), used[0]?.exponent ?? 0)
}

function integersOn(unit: number, list: readonly number[]): bigint[] {
  return list.map(dyadicOf).map(({ integer, exponent }) => (integer === 0n ? 0n : integer << BigInt(exponent - unit)))
}

const AXES: readonly Point[] = [
  [1n, 0n, 0n],
  [0n, 1n, 0n],
  [0n, 0n, 1n],
]

/** What is at right angles to the normals, none to two of them. */
function tangentsOf(normals: readonly Vec3[]): readonly Point[] {
  const [a, b] = normals.map(n => integersOn(gridOf(n), n) as unknown as Point)
  if (!a) return AXES
  if (b) return [cross(a, b)]
  const first = AXES.map(axis => cross(axis, a)).find(tangent => !isZero(tangent)) as Point
  return [first, cross(a, first)]
}

/** The cells of a star, 24 coordinates each, and which of their vertices move. */
export function cellsOf(star: Star): { readonly vertices: readonly number[]; readonly moving: readonly boolean[] }[] {
  const numbers = (list: ArrayLike<number>, from: number, count: number) =>
    Array.from({ length: count }, (_, i) => list[from + i] as number)
  if ('points' in star)
    return Array.from({ length: star.cells.length / VERTEX_COUNT }, (_, c) => {
      const indices = numbers(star.cells, VERTEX_COUNT * c, VERTEX_COUNT)
      return {
        vertices: indices.flatMap(i => numbers(star.points, 3 * i, 3)),
        moving: indices.map(i => i === star.vertex),
      }
    })
  return star.moving.map((moving, c) => ({
    vertices: numbers(star.hexahedra, 3 * VERTEX_COUNT * c, 3 * VERTEX_COUNT),
    moving: vertexReference.map((_, v) => moving.includes(v)),
  }))
}

/** Few first: the sets of 0 to count - 1 but the empty one. */
function subsets(count: number): number[][] {
  const all = Array.from({ length: 2 ** count - 1 }, (_, bits) =>
    Array.from({ length: count }, (_, i) => i).filter(i => ((bits + 1) >> i) & 1),
  )
  return all.sort((a, b) => a.length - b.length)
}

function dot(a: Point, b: Point): bigint {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

function cross(a: Point, b: Point): Point {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/** Positive integers whose combination of the vectors is 0, if these have one dimension less than their number; else null. */
function cancelling(vectors: readonly Point[]): bigint[] | null {
  const weights = dependency(vectors)
  if (!weights) return null
  if (weights.every(weight => weight > 0n)) return weights
  return weights.every(weight => weight < 0n) ? weights.map(weight => -weight) : null
}

/** By Cramer's rule on what does not vanish: for one to four vectors of three numbers. */
function dependency(vectors: readonly Point[]): bigint[] | null {
  const [a, b, c, d] = vectors as [Point, Point, Point, Point]
  if (vectors.length === 1) return isZero(a) ? [1n] : null
  if (vectors.length === 2) {
    const axis = a.findIndex(x => x !== 0n)
    return axis >= 0 && isZero(cross(a, b)) ? [b[axis] as bigint, -(a[axis] as bigint)] : null
  }
  if (vectors.length === 3) {
    if (dot(a, cross(b, c)) !== 0n) return null
    const normals = [cross(b, c), cross(c, a), cross(a, b)]
    const axis = [0, 1, 2].find(r => normals.some(normal => normal[r] !== 0n))
    return axis === undefined ? null : normals.map(normal => normal[axis] as bigint)
  }
  const weights = [dot(b, cross(c, d)), -dot(a, cross(c, d)), dot(a, cross(b, d)), -dot(a, cross(b, c))]
  return weights.some(weight => weight !== 0n) ? weights : null
}

function isZero(a: Point): boolean {
  return a.every(x => x === 0n)
}
