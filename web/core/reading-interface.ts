/** Text and compressed blocks by wasm if it may run; else readers do the same themselves. */

/** The progress in the window. */
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
  /** Each real number's first byte from the rows' beginning, plus 2^24 times its length. */
  readonly places: Uint32Array
}

/** Integers of 64 bits in a file, little-endian, as their low halves. */
export interface LowHalves {
  readonly list: Uint32Array<ArrayBuffer>
  /** 0 if no high half is anything else. */
  readonly high: number
  /** Of each `PART` numbers, as integers with a sign: the least, the greatest, and the step from each to the next; 0 where that is not the same. */
  readonly parts: Int32Array<ArrayBuffer>
}

/** Numbers of a part, and what is known of each. */
export const PART = 8192
export const KNOWN_OF_PART = 3

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

  /** The low halves go into `list`, if that is given. */
  lowHalves(bytes: Uint8Array, list?: Uint32Array<ArrayBuffer>): LowHalves

  /** Fills `output` from a zlib stream that must have just so many bytes. False if it has not, is damaged, or is too long to be done here. */
  unzlib(input: Uint8Array, output: Uint8Array): boolean
}

/** The parts of a row; hl_rows in wasm/src/reading/text.h says what each is. */
const [LINE_END, COMMA, BLANKS, WHOLE, REAL, BYTES] = [0, 1, 2, 3, 4, 5] as const

export class RowPattern {
  readonly bytes: Uint8Array
  /** Numbers of each row. */
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
