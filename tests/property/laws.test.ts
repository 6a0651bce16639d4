/**
 * Laws of what must not change, or in one exactly known way, when a hexahedron is moved, stretched,
 * turned, mirrored or numbered otherwise.
 */
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Candidate, Report } from '../../web/core/report'
import { type Vertices, vertexReference } from '../../web/model/hexahedron'
import { borderCrossing, isValid } from './border'
import { displaced, families, smallIntegers, touching } from './hexahedra'
import { holdsFor, replayed } from './replay'
import { analyzed } from './verdict-law'

const EACH = 2000

/** Both sides of the border, and elements far from it, of sizes that leave room for powers of two. */
const hexahedron = fc.oneof(
  displaced,
  smallIntegers,
  touching,
  families.scaled,
  borderCrossing('all').map(({ valid }) => valid),
  borderCrossing('vertex', 'coordinate').map(({ invalid }) => invalid),
)

/** Coordinates are integers over 2^20, so that sums with integers below 2^31 are exact. */
const onGrid = hexahedron.map(vertices => {
  const greatest = Math.max(...vertices.map(Math.abs))
  return vertices.map(x => Math.round((x / greatest) * 2 ** 22) / 2 ** 20)
})

type Placed = Pick<Candidate, 'position'>

/** All that a report says of jacdet; where in space it is depends on the translation. */
function withoutPlace(report: Report): unknown {
  const { vertices: _, ...rest } = report
  const strip = <T extends Placed>({ position: _, ...other }: T) => other
  const { minimizer, maximizer, volumeMinimum, candidates } = rest
  return {
    ...rest,
    minimizer: strip(minimizer),
    maximizer: strip(maximizer),
    volumeMinimum: strip(volumeMinimum),
    candidates: candidates.map(strip),
  }
}

/** value * 2^exponent, comparable: the sign, the significand in [1,2), and its power of two. */
function scientific(value: number, exponent: number): readonly number[] {
  if (value === 0) return [0, 0]
  const power = Math.floor(Math.log2(Math.abs(value)))
  const significand = value / 2 ** power
  if (Math.abs(significand) >= 2) return [significand / 2, power + 1 + exponent]
  return Math.abs(significand) < 1 ? [significand * 2, power - 1 + exponent] : [significand, power + exponent]
}

/** Every jacdet of the report as if the element were 2^-power as large. */
function jacdets(report: Report, power: number): unknown {
  const { exponent, boundaryMinimum, boundaryMinimumError, cornerMinimum, edgeMinimum, boundaryMaximum } = report
  const { volumeMinimum, bernstein, candidates, faces } = report
  const values = [
    boundaryMinimum,
    boundaryMinimumError,
    cornerMinimum,
    edgeMinimum,
    boundaryMaximum,
    volumeMinimum.lower,
    volumeMinimum.upper,
    ...bernstein,
    ...candidates.map(({ value }) => value),
    ...faces.flatMap(face => face.bernstein),
  ]
  return values.map(value => scientific(value, exponent - power))
}

type Permutation = readonly [number, number, number]

const PERMUTATIONS: readonly Permutation[] = [
  [0, 1, 2],
  [1, 2, 0],
  [2, 0, 1],
  [0, 2, 1],
  [2, 1, 0],
  [1, 0, 2],
]

/** The 48 symmetries of the cube: axes permuted, then some reversed. */
interface Symmetry {
  readonly permutation: Permutation
  readonly reversed: readonly boolean[]
  /** 1 for the 24 rotations, -1 for the others. */
  readonly orientation: 1 | -1
}

const SYMMETRIES: readonly Symmetry[] = PERMUTATIONS.flatMap((permutation, n) =>
  [0, 1, 2, 3, 4, 5, 6, 7].map(bits => {
    const reversed = [0, 1, 2].map(axis => (bits >> axis) % 2 === 1)
    const isOdd = (n >= 3 ? 1 : 0) + reversed.filter(Boolean).length
    return { permutation, reversed, orientation: isOdd % 2 === 0 ? 1 : -1 } as const
  }),
)

const rotations = SYMMETRIES.filter(({ orientation }) => orientation === 1)
const reflections = SYMMETRIES.filter(({ orientation }) => orientation === -1)

/** The symmetry applied in space; no coordinate is rounded. */
function turned(vertices: Vertices, { permutation, reversed }: Symmetry): number[] {
  return vertices.map((_, i) => {
    const x = vertices[i - (i % 3) + (permutation[i % 3] as number)] as number
    return reversed[i % 3] ? -x : x
  })
}

/** The symmetry applied in the reference cube: the same vertices in another order. */
function relabelled(vertices: Vertices, { permutation, reversed }: Symmetry): number[] {
  return vertexReference.flatMap(reference => {
    const from = permutation.map((axis, at) =>
      reversed[at] ? 1 - (reference[axis] as number) : (reference[axis] as number),
    )
    const v = vertexReference.findIndex(other => other.every((x, axis) => x === from[axis]))
    return vertices.slice(3 * v, 3 * v + 3)
  })
}

