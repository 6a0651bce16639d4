/**
 * A second oracle: verdict and boundary minimum in big integers of TypeScript, by Sturm sequences and bisection, while C uses integers
 * of its own. Conditions and proofs on the page use the same code.
 */
import { exactBoundaryMinimum } from '../../web/core/exact/exact-numbers'
import { exactBoundarySign } from '../../web/core/exact/exact-sign'
import type { Vertices } from '../../web/model/hexahedron'
import { isAtMost, negated, type Rational, scaledDouble, sumOf } from '../../web/model/rational'

export interface Minimum {
  /** value * 2^exponent. */
  readonly value: number
  readonly exponent: number
  /** The exact one is no further off. */
  readonly error: Rational
}

export interface Oracle {
  readonly valid: boolean
  /** The mistake in a minimum, in a sentence; null if there is none. */
  mistakeIn(minimum: Minimum): string | null
}

export function oracleOf(vertices: Vertices): Oracle {
  const sign = exactBoundarySign(vertices)
  const { lower, upper } = exactBoundaryMinimum(vertices)
  return {
    valid: sign > 0,
    mistakeIn({ value, exponent, error }) {
      if (Math.sign(value) !== sign) return `The minimum ${value} has not the sign ${sign}.`
      const reported = scaledDouble(value, exponent)
      // The exact one is between the two ends: where it is not rational they are nearer than any error that is allowed.
      const isNear = [lower, upper].every(end => isAtMost(size(sumOf(reported, negated(end))), error))
      return isNear ? null : `The minimum ${value} * 2^${exponent} is too far off.`
    },
  }
}

function size(value: Rational): Rational {
  return value.numerator < 0n ? negated(value) : value
}
