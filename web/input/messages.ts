/** What is said between the page and its worker for reading. */
import type { CheckedColumns } from '../mesh/checked-cells'
import type { PastedInput } from './pasted-input'

/** What was read, in words. */
export interface ReadSummary {
  /** "VTU"; several, where several meshes were given. */
  readonly format: string
  /** "15 hexahedra, 10 INVALID, 5 valid." */
  readonly headline: string
  /** What is not checked, and notes. */
  readonly sentences: readonly string[]
}

export type ReadingReply =
  /** With the name of a lock that the worker holds as long as it lives; null where there are no locks. */
  | { readonly kind: 'started'; readonly lock: string | null }
  | { readonly kind: 'progress'; readonly step: ReadingStep; readonly fraction: number }
  | { readonly kind: 'read'; readonly summary: ReadSummary; readonly columns: CheckedColumns }
  /** In one sentence; with the names of files that are named and were not given. */
  | { readonly kind: 'refused'; readonly message: string; readonly missing: readonly string[] }

export type ReadingStep = 'reading' | 'deciding'

export type ReadingRequest = PastedInput
