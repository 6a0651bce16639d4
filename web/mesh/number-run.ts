/**
 * Long runs of numbers in a text file, straight from its bytes into typed arrays: linear in time, constant in memory. A run ends, without
 * an error, before the first word that does not fit; who asked knows what was expected there.
 */

import type { ReadingCore } from '../core/reading-interface'
import { doubleOfDigits, POWERS_OF_TEN } from './decimal'
import { FileChunk } from './file-chunk'
import type { MeshFile } from './source'
import { numberOf } from './text-cursor'

const CHUNK = 1024 * 1024
/** Short runs read no more than they need; each chunk is twice as long as the one before. */
const FIRST_CHUNK = 4096
/** A number is no longer than this. */
const LONGEST_NUMBER = 1024

const [TAB, LF, CR, SPACE, PLUS, MINUS, DOT, ZERO, NINE] = [9, 10, 13, 32, 43, 45, 46, 48, 57] as const
const [LETTER_D, LETTER_E] = [100, 101] as const

export class NumberRun {
  readonly #file: MeshFile
  readonly #to: number
  readonly #core: ReadingCore | null
  readonly #onProgress: (position: number) => void
  #bytes: Uint8Array = new Uint8Array(0)
  readonly #memory = new FileChunk()
  /** The position of `#bytes` in the file. */
  #start: number
  #at = 0
  #chunk = FIRST_CHUNK
  /** The most significant digits with which a number with a point or an exponent is written. */
  mostDigits = 0

  /** Numbers in bytes [from, to) of the file; `onProgress` is called now and then with the byte that is next, and may throw. */
  constructor(
    file: MeshFile,
    from: number,
    to: number,
    core: ReadingCore | null,
    onProgress: (position: number) => void = () => {},
  ) {
    this.#file = file
    this.#start = from
    this.#to = to
    this.#core = core
    this.#onProgress = onProgress
  }

  /** The byte of the file that is next. */
  get position(): number {
    return this.#start + this.#at
  }

