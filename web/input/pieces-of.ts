/** Bytes of a piece: what is done with them next finds them in a processor's cache. */
export const PIECE = 1024 * 1024

/** Bytes that are read at once where they cannot be read into memory that is there. */
const SLICE = 8 * PIECE

/**
 * Calls with the bytes of a file, piece after piece, and where they begin; all pieces but the last have `PIECE` bytes, or a multiple of them. Their
 * memory is the same each time where the browser can read into it: memory that nobody has touched before takes as long as the reading.
 */
export async function eachPiece(blob: Blob, take: (bytes: Uint8Array<ArrayBuffer>, at: number) => void): Promise<void> {
  const stream = blob.stream()
  const reader = readerInto(stream)
  if (!reader) {
    for (let at = 0; at < blob.size; at += SLICE) take(await bytesOf(blob.slice(at, at + SLICE)), at)
    return
  }
  const open = { stream, reader }
  held.add(open)
  try {
    let memory = new ArrayBuffer(Math.min(PIECE, blob.size))
    for (let at = 0; at < blob.size; at += PIECE) {
      const length = Math.min(PIECE, blob.size - at)
      for (let done = 0; done < length; ) {
        const { value } = await reader.read(new Uint8Array(memory, done, length - done))
        if (!value || value.length === 0) throw new DOMException(CHANGED, 'NotReadableError')
        memory = value.buffer
        done += value.length
      }
      take(new Uint8Array(memory, 0, length), at)
    }
  } finally {
    held.delete(open)
  }
}

/** What is being read. Browsers collect a stream that nothing but its own pending promise holds, and the promise with it. */
const held = new Set<{ readonly stream: ReadableStream; readonly reader: ReadableStreamBYOBReader }>()

const CHANGED = 'the file has become shorter while it was read.'

async function bytesOf(blob: Blob): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await blob.arrayBuffer())
}

/** Null where streams of files bring memory of their own. */
function readerInto(stream: ReadableStream): ReadableStreamBYOBReader | null {
  try {
    return stream.getReader({ mode: 'byob' })
  } catch {
    return null
  }
}
