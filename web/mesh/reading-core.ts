/** What readers have done by wasm where it may run: the slow parts of text and of compressed blocks. Without it they do the same themselves. */

/** How far it came. */
export interface Taken {
  /** Numbers, or rows. */
  readonly count: number
  /** Bytes from where it began to behind the last of them. */
  readonly bytes: number
  /** Significant digits of real numbers, in runs those with a point or an exponent: the most, and the most of one that is no double. */
  readonly mostDigits: number
  readonly mostRounded: number
}

/** Rows in lists that hold until the next call. */
export interface TakenRows extends Taken {
  /** The numbers of all rows, one row after the other. */
  readonly numbers: Float64Array
  /** Of each real number of all rows: its first byte from where the rows begin, and times 2^24 how many it has. */
  readonly places: Uint32Array
}

export interface ReadingCore {
  /**
   * Fills `list` from `from` to `to` with numbers between blanks from byte `at` on; ends before a word that begins at `limit` or later, and before
   * the first that is no plain number: an infinity, or one of more than a thousand bytes.
   */
  numbers(bytes: Uint8Array, at: number, limit: number, list: Float64Array, from: number, to: number): Taken

  /** The same with whole numbers in digits alone that fit the list. */
  indices(bytes: Uint8Array, at: number, limit: number, list: Uint32Array | Uint8Array, from: number, to: number): Taken

  /** Rows of a pattern from byte `at` on that are whole before byte `end`; ends before the first that does not fit. Not all need be taken at once. */
  rows(bytes: Uint8Array, at: number, end: number, pattern: RowPattern): TakenRows

  /** Fills `output` from a zlib stream that must have just so many bytes. False if it has not, is damaged, or is too long to be done here. */
  unzlib(input: Uint8Array, output: Uint8Array): boolean
}

/** The parts of a row; hl_rows in wasm/src/reading/text.h says what each is. */
const [LINE_END, COMMA, BLANKS, WHOLE, REAL, BYTES] = [0, 1, 2, 3, 4, 5] as const

export class RowPattern {
  readonly bytes: Uint8Array
  /** Of each row. */
  readonly numberCount: number
  readonly realCount: number
  readonly lineCount: number

  /**
   * Parts: "end" of the line, ","; "whole" and "real" numbers, each with the width of its columns or, between blanks or commas, none; "blank8",
   * so many columns; and what begins with "=": the bytes behind it.
   */
  constructor(rowParts: readonly string[]) {
    const bytes: number[] = []
    let [wholes, reals, lines] = [0, 0, 0]
    for (const part of rowParts) {
      if (part.startsWith('=')) {
        bytes.push(BYTES, part.length - 1, ...new TextEncoder().encode(part.slice(1)))
        continue
      }
      const [, name = '', digits = ''] = /^(\D+)(\d*)$/.exec(part) ?? []
      const width = Number(digits)
      if (name === 'end') {
        bytes.push(LINE_END)
        lines++
      } else if (name === ',') bytes.push(COMMA)
      else if (name === 'blank') bytes.push(BLANKS, width)
      else if (name === 'whole') {
        bytes.push(WHOLE, width)
        wholes++
      } else {
        bytes.push(REAL, width)
        reals++
      }
    }
    this.bytes = Uint8Array.from(bytes)
    this.numberCount = wholes + reals
    this.realCount = reals
    this.lineCount = lines
  }
}

/** Rows with where they lie. */
export interface FileRows extends TakenRows {
  readonly pattern: RowPattern
  /** The byte of the file at which they begin, from which `places` count. */
  readonly start: number
  /** The line of the file in which they begin. */
  readonly line: number
  /** So many rows the file has at most from here on, if the others are as long. */
  readonly ahead: number
}

/** Of rows that begin at byte `start` of a file of `size` bytes. */
export function rowsAhead({ count, bytes }: TakenRows, start: number, size: number): number {
  return Math.ceil(((size - start) / bytes) * count)
}

/** Where in the file the real number of this index begins, and how many bytes it has. */
export function placeOfReal({ start, places }: FileRows, index: number): readonly [from: number, length: number] {
  const place = places[index] as number
  return [start + (place & 0xffffff), place >>> 24]
}

const FEWEST_BYTES = 2048
const MOST_BYTES = 1024 * 1024
/** So many records are read without looking for rows, if they were none before. */
const MOST_PASSED = 63

/** How far ahead it is worth to look for rows: farther each time they were there, and seldom where they were not. */
export class RowSearch {
  readonly #core: ReadingCore | null
  #bytes = FEWEST_BYTES
  #passed = 0
  #left = 0

  constructor(core: ReadingCore | null) {
    this.#core = core
  }

  /** Rows of the pattern from byte `at` on; null if there are none, or it is not worth to look. */
  rows(bytes: Uint8Array, at: number, pattern: RowPattern): TakenRows | null {
    if (this.#core === null || this.#left-- > 0) return null
    const taken = this.#core.rows(bytes, at, Math.min(bytes.length, at + this.#bytes), pattern)
    if (taken.count === 0) {
      this.#bytes = FEWEST_BYTES
      this.#passed = Math.min(2 * this.#passed + 1, MOST_PASSED)
      this.#left = this.#passed
      return null
    }
    this.#bytes = Math.min(2 * this.#bytes, MOST_BYTES)
    this.#passed = 0
    this.#left = 0
    return taken
  }
}
