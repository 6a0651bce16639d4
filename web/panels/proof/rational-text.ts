/** Rational numbers, however long, as text to be read. */
import { rounded } from '../../core/exact/rounding'
import { formatJacdet, superscript } from '../../model/decimal'
import { bitLength, fractionText, magnitude, type Rational } from '../../model/rational'

/** Longer numbers keep their first and last digits. */
const WHOLE_DIGITS = 12
const KEPT_DIGITS = 4
/** Powers of two up to this are denominators as they are. */
const PLAIN_DENOMINATOR = 1n << 16n

/** "−9/64", "39/2⁶⁰" or "−1419…0309/2¹⁶⁰": in lowest terms, a long one cut in the middle. */
export function rationalText({ numerator, denominator }: Rational): string {
  const sign = numerator < 0n ? '−' : ''
  const over = denominator === 1n ? '' : `/${denominatorText(denominator)}`
  return `${sign}${abbreviated(magnitude(numerator))}${over}`
}

/** " ≈ −0.12141" where rationalText is no longer easily read, else nothing. */
export function roundedText(rational: Rational): string {
  const { numerator, denominator } = rational
  if (rationalText(rational) === fractionText(rational).replace('-', '−') || numerator === 0n) return ''
  const { mantissa, exponent } = rounded({ numerator, denominator }, 0)
  return `\u00a0≈\u00a0${formatJacdet(mantissa, exponent, 'unit')}`
}

function denominatorText(denominator: bigint): string {
  const isPowerOfTwo = (denominator & (denominator - 1n)) === 0n
  return isPowerOfTwo && denominator > PLAIN_DENOMINATOR
    ? `2${superscript(bitLength(denominator) - 1)}`
    : abbreviated(denominator)
}

function abbreviated(size: bigint): string {
  const digits = String(size)
  return digits.length <= WHOLE_DIGITS ? digits : `${digits.slice(0, KEPT_DIGITS)}…${digits.slice(-KEPT_DIGITS)}`
}
