/** Files that are read piece after piece. */
import { describe, expect, test } from 'vitest'
import { meshFileOf } from '../../web/input/file-reading'
import { eachPiece, PIECE } from '../../web/input/pieces-of'
import { ReadFile, stubFileReaderSync } from './read-blobs'

function bytesOf(length: number): Uint8Array<ArrayBuffer> {
  const own = new Uint8Array(length)
  for (let i = 0; i < length; ++i) own[i] = (i * 2654435761) >>> 13
  return own
}

/** The beginnings and lengths of pieces; their bytes are looked at as they come. */
async function piecesOf(blob: Blob, bytes: Uint8Array): Promise<{ at: number; length: number }[]> {
  const pieces: { at: number; length: number }[] = []
  await eachPiece(blob, (piece, at) => {
    expect(Buffer.compare(piece, bytes.subarray(at, at + piece.length))).toBe(0)
    pieces.push({ at, length: piece.length })
  })
  expect(pieces.reduce((end, { at, length }) => (at === end ? end + length : -1), 0)).toBe(bytes.length)
  return pieces
}

/** A blob whose stream has memory of its own, as where no browser reads into one's. */
class OwnMemory extends Blob {
  override stream(): never {
    const [bytes] = [this.arrayBuffer()]
    return new ReadableStream({
      async start(controller) {
        controller.enqueue(new Uint8Array(await bytes))
        controller.close()
      },
    }) as never
  }
}

/** A stream that reads into given memory, at most so many bytes at once, and ends at the end of its bytes. */
function streamOf(bytes: Uint8Array, most: number): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0
  return new ReadableStream({
    type: 'bytes',
    pull(controller) {
      const request = controller.byobRequest
      const view = request?.view as Uint8Array | undefined
      if (!request || !view) throw new Error('Nobody gave memory.')
      const part = bytes.subarray(at, at + Math.min(most, view.byteLength))
      at += part.length
      if (part.length === 0) controller.close()
      new Uint8Array(view.buffer, view.byteOffset, view.byteLength).set(part)
      request.respond(part.length)
    },
  })
}

class Streamed extends Blob {
  readonly of: () => ReadableStream

  constructor(bytes: Uint8Array<ArrayBuffer>, of: () => ReadableStream) {
    super([bytes])
    this.of = of
  }

  override stream(): never {
    return this.of() as never
  }
}

describe('pieces of a blob', () => {
  const sizes = [0, 1, 1000, PIECE - 1, PIECE, PIECE + 1, 3 * PIECE, 3 * PIECE + 77]
  const expected = (size: number, longest: number) =>
    Array.from({ length: Math.ceil(size / longest) }, (_, i) => ({
      at: longest * i,
      length: Math.min(longest, size - longest * i),
    }))

  test('of this engine', async () => {
    for (const size of sizes) {
      const bytes = bytesOf(size)
      const pieces = await piecesOf(new Blob([bytes]), bytes)
      for (const { length } of pieces.slice(0, -1)) expect(length % PIECE).toBe(0)
    }
  })

  test('whose stream reads into memory that is there, whole pieces or less at once', async () => {
    for (const size of sizes)
      for (const most of [Infinity, 300_001]) {
        const bytes = bytesOf(size)
        const blob = new Streamed(bytes, () => streamOf(bytes, most))
        expect(await piecesOf(blob, bytes)).toEqual(expected(size, PIECE))
      }
  })

  test('whose stream brings memory of its own', async () => {
    for (const size of [...sizes, 8 * PIECE + 5]) {
      const bytes = bytesOf(size)
      expect(await piecesOf(new OwnMemory([bytes]), bytes)).toEqual(expected(size, 8 * PIECE))
    }
  })

  test('that has become shorter is refused', async () => {
    const bytes = bytesOf(2 * PIECE)
    for (const left of [0, 5, PIECE, PIECE + 5, 2 * PIECE - 1]) {
      const blob = new Streamed(bytes, () => streamOf(bytes.subarray(0, left), Infinity))
      let taken = 0
      await expect(eachPiece(blob, piece => (taken += piece.length))).rejects.toThrow('shorter')
      expect(taken).toBe(PIECE * Math.floor(left / PIECE))
    }
  })

  test('what is thrown in between, by the file or by whoever takes pieces, is handed on', async () => {
    const broken = () =>
      new ReadableStream({
        type: 'bytes',
        pull(controller) {
          controller.error(new Error('The disk is gone.'))
        },
      })
    await expect(eachPiece(new Streamed(bytesOf(10), broken), () => {})).rejects.toThrow('The disk is gone.')
    const bytes = bytesOf(2 * PIECE)
    const refuse = () => {
      throw new Error('No more.')
    }
    await expect(eachPiece(new Streamed(bytes, () => streamOf(bytes, Infinity)), refuse)).rejects.toThrow('No more.')
  })
})

describe('a file that is read at once', () => {
  const HEAD = 64 * 1024

  test('its head is read once, the rest each time', () => {
    const read = stubFileReaderSync()
    const bytes = bytesOf(3 * HEAD)
    const { read: own } = meshFileOf(new ReadFile(bytes))
    const stretches = [
      [0, 8],
      [0, HEAD],
      [HEAD - 1, HEAD],
      [5, 5],
      [100, 1000],
    ] as const
    for (const [from, to] of stretches) expect([...own(from, to)]).toEqual([...bytes.subarray(from, to)])
    expect(read).toEqual({ times: 1, bytes: HEAD })
    for (const [from, to] of [
      [0, HEAD + 1],
      [HEAD, HEAD + 5],
      [HEAD - 2, 2 * HEAD],
      [2 * HEAD, 3 * HEAD],
    ] as const)
      expect([...own(from, to)]).toEqual([...bytes.subarray(from, to)])
    expect(read.times).toBe(5)
  })

  test('what is done with its bytes changes no other reader’s', () => {
    stubFileReaderSync()
    const bytes = bytesOf(100)
    const { read, size } = meshFileOf(new ReadFile(bytes))
    expect(size).toBe(100)
    read(0, 100).fill(0)
    expect([...read(0, 100)]).toEqual([...bytes])
  })

  test('a short file ends where it does', () => {
    stubFileReaderSync()
    for (const size of [0, 10]) {
      const bytes = bytesOf(size)
      const { read } = meshFileOf(new ReadFile(bytes))
      expect([...read(0, 1000)]).toEqual([...bytes])
      expect([...read(size, size + 10)]).toEqual([])
    }
  })
})
