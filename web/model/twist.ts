/** The angle by which the top of an element is turned against its bottom. */
import { type Enclosure, exactly } from './condition/enclosure'
import type { Vertices } from './hexahedron'
import { isAtMost, negated, productOf, type Rational, scaledDouble, sumOf } from './rational'

export interface Twist {
  /** In [-180, 180], positive if the top is turned counter-clockwise, seen against z. */
  readonly degrees: number
  /** The error with respect to the doubles given; 360 if the angle means nothing. */
  readonly error: number
}

const BOTTOM = [0, 1, 2, 3]
const TOP = [4, 5, 6, 7]
/** The error of the sums below, in units of the square of the largest coordinate about vertex 0. */
const SUM_ERROR = 1024 * 2 ** -53
/** Engines' atan2 is good to a few units in the last place; this is 2^9 of them. */
const ANGLE_ERROR = 2 ** -44

/**
 * Seen along z, both about their middles: the turn that brings vertices 0 to 3 nearest to 4 to 7 in the sense of least squares. With
 * a_i, b_i their positions, it is the angle of (sum a_i . b_i, sum a_i x b_i).
 *
 * Error: with coordinates about vertex 0 up to X a component of a or b is at most 2X and off by 12uX, a product of two by 52uX^2, and eight of them with
 * the roundings of their sum by less than 1024uX^2.
 */
export function twistOf(vertices: Vertices): Twist {
  // Quarters, as the difference of two large doubles may overflow; about vertex 0.
  const relative = vertices.map((value, i) => value / 4 - (vertices[i % 3] as number) / 4)
  const size = Math.max(...relative.filter((_, i) => i % 3 < 2).map(Math.abs))
  const scaled = relative.map(value => (size > 0 ? value / size : 0))
  const [bottom, top] = [aboutMiddle(scaled, BOTTOM), aboutMiddle(scaled, TOP)]
  let [dot, cross] = [0, 0]
  for (const [i, [ax, ay]] of bottom.entries()) {
    const [bx, by] = top[i] as readonly [number, number]
    dot += ax * bx + ay * by
    cross += ax * by - ay * bx
  }
  const length = Math.hypot(dot, cross)
  const inDegrees = 180 / Math.PI
  const degrees = Math.atan2(cross, dot) * inDegrees
  if (length <= 4 * SUM_ERROR) return { degrees, error: 360 }
  return { degrees, error: (2 * SUM_ERROR * inDegrees) / length + 180 * ANGLE_ERROR }
}

function aboutMiddle(vertices: Vertices, four: readonly number[]): (readonly [number, number])[] {
  const [x, y] = [0, 1].map(axis => four.reduce((sum, v) => sum + (vertices[3 * v + axis] as number) / 4, 0)) as [
    number,
    number,
  ]
  return four.map(v => [(vertices[3 * v] as number) - x, (vertices[3 * v + 1] as number) - y])
}

/** Degrees, by the doubles above. */
export function twistEnclosure(vertices: Vertices): Enclosure {
  const { degrees, error } = twistOf(vertices)
  const [middle, half] = [scaledDouble(degrees, 0), scaledDouble(error, 0)]
  return { lower: sumOf(middle, negated(half)), upper: sumOf(middle, half) }
}

/**
 * No angle that is not zero is less: the cross product is a multiple of 2^-2150, as coordinates are of 2^-1074, and with the dot product
 * it is shorter than 2^2060.
 */
const LEAST_ANGLE: Rational = { numerator: 1n, denominator: 1n << 4300n }

/** The sign is never open, nor 0 and 180; where neither is turned it is 0. */
export function exactTwist(vertices: Vertices): Enclosure {
  const axes = [0, 1].map(axis => vertices.filter((_, i) => i % 3 === axis).map(value => scaledDouble(value, 0)))
  const [x, y] = axes as [Rational[], Rational[]]
  const cross = sumOf(covariance(x, y), negated(covariance(y, x)))
  if (cross.numerator === 0n) {
    const dot = sumOf(covariance(x, x), covariance(y, y))
    return exactly({ numerator: dot.numerator < 0n ? 180n : 0n, denominator: 1n })
  }
  const { lower, upper } = twistEnclosure(vertices)
  return cross.numerator > 0n
    ? { lower: atLeast(lower, LEAST_ANGLE), upper: atLeast(upper, LEAST_ANGLE) }
    : { lower: atMost(lower, negated(LEAST_ANGLE)), upper: atMost(upper, negated(LEAST_ANGLE)) }
}

function atLeast(value: Rational, bound: Rational): Rational {
  return isAtMost(value, bound) ? bound : value
}

function atMost(value: Rational, bound: Rational): Rational {
  return isAtMost(value, bound) ? value : bound
}

/** Four times the covariance of the bottom's coordinates on one axis with the top's on another. */
function covariance(ofBottom: readonly Rational[], ofTop: readonly Rational[]): Rational {
  const sum = (values: readonly Rational[]) => values.reduce(sumOf)
  const pairs = BOTTOM.map((v, i) => productOf(ofBottom[v] as Rational, ofTop[TOP[i] as number] as Rational))
  const means = productOf(sum(BOTTOM.map(v => ofBottom[v] as Rational)), sum(TOP.map(v => ofTop[v] as Rational)))
  return sumOf(scaledByFour(sum(pairs)), negated(means))
}

function scaledByFour({ numerator, denominator }: Rational): Rational {
  return { numerator: 4n * numerator, denominator }
}