  /** Passes blanks; true if only they were left. */
  isAtEnd(): boolean {
    do {
      this.#at = afterBlanks(this.#bytes, this.#at)
      if (this.#at < this.#bytes.length) return false
    } while (this.#fill())
    return true
  }

  /** The next word, cut where it is longer than a number; it is not passed. '' at the end. */
  nextWord(): string {
    if (this.isAtEnd()) return ''
    this.#fill()
    return wordAt(this.#bytes, this.#at)
  }

  /** True if there was more to read. */
  #fill(): boolean {
    const had = this.#bytes.length - this.#at
    const from = this.#start + this.#bytes.length
    const more = Math.min(this.#chunk, this.#to - from)
    if (had > LONGEST_NUMBER || more <= 0) return false
    this.#onProgress(this.position)
    this.#chunk = Math.min(CHUNK, 2 * this.#chunk)
    this.#bytes = this.#memory.next(this.#file, this.#bytes.subarray(this.#at), from, from + more)
    this.#start += this.#at
    if (had === 0) this.#start = from
    this.#at = 0
    return true
  }

  /** Fills `list` from `from` to `to`; returns how far it came. */
  numbers(list: Float64Array, from: number, to: number): number {
    let i = from
    while (i < to) {
      this.#fill()
      const limit = this.#safeLimit()
      const before = i
      i = this.#core === null ? this.#numbersUpTo(limit, list, i, to) : this.#numbersBy(this.#core, limit, list, i, to)
      if (i === before && !this.#fill()) break
    }
    return i
  }

  /** Words that begin before this byte of the chunk are whole in it. */
  #safeLimit(): number {
    const { length } = this.#bytes
    return this.#start + length >= this.#to ? length : length - LONGEST_NUMBER
  }

  /** The word at which the core stops may be a number that it does not know. */
  #numbersBy(core: ReadingCore, limit: number, list: Float64Array, from: number, to: number): number {
    const { count, bytes, mostDigits } = core.numbers(this.#bytes, this.#at, limit, list, from, to)
    this.#at += bytes
    this.mostDigits = Math.max(this.mostDigits, mostDigits)
    const next = from + count
    return this.#numbersUpTo(limit, list, next, Math.min(to, next + 1))
  }

  #numbersUpTo(limit: number, list: Float64Array, from: number, to: number): number {
    const bytes = this.#bytes
    let at = this.#at
    let mostDigits = this.mostDigits
    let i = from
    for (; i < to; ++i) {
      at = afterBlanks(bytes, at)
      if (at >= limit) break
      const begin = at
      let byte = bytes[at] as number
      const isNegative = byte === MINUS
      if (isNegative || byte === PLUS) byte = bytes[++at] as number
      const firstDigit = at
      let mantissa = 0
      while (byte >= ZERO && byte <= NINE) {
        mantissa = 10 * mantissa + (byte - ZERO)
        byte = bytes[++at] as number
      }
      let digits = at - firstDigit
      let power = 0
      const isWhole = byte !== DOT
      if (!isWhole) {
        const point = at
        byte = bytes[++at] as number
        while (byte >= ZERO && byte <= NINE) {
          mantissa = 10 * mantissa + (byte - ZERO)
          byte = bytes[++at] as number
        }
        power = point + 1 - at
        digits -= power
      }
      let isNumber = digits > 0
      let isPrinted = !isWhole
      if ((byte | 32) === LETTER_E || (byte | 32) === LETTER_D) {
        isPrinted = true
        byte = bytes[++at] as number
        const isDown = byte === MINUS
        if (isDown || byte === PLUS) byte = bytes[++at] as number
        const firstOfExponent = at
        let exponent = 0
        while (byte >= ZERO && byte <= NINE) {
          if (exponent < 100_000) exponent = 10 * exponent + (byte - ZERO)
          byte = bytes[++at] as number
        }
        if (at === firstOfExponent) isNumber = false
        power += isDown ? -exponent : exponent
      }
      if (isPrinted && digits > mostDigits) {
        const significant = significantDigits(bytes, firstDigit, at)
        if (significant > mostDigits) mostDigits = significant
      }
      // Below 2^53 the mantissa is exact, and one operation with an exact power of ten rounds correctly.
      if (isNumber && mantissa <= 2 ** 53 && power >= -22 && power <= 22 && !(byte > SPACE)) {
        const value =
          power < 0 ? mantissa / (POWERS_OF_TEN[-power] as number) : mantissa * (POWERS_OF_TEN[power] as number)
        list[i] = isNegative ? -value : value
        continue
      }
      if (isNumber && !(byte > SPACE)) {
        const value = doubleOfDigits(bytes, firstDigit, at, power)
        if (!Number.isNaN(value)) {
          list[i] = isNegative ? -value : value
          continue
        }
      }
      const word = wordAt(bytes, begin)
      const value = word.length < LONGEST_NUMBER ? numberOf(word) : null
      at = begin
      if (value === null) break
      list[i] = value
      at += word.length
    }
    this.#at = at
    this.mostDigits = mostDigits
    return i
  }

  /** Fills `list` with whole numbers below 2^32, written in digits alone, from `from` to `to`; returns how far it came. */
  indices(list: Uint32Array | Uint8Array, from: number, to: number): number {
    const most = list instanceof Uint8Array ? 255 : 0xffffffff
    let i = from
    while (i < to) {
      this.#fill()
      const limit = this.#safeLimit()
      const before = i
      const bytes = this.#bytes
      if (this.#core !== null) {
        const { count, bytes: used } = this.#core.indices(bytes, this.#at, limit, list, i, to)
        this.#at += used
        i += count
      }
      let at = this.#at
      for (; i < to; ++i) {
        at = afterBlanks(bytes, at)
        if (at >= limit) break
        const begin = at
        let value = 0
        let byte = bytes[at] as number
        while (byte >= ZERO && byte <= NINE) {
          value = 10 * value + (byte - ZERO)
          byte = bytes[++at] as number
        }
        if (at === begin || byte > SPACE || value > most) {
          at = begin
          break
        }
        list[i] = value
      }
      this.#at = at
      if (i === before && !this.#fill()) break
    }
    return i
  }
}

function afterBlanks(bytes: Uint8Array, at: number): number {
  for (let byte = bytes[at]; byte === SPACE || byte === LF || byte === CR || byte === TAB; ) byte = bytes[++at]
  return at
}

function wordAt(bytes: Uint8Array, at: number): string {
  let end = at
  while (end < bytes.length && (bytes[end] as number) > SPACE && end - at < LONGEST_NUMBER) end++
  return String.fromCharCode(...bytes.subarray(at, end))
}

/** The number of digits without zeros in front. */
function significantDigits(bytes: Uint8Array, from: number, to: number): number {
  let digits = 0
  for (let at = from; at < to; ++at) {
    const byte = bytes[at] as number
    if (byte === DOT) continue
    if (byte < ZERO || byte > NINE) break
    if (digits > 0 || byte !== ZERO) digits++
  }
  return digits
}

/** The line, from 1, in which a byte of the file lies. */
export function lineAt(file: MeshFile, position: number): number {
  let line = 1
  for (let from = 0; from < position; from += CHUNK) {
    const bytes = file.read(from, Math.min(position, from + CHUNK))
    for (let at = bytes.indexOf(LF); at >= 0; at = bytes.indexOf(LF, at + 1)) line++
  }
  return line
}
