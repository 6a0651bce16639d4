/** Lists of a file that is read beforehand: where they lie, and what is known of them beforehand. */
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { loadReadingCore } from '../../web/core/reading-core'
import { packedParts, unpackedPart } from '../../web/input/unpacking'
import type { Mesh } from '../../web/mesh/mesh'
import { listsIn, readMeshes } from '../../web/mesh/read-mesh'
import { type FileList, fileOfBytes, type MeshFile, type PackedBlocks, type UnpackedList } from '../../web/mesh/source'
import { practiceFile } from '../../web/survey/practice'
import { BLOCK, packedVtu } from './packed-vtu'

const bytes = new Uint8Array(await practiceFile(0.6).arrayBuffer())
const file = fileOfBytes('practice.vtu', bytes)
const core = await loadReadingCore(readFileSync(new URL('../../build/hexlens-reading.wasm', import.meta.url)))

/** By their bytes: millions of numbers. */
function areEqual(a: ArrayBufferView | undefined, b: ArrayBufferView | undefined): boolean {
  const of = (list: ArrayBufferView) => Buffer.from(list.buffer as ArrayBuffer, list.byteOffset, list.byteLength)
  return a !== undefined && b !== undefined && of(a).equals(of(b))
}

describe('a raw VTU', () => {
  const lists = listsIn(file)
  const [mesh] = readMeshes(file)

  test('says where its lists are, and what they most likely hold', () => {
    expect(lists.map(({ holds, isLong }) => ({ holds, isLong }))).toEqual([
      { holds: 'points', isLong: false },
      { holds: 'hexahedra', isLong: true },
      { holds: null, isLong: true },
    ])
    const [points, cells] = lists.map(({ from, to }) => bytes.slice(from, to).buffer)
    expect(areEqual(new Float64Array(points as ArrayBuffer), mesh?.points)).toBe(true)
    expect(areEqual(core.lowHalves(new Uint8Array(cells as ArrayBuffer)).list, mesh?.cells)).toBe(true)
  })

  test('says so from its beginning alone, where they follow each other', () => {
    const reads: number[] = []
    const counted: MeshFile = {
      ...file,
      read(from, to) {
        reads.push(to)
        return file.read(from, to)
      },
    }
    expect(listsIn(counted)).toEqual(lists)
    expect(Math.max(...reads)).toBeLessThanOrEqual(64 * 1024)
    expect(reads.length).toBeLessThanOrEqual(3)
  })

  test('says so from the lengths before them, where there is room between them', () => {
    const text = new TextDecoder('latin1').decode(bytes.subarray(0, 2000))
    const [, offset = ''] = /Name="types" format="appended" offset="(\d+)"/.exec(text) ?? []
    const moved = bytes.slice()
    moved.set(new TextEncoder().encode(String(Number(offset) + 8)), text.indexOf(offset, text.indexOf('"types"')))
    expect(listsIn(fileOfBytes('practice.vtu', moved))).toEqual(lists)
  })

  test('has an index that is none: it is told with its byte', () => {
    const { from } = lists[1] as FileList
    const bad = bytes.slice()
    new DataView(bad.buffer).setBigInt64(from + 8 * 40_000, -7n, true)
    expect(() => readMeshes(fileOfBytes('bad.vtu', bad))).toThrow(
      `bad.vtu, byte ${from + 8 * 40_000}: “connectivity” has -7 as its number 40000, counted from 0,`,
    )
  })

  test('is read the same with the halves that were taken beforehand, and without those that have more', () => {
    const taken = (isWhole: boolean): MeshFile => ({
      ...file,
      lowHalves(from, count) {
        const own = lists.find(list => list.from === from && list.isLong)
        if (!isWhole || !own || own.to - own.from !== 8 * count) return null
        const { list, parts } = core.lowHalves(bytes.subarray(own.from, own.to))
        const isOfEnds = own.holds === null
        return { list, greatest: list.reduce((a, b) => Math.max(a, b)), step: isOfEnds ? (parts[2] as number) : 0 }
      },
    })
    for (const isWhole of [true, false]) {
      const [other] = readMeshes(taken(isWhole))
      expect(areEqual(other?.points, mesh?.points) && areEqual(other?.cells, mesh?.cells)).toBe(true)
    }
  })

  test('is damaged: nothing is known beforehand', () => {
    for (const length of [40, 400, 700, 2_000_000]) {
      const known = listsIn(fileOfBytes('cut.vtu', bytes.subarray(0, length)))
      for (const { to } of known) expect(to).toBeLessThanOrEqual(length)
    }
    expect(listsIn(fileOfBytes('text.vtu', new TextEncoder().encode('<VTKFile type="ImageData">')))).toEqual([])
    expect(listsIn(fileOfBytes('text.inp', new TextEncoder().encode('*NODE\n1, 0, 0, 0\n')))).toEqual([])
  })
})

/** A list of the parts that were unpacked; null if one was damaged. */
function unpacked(bytes: Uint8Array, { to, isLong, packed }: FileList): UnpackedList | null {
  const blocks = packed as PackedBlocks
  const list = isLong ? new Uint32Array(blocks.bytes / 8) : new Float64Array(blocks.bytes / 8)
  for (const part of packedParts(blocks, isLong)) {
    const found = unpackedPart(bytes.slice(part.from, part.to).buffer as ArrayBuffer, part, core)
    if (found?.high !== 0) return null
    list.set(found.list, part.first)
  }
  return { list, to }
}

describe.each(['inline', 'appended'] as const)('a VTU in compressed blocks, %s', way => {
  const bytes = packedVtu(readMeshes(file)[0] as Mesh, way)
  const own = fileOfBytes('packed.vtu', bytes)
  const lists = listsIn(own)
  const [mesh] = readMeshes(file)
  const known = (from: number) => lists.find(list => list.from === from)

  test('says where its lists are', () => {
    expect(lists.map(({ holds, isLong, packed }) => ({ holds, isLong, blockSize: packed?.blockSize }))).toEqual([
      { holds: 'points', isLong: false, blockSize: BLOCK },
      { holds: 'hexahedra', isLong: true, blockSize: BLOCK },
      { holds: null, isLong: true, blockSize: BLOCK },
    ])
  })

  test('is read the same with the lists that were unpacked part by part', () => {
    let taken = 0
    const beforehand: MeshFile = {
      ...own,
      unpacked(from) {
        const list = known(from)
        taken += Number(list !== undefined)
        return list ? unpacked(bytes, list) : null
      },
    }
    const [other] = readMeshes(beforehand)
    expect(areEqual(other?.points, mesh?.points) && areEqual(other?.cells, mesh?.cells)).toBe(true)
    expect(taken).toBeGreaterThanOrEqual(3)
  })

  test('where a block is damaged its list is not taken, and the reader says so', () => {
    const { packed: blocks } = known(lists[1]?.from as number) as FileList
    const damaged = Uint8Array.from(bytes)
    const at = (blocks as PackedBlocks).from + 4000
    damaged[at] = damaged[at] === 65 ? 66 : 65
    expect(unpacked(damaged, lists[1] as FileList)).toBeNull()
    expect(unpacked(damaged, lists[0] as FileList)).not.toBeNull()
    const broken = fileOfBytes('packed.vtu', damaged)
    expect(() =>
      readMeshes({ ...broken, unpacked: from => (known(from) ? unpacked(damaged, known(from) as FileList) : null) }),
    ).toThrow(/packed\.vtu, byte \d+: “connectivity”/)
  })
})
