/** Files of a browser as the readers of web/mesh see them: read by slices, at once, which only workers can. */
import type { MeshFile } from '../mesh/source'

/** Workers alone have it, and the types of a page do not. */
declare class FileReaderSync {
  readAsArrayBuffer(blob: Blob): ArrayBuffer
}

/** Bytes that many look at, and those of a short reading, which is done again: each takes a millisecond. */
const HEAD = 64 * 1024
const SHORT = 64
/** More are not kept. */
const MOST_SHORT = 256

export function meshFileOf(file: File): MeshFile {
  const reader = new FileReaderSync()
  const read = (from: number, to: number) => new Uint8Array(reader.readAsArrayBuffer(file.slice(from, to)))
  let head: Uint8Array | null = null
  const short = new Map<number, Uint8Array>()
  return {
    name: file.name,
    size: file.size,
    read(from, to) {
      if (to <= HEAD) {
        head ??= read(0, HEAD)
        return head.slice(from, to)
      }
      const known = short.get(from)
      if (known && known.length >= to - from) return known.slice(0, to - from)
      const bytes = read(from, to)
      if (to - from <= SHORT && short.size < MOST_SHORT) short.set(from, bytes.slice())
      return bytes
    },
  }
}
