/**
 * Lines of a text file as bytes, for formats whose fields stand in columns or between commas. The
 * file is read in chunks; fields become numbers straight from the bytes. A text that is indented as
 * a whole is read as it was before.
 */

import type { RowPattern } from '../../core/reading-interface'
import { doubleOfDigits, POWERS_OF_TEN } from '../decimal'
import { FileChunk } from '../file-chunk'
import { type FileRows, RowSearch, rowsAhead } from '../file-rows'
import { MeshRefusal } from '../mesh'
import type { PrintedDigits } from '../precision'
import type { MeshFile, ReadOptions } from '../source'
import { numberOf, shown } from '../text-cursor'

const CHUNK = 1024 * 1024
const LONGEST_LINE = 1024 * 1024
const HEAD = 65_536

const [TAB, LF, SPACE, PLUS, COMMA, MINUS, DOT, ZERO] = [9, 10, 32, 43, 44, 45, 46, 48] as const

const POWERS_OF_FIVE = Array.from({ length: 23 }, (_, i) => 5 ** i)
const EXACT = 2 ** 53

const decoder = new TextDecoder()

export class TextLines {
  readonly file: MeshFile
  readonly #options: ReadOptions
  #start = 0
  #next = 0
  #indent = 0
  #isHeld = false
  readonly #rowSearch: RowSearch

  readonly #chunk = new FileChunk()

  /** Bytes of the file with the line among them; other ones when the next line has been read. */
  bytes = new Uint8Array(0)
  /** The line is the bytes [from, to), without its end and the blanks before that. */
  from = 0
  to = 0
  /** The number of the line, counted from 1; 0 before the first. */
  number = 0

  /** Commas and tabs are known once the line has been scanned. */
  hasComma = false
  hasTab = false

  /** Fields of the line, once it has been split. */
  fieldCount = 0
  #fieldFrom = new Int32Array(64)
  #fieldTo = new Int32Array(64)

  constructor(file: MeshFile, options: ReadOptions) {
    this.file = file
    this.#options = options
    this.#rowSearch = new RowSearch(options.core)
    this.#lookForIndent()
  }

  /** Throws: "part.inp, line 12: ...". */
  refuse(what: string, line = this.number): never {
    throw new MeshRefusal(`${shown(this.file.name).slice(1, -1)}, line ${line}: ${what}`)
  }

  /** The position in the file of a byte. */
  placeOf(byte: number): number {
    return this.#start + byte
  }

  get isBlank(): boolean {
    return this.from === this.to
  }

  /** True if the line only says that lines are left out: "...". */
  get isElision(): boolean {
    const length = this.to - this.from
    if (length < 3 || length > 12) return false
    return /^[[(<]?\s*(?:\.\s?\.\s?\.[.\s]*|…|:)\s*[\])>]?$/u.test(this.text().trim())
  }

  /** True for prose under a snippet: it begins with a letter, and stands below a blank line. */
  isProseAfter(blankLine: number): boolean {
    return blankLine === this.number - 1 && /^\p{L}\S*\s/u.test(this.text())
  }

  /** The byte at a column, counted from 0; 0 beyond the end. */
  at(column: number): number {
    const place = this.from + column
    return place < this.to ? (this.bytes[place] as number) : 0
  }

  /** The text between two bytes, by default the line. */
  text(from = this.from, to = this.to): string {
    return decoder.decode(this.bytes.subarray(Math.min(from, this.to), Math.min(to, this.to)))
  }

  /** The line that was read last comes again. */
  hold(): void {
    this.#isHeld = true
  }

