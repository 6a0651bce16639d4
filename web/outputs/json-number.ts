/** Numbers as the command line prints them. */
import { asDouble, decimalOf } from '../model/decimal'

/** Enough digits to tell every double from every other. */
const DIGITS = 17

/** A number that reads back bit for bit, or a decimal string where mantissa * 2^exponent is no double. */
export function jsonNumber(mantissa: number, exponent: number): number | string {
  return asDouble(mantissa, exponent) ?? decimalOf(mantissa, exponent, DIGITS)
}
