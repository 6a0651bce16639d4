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

export function lowestTerms({ numerator, denominator }: Rational): Rational {
  let [a, b] = [magnitude(numerator), denominator]
  while (b > 0n) [a, b] = [b, a % b]
  return { numerator: numerator / a, denominator: denominator / a }
}

/** "-9/64" or "3", every digit. */
export function fractionText({ numerator, denominator }: Rational): string {
  return denominator === 1n ? `${numerator}` : `${numerator}/${denominator}`
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

/** "12.5e-3" as the fraction that it is; null if its exponent is beyond the greatest one, either way. */
export function decimalFraction(text: string, greatestExponent: number): Rational | null {
  const [digits = '', power = '0'] = text.toLowerCase().split('e')
  const [whole = '', fraction = ''] = digits.split('.')
  const exponent = Number(power) - fraction.length
  if (!(Math.abs(exponent) <= greatestExponent)) return null
  const integer = BigInt(whole + fraction)
  const tens = 10n ** BigInt(Math.abs(exponent))
  return exponent < 0 ? { numerator: integer, denominator: tens } : { numerator: integer * tens, denominator: 1n }
}

/** The double nearest to a fraction that is not negative, half to even; infinity beyond the largest. */
export function nearestDouble({ numerator, denominator }: Rational): number {
  // 2^(lead - 1) < value < 2^(lead + 1), so the quotient has 53 or 54 bits, or is subnormal.
  const lead = bitLength(numerator) - bitLength(denominator)
  const isBelow = scaledUp(numerator, -lead) < scaledUp(denominator, lead)
  const unit = Math.max(lead - (isBelow ? 53 : 52), -1074)
  const [dividend, divisor] = [scaledUp(numerator, -unit), scaledUp(denominator, unit)]
  const quotient = dividend / divisor
  const twice = 2n * (dividend - quotient * divisor)
  const isUp = twice > divisor || (twice === divisor && (quotient & 1n) === 1n)
  // At most 2^53, so exact; a power of two beyond 2^1023 is taken in two steps.
  return Number(isUp ? quotient + 1n : quotient) * 2 ** Math.min(unit, 900) * 2 ** Math.max(unit - 900, 0)
}

function scaledUp(integer: bigint, exponent: number): bigint {
  return exponent > 0 ? integer << BigInt(exponent) : integer
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
