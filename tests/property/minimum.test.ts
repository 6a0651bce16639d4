/**
 * The reported minima against exact arithmetic: |boundaryMinimum - the true one| <= boundaryMinimumError, proved from above by
 * jacdet at the minimizer and from below by bisecting the faces; and the bracket of the volume minimum, by samples.
 */
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Report } from '../../web/core/report'
import type { Vec3 } from '../../web/model/hexahedron'
import { numbersIn } from '../unit/core-fixtures'
import { borderCrossing, CROSSING_SIZE, hexahedraOf } from './border'
import { FAMILIES, families } from './hexahedra'
import {
  type Dyadic,
  dyadicOf,
  FACE_EXPONENT,
  type Fraction,
  faceIsAbove,
  faceParabolas,
  floored,
  type IntegerHexahedron,
  integerHexahedron,
  jacdetAt,
  jacdetAtHalves,
  shifted,
} from './integer-jacdet'
import { holdsFor, replayed } from './replay'
import { analyzed } from './verdict-law'

const EACH = 2000
const CROSSINGS = EACH / CROSSING_SIZE

const BY_BOUNDS: ReadonlySet<string> = new Set(['bernstein', 'subdivision', 'tangents'])

/** Bits kept below the integers of a face, so that bounds can be as fine as reported errors are. */
const FINER = 160

/**
 * A minimizer's coordinates are doubles: off by d <= 2^-53, in s and t. Inside an edge or a face the gradient along it is zero
 * where the minimum is, so jacdet there is above it by at most (|f_ss| + 2|f_st| + |f_tt|) d^2 / 2. With M the largest
 * Bernstein coefficient |f_ss|, |f_tt| <= 8M and |f_st| <= 16M: 24 M 2^-106 < M 2^-101.
 */
const ROUNDED_POINT_BITS = 101n

/** Bits by which the bisection lowers a bound that may be attained, beside the greatest value. */
const HAIR_BITS = 120n

/** jacdet at a point of doubles as a dyadic in true units. */
function exactAt(hex: IntegerHexahedron, point: Vec3): Dyadic {
  const parts = point.map(dyadicOf)
  const power = Math.max(0, ...parts.map(({ integer, exponent }) => (integer === 0n ? 0 : -exponent)))
  const one = 1n << BigInt(power)
  const fractions = parts.map(part => [floored(part, -power), one] as Fraction)
  return { integer: jacdetAt(hex, fractions), exponent: hex.exponent - 6 * power }
}

/** A reported jacdet, in true units. */
function reported(value: number, { exponent }: Report): Dyadic {
  const { integer, exponent: own } = dyadicOf(value)
  return { integer, exponent: own + exponent }
}

function sum(x: Dyadic, y: Dyadic): Dyadic {
  const exponent = Math.min(x.exponent, y.exponent)
  return { integer: floored(x, exponent) + floored(y, exponent), exponent }
}

function isAtMost(x: Dyadic, y: Dyadic): boolean {
  const exponent = Math.min(x.exponent, y.exponent)
  return floored(x, exponent) <= floored(y, exponent)
}

const negative = ({ integer, exponent }: Dyadic): Dyadic => ({ integer: -integer, exponent })

/** The greatest magnitude of jacdet at the 26 points; the Bernstein coefficients of a face are at most nine times as large. */
function greatest(values: readonly bigint[]): bigint {
  return values.reduce((most, value) => (value > most ? value : -value > most ? -value : most), 0n)
}

function expectMinimumProved(report: Report): void {
  expect(numbersIn(report).filter(value => !Number.isFinite(value))).toEqual([])
  // Checks of values accept every valid element; bounds, and subdivision that gives up, need not.
  if (report.valid) expect(report.checks.filter(({ id, passes }) => !passes && !BY_BOUNDS.has(id))).toEqual([])
  const hex = integerHexahedron(report.vertices)
  const atHalves = jacdetAtHalves(hex)
  const faces = [0, 1, 2, 3, 4, 5].map(face => faceParabolas(atHalves, face))
  const unit = hex.exponent + FACE_EXPONENT
  const scale = faces.reduce((most, { start, middle, end }) => {
    const size = greatest([...start, ...middle, ...end])
    return size > most ? size : most
  }, 0n)
  const [minimum, error] = [reported(report.boundaryMinimum, report), reported(report.boundaryMinimumError, report)]
  const slack = { integer: scale, exponent: unit - Number(ROUNDED_POINT_BITS) }
  const atMinimizer = exactAt(hex, report.minimizer.point)
  if (!isAtMost(atMinimizer, sum(sum(minimum, error), slack)))
    throw new Error(`jacdet at the minimizer is above ${report.boundaryMinimum} + ${report.boundaryMinimumError}.`)
  const hair = (scale << BigInt(FINER)) >> HAIR_BITS
  const bound = floored(sum(minimum, negative(error)), unit - FINER) - (hair > 0n ? hair : 1n)
  for (const [face, parabolas] of faces.entries())
    if (!faceIsAbove(shifted(parabolas, FINER), bound))
      throw new Error(`Face ${face} goes below ${report.boundaryMinimum} - ${report.boundaryMinimumError}.`)
}

