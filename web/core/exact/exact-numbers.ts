/**
 * The numbers of a report from exact arithmetic, in true units: rationals where they are, else enclosed to 2^-48 of themselves,
 * the sign never open. For what docs/algorithm.md says about doubles does not reach.
 */

import { bernsteinIndices, bernsteinMiddles, bernsteinStrides, vertexBernstein } from '../../model/bernstein'
import { type Enclosure, exactly, negatedEnclosure } from '../../model/condition/enclosure'
import { type Axis, edgeVertices, type Vertices, vertexReference } from '../../model/hexahedron'
import { isAtMost, negated, productOf, type Rational, scaledDouble, scaledInteger, sumOf } from '../../model/rational'
import { exactChecks, type ScaledNumber } from './exact-checks'
import { type ExactJacdet, exactEdge, exactJacdet, exactVertex, sixteenths } from './exact-jacdet'
import { exactBoundary } from './exact-minimum'

/** Relative error of numbers that are handed on as doubles: less than 2^-52, and a few roundings of a scaled Jacobian's lengths. */
const ROUNDING = 2 ** -48

/** A number of exact-checks.ts below this is known by its sign, and to be no larger. */
const SMALL = 2 ** -950

export function exactCornerMinimum(vertices: Vertices): Enclosure {
  return exactly(cornerMinimum(exactJacdet(vertices)))
}

export function exactEdgeMinimum(vertices: Vertices): Enclosure {
  return exactly(edgeMinimum(exactJacdet(vertices)))
}

export function exactBoundaryMinimum(vertices: Vertices): Enclosure {
  const { jacdet, least } = exactBoundary(vertices)
  const unit = scaledInteger(1n, jacdet.exponent - 2)
  return {
    lower: productOf(sumOf(least.value, negated(least.error)), unit),
    upper: productOf(least.value, unit),
  }
}

/** Minus the boundary minimum of the mirrored element. */
export function exactBoundaryMaximum(vertices: Vertices): Enclosure {
  return negatedEnclosure(exactBoundaryMinimum(vertices.map((value, i) => (i % 3 === 0 ? -value : value))))
}

export function exactBernsteinMinimum(vertices: Vertices): Enclosure {
  const jacdet = exactJacdet(vertices)
  return exactly(scaledInteger(least(sixteenths(jacdet)), jacdet.exponent - 4))
}

/** jacdet in the middle: the mean of the coefficients with weights 1, 2, 1 on each axis. */
export function exactCentre(vertices: Vertices): Enclosure {
  const jacdet = exactJacdet(vertices)
  const sum = sixteenths(jacdet).reduce(
    (all, coefficient, i) => all + BigInt(2 ** (bernsteinMiddles[i] as number)) * coefficient,
    0n,
  )
  return exactly(scaledInteger(sum, jacdet.exponent - 10))
}

/** The integral of jacdet: the mean of the coefficients. */
export function exactVolume(vertices: Vertices): Enclosure {
  const jacdet = exactJacdet(vertices)
  const { numerator, denominator } = scaledInteger(
    sixteenths(jacdet).reduce((all, coefficient) => all + coefficient, 0n),
    jacdet.exponent - 4,
  )
  return exactly({ numerator, denominator: 27n * denominator })
}

/** The points' abscissae are the doubles nearest to the Gauss points'. */
export function exactGaussMinimum(vertices: Vertices, rule: 'gauss-2' | 'gauss-3'): Enclosure {
  return enclosed(exactChecks(exactJacdet(vertices)).jacdets[rule] as ScaledNumber)
}

export function exactScaledJacobian(vertices: Vertices): Enclosure {
  return enclosed({ mantissa: exactChecks(exactJacdet(vertices)).scaledJacobian, exponent: 0 })
}

const GIVES_UP_PAST = 4

/** The check of wasm/src/checks.c. */
export function exactSubdivision(vertices: Vertices): Enclosure {
  const jacdet = exactJacdet(vertices)
  return exactly(subdivided(sixteenths(jacdet), 0, jacdet.exponent - 4))
}

/** Coefficients are integers times 2^exponent. */
function subdivided(bernstein: readonly bigint[], depth: number, exponent: number): Rational {
  const bound = least(bernstein)
  if (bound > 0n) return scaledInteger(bound, exponent)
  const corner = least(vertexBernstein.map(i => bernstein[i] as bigint))
  if (corner <= 0n) return scaledInteger(corner, exponent)
  if (depth === GIVES_UP_PAST) return scaledInteger(bound, exponent)
  let parts = [bernstein]
  for (const axis of [0, 1, 2] as const) parts = parts.flatMap(part => halves(part, axis))
  let smallest: Rational | null = null
  for (const part of parts) {
    const number = subdivided(part, depth + 1, exponent - 6)
    if (number.numerator <= 0n) return number
    if (!smallest || isAtMost(number, smallest)) smallest = number
  }
  return smallest as Rational
}

/** Four times the coefficients on the lower and on the upper half along one axis. */
function halves(bernstein: readonly bigint[], axis: Axis): [bigint[], bigint[]] {
  const stride = bernsteinStrides[axis]
  const lower = [...bernstein]
  const upper = [...bernstein]
  bernstein.forEach((q0, i) => {
    if (bernsteinIndices[i]?.[axis] !== 0) return
    const [q1, q2] = [bernstein[i + stride] as bigint, bernstein[i + 2 * stride] as bigint]
    const middle = q0 + 2n * q1 + q2
    lower.splice(i, 1, 4n * q0)
    lower.splice(i + stride, 1, 2n * (q0 + q1))
    lower.splice(i + 2 * stride, 1, middle)
    upper.splice(i, 1, middle)
    upper.splice(i + stride, 1, 2n * (q1 + q2))
    upper.splice(i + 2 * stride, 1, 4n * q2)
  })
  return [lower, upper]
}

function cornerMinimum(jacdet: ExactJacdet): Rational {
  return scaledInteger(least(vertexReference.map((_, v) => exactVertex(jacdet, v))), jacdet.exponent - 2)
}

function edgeMinimum(jacdet: ExactJacdet): Rational {
  let smallest = cornerMinimum(jacdet)
  edgeVertices.forEach((_, edge) => {
    const [q0, q1, q2] = exactEdge(jacdet, edge)
    if (q1 >= q0 || q1 >= q2) return
    const { numerator, denominator } = scaledInteger(q0 * q2 - q1 * q1, jacdet.exponent - 2)
    const value = { numerator, denominator: denominator * (q0 - 2n * q1 + q2) }
    if (isAtMost(value, smallest)) smallest = value
  })
  return smallest
}

function least(values: readonly bigint[]): bigint {
  return values.reduce((a, b) => (b < a ? b : a))
}

function enclosed({ mantissa, exponent }: ScaledNumber): Enclosure {
  const near = scaledDouble(mantissa * (1 - ROUNDING), exponent + (Math.abs(mantissa) < SMALL ? -20000 : 0))
  const far = scaledDouble(mantissa * (1 + ROUNDING), exponent)
  return mantissa < 0 ? { lower: far, upper: near } : { lower: near, upper: far }
}
