/** Numbers known to lie between two rationals, and their arithmetic: exact, so that nothing is lost but what was open before. */

/** numerator / denominator, denominator > 0, not always in lowest terms. */
export interface Rational {
  readonly numerator: bigint
  readonly denominator: bigint
}

/** A number in [lower, upper]. */
export interface Enclosure {
  readonly lower: Rational
  readonly upper: Rational
}

export function exactly(value: Rational): Enclosure {
  return { lower: value, upper: value }
}

export function isAtMost(a: Rational, b: Rational): boolean {
  return a.numerator * b.denominator <= b.numerator * a.denominator
}

export function sumOf(a: Rational, b: Rational): Rational {
  if (a.denominator === b.denominator) return { numerator: a.numerator + b.numerator, denominator: a.denominator }
  return {
    numerator: a.numerator * b.denominator + b.numerator * a.denominator,
    denominator: a.denominator * b.denominator,
  }
}

export function negated({ numerator, denominator }: Rational): Rational {
  return { numerator: -numerator, denominator }
}

export function productOf(a: Rational, b: Rational): Rational {
  return { numerator: a.numerator * b.numerator, denominator: a.denominator * b.denominator }
}

/** Of what is not zero. */
export function reciprocal({ numerator, denominator }: Rational): Rational {
  return numerator < 0n
    ? { numerator: -denominator, denominator: -numerator }
    : { numerator: denominator, denominator: numerator }
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

/** Null where the number may be zero. */
export function reciprocalOfEnclosure({ lower, upper }: Enclosure): Enclosure | null {
  const mayBeZero = lower.numerator <= 0n && upper.numerator >= 0n
  return mayBeZero ? null : { lower: reciprocal(upper), upper: reciprocal(lower) }
}

/** integer * 2^exponent. */
export function scaledInteger(integer: bigint, exponent: number): Rational {
  return exponent >= 0
    ? { numerator: integer << BigInt(exponent), denominator: 1n }
    : { numerator: integer, denominator: 1n << BigInt(-exponent) }
}

const words = new DataView(new ArrayBuffer(8))

/** value * 2^exponent; the value is finite. */
export function scaledDouble(value: number, exponent: number): Rational {
  words.setFloat64(0, value)
  const bits = words.getBigUint64(0)
  const biased = Number((bits >> 52n) & 0x7ffn)
  const fraction = bits & 0xf_ffff_ffff_ffffn
  const integer = biased === 0 ? fraction : fraction | (1n << 52n)
  return scaledInteger(value < 0 ? -integer : integer, Math.max(biased, 1) - 1075 + exponent)
}
