/**
 * A file whose bytes have been read before its reader asks for them: several slices at a time, which is faster than one after the other. A
 * list of numbers is a slice of its own, so that it is not copied; integers of 64 bits become their low halves slice by slice, while the
 * next ones are read.
 */
import { KNOWN_OF_PART, type LowHalves, PART, type ReadingCore } from '../core/reading-interface'
import { listsIn } from '../mesh/read-mesh'
import type { FileList, KnownIndices, MeshFile, PackedBlocks, UnpackedList } from '../mesh/source'
import { meshFileOf } from './file-reading'
import { eachPiece, PIECE } from './pieces-of'
import { type PackedPart, packedParts, type UnpackedPart, unpackedPart } from './unpacking'

/** Bytes of a slice, of a list at least, and slices under way. */
const SLICE = 16 * PIECE
const AT_ONCE = 2
/** What another reader has under way: whoever hands it out may be busy. */
const AHEAD = 2
/** Shorter files are read at once anyway; longer ones stay where they are and are read in parts. */
const SHORT = 1024 * 1024
const LONG = 1024 * 1024 * 1024
/** Bytes between two lists, such as the length of one: they are read at once with all others. More are left to whoever asks for them. */
const LITTLE = 1024
const MOST_LITTLE = 64
/** Eight indices of 64 bits. */
const BYTES_OF_A_CELL = 64

export interface FileAtHand extends MeshFile {
  /** Gives the memory back; from then on the file is read where it is. */
  close(): void
}

/** Bytes of the file. */
interface Stretch {
  readonly from: number
  readonly to: number
}

interface Slice extends Stretch {
  /** Null before it is read, and once its bytes are somebody's, or were of no more use. */
  bytes: Uint8Array<ArrayBuffer> | null
  readonly halves: Halves | null
  /** Its bytes before that one are read. */
  readTo: number
}

/** The low halves of a list of integers of 64 bits. */
interface Halves {
  readonly from: number
  readonly list: Uint32Array<ArrayBuffer>
  /** As of LowHalves. */
  readonly parts: Int32Array<ArrayBuffer>
  /** 0 as long as no high half is anything else. */
  high: number
}

/** Called while the file is read with the points and the first so many of the cells that its reader may find there. */
export type OnCells = (points: Float64Array, cells: CellsInParts, count: number) => void

export interface HalvesOfPiece extends LowHalves {
  /** Bytes before them. */
  readonly at: number
}

export interface CellsInParts {
  readonly list: Uint32Array
  /** As of LowHalves. */
  readonly parts: Int32Array
}

