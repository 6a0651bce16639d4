/**
 * Words of a file that are names, most of which end in a number, as N12: a long list of them is read without a string for each. What a name is
 * looked up by are its beginning and its number, so that N12 and N012 are the same.
 */
import { FileChunk } from './file-chunk'
import { IdIndex } from './id-index'
import type { MeshFile } from './source'

const CHUNK = 1024 * 1024
const [LF, BLANK, PERCENT, COMMA, ZERO, NINE] = [10, 32, 37, 44, 48, 57] as const
/** Numbers of more digits are no doubles. */
const MOST_DIGITS = 15
/** Beginnings of names that are looked through for each name. */
const MOST_STEMS = 4
const NOTHING = new Uint8Array(0)
const latin1 = new TextDecoder('latin1')

/** Words between blanks or commas; from "%" on a line is a comment. */
export class NameWords {
  readonly #file: MeshFile
  readonly #onChunk: (position: number) => void
  readonly #memory = new FileChunk()
  #bytes: Uint8Array = NOTHING
  #start: number
  #at = 0
  /** Of the word that was read last: where it begins and ends in `#bytes`, where its number begins, and the number. */
  #from = 0
  #to = 0
  #digits = 0
  #number = 0
  /** The first few beginnings that names had. */
  readonly #stems: { readonly bytes: Uint8Array; readonly text: string }[] = []

  constructor(file: MeshFile, from: number, onChunk: (position: number) => void) {
    this.#file = file
    this.#start = from
    this.#onChunk = onChunk
  }

  /** Behind the word. */
  get position(): number {
    return this.#start + this.#at
  }

  /** Reads the next word; false at the end of the file. */
  next(): boolean {
    for (;;) {
      const bytes = this.#bytes
      const { length } = bytes
      let at = this.#at
      while (at < length && ((bytes[at] as number) <= BLANK || bytes[at] === COMMA)) ++at
      if (bytes[at] === PERCENT) {
        const end = bytes.indexOf(LF, at)
        this.#at = end < 0 ? at : end + 1
        if (end < 0 && !this.#more()) return false
        continue
      }
      const from = at
      let digits = at
      let number = 0
      for (; at < length; ++at) {
        const byte = bytes[at] as number
        if (byte >= ZERO && byte <= NINE) number = 10 * number + byte - ZERO
        else if (byte <= BLANK || byte === COMMA || byte === PERCENT) break
        else {
          digits = at + 1
          number = 0
        }
      }
      this.#at = from
      if (at === length && this.#more()) continue
      if (at === from) return false
      this.#at = at
      this.#from = from
      this.#to = at
      this.#digits = digits
      this.#number = number
      return true
    }
  }

  /** Keeps what has not been passed; false if there is no more. */
  #more(): boolean {
    const from = this.#start + this.#bytes.length
    if (from >= this.#file.size) return false
    this.#onChunk(this.position)
    // A word or a comment that is longer than a chunk is read in chunks that grow with it.
    const kept = this.#bytes.subarray(this.#at)
    const more = Math.min(Math.max(CHUNK, kept.length), this.#file.size - from)
    this.#bytes = this.#memory.next(this.#file, kept, from, from + more)
    this.#start += this.#at
    this.#at = 0
    return true
  }

  text(): string {
    return latin1.decode(this.#bytes.subarray(this.#from, this.#to))
  }

  /** The number at the end of the word; -1 if there is none, or too long a one. */
  get number(): number {
    const digits = this.#to - this.#digits
    return digits === 0 || digits > MOST_DIGITS ? -1 : this.#number
  }

  /** What stands in front of the number: the same string as long as names have but a few beginnings. */
  get stem(): string {
    const length = this.#digits - this.#from
    for (const { bytes, text } of this.#stems) if (bytes.length === length && this.#beginsWith(bytes)) return text
    const bytes = this.#bytes.slice(this.#from, this.#digits)
    const text = latin1.decode(bytes)
    if (this.#stems.length < MOST_STEMS) this.#stems.push({ bytes, text })
    return text
  }

  #beginsWith(stem: Uint8Array): boolean {
    for (let i = 0; i < stem.length; ++i) if (this.#bytes[this.#from + i] !== stem[i]) return false
    return true
  }
}

/** An index for each name. */
export class NameIndex {
  readonly #byStem = new Map<string, IdIndex>()
  /** The one that was asked for last. */
  #stem: string | null = null
  #index = new IdIndex()
  readonly #others = new Map<string, number>()

  /** That of the word; -1 if it has none. */
  get(word: NameWords): number {
    const { number } = word
    if (number < 0) return this.#others.get(word.text()) ?? -1
    return this.numbers(word.stem).get(number)
  }

  set(word: NameWords, index: number): void {
    const { number } = word
    if (number < 0) this.#others.set(word.text(), index)
    else this.numbers(word.stem).set(number, index)
  }

  /** The indices of names with this beginning. */
  numbers(stem: string): IdIndex {
    if (stem === this.#stem) return this.#index
    this.#stem = stem
    this.#index = this.#byStem.get(stem) ?? new IdIndex()
    this.#byStem.set(stem, this.#index)
    return this.#index
  }
}
