/** A mesh as a file has it: points, hexahedra, what the file calls them, and what else is in it. */
import { Refusal } from '../model/result'

export interface Mesh {
  /** The format's usual name: "VTU", "Gmsh", "Abaqus". */
  readonly format: string
  /** Three coordinates a point. One that is not finite stays as it is: its cells are unanswered, the others are not. */
  readonly points: Float64Array
  /** Eight indices of points for each cell of eight nodes, in VTK_HEXAHEDRON order; voxels are among them, reordered. */
  readonly cells: Uint32Array
  /** Ids of these cells in the file; null if it has none. */
  readonly ids: Float64Array | readonly string[] | null
  /** Blocks, parts, sets or groups by name, in the file's order; a cell may be in none or in several. */
  readonly blocks: readonly Block[]
  /** Cells of 20 or 27 nodes and Lagrange cells: they are not trilinear, and counted apart. */
  readonly notTrilinear: NotTrilinear
  /** All other cells, counted by type: "tetrahedron", "wedge", "pyramid", "quadrilateral", "polyhedron", ... */
  readonly other: ReadonlyMap<string, number>
  /** Sentences for people: precision, what is missing, what was passed over. */
  readonly notes: readonly string[]
  /** True if the file states the order of a cell's nodes; eight bare points state none. */
  readonly isOrderStated: boolean
  /** True if the text ends or leaves something out in the middle: whole cells have been read. */
  readonly isCutOff: boolean
  /** Positions of coordinates in the file, if each is a token or all are a block; else null. */
  readonly coordinatePlaces: CoordinatePlaces | null
  /** The times of the steps that the file has, of which this mesh is one, '' for one that is not said; empty where it has none. */
  readonly steps: readonly string[]
  /** True if the steps differ in results alone: the mesh is the same at all of them. */
  readonly isSteady?: boolean
}

export interface Block {
  readonly name: string
  /** Indices of cells, ascending. */
  readonly cells: Uint32Array
}

export interface NotTrilinear {
  /** Eight corners each, as in `cells`. */
  readonly corners: Uint32Array
  /** Cells with all further nodes at the middles, within rounding; null if not known. */
  readonly straight: number | null
}

/**
 * Bytes of the file: from where and how many each coordinate's token has, or a run [from, to) of text with all coordinates one after the other
 * and blanks between, or binary numbers, in one block or in several.
 */
export type CoordinatePlaces =
  | { readonly kind: 'tokens'; readonly from: Float64Array | Uint32Array; readonly lengths: Uint16Array }
  | { readonly kind: 'run'; readonly from: number; readonly to: number }
  | {
      readonly kind: 'block'
      readonly from: number
      readonly type: 'float32' | 'float64'
      readonly isLittleEndian: boolean
    }
  | {
      readonly kind: 'blocks'
      /** In the order of the points, from the first on. */
      readonly blocks: readonly PointBlock[]
      readonly type: 'float32' | 'float64'
      readonly isLittleEndian: boolean
    }

/** Points one after the other: the bytes of the first one's x, y and z, and how many bytes on those of the next are. */
export interface PointBlock {
  readonly count: number
  readonly from: readonly [number, number, number]
  readonly stride: number
}

/** A file that is none of ours, or damaged: one sentence with the place and what was expected. */
export class MeshRefusal extends Refusal {}

/** A reader that can refuse with its place in the file. */
export interface Refusing {
  refuse(what: string): never
}

/** Points and cells that a file implies or has generated beyond this are refused. */
export const MOST_IMPLIED_CELLS = 50_000_000

export const NOTHING_NOT_TRILINEAR: NotTrilinear = { corners: new Uint32Array(0), straight: null }

/** The index of each cell's first block; the count of blocks if none; null without blocks. */
export function firstBlocks({ cells, blocks }: Mesh): Uint32Array | null {
  if (blocks.length === 0) return null
  const places = new Uint32Array(cells.length / 8).fill(blocks.length)
  for (let i = blocks.length - 1; i >= 0; --i) for (const own of blocks[i]?.cells ?? []) places[own] = i
  return places
}
