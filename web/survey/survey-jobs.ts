/** What the worker of an open mesh is asked, and how it answers. Cells are counted from 0 in the file's order. */
import type { CheckId, ElementClass } from '../core/report'
import type { PastedInput } from '../input/pasted-input'
import type { ReadingProgress } from '../input/reading'
import type { Histogram } from '../mesh/histogram'
import type { Standing } from '../mesh/mesh-check'
import type { StepAnswer } from '../mesh/step-answers'
import type { Vec3, Vertices } from '../model/hexahedron'
import type { NodeOrder } from '../model/node-orders'
import type { IdKind } from '../outputs/ids'
import type { Practice } from './practice'

export type { Histogram } from '../mesh/histogram'

/** All jobs but `prepare`, `practise` and `open` want a mesh that is open. Each is short; what takes long goes on in steps. */
export type SurveyJobs = {
  /** Loads what opening needs, before there is anything to open. What is worth practising. */
  prepare(_: null): Promise<readonly Practice[]>
  /** Opens a mesh that nobody sees. */
  practise(practice: Practice): Promise<null>
  open(input: PastedInput, tell: (progress: ReadingProgress) => void): Promise<Opening>
  /** Rows from one rank to another in the present order. */
  rows(ranks: { readonly from: number; readonly to: number }): readonly Row[]
  /** Goes on to find the checks that accept cells. Which part is done; `arrange` and `write` do what is left at once. */
  accept(cells: 'invalid' | 'all'): Promise<number>
  arrange(order: Arrangement): null
  /** Begins another selection. */
  select(selection: Selection): Selected
  /** Goes on with it, for some milliseconds. */
  selectOn(_: null): Selected
  /** The next listed cell that the file calls so, behind a rank, from the first again behind the last. */
  find(wanted: { readonly id: string; readonly after: number }): Place | null
  /** The next invalid cell in the list, behind or before a rank and round its end; null if none is invalid. */
  nextInvalid(from: { readonly rank: number; readonly step: 1 | -1 }): Place | null
  placeOf(cell: number): Place
  histogram(_: null): Histogram
  detail(cell: number): CellDetail
  /** Goes on to find the cells that share a face, for some milliseconds. Which part is done; `faces` does what is left at once. */
  join(_: null): number
  faces(shown: ShownCells): FaceList
  /** The same of cells that are less what has been cut away. */
  cut(cells: CutCells): CutFaces
  /** Exchanges the bottom with the top of what is mirrored, or takes the order that makes all valid; in all steps. */
  mend(fix: FixId): Promise<Opening>
  /** Begins to write the mesh in a form, in place of what was being written. */
  write(form: FormId): Written
  /** Goes on with it, for some milliseconds. */
  writeOn(_: null): Written
  /** Null as long as it is not known which cells share a face. */
  around(cell: number): Around | null
  /** Moves points: one step to undo. Order and selection begin anew, as after the next three. */
  move(moves: Moves): Promise<MovedMesh>
  undo(_: null): Promise<MovedMesh>
  redo(_: null): Promise<MovedMesh>
  /** These points where they were read, or all. */
  restore(points: readonly number[] | null): Promise<MovedMesh>
  /** What an untangling is given: all cells, or those with a point of a cell and of so many rings around it. */
  tangled(part: { readonly cell: number; readonly rings: number } | null): TangledPart
  /** Null where the mesh has no steps. */
  steps(_: null): StepList | null
  /** Reads and decides a step; no more is kept of it than its answer. */
  readStep(step: number, tell: (progress: ReadingProgress) => void): Promise<StepAnswer>
  /** Opens a step in the place of the one that is shown, which stays if it is refused. Order and selection begin anew. */
  showStep(wanted: StepWanted, tell: (progress: ReadingProgress) => void): Promise<StepOpening>
  /** The files of the steps as parts of one mesh instead. */
  together(_: null, tell: (progress: ReadingProgress) => void): Promise<Opening>
}

/** The jobs as a worker serves them, some of which wait for others. */
export type Served<Jobs> = {
  [Kind in keyof Jobs]: Jobs[Kind] extends (...given: infer Given) => infer Answer
    ? (...given: Given) => Answer | Promise<Awaited<Answer>>
    : never
}

/** What can be taken away of an open mesh, each the same as the command line writes it. */
export type FormId = 'csv' | 'json' | 'html' | 'own' | 'certificates' | IdKind | MeshFormId

/** The whole mesh, or its invalid cells alone, as a file with such an ending: those of outputs/meshes/list.ts. */
export type MeshFormId = `mesh.${string}` | `invalid.${string}`

