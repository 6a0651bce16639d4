/**
 * Small reads of a file by pages that are kept: the library reads its tables in pieces of a few bytes. Heaps of strings in them are looked through:
 * the library reads one for ever in which an object has no size.
 */
import type { MeshFile } from '../source'

const PAGE = 65_536
const MOST_PAGES = 64
/** A global heap: "GCOL" and version 1, its size, then objects, each with a header. They stand at multiples of eight bytes. */
const HEAP = [0x47, 0x43, 0x4f, 0x4c, 1, 0, 0, 0] as const
const HEADER = 16
const MOST_HEAP = 2 ** 31

/** A part of the file that would not be read to an end. */
export class EndlessPart extends Error {}

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
    const page = kept ?? this.#checkedPage(PAGE * number)
    this.#pages.set(number, page)
    if (this.#pages.size > MOST_PAGES) this.#pages.delete(this.#pages.keys().next().value as number)
    return page
  }

  #checkedPage(from: number): Uint8Array {
    const page = this.#file.read(from, Math.min(from + PAGE, this.#file.size))
    for (let at = 0; at + HEADER <= page.length; at += 8)
      if (page[at] === HEAP[0] && HEAP.every((byte, i) => page[at + i] === byte)) this.#checkHeap(from + at)
    return page
  }

  /** One object after the other: the number 0 says that what is left is free. */
  #checkHeap(from: number): void {
    const size = longAt(this.#file.read(from, from + HEADER), 8)
    if (!(size >= HEADER && size <= MOST_HEAP && from + size <= this.#file.size)) return
    const heap = this.#file.read(from, from + size)
    for (let at = HEADER; at + HEADER <= size; ) {
      const isFree = heap[at] === 0 && heap[at + 1] === 0
      const own = longAt(heap, at + 8)
      const step = isFree ? own : HEADER + 8 * Math.ceil(own / 8)
      if (step < HEADER) throw new EndlessPart(`the heap at byte ${from} has an object without a size`)
      at += step
    }
  }
}

/** A whole number of 64 bits. */
function longAt(bytes: Uint8Array, at: number): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset + at, 8)
  return view.getUint32(0, true) + 2 ** 32 * view.getUint32(4, true)
}
