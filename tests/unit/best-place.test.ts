/** Best places from wasm: the bits of native code, proofs that an independent check accepts, nothing better around, and refusals. */
import { execFileSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import type { BestPlace, Star } from '../../web/core/repair/best-place'
import { provePlace } from '../../web/core/repair/place-proof'
import { type Vec3, vertexReference } from '../../web/model/hexahedron'
import { productOf, sumOf } from '../../web/model/rational'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import {
  bestOf,
  cellsAt,
  exactJacdet,
  exactVolume,
  MIDDLE,
  noisyStars,
  type PointStar,
  presentOf,
  proofHolds,
  repairCore,
  scalesOf,
  starOf,
} from './stars'

const families = [
  { name: 'noise', next: noisyStars(1, 0.1, 0.1) },
  { name: 'much noise', next: noisyStars(2, 0.2, 0.3) },
  { name: 'noise that none survives', next: noisyStars(3, 0.3, 1) },
  { name: 'a vertex thrown out', next: noisyStars(4, 0.1, 3) },
]

function checkedProof(star: Star, best: BestPlace) {
  const proof = provePlace(star, best)
  expect(proof.isProved).toBe(true)
  expect(proofHolds(star, best.measure, proof, scalesOf(best, proof), best.unitExponent)).toBe(true)
  if (!proof.isProved) throw new Error('unreachable')
  return proof
}

/** The order of hl_pack_place. */
function packed(best: BestPlace): number[] {
  const { position, isMoved, isClosed, measure, value, bound, unitExponent, roundCount, holds } = best
  return [
    ...position,
    Number(isMoved),
    Number(isClosed),
    Number(measure === 'volume'),
    value,
    bound,
    best.relativeMinimum ?? Number.NaN,
    best.presentRelativeMinimum ?? Number.NaN,
    unitExponent,
    roundCount,
    holds.length,
    ...holds.flatMap(({ cell, point, weight, scale, isBySign }) => [
      cell ?? 0xffffffff,
      ...point,
      weight,
      scale,
      Number(isBySign),
    ]),
  ]
}

it('has the bits of native code', () => {
  const folder = fileURLToPath(new URL('../../wasm', import.meta.url))
  const stars = families.flatMap(({ next }) => Array.from({ length: 100 }, next))
  const blocks = stars.flatMap(star => cellsAt(star, presentOf(star)).flat())
  execFileSync('make', ['-s', '-C', folder, 'parity'])
  const native = execFileSync(`${folder}/../build/native/parity`, ['places'], {
    input: new Uint8Array(new Float64Array(blocks).buffer),
    maxBuffer: 2 ** 24,
  })
  const wasm = new Float64Array(stars.flatMap(star => packed(bestOf(star))))
  expect(Buffer.from(wasm.buffer).equals(native)).toBe(true)
})

it('crosses a mesh by its used points, and cells of 24 coordinates, with the same answer', () => {
  const star = noisyStars(5, 0.1, 0.5)()
  const best = bestOf(star)
  const points = [...Array.from({ length: 300 }, () => 7), ...(star.points as number[])]
  const cells = Array.from(star.cells, i => i + 100)
  expect(bestOf({ points, cells, vertex: MIDDLE + 100 })).toEqual(best)
  const hexahedra = cellsAt(star, presentOf(star)).flat()
  const moving = Array.from({ length: 8 }, (_, c) =>
    Array.from({ length: 8 }, (_, v) => v).filter(v => star.cells[8 * c + v] === MIDDLE),
  )
  expect(bestOf({ hexahedra, moving })).toEqual(best)
})

it('moves jacdet and volume as affine functions, exactly', () => {
  const random = randomSource(6)
  for (let n = 0; n < 50; ++n) {
    const vertices = randomHexahedron(random, 0.3)
    const star: Star = { hexahedra: vertices, moving: [[n % 8]] }
    const places = [0, 1].map(() => [0, 1, 2].map(() => Math.round(2 ** 20 * (random() - 0.5)) / 2 ** 10))
    const middle = (places[0] as number[]).map((x, r) => (x + (places[1]?.[r] as number)) / 2)
    const point = [0, 1, 2].map(() => Math.round(random() * 2 ** 26) / 2 ** 26) as unknown as [number, number, number]
    for (const f of [(v: number[]) => exactJacdet(v, point), exactVolume]) {
      const [a, b, m] = [...places, middle].map(place => f(cellsAt(star, place)[0] as number[])) as [
        Value,
        Value,
        Value,
      ]
      const sum = a.numerator * b.denominator + b.numerator * a.denominator
      expect(sum * m.denominator).toBe(2n * m.numerator * a.denominator * b.denominator)
    }
  }
})

type Value = ReturnType<typeof exactVolume>

it('has a concave least jacdet, and a convex set of places with a relative minimum, exactly', () => {
  const random = randomSource(14)
  let valid = 0
  for (let n = 0; n < 6; ++n) {
    const star = noisyStars(20 + n, 0.1, 0.1)()
    const points = Array.from({ length: 3 }, () => [0, 1, 2].map(() => Math.round(random() * 2 ** 26) / 2 ** 26))
    const all = [...vertexReference, ...(points as unknown as Vec3[])]
    const places = [0, 1].map(() => presentOf(star).map(x => x + Math.round(2 ** 20 * (random() - 0.5)) / 2 ** 21))
    const middle = (places[0] as number[]).map((x, r) => (x + (places[1]?.[r] as number)) / 2)
    const [a, b, m] = [...places, middle].map(place => {
      const cells = cellsAt(star, place)
      const jacdets = cells.map(vertices => all.map(point => exactJacdet(vertices, point)))
      const volumes = cells.map(exactVolume)
      const least = jacdets.flat().reduce((x, y) => (isLess(y, x) ? y : x))
      const relative = jacdets.map((list, c) =>
        quotient(
          list.reduce((x, y) => (isLess(y, x) ? y : x)),
          volumes[c],
        ),
      )
      return { least, relative: relative.reduce((x, y) => (isLess(y, x) ? y : x)) }
    }) as [Measured, Measured, Measured]
    const half = { numerator: 1n, denominator: 2n }
    expect(isLess(m.least, productOf(half, sumOf(a.least, b.least)))).toBe(false)
    if (a.least.numerator <= 0n || b.least.numerator <= 0n) continue
    ++valid
    expect(isLess(m.relative, isLess(a.relative, b.relative) ? a.relative : b.relative)).toBe(false)
  }
  expect(valid).toBeGreaterThan(2)
})

type Measured = { readonly least: Value; readonly relative: Value }

function isLess(a: Value, b: Value): boolean {
  return a.numerator * b.denominator < b.numerator * a.denominator
}

/** Of a positive divisor. */
function quotient(a: Value, b: Value | undefined): Value {
  if (!b) throw new Error('There is no volume.')
  return { numerator: a.numerator * b.denominator, denominator: a.denominator * b.numerator }
}

describe.each(families)('with $name', ({ next }) => {
  it('is within a millionth of a bound that is proved exactly', () => {
    for (let n = 0; n < 40; ++n) {
      const star = next()
      const best = bestOf(star)
      expect(best.isClosed).toBe(true)
      const { bound, isImpossible } = checkedProof(star, best)
      const proved = Number(bound.numerator) / Number(bound.denominator) || best.bound
      expect(Math.abs(proved - best.bound)).toBeLessThanOrEqual(1e-12 * Math.abs(best.bound))
      expect(best.bound - best.value).toBeLessThanOrEqual(1.0001e-6 * Math.abs(best.value))
      expect(isImpossible).toBe(best.measure === 'scale')
      expect(best.value > 0).toBe(best.measure === 'volume')
    }
  })
})

/** The least relative minimum of the cells by the core's reports; minus infinity where a volume is not positive. */
function relativeMinimumAt(star: PointStar, place: readonly number[]): number {
  return Math.min(
    ...cellsAt(star, place).map(vertices => {
      const minimum = core.boundaryMinimum(vertices, 'roots-b')
      const volume = volumeOf(vertices)
      return minimum.ok && volume > 0 ? minimum.value.minimizer.value / volume : Number.NEGATIVE_INFINITY
    }),
  )
}

/** Of a hexahedron, by its report. */
function volumeOf(vertices: readonly number[]): number {
  const report = core.analyze(vertices)
  return report.ok ? report.value.volume : Number.NaN
}

it('is not worse than 10,000 places around it', () => {
  const random = randomSource(7)
  const star = noisyStars(8, 0.15, 1)()
  const best = bestOf(star)
  expect(best.measure).toBe('volume')
  expect(relativeMinimumAt(star, best.position)).toBeCloseTo(best.value, 12)
  let greatest = Number.NEGATIVE_INFINITY
  for (let n = 0; n < 10_000; ++n) {
    const size = 10 ** (-5 * random())
    const place = best.position.map(x => x + size * (random() - 0.5))
    greatest = Math.max(greatest, relativeMinimumAt(star, place))
  }
  expect(greatest).toBeLessThanOrEqual(best.bound)
  expect(greatest).toBeGreaterThan(0.9 * best.value)
})

it('tells what forbids a valid place: one point that nothing lifts, or four together', () => {
  const next = noisyStars(9, 0.25, 0.5)
  const sizes = new Set<number>()
  for (let n = 0; n < 100; ++n) {
    const star = next()
    const best = bestOf(star)
    if (best.measure === 'volume') continue
    const proof = checkedProof(star, best)
    expect(proof.isImpossible).toBe(true)
    sizes.add(proof.holds.length)
  }
  expect(sizes).toEqual(new Set([1, 4]))
})

it('refuses proofs that were tampered with', () => {
  const star = noisyStars(10, 0.1, 0.3)()
  const best = bestOf(star)
  const proof = checkedProof(star, best)
  const scales = scalesOf(best, proof)
  const holds = (changed: Partial<typeof proof>) =>
    proofHolds(star, 'volume', { ...proof, ...changed }, scales, best.unitExponent)
  const lower = { numerator: proof.bound.numerator * 999n, denominator: proof.bound.denominator * 1000n }
  expect(holds({ bound: lower })).toBe(false)
  const [first, ...others] = proof.holds
  if (!first) throw new Error('There are no holds.')
  const { numerator, denominator } = first.weight
  expect(holds({ holds: [{ ...first, weight: { numerator: numerator + 1n, denominator } }, ...others] })).toBe(false)
  expect(holds({ holds: [{ ...first, cell: (first.cell as number) ^ 1 }, ...others] })).toBe(false)
  expect(holds({ holds: others })).toBe(false)
  // A value better than what was found cannot be proved to be a bound.
  expect(provePlace(star, { ...best, bound: best.value * (1 - 1e-3) }).isProved).toBe(false)
  const [hold, ...rest] = best.holds
  if (!hold) throw new Error('There are no holds.')
  const moved = { ...hold, point: [0.5, 0.5, 0] as const }
  expect(provePlace(star, { ...best, holds: [moved, ...rest] }).isProved).toBe(false)
})

it('takes back a vertex of a perfect grid, and leaves it where it is', () => {
  const grid = starOf(x => x)
  expect(bestOf(grid)).toMatchObject({ isMoved: false, value: 1, bound: 1, holds: [], relativeMinimum: 1 })
  const pulled = starOf((x, i) => (i === MIDDLE ? [1.375, 0.5, 1.75] : x))
  const best = bestOf(pulled)
  expect(best).toMatchObject({ isMoved: true, isClosed: true, bound: 1 })
  for (const x of best.position) expect(x).toBeCloseTo(1, 5)
  expect(checkedProof(pulled, best).holds).toEqual([])
})

it('lets any vertex of a single hexahedron move', () => {
  const random = randomSource(11)
  for (let n = 0; n < 64; ++n) {
    const star: Star = { hexahedra: randomHexahedron(random, 0.15), moving: [[n % 8]] }
    const best = bestOf(star)
    expect(best.isClosed).toBe(true)
    checkedProof(star, best)
    if (best.measure === 'volume') expect(best.value).toBeGreaterThanOrEqual(best.presentRelativeMinimum as number)
  }
})

it('moves repeated nodes together; a wedge stays invalid, for a reason', () => {
  const wedge = unitCube.with(9, 0).with(10, 0).with(21, 0).with(22, 0)
  const best = bestOf({ hexahedra: wedge, moving: [[0, 3]] })
  expect(best).toMatchObject({ measure: 'scale', bound: 0, isClosed: true })
  expect(checkedProof({ hexahedra: wedge, moving: [[0, 3]] }, best)).toMatchObject({ isImpossible: true })
  const whole = bestOf({ hexahedra: unitCube, moving: [[0]] })
  expect(whole).toMatchObject({ value: 1, isMoved: false })
})

it('answers coordinates of any size with the same place', () => {
  const next = noisyStars(12, 0.1, 0.4)
  for (const power of [-1000, -300, 300, 1000]) {
    const star = next()
    const best = bestOf(star)
    const scaled = { ...star, points: Array.from(star.points, x => x * 2 ** power) }
    const other = bestOf(scaled)
    expect(other.position).toEqual(best.position.map(x => x * 2 ** power))
    expect(other).toEqual({ ...best, position: other.position, unitExponent: best.unitExponent + power })
  }
})

it('refuses in sentences', () => {
  const star = noisyStars(13, 0.1, 0.1)()
  const message = (other: Star) => {
    const result = repairCore.bestPlace(other)
    return result.ok ? 'answered' : `${result.error.code}: ${result.error.message}`
  }
  const points = star.points as number[]
  expect(message({ ...star, points: points.with(0, Number.NaN) })).toBe(
    'not-finite: A coordinate of the cells is not a finite number.',
  )
  expect(message({ ...star, points: points.slice(1) })).toBe(
    'wrong-count: Points have three coordinates each; 80 are not.',
  )
  expect(message({ ...star, cells: [1, 2] })).toBe('wrong-count: Cells have eight indices each; 2 are not.')
  expect(message({ ...star, cells: [] })).toBe('no-cells: There are no cells around the vertex.')
  expect(message({ ...star, cells: (star.cells as number[]).with(9, 27) })).toBe(
    "no-such-point: Cell 1 has the index 27, which is no point's.",
  )
  expect(message({ ...star, vertex: -1 })).toBe("no-such-point: The vertex -1 is no point's index.")
  expect(message({ ...star, vertex: 0 })).toBe('nothing-moves: The vertex is not one of every cell.')
  expect(message({ hexahedra: unitCube, moving: [] })).toBe('wrong-count: 0 cells have 0 coordinates, not 24.')
  expect(message({ hexahedra: unitCube, moving: [[8]] })).toBe('nothing-moves: A cell has vertices 0 to 7, not 8.')
  expect(message({ hexahedra: unitCube, moving: [[]] })).toBe('nothing-moves: The vertex is not one of every cell.')
  expect(message({ hexahedra: unitCube, moving: [[0, 1]] })).toBe(
    'several-places: What moves is not at one place in all cells.',
  )
})
