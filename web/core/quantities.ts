/**
 * The numbers that conditions speak of (web/model/condition.ts): what each is in words, and how a report answers. docs/algorithm.md
 * says how the report's numbers are computed; what its doubles leave open is decided in exact arithmetic.
 */

import type { Quantities } from '../model/condition'
import { type Enclosure, exactly } from '../model/condition/enclosure'
import type { Claim, NumberName } from '../model/condition/names'
import { VERTEX_COUNT, type Vertices } from '../model/hexahedron'
import { isAtMost, negated, scaledDouble, scaledInteger, sumOf } from '../model/rational'
import { exactTwist, twistEnclosure, twistOf } from '../model/twist'
import {
  exactBernsteinMinimum,
  exactBoundaryMaximum,
  exactBoundaryMinimum,
  exactCentre,
  exactCornerMinimum,
  exactEdgeMinimum,
  exactGaussMinimum,
  exactScaledJacobian,
  exactSubdivision,
  exactVolume,
} from './exact/exact-numbers'
import { approximation, lowerInside } from './inside'
import { boundaryMaximumError, scaledJacobianError, valueError } from './number-errors'
import type { CheckId, Report } from './report'

/** A number to show: value, times 2^exponent where it is a jacdet. */
export interface ShownNumber {
  readonly value: number
  readonly exponent: number
}

interface Description {
  /** A name of a few words. */
  readonly name: string
  /** One plain sentence. */
  readonly sentence: string
}

interface NumberDescription extends Description {
  /** length^3, or none. */
  readonly unit: 'jacdet' | 'none'
  /** The report's number: times 2^exponent if it is a jacdet. */
  readonly shown: (report: Report, start: Vertices) => number
  /** The number in true units, from doubles with their error bounds; null if those say nothing. */
  readonly roughly: (report: Report, start: Vertices) => Enclosure | null
  readonly exactly: (report: Report, start: Vertices) => Enclosure
}

export const claims: Readonly<Record<Claim, Description>> = {
  valid: { name: 'Valid', sentence: 'jacdet is more than zero on the whole element.' },
}

export const numbers: Readonly<Record<NumberName, NumberDescription>> = {
  boundary_min: {
    name: 'Boundary minimum',
    sentence: 'The least jacdet on the six faces.',
    ...jacdet(
      report => report.boundaryMinimum,
      exactBoundaryMinimum,
      report => report.boundaryMinimumError,
    ),
  },
  boundary_max: {
    name: 'Boundary maximum',
    sentence: 'The greatest jacdet on the six faces.',
    ...jacdet(report => report.boundaryMaximum, exactBoundaryMaximum, boundaryMaximumError),
  },
  volume_min: {
    name: 'Volume minimum',
    sentence:
      'The least jacdet in the whole element: of a valid one the boundary minimum, of an invalid one it may be lower.',
    unit: 'jacdet',
    shown: report => {
      const inside = lowerInside(report)
      return inside === null ? report.boundaryMinimum : approximation(inside).value
    },
    roughly: volumeMinimum,
    exactly: exactVolumeMinimum,
  },
  corner_min: {
    name: 'Corner minimum',
    sentence: 'The least jacdet at the eight vertices.',
    ...jacdet(report => report.cornerMinimum, exactCornerMinimum),
  },
  edge_min: {
    name: 'Edge minimum',
    sentence: 'The least jacdet on the twelve edges, vertices included.',
    ...jacdet(report => report.edgeMinimum, exactEdgeMinimum),
  },
  centre: {
    name: 'Centre',
    sentence: 'jacdet in the middle, at (1/2, 1/2, 1/2).',
    ...jacdet(({ bernstein }) => weightedMean(bernstein, [1, 2, 1]), exactCentre),
  },
  volume: {
    name: 'Volume',
    sentence: 'The integral of jacdet: the element’s volume, where jacdet is not negative.',
    ...jacdet(({ bernstein }) => weightedMean(bernstein, [1, 1, 1]), exactVolume),
  },
  scaled_jacobian: {
    name: 'Scaled Jacobian',
    sentence:
      'The least of jacdet over the lengths of its three columns, at the eight vertices and the centre: from −1 to 1.',
    unit: 'none',
    shown: report => report.scaledJacobian,
    roughly: report => around(report.scaledJacobian, scaledJacobianError(report), 0),
    exactly: ({ vertices }) => exactScaledJacobian(vertices),
  },
  gauss2_min: {
    name: '2×2×2 Gauss points',
    sentence: 'The least jacdet at the eight points of the 2×2×2 Gauss rule.',
    ...jacdet(
      report => checkValue(report, 'gauss-2'),
      vertices => exactGaussMinimum(vertices, 'gauss-2'),
    ),
  },
  gauss3_min: {
    name: '3×3×3 Gauss points',
    sentence: 'The least jacdet at the 27 points of the 3×3×3 Gauss rule.',
    ...jacdet(
      report => checkValue(report, 'gauss-3'),
      vertices => exactGaussMinimum(vertices, 'gauss-3'),
    ),
  },
  bernstein_min: {
    name: 'Bernstein bound',
    sentence: 'The least of the 27 Bernstein coefficients: jacdet is nowhere below it.',
    ...jacdet(report => checkValue(report, 'bernstein'), exactBernsteinMinimum),
  },
  subdivision: {
    name: 'Subdivision to depth 4',
    sentence: 'The number at which cutting into eight, four times at most, ends: it accepts what is more than zero.',
    ...jacdet(report => checkValue(report, 'subdivision'), exactSubdivision),
  },
  moved: {
    name: 'Moved vertices',
    sentence: 'How many of the eight vertices are not where they were at the start.',
    unit: 'none',
    shown: ({ vertices }, start) => movedVertices(vertices, start),
    roughly: ({ vertices }, start) => wholeNumber(movedVertices(vertices, start)),
    exactly: ({ vertices }, start) => wholeNumber(movedVertices(vertices, start)),
  },
  twist: {
    name: 'Twist',
    sentence:
      'By how many degrees the top, vertices 4 to 7, is turned against the bottom, vertices 0 to 3, seen along z: the turn about their middles that fits best.',
    unit: 'none',
    shown: ({ vertices }) => twistOf(vertices).degrees,
    roughly: ({ vertices }) => twistEnclosure(vertices),
    exactly: ({ vertices }) => exactTwist(vertices),
  },
}

