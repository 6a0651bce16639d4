/** Exact values rounded to doubles. */
import { bitLength, magnitude, type Rational } from '../../model/rational'

/** Bits kept of a quotient: more than a double's 53, and a last one that says whether anything was cut off. */
const QUOTIENT_BITS = 64

/**
 * The value * 2^exponent as mantissa * 2^(its own exponent), the mantissa correctly rounded. The exponent is 0 where that is
 * a normal double.
 */
export function rounded(
  { numerator, denominator }: Rational,
  exponent: number,
): { mantissa: number; exponent: number } {
  if (numerator === 0n) return { mantissa: 0, exponent: 0 }
  const shift = QUOTIENT_BITS + bitLength(denominator) - bitLength(numerator)
  const dividend = shift >= 0 ? magnitude(numerator) << BigInt(shift) : magnitude(numerator)
  const divisor = shift >= 0 ? denominator : denominator << BigInt(-shift)
  const quotient = dividend / divisor
  const sticky = quotient * divisor === dividend ? quotient : quotient | 1n
  const size = (numerator < 0n ? -1 : 1) * Number(sticky)
  const power = exponent - shift
  const scaled = power > -960 && power < 950 ? size * 2 ** power : null
  return scaled === null ? { mantissa: size, exponent: power } : { mantissa: scaled, exponent: 0 }
}

/** The double nearest to a value in [0,1]; below 2^-1022 it may be 0. */
export function unitDouble(value: Rational): number {
  const { mantissa, exponent } = rounded(value, 0)
  return mantissa * 2 ** exponent
}
