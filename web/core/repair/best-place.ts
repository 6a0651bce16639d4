/** What the core says of the best place of a vertex. The contracts are those of hl_best_place in wasm/include/hexlens.h. */
import type { Vec3 } from '../../model/hexahedron'
import type { CodedError, Result } from '../../model/result'
import type { Limits } from './limits'
import type { PointMesh, UntangleError, UntangleOptions, Untangling } from './untangling'

/**
 * The cells around a vertex that moves, while all others stay: cells of 24 coordinates each, and for each the local vertices that are the
 * moving one; or eight indices of points a cell, and the index of the one that moves. Without limits it may go anywhere.
 */
export type Star = (
  | { readonly hexahedra: ArrayLike<number>; readonly moving: readonly (readonly number[])[] }
  | { readonly points: ArrayLike<number>; readonly cells: ArrayLike<number>; readonly vertex: number }
) & { readonly limits?: Limits | undefined }

/** The least over the cells of the boundary minimum over the cell's volume, or over a scale that is the same for every place. */
export type Measure = 'volume' | 'scale'

/** A point that holds the value of every place down, or a side of the box in which places are sought. */
export interface Hold {
  /** Null for a side of the box, or of the limits where these are nearer. */
  readonly cell: number | null
  /** (xi, eta, zeta), multiples of 2^-26; of a side the outward normal of length 1. */
  readonly point: Vec3
  /** Of jacdet over the scale; over the points they sum to 1. */
  readonly weight: number
  /** Times 2^(3 unitExponent). */
  readonly scale: number
  /** jacdet there is to be positive, whatever the volume. */
  readonly isBySign: boolean
}

export interface BestPlace {
  readonly position: Vec3
  /** False where the present place is as good as any that was found. */
  readonly isMoved: boolean
  /** The bound is within a millionth of the value. */
  readonly isClosed: boolean
  /** By volume where all cells are valid at the position; else by scale. */
  readonly measure: Measure
  readonly value: number
  /** No place has a greater value, but for rounding: `provePlace` makes it certain. */
  readonly bound: number
  /** The least of the cells'; null where one has none. */
  readonly relativeMinimum: number | null
  readonly presentRelativeMinimum: number | null
  /** Places are sought up to 2^(20 + unitExponent) from the present one on each axis. */
  readonly unitExponent: number
  readonly roundCount: number
  /** At most four. */
  readonly holds: readonly Hold[]
}

export type StarError = CodedError<
  'wrong-count' | 'no-cells' | 'not-finite' | 'no-such-point' | 'nothing-moves' | 'several-places' | 'outside-limits'
>

export interface RepairCore {
  /** Never throws for any numbers given. */
  bestPlace(star: Star): Result<BestPlace, StarError>
  /** Begins sweeps of best places over a mesh, which are done by steps: untangle.ts does them. */
  untangling(mesh: PointMesh, options: UntangleOptions): Promise<Result<Untangling, UntangleError>>
  /** 1 for each cell whose nodes are numbered the other way round than is meant, by hl_reversed_cells; the mesh is one that untangles. */
  reversedCells(mesh: PointMesh): Promise<Uint8Array>
}