/** The two minima are the same number as far as their errors tell; exactly so where they are exact zeros. */
function expectSameMinimum(report: Report, other: Report): void {
  expect(other.valid).toBe(report.valid)
  const power = report.exponent - other.exponent
  expect(Math.abs(power)).toBeLessThan(200)
  const difference = Math.abs(other.boundaryMinimum - report.boundaryMinimum * 2 ** power)
  const errors = other.boundaryMinimumError + report.boundaryMinimumError * 2 ** power
  // The difference and the sum above are rounded.
  expect(difference).toBeLessThanOrEqual(errors * (1 + 2 ** -50))
  expect(Math.sign(other.boundaryMinimum)).toBe(Math.sign(report.boundaryMinimum))
}

const integer = (most: number) => fc.noBias(fc.integer({ min: -most, max: most }))

describe('a hexahedron', () => {
  it('is the same after an exactly representable translation', () => {
    fc.assert(
      fc.property(onGrid, fc.tuple(...[0, 1, 2].map(() => integer(2 ** 30))), (vertices, by) =>
        holdsFor(vertices, () => {
          const away = vertices.map((x, i) => x + (by[i % 3] as number))
          expect(away.every((x, i) => x - (by[i % 3] as number) === vertices[i])).toBe(true)
          expect(withoutPlace(analyzed(away))).toEqual(withoutPlace(analyzed(vertices)))
          expect(isValid(away)).toBe(isValid(vertices))
        }),
      ),
      replayed(EACH),
    )
  })

  it('has its jacdets times 2^(i+j+k) when the axes are stretched by 2^i, 2^j, 2^k', () => {
    const powers = fc.oneof(
      integer(250).map(k => [k, k, k]),
      fc.tuple(...[0, 1, 2].map(() => integer(250))),
    )
    fc.assert(
      fc.property(hexahedron, powers, (vertices, by) =>
        holdsFor(vertices, () => {
          const stretched = vertices.map((x, i) => x * 2 ** (by[i % 3] as number))
          const total = by.reduce((all, power) => all + power, 0)
          const [report, other] = [analyzed(vertices), analyzed(stretched)]
          expect([other.valid, other.decidedBy]).toEqual([report.valid, report.decidedBy])
          expect(other.minimizer.point).toEqual(report.minimizer.point)
          expect(jacdets(other, total)).toEqual(jacdets(report, 0))
        }),
      ),
      replayed(EACH),
    )
  })

  it('keeps verdict and minimum under the 24 rotations, of space and of the labels', () => {
    fc.assert(
      fc.property(
        hexahedron,
        fc.constantFrom(...rotations),
        fc.constantFrom(...rotations),
        (vertices, inSpace, ofLabels) =>
          holdsFor(vertices, () => {
            const report = analyzed(vertices)
            expectSameMinimum(report, analyzed(turned(vertices, inSpace)))
            expectSameMinimum(report, analyzed(relabelled(vertices, ofLabels)))
          }),
      ),
      replayed(EACH),
    )
  })

  it('keeps verdict and minimum when space and labels are both mirrored', () => {
    fc.assert(
      fc.property(
        hexahedron,
        fc.constantFrom(...reflections),
        fc.constantFrom(...reflections),
        (vertices, inSpace, ofLabels) =>
          holdsFor(vertices, () =>
            expectSameMinimum(analyzed(vertices), analyzed(relabelled(turned(vertices, inSpace), ofLabels))),
          ),
      ),
      replayed(EACH),
    )
  })

  it('has all its jacdets negated in a mirror, and is never valid on both sides', () => {
    const verdicts = { valid: 0, mirrored: 0, neither: 0 }
    let compared = 0
    const negated = (x: number) => (x === 0 ? 0 : -x)
    fc.assert(
      fc.property(hexahedron, fc.constantFrom(0, 1, 2), fc.boolean(), (vertices, axis, isMirroredBefore) =>
        holdsFor(vertices, () => {
          const mirrored = vertices.map((x, i) => (i % 3 === axis ? -x : x))
          const [report, other] = (isMirroredBefore ? [mirrored, vertices] : [vertices, mirrored]).map(analyzed) as [
            Report,
            Report,
          ]
          expect(report.valid && other.valid).toBe(false)
          ++verdicts[report.valid ? 'valid' : other.valid ? 'mirrored' : 'neither']
          // Exact arithmetic rounds them once, doubles do so at each step.
          if (report.exponent !== other.exponent || report.decidedBy !== other.decidedBy) return
          ++compared
          expect(other.bernstein.map(negated)).toEqual(report.bernstein.map(x => x + 0))
        }),
      ),
      replayed(EACH),
    )
    expect(Math.min(...Object.values(verdicts), compared)).toBeGreaterThan(100)
  })
})
