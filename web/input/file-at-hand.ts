/**
 * A file whose bytes have been read before its reader asks for them: several slices at a time, which is faster than one after the other. A
 * list of numbers is a slice of its own, so that it is not copied; integers of 64 bits become their low halves slice by slice, while the
 * next ones are read.
 */
import type { ReadingCore } from '../core/reading-interface'
import { listsIn } from '../mesh/read-mesh'
import type { FileList, MeshFile, PackedBlocks, UnpackedList } from '../mesh/source'
import { meshFileOf } from './file-reading'
import { type LowHalves, lowHalves, PART } from './low-halves'
import { type PackedPart, packedParts, type UnpackedPart, unpackedPart } from './unpacking'

/** Bytes of a slice, and slices under way. */
const SLICE = 8 * 1024 * 1024
const AT_ONCE = 3
/** What another reader has under way: whoever hands it out may be busy. */
const AHEAD = 3
/** Shorter files are read at once anyway; longer ones stay where they are and are read in parts. */
const SHORT = 1024 * 1024
const LONG = 1024 * 1024 * 1024
/** Eight indices of 64 bits. */
const BYTES_OF_A_CELL = 64

export interface FileAtHand extends MeshFile {
  /** Gives the memory back; from then on the file is read where it is. */
  close(): void
}

interface Slice {
  readonly from: number
  readonly to: number
  /** Null before it is read, and once its bytes are somebody's, or were of no more use. */
  bytes: Uint8Array<ArrayBuffer> | null
  readonly halves: Halves | null
  isRead: boolean
}

/** The low halves of a list of integers of 64 bits. */
interface Halves {
  readonly from: number
  readonly list: Uint32Array<ArrayBuffer>
  readonly ranges: Int32Array<ArrayBuffer>
  /** 0 as long as no high half is anything else. */
  high: number
}

/** Called while the file is read with the points and the first so many of the cells that its reader may find there. */
export type OnCells = (points: Float64Array, cells: CellsInParts, count: number) => void

export interface CellsInParts {
  readonly list: Uint32Array
  /** The least and the greatest index of each `PART` of them. */
  readonly ranges: Int32Array
}

/** Somebody else who reads parts of a file; a promise that rejects is of one who does no more. */
export interface PartReader {
  /** Integers of 64 bits. */
  halve(bytes: Blob): Promise<LowHalves>
  /** Compressed blocks; null where they are damaged. */
  unpack(bytes: Blob, part: PackedPart): Promise<UnpackedPart | null>
}

export interface Beforehand {
  readonly onCells: OnCells
  readonly readers: readonly PartReader[]
}

export async function fileAtHand(
  file: File,
  onProgress: (fraction: number) => void,
  core: ReadingCore | null,
  { onCells, readers }: Beforehand = { onCells() {}, readers: [] },
): Promise<FileAtHand> {
  const own = meshFileOf(file)
  if (file.size < SHORT || file.size > LONG) return { ...own, close: () => {} }
  const lists = listsIn(own).filter(({ packed }) => packed === null || core !== null)
  const slices = slicesOf(lists, file.size)
  const unpacking = lists.flatMap(list => (list.packed ? [new Unpacking(list, list.packed)] : []))
  const [of, cells] = (['points', 'hexahedra'] as const).map(holds => lists.filter(list => list.holds === holds))
  /** Where there are points and hexahedra of one kind each. */
  const isTold = of?.length === 1 && cells?.length === 1 && unpacking.length === 0
  const told = isTold ? { points: of[0]?.from, cells: cells[0]?.from } : null
  let points: Float64Array | null = null
  let toldCells = 0
  let done = 0

  function tellOfCells(): void {
    const ofCells = slices.filter(slice => slice.halves?.from === told?.cells)
    const missing = ofCells.find(slice => !slice.isRead)
    const [{ halves, from }, end] = [ofCells[0] as Slice, missing?.from ?? ofCells.at(-1)?.to ?? 0]
    const known = Math.floor((end - from) / BYTES_OF_A_CELL)
    if (!points || !halves || halves.high !== 0 || known === toldCells) return
    toldCells = known
    onCells(points, halves, known)
  }
  const waiting = slices.filter(({ isRead }) => !isRead)
  const packed: Packed[] = unpacking.flatMap(each => each.parts.map(part => ({ each, part })))
  const total = waiting.length + packed.length

  function took(slice: Slice): void {
    slice.isRead = true
    onProgress(++done / total)
    if (told) tellOfCells()
  }

  async function read(slice: Slice): Promise<void> {
    const bytes = await bytesOf(slice).arrayBuffer()
    const { halves } = slice
    if (halves) put(lowHalves(bytes, partOf(slice, halves)), slice, halves)
    else slice.bytes = new Uint8Array(bytes)
    if (told && slice.from === told.points) points = new Float64Array(bytes)
    took(slice)
  }

  const bytesOf = ({ from, to }: { readonly from: number; readonly to: number }) => file.slice(from, to)

  async function readAll(): Promise<void> {
    for (let slice = waiting.shift(); slice; slice = waiting.shift()) await read(slice)
    for (let next = packed.shift(); next; next = packed.shift()) await unpackHere(next)
  }

  async function unpackHere({ each, part }: Packed): Promise<void> {
    each.put(part, unpackedPart(await bytesOf(part).arrayBuffer(), part, core as ReadingCore))
    onProgress(++done / total)
  }

  async function readElsewhere({ halve, unpack }: PartReader): Promise<void> {
    for (let next = packed.shift(); next; next = packed.shift()) {
      const { each, part } = next
      try {
        each.put(part, await unpack(bytesOf(part), part))
        onProgress(++done / total)
      } catch {
        return unpackHere(next)
      }
    }
    for (;;) {
      const at = waiting.findIndex(slice => slice.halves)
      const [slice] = at < 0 ? [] : waiting.splice(at, 1)
      if (!slice) return
      const halves = slice.halves as Halves
      try {
        const found = await halve(bytesOf(slice))
        partOf(slice, halves).set(found.list)
        put(found, slice, halves)
        took(slice)
      } catch {
        return read(slice)
      }
    }
  }

  await Promise.all([
    ...Array.from({ length: AT_ONCE }, readAll),
    ...readers.flatMap(reader => Array.from({ length: AHEAD }, () => readElsewhere(reader))),
  ])
  return {
    name: own.name,
    size: own.size,
    read(from, to, into) {
      const whole = into ? undefined : slices.find(slice => slice.from === from && slice.to === to)
      const { bytes = null } = whole ?? {}
      if (whole) whole.bytes = null
      return bytes ?? copyOf(slices, own, { from, to, into })
    },
    lowHalves(from, count) {
      const { halves } = slices.find(slice => slice.halves?.from === from) ?? {}
      if (halves?.high !== 0 || halves.list.length !== count) return null
      // Of those from 2^31 on the least is negative.
      const isSigned = halves.ranges.every(each => each >= 0)
      return isSigned ? { list: halves.list, greatest: halves.ranges.reduce((a, b) => Math.max(a, b), 0) } : null
    },
    unpacked: from => unpacking.find(each => each.from === from)?.found() ?? null,
    close() {
      slices.splice(0)
      unpacking.splice(0)
    },
  }
}

