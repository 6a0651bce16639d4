/** Numbers known to lie between two rationals, and their arithmetic: exact, so that nothing is lost but what was open before. */
import { isAtMost, negated, productOf, type Rational, reciprocal, sumOf } from '../rational'

/** A number in [lower, upper]. */
export interface Enclosure {
  readonly lower: Rational
  readonly upper: Rational
}

export function exactly(value: Rational): Enclosure {
  return { lower: value, upper: value }
}

export function negatedEnclosure({ lower, upper }: Enclosure): Enclosure {
  return { lower: negated(upper), upper: negated(lower) }
}

export function sumOfEnclosures(a: Enclosure, b: Enclosure): Enclosure {
  return { lower: sumOf(a.lower, b.lower), upper: sumOf(a.upper, b.upper) }
}

export function productOfEnclosures(a: Enclosure, b: Enclosure): Enclosure {
  const products = [a.lower, a.upper].flatMap(x => [productOf(x, b.lower), productOf(x, b.upper)])
  return {
    lower: products.reduce((least, x) => (isAtMost(x, least) ? x : least)),
    upper: products.reduce((greatest, x) => (isAtMost(greatest, x) ? x : greatest)),
  }
}

/** Null if the number may be zero. */
export function reciprocalOfEnclosure({ lower, upper }: Enclosure): Enclosure | null {
  const mayBeZero = lower.numerator <= 0n && upper.numerator >= 0n
  return mayBeZero ? null : { lower: reciprocal(upper), upper: reciprocal(lower) }
}
