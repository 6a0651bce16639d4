/** The check of a mesh. */
import type { Classification } from '../core/batch/classify'
import type { Wanted } from '../core/batch/lists'
import type { Report } from '../core/report'
import type { NodeOrder } from '../model/node-orders'
import type { Mesh } from './mesh'

/** Lists without which there are no counts. */
export const NEEDED = { relativeMinima: true, classes: true, statuses: true, coincident: true } as const
export type CheckAnswers = Classification<typeof NEEDED & Wanted>

/** The kinds of cells that are counted. */
export type Standing = 'valid' | 'invalid' | 'unanswered' | 'degenerate'
export const STANDINGS: readonly Standing[] = ['valid', 'invalid', 'unanswered', 'degenerate']

export interface MeshCheck {
  readonly mesh: Mesh
  /** One entry a cell: also for those that count as something else, in the order of the text where none is stated. */
  readonly answers: CheckAnswers
  readonly hexahedra: number
  /** One entry a cell: indices into STANDINGS. */
  readonly standings: Uint8Array
  readonly valid: number
  readonly invalid: number
  readonly unanswered: number
  /** Cells with coincident vertices. */
  readonly degenerate: number
  readonly below: number
  /** jacdet < 0 everywhere: cells that are valid when numbered the other way round. */
  readonly mirrored: number
  readonly notTrilinear: { readonly count: number; readonly validByCorners: number }
  /** Notes of the mesh, and those that the answers add. */
  readonly notes: readonly string[]
  /** Indices of cells, worst first. */
  readonly worst: Uint32Array
  /** Unanswered cells, of no stated order, with the first order in which they are valid. */
  readonly openOrders: ReadonlyMap<number, NodeOrder>
  standingOf(cell: number): Standing
  isAnswered(cell: number): boolean
  isBelow(cell: number): boolean
  /** Null where the file has no ids. */
  idOf(cell: number): string | null
  /** The name of the first block that the cell is in, as the file has it. */
  blockOf(cell: number): string | null
  /** Everything about the cell; or, for one that is unanswered, why. */
  answerTo(cell: number): { readonly report: Report } | { readonly why: string }
}