interface Packed {
  readonly each: Unpacking
  readonly part: PackedPart
}

/** A list of compressed blocks that is unpacked part by part. */
class Unpacking {
  readonly from: number
  readonly parts: readonly PackedPart[]
  readonly #list: UnpackedList
  #missing: number

  constructor({ from, to, isLong }: FileList, packed: PackedBlocks) {
    this.from = from
    this.parts = packedParts(packed, isLong)
    this.#missing = this.parts.length
    const count = packed.bytes / 8
    this.#list = { list: isLong ? new Uint32Array(count) : new Float64Array(count), to }
  }

  put({ first }: PackedPart, found: UnpackedPart | null): void {
    if (found?.high !== 0) return
    this.#list.list.set(found.list, first)
    this.#missing--
  }

  /** Null where a part was damaged, or an integer was greater. */
  found(): UnpackedList | null {
    return this.#missing === 0 ? this.#list : null
  }
}

/** All of a file: its lists, and what lies between them. */
function slicesOf(lists: readonly FileList[], size: number): Slice[] {
  const slices: Slice[] = []
  let at = 0
  const cutTo = (end: number, longest: number, halves: Halves | null) => {
    for (; at < end; at = Math.min(at + longest, end))
      slices.push({ from: at, to: Math.min(at + longest, end), bytes: null, halves, isRead: false })
  }
  for (const { from, to, isLong, packed } of lists.toSorted((a, b) => a.from - b.from)) {
    // Lists that overlap are a damaged file's.
    if (from < at) continue
    cutTo(from, SLICE, null)
    if (packed) {
      // Others read it.
      slices.push({ from, to, bytes: null, halves: null, isRead: true })
      at = to
      continue
    }
    const count = (to - from) / 8
    const ranges = new Int32Array(2 * Math.ceil(count / PART))
    if (isLong) cutTo(to, SLICE, { from, list: new Uint32Array(count), ranges, high: 0 })
    else cutTo(to, Infinity, null)
  }
  cutTo(size, SLICE, null)
  return slices
}

/** Slices are whole parts, but for the last. */
function put({ high, ranges }: LowHalves, { from }: Slice, halves: Halves): void {
  halves.high |= high
  halves.ranges.set(ranges, (2 * (from - halves.from)) / (8 * PART))
}

/** The numbers of a slice. */
function partOf({ from, to }: Slice, { from: first, list }: Halves): Uint32Array<ArrayBuffer> {
  return list.subarray((from - first) / 8, (to - first) / 8)
}

interface Wanted {
  readonly from: number
  readonly to: number
  readonly into: Uint8Array | undefined
}

/** What is not at hand is read once more. */
function copyOf(slices: readonly Slice[], own: MeshFile, { from, to, into }: Wanted): Uint8Array {
  const bytes = into ? into.subarray(0, to - from) : new Uint8Array(to - from)
  let at = from
  for (const slice of slices) {
    if (slice.to <= at || slice.from >= to) continue
    const end = Math.min(slice.to, to)
    const part = slice.bytes?.subarray(at - slice.from, end - slice.from) ?? own.read(at, end)
    bytes.set(part, at - from)
    at = end
  }
  return at < to ? own.read(from, to) : bytes
}
