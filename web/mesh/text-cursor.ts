/**
 * Words, numbers and lines of a text file, read in chunks and never held as one string: linear in
 * time, constant in memory. ASCII; bytes of other characters are part of words.
 */

import type { RowPattern } from '../core/reading-interface'
import { doubleOfDigits, POWERS_OF_TEN } from './decimal'
import { FileChunk } from './file-chunk'
import { type FileRows, type RowSearch, rowsAhead } from './file-rows'
import { MeshRefusal } from './mesh'
import { shown } from './shown'
import type { MeshFile } from './source'

export { shown, withoutControls } from './shown'

const CHUNK = 1024 * 1024
/** The longest word or number. */
const LONGEST_WORD = 4096
/** The longest line that is asked for as text. */
const LONGEST_LINE = 1024 * 1024

const [TAB, LF, CR, SPACE, PLUS, MINUS, DOT, ZERO, NINE] = [9, 10, 13, 32, 43, 45, 46, 48, 57] as const

const decoder = new TextDecoder('latin1')

export class TextCursor {
  readonly #file: MeshFile
  readonly #chunk = new FileChunk()
  #bytes = new Uint8Array(0)
  /** The position of `#bytes` in the file. */
  #start = 0
  #at = 0
  #line: number
  /** Significant digits of the last number. */
  digits = 0
  /** The byte of the file at which the last number begins; it ends at `position`. */
  numberFrom = 0

  /** Begins at a byte in line `line`. */
  constructor(file: MeshFile, from = 0, line = 1) {
    this.#file = file
    this.#start = from
    this.#line = line
    this.#fill()
  }

  /** The byte of the file that is next. */
  get position(): number {
    return this.#start + this.#at
  }

  /** The line of the next byte, counted from 1. */
  get line(): number {
    return this.#line
  }

  get isAtEnd(): boolean {
    return this.#at >= this.#bytes.length && this.position >= this.#file.size
  }

