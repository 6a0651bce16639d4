/** An output of `check` turns the results, file by file, into text or bytes. */
import type { Wanted } from '../core/batch/lists'
import type { ExitStatus } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'
import type { StepAnswer } from '../mesh/step-answers'

export type FileResult = { readonly file: string; readonly exit: ExitStatus } & (
  | { readonly check: MeshCheck; readonly steps?: CheckedSteps | null }
  | { readonly error: string }
)

/** All time steps of a file, of which one is the result. */
export interface CheckedSteps {
  readonly answers: readonly StepAnswer[]
  /** Counted from 0. */
  readonly shown: number
}

export interface Output {
  /** Lists that it needs beside the counts. */
  readonly lists: Wanted
  file(result: FileResult): Iterable<string | Uint8Array>
  /** The end, after the last file. */
  end(exit: ExitStatus): Iterable<string>
}

export { counted } from '../mesh/check-summary'
/** Names of files and from files, for people. */
export { shown, withoutControls } from '../mesh/text-cursor'
