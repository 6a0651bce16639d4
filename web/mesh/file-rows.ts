/** Rows of numbers in a file, taken by wasm ahead of the records that readers go through. */
import type { ReadingCore, RowPattern, TakenRows } from '../core/reading-interface'

/** Rows with where they lie. */
export interface FileRows extends TakenRows {
  readonly pattern: RowPattern
  /** The byte of the file at which they begin, from which `places` count. */
  readonly start: number
  /** The line of the file in which they begin. */
  readonly line: number
  /** The most rows from here on, if the others are as long. */
  readonly ahead: number
}

/** The rows ahead of those that begin at byte `start` of a file of `size` bytes. */
export function rowsAhead({ count, bytes }: TakenRows, start: number, size: number): number {
  return Math.ceil(((size - start) / bytes) * count)
}

const FEWEST_BYTES = 2048
const MOST_BYTES = 1024 * 1024
/** Records that are read without looking for rows, if they were none before. */
const MOST_PASSED = 63

/** Looks ahead for rows: farther each time they were there, and seldom if they were not. */
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
