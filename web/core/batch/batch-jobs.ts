/** The jobs of a worker for batches: one wasm instance, one piece after another. */
import { seldom } from '../workers'
import { type Counts, countsOf, loadBatchCore, type Piece } from './batch-core'
import type { CandidateOptions, Candidates } from './candidates'
import { listsIn, type Wanted } from './lists'

export interface BatchJob {
  readonly piece: Piece
  /** Memory for the answers, which will lie at its beginning (listsIn); the piece may lie in it. */
  readonly block: ArrayBuffer
  readonly wanted: Wanted
  readonly worst?: CandidateOptions | null
}

/** All memory of the job comes back, and is filled again. */
export interface BatchAnswer extends Omit<BatchJob, 'wanted' | 'worst'> {
  readonly counts: Counts
  readonly candidates: Candidates | null
}

export type BatchJobs = {
  /** Tells of cells of the piece that are done, where they take long. */
  classify(job: BatchJob, tell: (done: number) => void): BatchAnswer
}

/** The jobs, and the core, for whoever has others for it. */
export async function startBatchJobs(module: WebAssembly.Module) {
  const core = await loadBatchCore(module)
  const jobs: BatchJobs = {
    classify({ piece, block, wanted, worst = null }, tell) {
      const into = (count: number) => listsIn(block, count, wanted)
      const found = core.classify(piece, wanted, { into, onProgress: seldom(tell), worst })
      return { counts: countsOf(found), candidates: found.candidates, piece, block }
    },
  }
  return { core, jobs }
}