/** The report's numbers for a condition; `moved` counts from `start`. */
export function quantitiesOf(report: Report, start: Vertices): Quantities {
  const exact = new Map<NumberName, Enclosure>()
  return {
    claim: () => report.valid,
    roughly: name => numbers[name].roughly(report, start),
    exactly: name => {
      const known = exact.get(name) ?? numbers[name].exactly(report, start)
      exact.set(name, known)
      return known
    },
  }
}

export function shownNumber(name: NumberName, report: Report, start: Vertices): ShownNumber {
  const { unit, shown } = numbers[name]
  return { value: shown(report, start), exponent: unit === 'jacdet' ? report.exponent : 0 }
}

function jacdet(
  shown: (report: Report) => number,
  exact: (vertices: Vertices) => Enclosure,
  error: (report: Report) => number = valueError,
): Pick<NumberDescription, 'unit' | 'shown' | 'roughly' | 'exactly'> {
  return {
    unit: 'jacdet',
    shown,
    roughly: report => around(shown(report), error(report), report.exponent),
    exactly: ({ vertices }) => exact(vertices),
  }
}

function around(value: number, error: number, exponent: number): Enclosure | null {
  if (!Number.isFinite(error)) return null
  const middle = scaledDouble(value, exponent)
  const half = scaledDouble(error, exponent)
  return { lower: sumOf(middle, negated(half)), upper: sumOf(middle, half) }
}

/** The report's bracket holds however it was decided. */
function volumeMinimum({ volumeMinimum: { lower, upper }, exponent }: Report): Enclosure {
  return { lower: scaledDouble(lower, exponent), upper: scaledDouble(upper, exponent) }
}

/** The boundary minimum of a valid element; else no more than that, as the search inside found. */
function exactVolumeMinimum(report: Report): Enclosure {
  const boundary = exactBoundaryMinimum(report.vertices)
  if (report.valid) return boundary
  const { lower, upper } = volumeMinimum(report)
  const isLower = isAtMost(upper, boundary.upper)
  return { lower: isAtMost(lower, boundary.lower) ? lower : boundary.lower, upper: isLower ? upper : boundary.upper }
}

function checkValue(report: Report, id: CheckId): number {
  return report.checks.find(check => check.id === id)?.value as number
}

/** A mean of the 27 coefficients; on each axis the three count by `weights`. */
function weightedMean(bernstein: readonly number[], weights: readonly [number, number, number]): number {
  const weight = (i: number) =>
    [Math.floor(i / 9), Math.floor(i / 3) % 3, i % 3].reduce((product, k) => product * (weights[k] as number), 1)
  const total = weights.reduce((sum, value) => sum + value, 0) ** 3
  return bernstein.reduce((sum, value, i) => sum + weight(i) * value, 0) / total
}

function movedVertices(vertices: Vertices, start: Vertices): number {
  const isMoved = (vertex: number) => [0, 1, 2].some(axis => vertices[3 * vertex + axis] !== start[3 * vertex + axis])
  return Array.from({ length: VERTEX_COUNT }, (_, vertex) => vertex).filter(isMoved).length
}

function wholeNumber(value: number): Enclosure {
  return exactly(scaledInteger(BigInt(value), 0))
}
