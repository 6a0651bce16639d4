/** The state of the last input, for views. */

import type { CheckedCells } from '../mesh/checked-cells'
import type { Vertices } from '../model/hexahedron'
import type { NodeOrder } from '../model/node-orders'
import type { PastedInput } from './pasted-input'

export interface ReadingProgress {
  /** What is loaded is the reader of HDF5 files. */
  readonly step: 'loading' | 'reading' | 'deciding'
  readonly fraction: number
}

/** A mesh in words. */
export interface ReadSummary {
  /** "VTU"; several, where several meshes were given. */
  readonly format: string
  /** "15 hexahedra, 10 INVALID, 5 valid." */
  readonly headline: string
  /** Cells that are not checked, and notes. */
  readonly sentences: readonly string[]
}

export type Reading =
  | ({ readonly state: 'under-way'; readonly name: string } & ReadingProgress)
  | { readonly state: 'refused'; readonly message: string }
  | ReadCells

export interface ReadCells {
  readonly state: 'read'
  /** True if it was there before: the reader may be somewhere else. */
  readonly isQuiet: boolean
  readonly summary: ReadSummary
  /** One cell or more. */
  readonly cells: CheckedCells
  /** The cell that an element is, by the very list of its vertices; null for one that was not read or has been changed. */
  cellOf(vertices: Vertices): ShownCell | null
}

export interface ShownCell {
  readonly cell: number
  readonly id: string
  /** The order whose button was pressed: the vertices are in it. */
  readonly order: NodeOrder | null
}

/** Requests of views. */
export interface InputHost {
  /** True if this element reads what is pasted into it. */
  isWelcome(): boolean
  read(input: PastedInput): void
  /** Ends what is under way, or puts away what was read. */
  close(): void
  /** Makes a cell the element, as one step to undo; with `order`, in that order of its nodes. */
  show(cell: number, order?: NodeOrder): void
}
