/** Numbers as programs print them: decimals, Fortran's D exponents, true minus signs, C's hexadecimal floats. */
import { asDouble } from '../decimal'
import { Refused } from './format'

const BODY = String.raw`(?:0[xX][\da-fA-F]+(?:\.[\da-fA-F]*)?[pP][-+]?\d+|(?:\d+(?:\.\d*)?|\.\d+)(?:[eEdDqQ][-+]?\d+)?)[fFlL]?`

/** A sign may touch the number before it, as in Fortran's fixed columns; a word may not touch a number. */
const NUMBER = String.raw`(?:(?<![A-Za-z_])[-+−]|(?<![\w.]))${BODY}(?!\w|\.\d)`

const HEXADECIMAL = /^([-+]?)0x([\da-f]+)\.?([\da-f]*)p([-+]?\d+)$/

/** A fresh expression for each use, as a global one remembers its place. */
export function numberPattern(): RegExp {
  return new RegExp(NUMBER, 'g')
}

const ALONE = new RegExp(`^[-+−]?${BODY}$`)

/** The double that a text says. Throws Refused where it is no number, or one beyond the doubles. */
export function toDouble(text: string): number {
  if (!ALONE.test(text)) throw new Refused(`“${shortened(text)}” stands where a number is needed.`)
  const plain = text.replace('−', '-').toLowerCase()
  const value = plain.includes('0x') ? fromHexadecimal(plain) : Number(plain.replace(/[fl]$/, '').replace(/[dq]/, 'e'))
  if (!Number.isFinite(value)) {
    throw new Refused(`${shortened(text)} is too large: a coordinate is a double, at most 1.8×10³⁰⁸.`)
  }
  return value
}

/** All numbers of a text, in order; words, also those with digits in them, are passed over. */
export function numbersIn(text: string): number[] {
  return Array.from(text.matchAll(numberPattern()), ([found]) => toDouble(found))
}

function fromHexadecimal(text: string): number {
  const [, sign = '', whole = '', fraction = '', power = ''] = HEXADECIMAL.exec(text.replace(/[fl]$/, '')) ?? []
  const mantissa = Number(`0x${whole}${fraction}`)
  const value = asDouble(sign === '-' ? -mantissa : mantissa, Number(power) - 4 * fraction.length)
  if (value === null || whole.length + fraction.length > 15) throw new Refused(`${shortened(text)} is not a double.`)
  return value
}

export function shortened(text: string): string {
  return text.length > 24 ? `${text.slice(0, 24)}…` : text
}
