/** Rational numbers of big integers, and doubles as such: exact. */

/** numerator / denominator, denominator > 0, not always in lowest terms. */
export interface Rational {
  readonly numerator: bigint
  readonly denominator: bigint
}

export function isLess(a: Rational, b: Rational): boolean {
  return a.numerator * b.denominator < b.numerator * a.denominator
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

/** One over a rational that is not zero. */
export function reciprocal({ numerator, denominator }: Rational): Rational {
  return numerator < 0n
    ? { numerator: -denominator, denominator: -numerator }
    : { numerator: denominator, denominator: numerator }
}

export function magnitude(value: bigint): bigint {
  return value < 0n ? -value : value
}

/** Binary digits of the magnitude; none of zero. */
export function bitLength(value: bigint): number {
  if (value === 0n) return 0
  const digits = magnitude(value).toString(16)
  return 4 * (digits.length - 1) + 32 - Math.clz32(Number.parseInt(digits.charAt(0), 16))
}

/** integer * 2^exponent, as a fraction. */
export function scaledInteger(integer: bigint, exponent: number): Rational {
  return exponent >= 0
    ? { numerator: integer << BigInt(exponent), denominator: 1n }
    : { numerator: integer, denominator: 1n << BigInt(-exponent) }
}

const double = new DataView(new ArrayBuffer(8))

/** A finite double as integer * 2^exponent, exactly. */
export function dyadicOf(value: number): { readonly integer: bigint; readonly exponent: number } {
  double.setFloat64(0, value)
  const bits = double.getBigUint64(0)
  const biased = Number((bits >> 52n) & 0x7ffn)
  const fraction = bits & 0xf_ffff_ffff_ffffn
  const integer = biased === 0 ? fraction : fraction | (1n << 52n)
  return { integer: value < 0 ? -integer : integer, exponent: Math.max(biased, 1) - 1075 }
}

/** value * 2^exponent; the value is finite. */
export function scaledDouble(value: number, exponent: number): Rational {
  const binary = dyadicOf(value)
  return scaledInteger(binary.integer, binary.exponent + exponent)
}