/** Points that move at once: their indices, and three coordinates each. */
export interface Moves {
  readonly points: Uint32Array
  readonly to: Float64Array
}

/** A cell with a vertex of the chosen one, which is among them. */
export interface CellAround {
  readonly row: Row
  /** 24 coordinates. */
  readonly vertices: readonly number[]
  /** Of each of its vertices the chosen cell's, 0 to 7, that is the same point; -1 for others. */
  readonly shared: readonly number[]
}

export interface Around {
  /** The indices of the chosen cell's points. */
  readonly points: readonly number[]
  /** Vertices of the chosen cell on the boundary of the hexahedra, and those that have moved. */
  readonly onBoundary: readonly number[]
  readonly moved: readonly number[]
  readonly cells: readonly CellAround[]
}

/** A mesh of which points have moved, or have come back. */
export interface MovedMesh {
  readonly opened: Overview
  readonly movement: MovementCounts
}

export interface MovementCounts {
  /** Points that are not where they were read. */
  readonly movedCount: number
  readonly canUndo: boolean
  readonly canRedo: boolean
  /** Why the file that was read cannot be written with the points as they are; null where it can. */
  readonly whyNotInPlace: string | null
}

/** Cells with their points, and what an untangling may do. */
export interface TangledPart {
  readonly points: Float64Array
  readonly cells: Uint32Array
  /** One of MOVES a point. */
  readonly moves: Uint8Array
  /** Of each point and of each cell its index in the mesh; null where they are the same. */
  readonly indices: Uint32Array | null
  readonly cellIndices: Uint32Array | null
  /** The cells' ids in the file; null where it has none. */
  readonly ids: Float64Array | readonly string[] | null
}

/** Files that say which checks accept cells, and of which cells. */
export const ACCEPTED_IN: Readonly<Partial<Record<FormId, 'invalid' | 'all'>>> = { csv: 'all', html: 'invalid' }

/** The next bytes of a file. */
export type Written =
  | {
      readonly bytes: Uint8Array<ArrayBuffer>
      /** About how much of the file there is, from 0 to 1. */
      readonly fraction: number
      readonly isEnd: boolean
      /** Sentences about the file, for people. */
      readonly said: readonly string[]
    }
  /** One sentence: there is no such file. */
  | { readonly refused: string }

export type Opening =
  | { readonly opened: Overview }
  /** One sentence; `missing` are files that are named and were not given. */
  | { readonly refused: string; readonly missing: readonly string[] }

export interface Overview {
  readonly name: string
  readonly format: string
  /** "12 of 88,432 hexahedra are invalid. ..." */
  readonly headline: string
  /** What was not checked, and notes. */
  readonly sentences: readonly string[]
  readonly hexahedra: number
  readonly counts: Readonly<Record<Standing, number>>
  readonly fixes: readonly Fix[]
  readonly blocks: readonly { readonly name: string; readonly cells: number }[]
  readonly hasIds: boolean
  /** Of the points of cells; null if none is finite. */
  readonly bounds: Bounds | null
  /** The worst: the first rows of the list, as many as it asks for at once. */
  readonly worst: readonly Row[]
}

export interface Bounds {
  readonly least: Vec3
  readonly greatest: Vec3
}

/** With an order: that of node-orders.ts in which all are valid. */
export type FixId = 'mirrored' | `order-${string}`

export interface Fix {
  readonly id: FixId
  /** "Correct 97 mirrored cells", "Take the nodes in the order “Lexicographic”": the words of its button. */
  readonly words: string
}

export interface Place {
  readonly cell: number
  /** In the list as it is now; null if the cell is not in it. */
  readonly rank: number | null
}

/** A jacdet, times 2^exponent. */
export interface Scaled {
  readonly value: number
  readonly exponent: number
}

export interface Row {
  readonly cell: number
  /** The id in the file, or the cell's index if it has none; safe to show. */
  readonly id: string
  readonly block: string | null
  readonly standing: Standing
  readonly class: ElementClass | null
  /** NaN where the volume is 0, or there is no answer. */
  readonly relativeMinimum: number
  readonly minimum: Scaled
  readonly volume: Scaled
  readonly acceptedBy: readonly CheckId[]
  /** Why there is no answer; null where there is one. */
  readonly why: string | null
}

/** `worst` is by relative minimum, cells of volume 0 in their place; all others put ties in this order. */
export type Column = 'worst' | 'id' | 'block' | 'minimum' | 'volume' | 'class' | 'accepted-by'

export interface Arrangement {
  readonly column: Column
  readonly isDescending: boolean
}

