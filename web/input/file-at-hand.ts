/** A file whose bytes have been read before its reader asks for them: several slices at a time, which is faster than one after the other. */
import type { MeshFile } from '../mesh/source'
import { meshFileOf } from './file-reading'

/** Bytes of a slice, and slices under way. */
const SLICE = 32 * 1024 * 1024
const AT_ONCE = 3
/** Shorter files are read at once anyway; longer ones stay where they are and are read in parts. */
const SHORT = 1024 * 1024
const LONG = 1024 * 1024 * 1024

export interface FileAtHand extends MeshFile {
  /** Gives the memory back; from then on the file is read where it is. */
  close(): void
}

export async function fileAtHand(file: File, onProgress: (fraction: number) => void): Promise<FileAtHand> {
  const own = meshFileOf(file)
  if (file.size < SHORT || file.size > LONG) return { ...own, close: () => {} }
  const slices: Uint8Array<ArrayBuffer>[] = new Array(Math.ceil(file.size / SLICE))
  let [next, done] = [0, 0]
  async function readSlices(): Promise<void> {
    while (next < slices.length) {
      const at = next++
      slices[at] = new Uint8Array(await file.slice(at * SLICE, (at + 1) * SLICE).arrayBuffer())
      onProgress(++done / slices.length)
    }
  }
  await Promise.all(Array.from({ length: AT_ONCE }, readSlices))
  return {
    name: own.name,
    size: own.size,
    read(from, to, into) {
      if (slices.length === 0) return own.read(from, to, into)
      const first = Math.floor(from / SLICE)
      // A copy of one slice's bytes is made at once, of several in parts.
      if (!into && to <= (first + 1) * SLICE)
        return (slices[first] as Uint8Array).slice(from - first * SLICE, to - first * SLICE)
      const bytes = into ? into.subarray(0, to - from) : new Uint8Array(to - from)
      for (let at = first; at * SLICE < to; ++at) {
        const [begin, end] = [Math.max(from, at * SLICE), Math.min(to, (at + 1) * SLICE)]
        bytes.set((slices[at] as Uint8Array).subarray(begin - at * SLICE, end - at * SLICE), begin - from)
      }
      return bytes
    },
    close: () => slices.splice(0),
  }
}