/** Somebody else who reads parts of a file; a promise that rejects is of one who does no more. */
export interface PartReader {
  /** Integers of 64 bits, piece after piece, whose lists hold until the next one. */
  halve(bytes: Blob, onPiece: (piece: HalvesOfPiece) => void): Promise<unknown>
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
  const lists = listsIn(own).filter(({ packed, isLong }) => core !== null || (packed === null && !isLong))
  const slices = slicesOf(lists, file.size, 1 + readers.length)
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
    const missing = ofCells.find(({ readTo, to }) => readTo < to)
    const [{ halves, from }, end] = [ofCells[0] as Slice, missing?.readTo ?? ofCells.at(-1)?.to ?? 0]
    const known = Math.floor((end - from) / BYTES_OF_A_CELL)
    if (!points || !halves || halves.high !== 0 || known === toldCells) return
    toldCells = known
    onCells(points, halves, known)
  }
  const unread = slices.filter(({ readTo, to }) => readTo < to)
  const little = unread.filter(isLittle)
  const waiting = unread.filter(slice => !isLittle(slice))
  const packed: Packed[] = unpacking.flatMap(each => each.parts.map(part => ({ each, part })))
  const total = [...unread, ...packed.map(({ part }) => part)].reduce((sum, { from, to }) => sum + to - from, 0)

  function took(bytes: number): void {
    done += bytes
    onProgress(done / total)
  }

  function tookOf(slice: Slice, to: number): void {
    // Another reader may have failed behind it.
    if (to <= slice.readTo) return
    took(to - slice.readTo)
    slice.readTo = to
    if (told) tellOfCells()
  }

  async function read(slice: Slice): Promise<void> {
    const { halves, from, to } = slice
    if (halves) {
      await eachPiece(bytesOf(slice), (bytes, at) => {
        const own = { from: from + at, to: from + at + bytes.length }
        put((core as ReadingCore).lowHalves(bytes, partOf(own, halves)), own, halves)
        tookOf(slice, own.to)
      })
      return
    }
    const bytes = await bytesOf(slice).arrayBuffer()
    slice.bytes = new Uint8Array(bytes)
    if (told && from === told.points) points = new Float64Array(bytes)
    tookOf(slice, to)
  }

  const bytesOf = ({ from, to }: Stretch) => file.slice(from, to)

  async function readAll(): Promise<void> {
    for (let slice = waiting.shift(); slice; slice = waiting.shift()) await read(slice)
    for (let next = packed.shift(); next; next = packed.shift()) await unpackHere(next)
  }

  async function unpackHere({ each, part }: Packed): Promise<void> {
    each.put(part, unpackedPart(await bytesOf(part).arrayBuffer(), part, core as ReadingCore))
    took(part.to - part.from)
  }

  async function readElsewhere({ halve, unpack }: PartReader): Promise<void> {
    for (let next = packed.shift(); next; next = packed.shift()) {
      const { each, part } = next
      try {
        each.put(part, await unpack(bytesOf(part), part))
        took(part.to - part.from)
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
        await halve(bytesOf(slice), piece => {
          const from = slice.from + piece.at
          const own = { from, to: from + 8 * piece.list.length }
          partOf(own, halves).set(piece.list)
          put(piece, own, halves)
          tookOf(slice, own.to)
        })
      } catch {
        return read(slice)
      }
    }
  }

  await Promise.all([
    ...little.map(read),
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
      return halves?.high === 0 && halves.list.length === count ? knownIndices(halves) : null
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
function slicesOf(lists: readonly FileList[], size: number, readerCount: number): Slice[] {
  const slices: Slice[] = []
  let at = 0
  const cutTo = (end: number, longest: (left: number) => number, halves: Halves | null) => {
    while (at < end) {
      const to = Math.min(at + longest(end - at), end)
      slices.push({ from: at, to, bytes: null, halves, readTo: at })
      at = to
    }
  }
  // What is left is shared out: long at first, as each takes a while to begin, and short in the end.
  const share = (left: number) => Math.max(SLICE, PIECE * Math.ceil(left / readerCount / PIECE))
  for (const { from, to, isLong, packed } of lists.toSorted((a, b) => a.from - b.from)) {
    // Lists that overlap are a damaged file's.
    if (from < at) continue
    cutTo(from, () => SLICE, null)
    if (packed) {
      // Others read it.
      slices.push({ from, to, bytes: null, halves: null, readTo: to })
      at = to
      continue
    }
    const count = (to - from) / 8
    const parts = new Int32Array(KNOWN_OF_PART * Math.ceil(count / PART))
    if (isLong) cutTo(to, share, { from, list: new Uint32Array(count), parts, high: 0 })
    else cutTo(to, left => left, null)
  }
  cutTo(size, () => SLICE, null)
  for (const slice of slices.filter(isLittle).slice(MOST_LITTLE)) slice.readTo = slice.to
  return slices
}

const isLittle = ({ from, to }: Stretch) => to - from < LITTLE

/** Of a piece; pieces are whole parts, but for the last of a list. */
function put({ high, parts }: LowHalves, { from }: Stretch, halves: Halves): void {
  halves.high |= high
  halves.parts.set(parts, (KNOWN_OF_PART * (from - halves.from)) / (8 * PART))
}

/** The list with its greatest number and its step; null where a number has 2^31 or more. */
function knownIndices({ list, parts }: Halves): KnownIndices | null {
  const first = list[0] ?? 0
  let greatest = 0
  let step = (parts[2] as number) ?? 0
  for (let at = 0, before = 0; at < parts.length; at += KNOWN_OF_PART, before += PART) {
    const [least, most, own] = [parts[at], parts[at + 1], parts[at + 2]] as [number, number, number]
    // As integers with a sign these are negative.
    if (least < 0) return null
    greatest = Math.max(greatest, most)
    const isAlone = before + 1 === list.length
    if ((own !== step && !isAlone) || list[before] !== first + step * before) step = 0
  }
  return { list, greatest, step }
}

/** The numbers of a piece. */
function partOf({ from, to }: Stretch, { from: first, list }: Halves): Uint32Array<ArrayBuffer> {
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