  /** Goes to a byte of the file that lies in line `line`. Without it lines are not counted on the way there; `lineAt` knows them. */
  goTo({ position, line = this.#line }: { readonly position: number; readonly line?: number }): void {
    this.#line = line
    const at = position - this.#start
    if (at >= 0 && at <= this.#bytes.length) {
      this.#at = at
      return
    }
    this.#bytes = new Uint8Array(0)
    this.#start = position
    this.#at = 0
    this.#fill()
  }

  /** Throws: "part.inp, line 12: ...". */
  refuse(what: string, line = this.#line): never {
    throw new MeshRefusal(`${this.#file.name}, line ${line}: ${what}`)
  }

  /** Makes sure that at least `LONGEST_WORD` bytes lie ahead, or all there are. */
  #fill(ahead = LONGEST_WORD): void {
    const left = this.#bytes.length - this.#at
    if (left >= ahead || this.#start + this.#bytes.length >= this.#file.size) return
    const from = this.#start + this.#bytes.length
    const to = Math.min(this.#file.size, from + Math.max(CHUNK, ahead))
    this.#bytes = this.#chunk.next(this.#file, this.#bytes.subarray(this.#at), from, to)
    this.#start += this.#at
    this.#at = 0
  }

  /** The next byte, or -1 at the end; it is not passed. */
  peek(): number {
    if (this.#at >= this.#bytes.length) this.#fill(1)
    return this.#bytes[this.#at] ?? -1
  }

  /** Passes one byte. */
  skip(): void {
    if (this.peek() === LF) this.#line++
    this.#at++
  }

  /** Passes blanks; with `lines` also the ends of lines. */
  skipBlanks(lines = true): void {
    for (let byte = this.peek(); ; byte = this.peek()) {
      if (byte === SPACE || byte === TAB || byte === CR) this.#at++
      else if (byte === LF && lines) this.skip()
      else return
    }
  }

  /** True if anything but blanks is left of the line; blanks are passed. */
  hasMoreOnLine(): boolean {
    this.skipBlanks(false)
    const byte = this.peek()
    return byte !== LF && byte !== -1
  }

  /** Passes the rest of the line and its end. */
  skipLine(): void {
    for (; this.peek() !== -1; this.#at = this.#bytes.length) {
      const end = this.#bytes.indexOf(LF, this.#at)
      if (end < 0) continue
      this.#at = end + 1
      this.#line++
      return
    }
  }

  /** The rest of the line without its end, which is passed; null at the end of the file. */
  nextLine(): string | null {
    if (this.isAtEnd) return null
    let length = 0
    for (;;) {
      if (this.#at + length >= this.#bytes.length) {
        const had = this.#bytes.length - this.#at
        this.#fill(had + LONGEST_WORD)
        if (this.#bytes.length - this.#at === had) break
      }
      if (this.#bytes[this.#at + length] === LF) break
      if (++length > LONGEST_LINE) this.refuse('the line is longer than a line of a mesh is.')
    }
    const line = decoder.decode(this.#bytes.subarray(this.#at, this.#at + length))
    this.#at += length
    if (this.peek() === LF) this.skip()
    return line.endsWith('\r') ? line.slice(0, -1) : line
  }

  /** Rows of a pattern from here on; they are passed. Null where none is seen. */
  rows(search: RowSearch, pattern: RowPattern): FileRows | null {
    this.#fill()
    const [start, line] = [this.position, this.#line]
    const taken = search.rows(this.#bytes, this.#at, pattern)
    if (taken === null) return null
    this.#at += taken.bytes
    this.#line += taken.count * pattern.lineCount
    return { ...taken, pattern, start, line, ahead: rowsAhead(taken, start, this.#file.size) }
  }

  /** The next bytes of the line, at most so many; they are not passed. */
  peekLine(most = LONGEST_WORD): string {
    this.#fill()
    const ahead = this.#bytes.subarray(this.#at, this.#at + most)
    const end = ahead.indexOf(LF)
    return decoder.decode(end < 0 ? ahead : ahead.subarray(0, end))
  }

  /** The next word, up to a blank or `until`; '' at the end of the file. */
  word(until = -1): string {
    this.skipBlanks()
    this.#fill()
    let end = this.#at
    for (; end < this.#bytes.length; ++end) {
      const byte = this.#bytes[end] as number
      if (byte <= SPACE || byte === until) break
      if (end - this.#at > LONGEST_WORD) this.refuse('a word is longer than words of a mesh are.')
    }
    const word = decoder.decode(this.#bytes.subarray(this.#at, end))
    this.#at = end
    return word
  }

  /** The next number, an exponent in E or D; NaN and infinities by their usual names. Refuses what is none, saying what was expected. */
  number(expected = 'a number'): number {
    this.skipBlanks()
    this.#fill()
    const bytes = this.#bytes
    const from = this.#at
    this.numberFrom = this.#start + from
    let at = from
    const isNegative = bytes[at] === MINUS
    if (isNegative || bytes[at] === PLUS) at++
    const firstDigit = at
    let digits = 0
    let mantissa = 0
    let power = 0
    for (let seenDot = false; ; ++at) {
      const byte = bytes[at] as number
      if (byte >= ZERO && byte <= NINE) {
        if (digits < 15) mantissa = 10 * mantissa + (byte - ZERO)
        if (digits > 0 || byte !== ZERO) digits++
        if (seenDot) power--
      } else if (byte === DOT && !seenDot) seenDot = true
      else break
    }
    const afterDigits = at
    const mark = (bytes[at] ?? 0) | 32
    if (afterDigits > from && (mark === 101 || mark === 100)) {
      at++
      const isDown = bytes[at] === MINUS
      if (isDown || bytes[at] === PLUS) at++
      let exponent = 0
      const first = at
      for (; (bytes[at] as number) >= ZERO && (bytes[at] as number) <= NINE; ++at)
        exponent = Math.min(10 * exponent + (bytes[at] as number) - ZERO, 100_000)
      if (at === first) at = -1
      power += isDown ? -exponent : exponent
    }
    const isWhole = at > from && isEndOfNumber(bytes[at]) && digits > 0
    if (isWhole && (digits > 15 || power < -22 || power > 22)) {
      const size = doubleOfDigits(bytes, firstDigit, afterDigits, power)
      if (Number.isNaN(size)) return this.#slowNumber(from, expected)
      this.#at = at
      this.digits = digits
      return isNegative ? -size : size
    }
    if (at > from && isEndOfNumber(bytes[at]) && afterDigits > from && digits <= 15 && power >= -22 && power <= 22) {
      this.#at = at
      this.digits = digits
      if (mantissa === 0 && !hasDigit(bytes, from, afterDigits)) return this.#slowNumber(from, expected)
      const value =
        power < 0 ? mantissa / (POWERS_OF_TEN[-power] as number) : mantissa * (POWERS_OF_TEN[power] as number)
      return isNegative ? -value : value
    }
    return this.#slowNumber(from, expected)
  }

  #slowNumber(from: number, expected: string): number {
    this.#at = from
    const word = this.word(44)
    const value = numberOf(word)
    this.digits = significantDigits(word)
    if (value === null) {
      this.refuse(word === '' ? `the file ends where ${expected} was expected.` : `${shown(word)} is not ${expected}.`)
    }
    return value
  }

  /** The next integer from 0 to 2^53. */
  count(expected = 'a count'): number {
    const value = this.number(expected)
    if (!Number.isSafeInteger(value) || value < 0) {
      const word = decoder.decode(this.#bytes.subarray(this.numberFrom - this.#start, this.#at))
      this.refuse(`${shown(word)} is not ${expected}.`)
    }
    return value
  }
}

/** One of many rows, of which something may be wrong. */
export class RowCursor {
  row = 0
  readonly #cursor: TextCursor
  readonly #rows: FileRows

  constructor(cursor: TextCursor, rows: FileRows) {
    this.#cursor = cursor
    this.#rows = rows
  }

  refuse(what: string): never {
    return this.#cursor.refuse(what, this.#rows.line + this.#rows.pattern.lineCount * this.row)
  }
}

function isEndOfNumber(byte: number | undefined): boolean {
  return byte === undefined || byte <= SPACE || byte === 44
}

function hasDigit(bytes: Uint8Array, from: number, to: number): boolean {
  for (let i = from; i < to; ++i) if ((bytes[i] as number) >= ZERO && (bytes[i] as number) <= NINE) return true
  return false
}

const NUMBER = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?$/
/** Prints of C, Fortran and Microsoft's C before 2015: nan, -nan(ind), inf, 1.#QNAN, 1.#INF00. */
const NOT_FINITE = /^([-+]?)(?:1\.#)?((?:[qs]?nan|ind)(?:\([a-z]*\))?|inf(?:inity)?)0*$/i

/** The double that a word stands for, an infinity for what is too large; null if it is no number. */
export function numberOf(word: string): number | null {
  if (NUMBER.test(word)) return Number(word.replace(/[dD]/, 'e'))
  const [, sign, name] = NOT_FINITE.exec(word) ?? []
  if (name === undefined) return null
  return !/^inf/i.test(name) ? Number.NaN : sign === '-' ? -Infinity : Infinity
}

/** The number of digits without zeros in front. */
export function significantDigits(word: string): number {
  let digits = 0
  for (const character of word) {
    if (character >= '0' && character <= '9') digits += digits > 0 || character !== '0' ? 1 : 0
    else if (character > '9') break
  }
  return digits
}