/** Dyadic points of the cube, half of them on its boundary. */
const SAMPLE_POWER = 10
const samples = fc.array(
  fc.tuple(...[0, 1, 2].map(() => fc.noBias(fc.integer({ min: 0, max: 2 ** SAMPLE_POWER }))), fc.nat(11)),
  { minLength: 8, maxLength: 8 },
)

function sampled(drawn: readonly (readonly number[])[]): Vec3[] {
  return drawn.map(([x = 0, y = 0, z = 0, face = 0]) => {
    const point = [x, y, z].map(n => n / 2 ** SAMPLE_POWER) as [number, number, number]
    if (face < 6) point[(face >> 1) as 0 | 1 | 2] = face & 1
    return point
  })
}

/** The minimum inside is never above jacdet anywhere, and its point keeps the promise. */
function expectVolumeBracketed(report: Report, points: readonly Vec3[]): void {
  const hex = integerHexahedron(report.vertices)
  const { volumeMinimum, bernstein } = report
  const [lower, upper] = [volumeMinimum.lower, volumeMinimum.upper].map(x => reported(x, report)) as [Dyadic, Dyadic]
  const onBoundary = sum(
    reported(report.boundaryMinimum, report),
    negative(reported(report.boundaryMinimumError, report)),
  )
  for (const point of points) {
    const jacdet = exactAt(hex, point)
    if (!isAtMost(lower, jacdet)) throw new Error(`jacdet at ${point} is below ${volumeMinimum.lower}.`)
    if (point.some(x => x === 0 || x === 1) && !isAtMost(onBoundary, jacdet))
      throw new Error(`jacdet at ${point} is below the boundary minimum.`)
  }
  const atPoint = exactAt(hex, volumeMinimum.point)
  if (!isAtMost(lower, atPoint)) throw new Error(`jacdet at the volume minimizer is below ${volumeMinimum.lower}.`)
  const unit = hex.exponent
  const slack = { integer: 9n * greatest(jacdetAtHalves(hex)), exponent: unit - 6 - Number(ROUNDED_POINT_BITS) }
  if (!isAtMost(atPoint, sum(upper, slack)))
    throw new Error(`jacdet at the volume minimizer is above ${volumeMinimum.upper}.`)
  const widest = 1e-10 * Math.max(...bernstein.map(Math.abs))
  if (!(volumeMinimum.upper - volumeMinimum.lower <= widest)) throw new Error('The bracket is wide.')
}

describe('the reported boundary minimum is off by its error at most', () => {
  for (const family of FAMILIES)
    it(`on ${EACH} hexahedra, ${family}`, () => {
      fc.assert(
        fc.property(families[family], vertices => holdsFor(vertices, () => expectMinimumProved(analyzed(vertices)))),
        replayed(EACH),
      )
    })

  it(`on ${EACH} hexahedra at the border`, () => {
    fc.assert(
      fc.property(borderCrossing('all', 'vertex', 'coordinate'), crossing => {
        for (const vertices of hexahedraOf(crossing)) holdsFor(vertices, () => expectMinimumProved(analyzed(vertices)))
      }),
      replayed(CROSSINGS),
    )
  })
})

describe('the volume minimum is in its bracket', () => {
  for (const family of FAMILIES)
    it(`on ${EACH} hexahedra, ${family}`, () => {
      fc.assert(
        fc.property(families[family], samples, (vertices, drawn) =>
          holdsFor(vertices, () => expectVolumeBracketed(analyzed(vertices), sampled(drawn))),
        ),
        replayed(EACH),
      )
    })

  it(`on ${EACH} hexahedra at the border`, () => {
    fc.assert(
      fc.property(borderCrossing('all', 'vertex', 'coordinate'), samples, (crossing, drawn) => {
        for (const vertices of hexahedraOf(crossing))
          holdsFor(vertices, () => expectVolumeBracketed(analyzed(vertices), sampled(drawn)))
      }),
      replayed(CROSSINGS),
    )
  })
})

it('the proof refutes bounds that are too high', () => {
  const [vertices = []] = fc.sample(families.displaced, { seed: 1, numRuns: 1 })
  const report = analyzed(vertices)
  expect(() => expectMinimumProved(report)).not.toThrow()
  const size = 1e-9 * Math.max(...report.bernstein.map(Math.abs))
  for (const by of [size, -size])
    expect(() => expectMinimumProved({ ...report, boundaryMinimum: report.boundaryMinimum + by })).toThrow()
})
