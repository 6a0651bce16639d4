/** Events of `<hex-mesh>`. `npm run reference` reads what each means. */

/** What is said of a mesh, for programs. */
export interface MeshSummary {
  /** The name of the file. */
  readonly name: string
  /** "VTU", say. */
  readonly format: string
  readonly hexahedra: number
  readonly invalid: number
  readonly valid: number
  /** Cells without a verdict: a coordinate is not finite. */
  readonly unanswered: number
}

/** A cell that was chosen. */
export interface PickedCell {
  /** Its index, from 0 in the order of the file. */
  readonly cell: number
  /** Its id in the file, or the index if the file has none. */
  readonly id: string
  /** 24 coordinates in VTK_HEXAHEDRON order; null if one is not finite. */
  readonly vertices: readonly number[] | null
  /** Null where there is no verdict. */
  readonly valid: boolean | null
  /** The least jacdet over the volume; null where the volume is 0, or there is no verdict. */
  readonly relativeMinimum: number | null
}

export interface HexMeshEventMap {
  /** A mesh is open, and its sentence is there. */
  'hex-open': CustomEvent<MeshSummary>
  /** Everything is drawn for the first time since the element came into the page. */
  'hex-ready': CustomEvent<null>
  /** The reader has chosen a cell, in the picture or in the list. Not told of `pick()`. */
  'hex-pick': CustomEvent<PickedCell>
  /**
   * Something does not work, and `message` says so in a sentence. The codes: `not-fetched`,
   * `too-large`, `not-read`, `no-webgl`, and `bad-` with the name of an attribute or a method that
   * was not understood, which then changes nothing.
   */
  'hex-error': CustomEvent<{ code: string; message: string }>
}
