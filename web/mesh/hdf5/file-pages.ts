/** Small reads of a file by pages that are kept: the library reads its tables in pieces of a few bytes. */
import type { MeshFile } from '../source'

const PAGE = 65_536
const MOST_PAGES = 64

export class FilePages {
  readonly #file: MeshFile
  /** By number; the one used last comes last. */
  readonly #pages = new Map<number, Uint8Array>()

  constructor(file: MeshFile) {
    this.#file = file
  }

  /** Fills `into` with the bytes from `from` on, which must be there. */
  read(from: number, into: Uint8Array): void {
    if (into.length >= PAGE) {
      into.set(this.#file.read(from, from + into.length))
      return
    }
    for (let done = 0; done < into.length; ) {
      const at = from + done
      const number = Math.floor(at / PAGE)
      const page = this.#page(number)
      const piece = page.subarray(at - PAGE * number, at - PAGE * number + into.length - done)
      into.set(piece, done)
      done += piece.length
    }
  }

  #page(number: number): Uint8Array {
    const kept = this.#pages.get(number)
    if (kept) this.#pages.delete(number)
    const page = kept ?? this.#file.read(PAGE * number, Math.min(PAGE * (number + 1), this.#file.size))
    this.#pages.set(number, page)
    if (this.#pages.size > MOST_PAGES) this.#pages.delete(this.#pages.keys().next().value as number)
    return page
  }
}
