/** Files as readers see them: bytes that are read when they are asked for, in a worker or in Node. */

import type { ReadingCore } from '../core/reading-interface'
import type { Mesh } from './mesh'

export interface MeshFile {
  readonly name: string
  /** From the folder that was given, its name included; without it the name is all that is known. */
  readonly path?: string
  readonly size: number
  /** A copy of the bytes [from, to), which must lie in the file; it may be in `into`, if that is given, which is as long at least. */
  read(from: number, to: number, into?: Uint8Array): Uint8Array
  /** The low halves of integers of 64 bits from a byte on, where they were taken beforehand and none has more; the list is the caller's. */
  lowHalves?(from: number, count: number): KnownIndices | null
  /** The numbers of compressed blocks whose header begins at a byte, where they were unpacked beforehand; the list is the caller's. */
  unpacked?(from: number): UnpackedList | null
}

export interface KnownIndices {
  readonly list: Uint32Array
  readonly greatest: number
  /** From each to the next; 0 where that is not always the same. */
  readonly step: number
}

export interface UnpackedList {
  /** Doubles, or the low halves of integers of 64 bits of which none has more. */
  readonly list: Float64Array | Uint32Array
  /** The byte behind the blocks; in base64, no other text stands before it. */
  readonly to: number
}

/** Bytes of a file that are a list of numbers by themselves; of integers of 64 bits, little-endian ones, only the low halves are wanted. */
export interface FileList {
  readonly from: number
  readonly to: number
  readonly isLong: boolean
  /** What the list most likely is: the points of the mesh, or the vertices of its cells, all of them hexahedra. */
  readonly holds: 'points' | 'hexahedra' | null
  /** Null where the bytes are the numbers. */
  readonly packed: PackedBlocks | null
}

/** Streams of zlib, one after the other behind a header. */
export interface PackedBlocks {
  /** Where the first begins. */
  readonly from: number
  /** All of them are one text. */
  readonly isBase64: boolean
  /** Bytes of each. */
  readonly sizes: Float64Array
  /** What each is unpacked, but perhaps the last; whole kilobytes. */
  readonly blockSize: number
  /** What all are, unpacked. */
  readonly bytes: number
}

/** Finds a file that was dropped or lies beside, by its name in the file; null if none does. */
export type FindFile = (name: string) => MeshFile | null

export interface ReadOptions {
  readonly find: FindFile
  /** Called now and then with the share of the file that has been read, from 0 to 1. */
  readonly onProgress: (share: number) => void
  /** The time step to read, counted from 0, of a file that has several. */
  readonly step: number | 'last'
  /** Throws if the reading is no longer wanted. */
  readonly throwIfCancelled: () => void
  /** The wasm for the slow work; null if it may not run. */
  readonly core: ReadingCore | null
  /** The reader of HDF5 files; null where none came so far. */
  readonly hdf5: Hdf5Reader | null
}

/** Sentences in place of errors: the reader may be a script of its own, with classes of its own. */
export interface Hdf5Reader {
  /** False once it has crashed on a damaged file: another has to be loaded then. */
  readonly isWhole: boolean
  /** The meshes, or why there are none. */
  read(file: MeshFile, options: ReadOptions): readonly Mesh[] | string
  /** The numbers of a dataset, such as XDMF names, or why there are none. */
  numbers(file: MeshFile, path: string): Hdf5Numbers | string
}

export interface Hdf5Numbers {
  readonly shape: readonly number[]
  readonly isFloat32: boolean
  readonly values: Float64Array
}

/** One of the formats: a file of its own in formats/. */
export interface MeshFormat {
  readonly name: string
  /** Judges the first bytes (up to 64 kB) and the name in lower case: certain, possible, or no. */
  recognizes(head: Uint8Array, name: string): 'yes' | 'maybe' | 'no'
  /** Throws a MeshRefusal. Several meshes where the text holds several files. */
  read(file: MeshFile, options: ReadOptions): readonly Mesh[]
  /** Long lists, in any order, for whoever reads the file beforehand; reads no more than what says where they lie. */
  listsIn?(file: MeshFile): readonly FileList[]
}

const CALLS = 65_536

/** A function to be called for each record of a file, with the byte that is next: it tells of the progress once in so many calls. */
export function progressOf(file: MeshFile, { onProgress, throwIfCancelled }: ReadOptions): (position: number) => void {
  let calls = 0
  return position => {
    if (calls++ % CALLS > 0) return
    throwIfCancelled()
    onProgress(position / file.size)
  }
}

export function fileOfBytes(name: string, bytes: Uint8Array): MeshFile {
  return { name, size: bytes.length, read: (from, to) => bytes.slice(from, to) }
}

/** True if a file is the one that another names, with or without its folder. */
export function isNamed({ name }: { readonly name: string }, wanted: string): boolean {
  return name.toLowerCase() === wanted.split(/[\\/]/).at(-1)?.toLowerCase()
}

/**
 * The file that another names. Of several with its name, the one at that path from a file of `from`, the first of these first, or else
 * the only one whose folders agree with the name; null if that leaves it open.
 */
export function fileNamed(files: readonly MeshFile[], wanted: string, from: readonly MeshFile[]): MeshFile | null {
  const found = files.filter(file => isNamed(file, wanted))
  const [first] = found
  if (!first || found.every(file => pathOf(file) === pathOf(first))) return first ?? null
  for (const { path = '' } of from) {
    const exact = found.find(file => pathOf(file).toLowerCase() === pathFrom(path, wanted).toLowerCase())
    if (exact) return exact
  }
  const fitting = found.filter(file => haveSameEnd(pathOf(file), wanted))
  return fitting.length === 1 ? (fitting[0] as MeshFile) : null
}

export function pathOf({ name, path = name }: Pick<MeshFile, 'name' | 'path'>): string {
  return path
}

function pathFrom(path: string, wanted: string): string {
  const folders = path.split('/').slice(0, -1)
  for (const part of wanted.split(/[\\/]/))
    if (part === '..') folders.pop()
    else if (part !== '.') folders.push(part)
  return folders.join('/')
}

function haveSameEnd(path: string, wanted: string): boolean {
  const [a, b] = [path, pathFrom('', wanted)].map(each => each.toLowerCase().split('/').reverse())
  return a?.every((part, i) => i >= (b?.length ?? 0) || part === b?.[i]) ?? false
}
