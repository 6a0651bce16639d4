/** Messages between the page and its worker for reading. */
import type { CheckedColumns } from '../mesh/checked-cells'
import type { PastedInput } from './pasted-input'

/** A mesh in words. */
export interface ReadSummary {
  /** "VTU"; several, where several meshes were given. */
  readonly format: string
  /** "15 hexahedra, 10 INVALID, 5 valid." */
  readonly headline: string
  /** Cells that are not checked, and notes. */
  readonly sentences: readonly string[]
}

export type ReadingReply =
  /** The worker holds the lock of this name as long as it lives; null if there are no locks. */
  | { readonly kind: 'started'; readonly lock: string | null }
  | { readonly kind: 'progress'; readonly step: ReadingStep; readonly fraction: number }
  | { readonly kind: 'read'; readonly summary: ReadSummary; readonly columns: CheckedColumns }
  /** One sentence; `missing` are files that are named and were not given. */
  | { readonly kind: 'refused'; readonly message: string; readonly missing: readonly string[] }

export type ReadingStep = 'reading' | 'deciding'

export type ReadingRequest = PastedInput
