/** A large file that is read beforehand: what is known of its integers is what they are, whoever reads them. */
import { readFileSync } from 'node:fs'
import { beforeEach, describe, expect, test } from 'vitest'
import { loadReadingCore } from '../../web/core/reading-core'
import { fileAtHand, type PartReader } from '../../web/input/file-at-hand'
import { eachPiece, PIECE } from '../../web/input/pieces-of'
import { unpackedPart } from '../../web/input/unpacking'
import { vtu } from '../../web/mesh/formats/vtu'
import type { Mesh } from '../../web/mesh/mesh'
import { listsIn, readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { practiceFile } from '../../web/survey/practice'
import { ReadFile, stubFileReaderSync } from './read-blobs'

let reads: ReturnType<typeof stubFileReaderSync>
beforeEach(() => {
  reads = stubFileReaderSync()
})

const core = await loadReadingCore(readFileSync(new URL('../../build/hexlens-reading.wasm', import.meta.url)))
const plain = new Uint8Array(await practiceFile(0.6).arrayBuffer())
const [cells, ends] = listsIn(fileOfBytes('made.vtu', plain)).filter(({ isLong }) => isLong) as Place[] as [
  Place,
  Place,
]
const countOf = ({ from, to }: Place) => (to - from) / 8

interface Place {
  readonly from: number
  readonly to: number
}

/** The file with other integers in some places of a list. */
function changed({ from }: Place, others: Readonly<Record<number, bigint>>): Uint8Array<ArrayBuffer> {
  const own = plain.slice()
  const view = new DataView(own.buffer)
  for (const [i, value] of Object.entries(others)) view.setBigInt64(from + 8 * Number(i), value, true)
  return own
}

/** Millions of numbers are compared by these. */
function bytesOf({ buffer, byteOffset, byteLength }: ArrayBufferView): Buffer {
  return Buffer.from(buffer as ArrayBuffer, byteOffset, byteLength)
}

/** The greatest number and the step of the list, as the file at hand knows them. */
async function known(bytes: Uint8Array<ArrayBuffer>, place: Place, readers: readonly PartReader[] = []) {
  const file = await fileAtHand(new ReadFile(bytes), () => {}, core, { onCells() {}, readers })
  return file.lowHalves?.(place.from, countOf(place)) ?? null
}

const another: PartReader = {
  halve: (blob, onPiece) => eachPiece(blob, (bytes, at) => onPiece({ ...core.lowHalves(bytes), at })),
  unpack: async (blob, part) => unpackedPart(await blob.arrayBuffer(), part, core),
}
/** Fails behind its second piece. */
const failing: PartReader = {
  ...another,
  halve: (blob, onPiece) =>
    eachPiece(blob, (bytes, at) => {
      if (at > PIECE) throw new Error('It was ended.')
      onPiece({ ...core.lowHalves(bytes), at })
    }),
}
const crews: Readonly<Record<string, readonly PartReader[]>> = {
  alone: [],
  'with another reader': [another],
  'with one that fails': [failing],
}

describe.each(Object.entries(crews))('%s', (_, readers) => {
  test('the ends of cells have a step, their points a greatest', async () => {
    const ofEnds = await known(plain, ends, readers)
    expect([ofEnds?.step, ofEnds?.greatest, ofEnds?.list.length]).toEqual([8, 8 * 42 ** 3, 42 ** 3])
    expect(ofEnds?.list.every((own, i) => own === 8 * (i + 1))).toBe(true)
    const ofCells = await known(plain, cells, readers)
    expect([ofCells?.step, ofCells?.greatest]).toEqual([0, 43 ** 3 - 1])
  })

  test('it is read as without, and tells of cells as they come', async () => {
    const counts: number[] = []
    const progress: number[] = []
    const onCells = (points: Float64Array, own: { readonly list: Uint32Array }, count: number) => {
      expect(points.length).toBe(3 * 43 ** 3)
      expect(own.list.length).toBe(8 * 42 ** 3)
      counts.push(count)
    }
    const own = await fileAtHand(new ReadFile(plain), done => progress.push(done), core, { onCells, readers })
    const [mesh, expected] = [own, fileOfBytes('made.vtu', plain)].map(each => readMeshes(each)[0] as Mesh) as [
      Mesh,
      Mesh,
    ]
    for (const list of ['points', 'cells'] as const)
      expect(bytesOf(mesh[list]).equals(bytesOf(expected[list]))).toBe(true)
    expect(counts).toEqual(counts.toSorted((a, b) => a - b))
    expect([counts.at(-1), progress.at(-1)]).toEqual([42 ** 3, 1])
    expect(progress).toEqual(progress.toSorted((a, b) => a - b))
    own.close()
  })
})

test('what reads the mesh finds all of it at hand', async () => {
  const own = await fileAtHand(new ReadFile(plain), () => {}, core, { onCells() {}, readers: [another] })
  const before = reads.times
  const alone = { find: () => null, onProgress() {}, throwIfCancelled() {}, step: 0, core, hdf5: null }
  expect(vtu.read(own, alone)[0]?.cells.length).toBe(8 * 42 ** 3)
  expect(reads.times).toBe(before)
})

test('one end that is another, in each kind of place, leaves no step', async () => {
  // The first and the last of all, of a part and of a piece.
  const last = 42 ** 3 - 1
  for (const at of [0, 1, 2, 8191, 8192, 16_384, 40_000, last - 1, last]) {
    const own = await known(changed(ends, { [at]: BigInt(8 * (at + 1) + 1) }), ends)
    expect([at, own?.step]).toEqual([at, 0])
    expect(own?.list[at]).toBe(8 * (at + 1) + 1)
  }
})

test('steps that are the same in each part, but not from one to the next, are none', async () => {
  const others: Record<number, bigint> = {}
  for (let i = 8192; i < 42 ** 3; ++i) others[i] = BigInt(8 * (i + 2))
  expect((await known(changed(ends, others), ends))?.step).toBe(0)
})

test('an index from 2^31 on, or one with a high half, is not taken for a low half', async () => {
  for (const at of [0, 9000, 300_000, 8 * 42 ** 3 - 1]) {
    expect((await known(changed(cells, { [at]: 2n ** 31n - 1n }), cells))?.greatest).toBe(2 ** 31 - 1)
    for (const value of [2n ** 31n, 2n ** 32n - 1n, 2n ** 32n, -1n, 2n ** 63n - 1n])
      expect(await known(changed(cells, { [at]: value }), cells, [another])).toBeNull()
  }
})

test('without the core nothing is known beforehand, and the mesh is the same', async () => {
  const own = await fileAtHand(new ReadFile(plain), () => {}, null)
  expect(own.lowHalves?.(ends.from, countOf(ends)) ?? null).toBeNull()
  expect(readMeshes(own)[0]?.cells.length).toBe(8 * 42 ** 3)
})
