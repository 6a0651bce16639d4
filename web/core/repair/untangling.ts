/** What untangling takes and gives. The contracts are those of hl_untangle in wasm/include/hexlens.h. */
import type { CodedError } from '../../model/result'
import type { Limits } from './limits'

/** Points of three coordinates, cells of eight indices of points in VTK's order. */
export interface PointMesh {
  readonly points: Float64Array
  readonly cells: Int32Array | Uint32Array
}

export interface UntangleOptions {
  /** Wanted: relative minima at least this, from 0, for all that are valid, to 1. */
  readonly margin: number
  /** One of MOVES a point; where missing, all points move that are not on the boundary. */
  readonly moves?: Uint8Array | undefined
  /** Points of planar parts of the boundary move in their plane, those on an edge between two planes along it; none where missing. */
  readonly slides?: boolean | undefined
  /** Boundary points move so far at most: all, or if they slide, these too; where missing, none but those that slide. */
  readonly boundaryDistance?: number | undefined
}

/**
 * Whether a point may move. On the boundary are the points of faces that are not shared by exactly two cells: of these `unlessBoundary`
 * lets move as the options say, `freed` lets move anywhere.
 */
export const MOVES = { stays: 0, unlessBoundary: 1, freed: 2 } as const

/** Cells are below the margin, or invalid; relative minima are the least of all cells, null where a cell has none. */
export interface UntangledCounts {
  readonly invalidBefore: number
  readonly invalidAfter: number
  readonly belowBefore: number
  readonly belowAfter: number
  readonly movedCount: number
  /** Best places that were sought. */
  readonly placeCount: number
  readonly sweepCount: number
  /** Points that could move, but have more cells than the core takes. */
  readonly tooManyCount: number
  readonly greatestDistance: number
  /** Of the points that have moved. */
  readonly meanDistance: number
  readonly leastBefore: number | null
  readonly leastAfter: number | null
}

export interface Untangled extends UntangledCounts {
  readonly points: Float64Array
  /** The points that may move and still have a cell below the margin, ascending. */
  readonly heldPoints: Uint32Array
  /** Where each of these may go; null is anywhere. `bestPlace` with them says what forbids the margin. */
  readonly heldLimits: readonly (Limits | null)[]
}

export type UntangleError = CodedError<
  'wrong-count' | 'not-finite' | 'no-such-point' | 'no-such-margin' | 'no-such-distance'
>

export interface Untangling {
  /** Looks at the next piece of points, which takes some milliseconds; false when there is nothing more to do. */
  step(): boolean
  /** So far: of the distances and the least values nothing is known. */
  progress(): UntangledCounts
  /** To be called once, and nothing after it. */
  end(): Untangled
}