/** Cells that are listed: all of these at once. */
export interface Selection {
  /** In the language of conditions; null for all. */
  readonly condition: string | null
  /** Relative minima from one number to another, both within; null for all. */
  readonly range: readonly [number, number] | null
}

export interface Selected {
  /** Cells that are in the list so far. */
  readonly listed: number
  /** Cells that have been looked at: all of them when it is done. */
  readonly done: number
}

export interface CellDetail {
  readonly row: Row
  /** Null where a coordinate is not finite. */
  readonly vertices: Vertices | null
  /** The order in which the cell is valid, where its own is not stated and it is not valid in that of the text. */
  readonly openOrder: NodeOrder | null
  /** Cells with a face of it, by that face; without `join` none. */
  readonly neighbours: readonly Neighbour[]
}

export interface Neighbour {
  readonly cell: number
  readonly face: number
  readonly isInvalid: boolean
  /** 24 coordinates. */
  readonly vertices: readonly number[]
}

/** Cells of the picture. What bounds them is shown, or all of their faces. */
export interface ShownCells {
  readonly cells:
    | { readonly which: 'all' }
    /** Those whose middle, less `origin`, is behind a plane: its product with the normal is `offset` at most. */
    | { readonly which: 'behind-plane'; readonly normal: Vec3; readonly offset: number }
    /** The invalid ones, and so many rings of cells around them that share a point. */
    | { readonly which: 'invalid'; readonly rings: number }
    | { readonly which: 'listed' }
    | { readonly which: 'block'; readonly block: number }
    | { readonly which: 'one'; readonly cell: number }
  /** Every face of each cell: for cells that are drawn apart. */
  readonly isWhole: boolean
  /** The worst cells come first, and so many are enough. */
  readonly most: number
}

/** Bilinear faces, seen from outside their cells. */
export interface FaceList {
  /**
   * Five vertices a face, its corners in cyclic order and its middle, four numbers each: x, y and z less `origin`, and the tone of the face's
   * cell, from which its colour follows.
   */
  readonly vertices: Float32Array
  /** The middle of the face's cell less `origin` for each vertex, where cells are drawn whole; else null. */
  readonly middles: Float32Array | null
  readonly cells: Uint32Array
  /** The middle of the bounds; of the bounds of the first step that was opened. */
  readonly origin: Vec3
  /** Cells that are shown, and those that should be. */
  readonly shown: number
  readonly wanted: number
}

/** Cells of a set, less what has been cut away of them. */
export interface CutCells {
  readonly set:
    | ShownCells['cells']
    /** A cell, and so many rings of cells around it that share a point. */
    | { readonly which: 'around'; readonly cell: number; readonly rings: number }
  /** Those behind it stay, as in ShownCells. */
  readonly plane: { readonly normal: Vec3; readonly offset: number } | null
  /** Relative minima from one number to another, both within; cells without one go. */
  readonly relative: readonly [number, number] | null
  /**
   * So many layers go. Cells with a point on the boundary of the mesh are the first; each other layer has the cells that share a point
   * with the one before.
   */
  readonly layers: number
  /** Cells that go one by one. */
  readonly away: readonly number[]
  readonly onlyInvalid: boolean
  /** Every face of each cell: for cells that are drawn apart. */
  readonly isWhole: boolean
  /** Whoever asks has the boundary of the mesh, from `faces`: of it no more is answered than which faces are hidden. */
  readonly hasBoundary: boolean
  /** Of cells with more than six times so many faces to draw, so many are left: the worst. */
  readonly most: number
}

export interface CutFaces extends FaceList {
  /** 1 for each vertex of the boundary whose face is hidden; null if the list has all faces, those of the boundary as well. */
  readonly hidden: Uint8Array | null
  /** Layers that the mesh has; null where none was to go. */
  readonly layers: number | null
}

/** Steps are counted from 0. */
export interface StepList {
  /** "7 files are taken as 7 steps of one mesh, in the order of their numbers." */
  readonly sentences: readonly string[]
  /** True if each step has files of its own. */
  readonly areFiles: boolean
  /** The name of each step's file, and its time, where this is known before it is read; safe to show. */
  readonly steps: readonly { readonly name: string; readonly time: string | null }[]
  readonly shown: number
  /** That of the shown step. */
  readonly answer: StepAnswer
}

export interface StepWanted {
  readonly step: number
  /** The chosen cell of the step that is shown. */
  readonly chosen: number | null
}

export type StepOpening =
  | {
      readonly opened: Overview
      readonly answer: StepAnswer
      /** The cell of the same id; null if there is none. */
      readonly chosen: number | null
    }
  | { readonly refused: string; readonly missing: readonly string[] }
