/** Files as readers see them: bytes that are read when they are asked for, in a worker or in Node. */

import type { ReadingCore } from '../core/reading-interface'
import type { Mesh } from './mesh'

export interface MeshFile {
  readonly name: string
  readonly size: number
  /** A copy of the bytes [from, to), which must lie in the file; it may be in `into`, if that is given, which is as long at least. */
  read(from: number, to: number, into?: Uint8Array): Uint8Array
}

/** What was dropped or lies beside the file, by its name as the file writes it; null for what is not there. */
export type FindFile = (name: string) => MeshFile | null

export interface ReadOptions {
  readonly find: FindFile
  /** Called now and then with the part of the file that has been read, from 0 to 1. */
  readonly onProgress: (part: number) => void
  /** Which time step is read, counted from 0, of a file that has several. */
  readonly step: number | 'last'
  /** Throws if the reading is no longer wanted. */
  readonly throwIfCancelled: () => void
  /** What does the slow parts by wasm; null where that may not run. */
  readonly core: ReadingCore | null
}

/** One of the formats: a file of its own in formats/. */
export interface MeshFormat {
  readonly name: string
  /** By the first bytes of the file (up to 64 kB), then by its name, which is in lower case: certain, possible, or no. */
  recognizes(head: Uint8Array, name: string): 'yes' | 'maybe' | 'no'
  /** Throws a MeshRefusal. Several meshes where the text holds several files. */
  read(file: MeshFile, options: ReadOptions): readonly Mesh[]
}

export function fileOfBytes(name: string, bytes: Uint8Array): MeshFile {
  return { name, size: bytes.length, read: (from, to) => bytes.slice(from, to) }
}
