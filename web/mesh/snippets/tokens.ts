/**
 * A pasted text cut into numbers, words, strings and marks, in one pass: each character is looked at a bounded number of times, however
 * the text is made.
 */
import { asDouble } from '../../model/decimal'

export type TokenKind = 'number' | 'word' | 'string' | 'mark' | 'line' | 'end'

/**
 * A decimal number, an exponent in E, D, Q or Mathematica's *^ and its precision behind `, the suffixes of C, Rust, Julia and Fortran, and
 * hexadecimal floats; or what programs print for what is none. What follows must not go on as a word. It is tried once a word, and a word it fails on is passed over whole.
 */
const NUMBER =
  /[-+−–]?(?:0[xX][\da-fA-F]+(?:\.[\da-fA-F]*)?[pP][-+]?\d+|(?:\d+(?:\.\d*)?|\.\d+)(?:`+[\d.]*)?(?:(?:[eEdDqQ]|\*\^)[-+]?\d+)?|(?:[nN]a[nN]|NAN|inf|Inf|INF|Infinity|infinity)(?![.\w]))(?:[fFlL]|f0|_?[fi](?:32|64)|_(?:[A-Za-z]\w{0,9}|4|8|16))?(?!\w|\.\d)/y
const SUFFIX = /(?:_\w+|[fi](?:32|64)|f0|[fl])$|`+[\d.]*/g
const HEXADECIMAL = /^([-+]?)0x([\da-f]+)\.?([\da-f]*)p([-+]?\d+)$/

/** Digits: zeros beyond those of a double are no matter. */
const LONGEST_HEXADECIMAL = 40

const [LF, QUOTE, APOSTROPHE, ASTERISK, MINUS, PLUS, DOT, BACKTICK] = [10, 34, 39, 42, 45, 43, 46, 96] as const
const [TRUE_MINUS, DASH] = [0x2212, 0x2013] as const

export class Tokens {
  readonly text: string
  kind: TokenKind = 'line'
  /** The token is [from, to) of the text. */
  from = 0
  to: number
  /** The value of a number. */
  value = 0
  /** True if a number is written as an integer. */
  isInteger = false
  /** Significant digits of a number as written. */
  digits = 0
  readonly #hasStrings: boolean

  /** A quoted string is one token with `hasStrings`; else quotes are marks. */
  constructor(text: string, from = 0, hasStrings = false) {
    this.text = text
    this.to = from
    this.#hasStrings = hasStrings
  }

  /** The token's characters. */
  get word(): string {
    return this.text.slice(this.from, this.to)
  }

  next(): TokenKind {
    const { text } = this
    let at = this.to
    while (at < text.length && isBlank(text.charCodeAt(at))) at++
    this.from = at
    this.kind = this.#kindAt(at)
    return this.kind
  }

  #kindAt(at: number): TokenKind {
    const { text } = this
    if (at >= text.length) {
      this.to = at
      return 'end'
    }
    const code = text.charCodeAt(at)
    this.to = at + 1
    if (code === LF) return 'line'
    const isSign = code === MINUS || code === PLUS || code === TRUE_MINUS || code === DASH
    const before = at > 0 ? text.charCodeAt(at - 1) : LF
    const mayBegin = isSign ? !isLetter(before) : isWordCharacter(code) || (code === DOT && !isWordCharacter(before))
    if (mayBegin && before !== DOT && this.#number(at)) return 'number'
    if (isWordCharacter(code)) {
      let end = at + 1
      while (end < text.length && (isWordCharacter(text.charCodeAt(end)) || text.charCodeAt(end) === DOT)) end++
      this.to = end
      return 'word'
    }
    if (this.#hasStrings && (code === QUOTE || (code === APOSTROPHE && !isWordCharacter(before)))) {
      const end = endOfString(text, at, code)
      if (end > 0) {
        this.to = end
        return 'string'
      }
    }
    return 'mark'
  }

  #number(at: number): boolean {
    NUMBER.lastIndex = at
    const found = NUMBER.exec(this.text)?.[0]
    if (found === undefined) return false
    this.to = at + found.length
    this.value = doubleOf(found)
    this.isInteger = isInteger(found)
    this.digits = significantDigits(found)
    return true
  }
}

export function isBlank(code: number): boolean {
  if (code <= 32) return code !== LF
  return code === 0xa0 || (code >= 0x2000 && code <= 0x200b) || code === 0x202f || code === 0x3000 || code === 0xfeff
}

function isLetter(code: number): boolean {
  return (code >= 65 && code <= 90) || (code >= 97 && code <= 122) || code === 95
}

export function isWordCharacter(code: number): boolean {
  return isLetter(code) || (code >= 48 && code <= 57)
}

/** The index behind the closing quote, or 0 if the line ends first. */
function endOfString(text: string, at: number, quote: number): number {
  for (let end = at + 1; end < text.length; end++) {
    const code = text.charCodeAt(end)
    if (code === quote) return end + 1
    if (code === LF) return 0
  }
  return 0
}

function doubleOf(found: string): number {
  const quick = Number(found)
  if (!Number.isNaN(quick)) return quick
  const plain = found.replace(/^[−–]/, '-').toLowerCase()
  if (plain.includes('nan')) return Number.NaN
  if (plain.includes('inf')) return plain.startsWith('-') ? -Infinity : Infinity
  if (!plain.includes('x')) return Number(plain.replace(SUFFIX, '').replace(/[dq]|\*\^/, 'e'))
  const [, sign = '', whole = '', fraction = '', power = ''] = HEXADECIMAL.exec(plain.replace(/[fl]$/, '')) ?? []
  return doubleOfHexadecimal(sign, `${whole}${fraction}`, Number(power) - 4 * fraction.length)
}

/** NaN for digits that are no double: nothing is rounded that was written bit for bit. */
function doubleOfHexadecimal(sign: string, digits: string, exponent: number): number {
  const integer = BigInt(`0x${digits === '' ? '0' : digits.slice(0, LONGEST_HEXADECIMAL)}`)
  const mantissa = Number(integer)
  if (digits.length > LONGEST_HEXADECIMAL || BigInt(mantissa) !== integer) return Number.NaN
  return asDouble(sign === '-' ? -mantissa : mantissa, exponent) ?? Number.NaN
}

function isInteger(found: string): boolean {
  for (let i = 0; i < found.length; i++) {
    const code = found.charCodeAt(i)
    if ((code < 48 || code > 57) && i > 0) return false
  }
  return found.length > 0
}

function significantDigits(found: string): number {
  let digits = 0
  for (let i = 0; i < found.length; i++) {
    const code = found.charCodeAt(i)
    if (code >= 48 && code <= 57) {
      if (code !== 48 || digits > 0) digits++
    } else if (isLetter(code) || code === ASTERISK || code === BACKTICK) break
  }
  return digits
}
