/**
 * The text of a field as one number: decimals, fractions such as 1/3, 1 1/2 and ½, and numbers as
 * the page prints them (−1/8, 3.88×10⁻¹²). The value is the double nearest to what is written.
 */

import { say } from '../words/say'
import { spoken } from './decimal'
import { decimalFraction, nearestDouble, productOf, type Rational, reciprocal, sumOf } from './rational'
import { type CodedError, type Result, refused } from './result'

/** The numbers that a field takes, both ends included. */
export interface Limits {
  readonly least?: number
  readonly most?: number
  readonly isWhole?: true
}

export type NumberTextError = CodedError<'missing' | 'not-a-number' | 'ambiguous' | 'out-of-range'>

const DECIMAL = String.raw`(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+−]?\d+|\s?×\s?10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?`
const NUMBER = new RegExp(
  String.raw`^([-+−–]?)\s*(?:(\d+)\s+(?=\d+\s*[/⁄∕]\s*\d+$))?(${DECIMAL})(?:\s*[/⁄∕]\s*(${DECIMAL}))?$`,
)
/** One that begins with 0, or with four digits, has no separator of thousands. */
const PERHAPS_THOUSANDS = /^[1-9]\d{0,2},\d{3}$/
const VULGAR = /[¼-¾⅐-⅞↉]/g
/** Exact fractions of the proof are longer than any number that is typed. */
const GREATEST_LENGTH = 5000
/** A text of that length times a power of ten beyond this is outside the doubles. */
const GREATEST_EXPONENT = 6000
const QUOTED = 24

/** The shortest text that reads back as the same double, the sign of zero included. */
export function numberText(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value)
}

/** The message is a sentence about the text. */
export function readNumber(text: string, limits: Limits = {}): Result<number, NumberTextError> {
  const typed = text.trim()
  if (typed === '') return refused('missing', say('A number is missing.'))
  const quoted = `“${typed.length > QUOTED ? `${typed.slice(0, QUOTED)}…` : typed}”`
  const plain = typed.replace(VULGAR, fraction => ` ${fraction.normalize('NFKD')} `)
  const [, sign = '', whole = '0', over = '', under = '1'] =
    (plain.length <= GREATEST_LENGTH && NUMBER.exec(plain.trim())) || []
  if (over === '')
    return refused('not-a-number', say('{text} is not one number, such as −1.5, 1/3 or 2e-3.', { text: quoted }))
  const ambiguous = [over, under].find(part => PERHAPS_THOUSANDS.test(part))
  if (ambiguous !== undefined) {
    const [point, none] = ['.', ''].map(comma => typed.replace(ambiguous, ambiguous.replace(',', comma))) as [
      string,
      string,
    ]
    return refused(
      'ambiguous',
      say('{text} can mean {point} or {none}: write one of them.', { text: quoted, point, none }),
    )
  }
  const [numerator, denominator, integer] = [over, under, whole].map(fractionOf)
  if (denominator?.numerator === 0n) return refused('not-a-number', say('{text} divides by zero.', { text: quoted }))
  const exact = numerator && denominator && integer && sumOf(integer, productOf(numerator, reciprocal(denominator)))
  const size = exact ? nearestDouble(exact) : Number.POSITIVE_INFINITY
  if (!exact || size === Number.POSITIVE_INFINITY || (size === 0 && exact.numerator !== 0n))
    return refused(
      'out-of-range',
      say('{text} is outside the doubles, which are from 5e-324 to 1.8e308.', { text: quoted }),
    )
  const value = sign === '-' || sign === '−' || sign === '–' ? -size : size
  return isWithin(value, limits) ? { ok: true, value } : refused('out-of-range', outOfLimits(quoted, limits))
}

function fractionOf(decimal: string): Rational | null {
  return decimalFraction(spoken(decimal.replaceAll(' ', '')).replace(',', '.'), GREATEST_EXPONENT)
}

export function isWithin(value: number, { least = -Infinity, most = Infinity, isWhole }: Limits): boolean {
  return value >= least && value <= most && (!isWhole || Number.isInteger(value))
}

function outOfLimits(text: string, { least, most, isWhole }: Limits): string {
  if (least === undefined) return say('{text} is not a whole number.', { text })
  if (most === undefined)
    return isWhole
      ? say('{text} is not a whole number of {least} or more.', { text, least })
      : say('{text} is not a number of {least} or more.', { text, least })
  return isWhole
    ? say('{text} is not a whole number from {least} to {most}.', { text, least, most })
    : say('{text} is not a number from {least} to {most}.', { text, least, most })
}