  /** False at the end of the file. */
  next(): boolean {
    if (this.#isHeld) {
      this.#isHeld = false
      return true
    }
    if (!this.#nextRaw()) return false
    if (this.#indent > 0) this.from = Math.min(this.to, this.from + this.#indent)
    return true
  }

  /** Rows of a pattern that begin with this line; they are passed. Null where none is seen. */
  rows(pattern: RowPattern): FileRows | null {
    if (this.#indent > 0) return null
    const at = this.from
    const taken = this.#rowSearch.rows(this.bytes, at, pattern)
    if (taken === null) return null
    const line = this.number
    this.#next = at + taken.bytes
    this.number += taken.count * pattern.lineCount - 1
    this.from = this.#next - 1
    this.to = this.from
    const start = this.#start + at
    return { ...taken, pattern, start, line, ahead: rowsAhead(taken, start, this.file.size) }
  }

  #nextRaw(): boolean {
    let end = this.bytes.indexOf(LF, this.#next)
    if (end < 0) {
      this.#fill()
      end = this.bytes.indexOf(LF, this.#next)
      if (end < 0) {
        end = this.bytes.length
        if (this.#next >= end) return false
        if (this.#start + end < this.file.size)
          this.refuse('the line is longer than lines of a mesh are.', this.number + 1)
      }
    }
    this.number++
    this.from = this.#next
    this.to = end
    this.#next = end + 1
    if (
      this.number === 1 &&
      this.#start === 0 &&
      this.bytes[0] === 0xef &&
      this.bytes[1] === 0xbb &&
      this.bytes[2] === 0xbf
    )
      this.from += 3
    while (this.to > this.from && (this.bytes[this.to - 1] as number) <= SPACE) this.to--
    return true
  }

  #fill(): void {
    const begin = this.#start + this.bytes.length
    const { size } = this.file
    if (begin >= size) return
    this.#options.throwIfCancelled()
    this.#options.onProgress(begin / size)
    const left = this.bytes.length - this.#next
    this.bytes = this.#chunk.next(this.file, this.bytes.subarray(this.#next), begin, Math.min(size, begin + CHUNK))
    this.#start += this.#next
    this.#next = 0
    if (left > LONGEST_LINE) this.refuse('the line is longer than lines of a mesh are.', this.number + 1)
  }

  /** Blanks with which every line begins, as in quoted texts. */
  #lookForIndent(): void {
    const head = decoder.decode(this.file.read(0, Math.min(HEAD, this.file.size)))
    let indent = Number.POSITIVE_INFINITY
    for (const line of head.split('\n'))
      if (line.trim() !== '') indent = Math.min(indent, line.length - line.trimStart().length)
    this.#indent = Number.isFinite(indent) ? indent : 0
  }

  // Fields

  /** The beginning and the end of a field, without blanks. */
  fieldFrom(field: number): number {
    return field < this.fieldCount ? (this.#fieldFrom[field] as number) : this.to
  }

  fieldTo(field: number): number {
    return field < this.fieldCount ? (this.#fieldTo[field] as number) : this.to
  }

  isFieldBlank(field: number): boolean {
    return this.fieldFrom(field) >= this.fieldTo(field)
  }

  fieldText(field: number): string {
    return this.text(this.fieldFrom(field), this.fieldTo(field))
  }

  startFields(): void {
    this.fieldCount = 0
  }

  /** Appends the bytes [from, to) as a field. */
  addField(from: number, to: number): void {
    const { bytes, to: last } = this
    let begin = from < last ? from : last
    let end = to < last ? to : last
    while (begin < end && (bytes[begin] as number) <= SPACE) begin++
    while (end > begin && (bytes[end - 1] as number) <= SPACE) end--
    if (this.fieldCount === this.#fieldFrom.length) {
      const [moreFrom, moreTo] = [new Int32Array(2 * this.fieldCount), new Int32Array(2 * this.fieldCount)]
      moreFrom.set(this.#fieldFrom)
      moreTo.set(this.#fieldTo)
      this.#fieldFrom = moreFrom
      this.#fieldTo = moreTo
    }
    this.#fieldFrom[this.fieldCount] = begin
    this.#fieldTo[this.fieldCount++] = end
  }

  /** Appends so many fields that stand side by side, each as wide, from byte `first` on. */
  addColumns(count: number, width: number, first = this.from): void {
    for (let i = 0; i < count; ++i) this.addField(first + i * width, first + (i + 1) * width)
  }

  /** The number of fields up to the last that is not blank. */
  get filledCount(): number {
    let count = this.fieldCount
    while (count > 0 && this.isFieldBlank(count - 1)) count--
    return count
  }

  /** Fields between commas. A comma at the end of the line begins one more, a blank one. */
  splitAtCommas(): void {
    const { bytes, to } = this
    this.fieldCount = 0
    let begin = this.from
    for (let at = this.from; at < to; ++at) {
      if (bytes[at] !== COMMA) continue
      this.addField(begin, at)
      begin = at + 1
    }
    this.addField(begin, to)
  }

  /** Fields between blanks. */
  splitAtBlanks(): void {
    this.fieldCount = 0
    for (let at = this.from; at < this.to; ) {
      while (at < this.to && (this.bytes[at] as number) <= SPACE) at++
      const begin = at
      while (at < this.to && (this.bytes[at] as number) > SPACE) at++
      if (at > begin) this.addField(begin, at)
    }
  }

  /** Finds commas, tabs and the line's end without blanks and a comment after `commentMark`. */
  scan(commentMark = -1): void {
    const { bytes, to } = this
    this.hasComma = false
    this.hasTab = false
    let at = this.from
    for (; at < to; ++at) {
      const byte = bytes[at] as number
      if (byte === COMMA) this.hasComma = true
      else if (byte === TAB) this.hasTab = true
      else if (byte === commentMark) break
    }
    while (at > this.from && (bytes[at - 1] as number) <= SPACE) at--
    this.to = at
  }

  /** The number in a field, 0 where that is blank; refuses what is none. An exponent may stand without its letter: 1.0-3. */
  real(field: number, precision: PrintedDigits | null = null): number {
    return this.realIn(this.fieldFrom(field), this.fieldTo(field), precision)
  }

  realIn(from: number, to: number, precision: PrintedDigits | null): number {
    const bytes = this.bytes
    if (from >= to) return 0
    let at = from
    const isNegative = bytes[at] === MINUS
    if (isNegative || bytes[at] === PLUS) at++
    let mantissa = 0
    let digits = 0
    let zeros = 0
    let power = 0
    let isDotted = false
    let hasDigits = false
    let isExact = true
    for (; at < to; ++at) {
      const digit = (bytes[at] as number) - ZERO
      if (digit === 0) {
        hasDigits = true
        if (digits > 0) {
          digits++
          zeros++
        }
        if (isDotted) power--
      } else if (digit > 0 && digit <= 9) {
        hasDigits = true
        digits++
        if (zeros === 0) {
          mantissa = 10 * mantissa + digit
          if (mantissa > EXACT) isExact = false
        } else if (zeros < 16) {
          mantissa = mantissa * (POWERS_OF_TEN[zeros + 1] as number) + digit
          if (mantissa > EXACT) isExact = false
        } else if (mantissa === 0) mantissa = digit
        else isExact = false
        zeros = 0
        if (isDotted) power--
      } else if (digit === DOT - ZERO && !isDotted) isDotted = true
      else break
    }
    if (at < to && hasDigits) {
      const byte = bytes[at] as number
      const letter = byte | 32
      if (letter === 101 || letter === 100) at++
      else if (byte !== PLUS && byte !== MINUS) return this.#slowReal(from, to)
      const isDown = bytes[at] === MINUS
      if (isDown || bytes[at] === PLUS) at++
      const first = at
      let exponent = 0
      for (; at < to; ++at) {
        const digit = (bytes[at] as number) - ZERO
        if (digit < 0 || digit > 9) break
        if (exponent < 100_000) exponent = 10 * exponent + digit
      }
      if (at === first) return this.#slowReal(from, to)
      power += isDown ? -exponent : exponent
    }
    if (at < to || !hasDigits) return this.#slowReal(from, to)
    power += zeros
    if (digits === 0) return isNegative ? -0 : 0
    if (precision !== null && digits > precision.digits) precision.digits = digits
    if (!isExact || power < -22 || power > 22) {
      if (precision !== null) precision.isRounded = true
      const size = doubleOfDigits(bytes, isNegative || bytes[from] === PLUS ? from + 1 : from, to, power - zeros)
      if (Number.isNaN(size)) return Number(withExponentLetter(this.text(from, to)))
      return isNegative ? -size : size
    }
    if (precision !== null && power < 0 && !precision.isRounded && mantissa % (POWERS_OF_FIVE[-power] as number) !== 0)
      precision.isRounded = true
    const value = power < 0 ? mantissa / (POWERS_OF_TEN[-power] as number) : mantissa * (POWERS_OF_TEN[power] as number)
    return isNegative ? -value : value
  }

  /** Numbers without digits: infinities and NaN. */
  #slowReal(from: number, to: number): number {
    const word = this.text(from, to)
    const value = to - from > 64 ? null : numberOf(word)
    if (value === null) this.refuse(`${shown(word)} is not a number.`)
    return value
  }

  /** The integer from 0 to 2^53 in a field; refuses a blank one. */
  id(field: number, what: string): number {
    return this.idIn(this.fieldFrom(field), this.fieldTo(field), what)
  }

  idIn(from: number, to: number, what: string): number {
    let value = 0
    for (let at = from; at < to; ++at) {
      const digit = (this.bytes[at] as number) - ZERO
      if (digit < 0 || digit > 9) {
        if (at === from && digit === PLUS - ZERO && to > from + 1) continue
        this.refuse(`${shown(this.text(from, to))} is not ${what}.`)
      }
      value = 10 * value + digit
      if (value >= EXACT) this.refuse(`${shown(this.text(from, to))} is too large for ${what}.`)
    }
    if (from >= to) this.refuse(`${what} is missing.`)
    return value
  }

  /** An integer with a sign; 0 for a blank field. */
  integer(field: number, what: string): number {
    const from = this.fieldFrom(field)
    if (this.isFieldBlank(field)) return 0
    return this.bytes[from] === MINUS ? -this.idIn(from + 1, this.fieldTo(field), what) : this.id(field, what)
  }
}

/** 1.0-3 and 1.0D-3 as 1.0e-3. */
function withExponentLetter(word: string): string {
  const letter = /[deDE]/.exec(word)?.[0]
  if (letter !== undefined) return letter === 'd' || letter === 'D' ? word.replace(letter, 'e') : word
  const sign = Math.max(word.lastIndexOf('-'), word.lastIndexOf('+'))
  return sign > 0 ? `${word.slice(0, sign)}e${word.slice(sign)}` : word
}
