/** A worker for batches, in a browser or in Node: one wasm instance, one piece after another. */
import { seldom, serve } from '../workers'
import { type Counts, loadBatchCore, type Piece } from './batch-core'
import { listsIn, type Wanted } from './lists'
import { type LowHalves, lowHalves } from './low-halves'

export interface BatchJob {
  readonly piece: Piece
  /** Memory for the answers, which will lie at its beginning (listsIn); the piece may lie in it. */
  readonly block: ArrayBuffer
  readonly wanted: Wanted
}

/** All memory of the job comes back, and is filled again. */
export interface BatchAnswer extends Omit<BatchJob, 'wanted'> {
  readonly counts: Counts
}

export type BatchJobs = {
  /** Tells of cells of the piece that are done, where they take long. */
  classify(job: BatchJob, tell: (done: number) => void): BatchAnswer
  /** Holds points for pieces that come without any. */
  hold(points: Float64Array): null
  /** Reads integers of 64 bits. */
  halve(bytes: Blob): Promise<LowHalves>
}

serve<WebAssembly.Module, BatchJobs>('hexlens-batch', async module => {
  const core = await loadBatchCore(module)
  return {
    hold(points) {
      core.hold(points)
      return null
    },
    halve: async bytes => lowHalves(await bytes.arrayBuffer()),
    classify({ piece, block, wanted }, tell) {
      const { validCount, invalidCount, unansweredCount, firstUnanswered, exactCount } = core.classify(piece, wanted, {
        into: count => listsIn(block, count, wanted),
        onProgress: seldom(tell),
      })
      return { counts: { validCount, invalidCount, unansweredCount, firstUnanswered, exactCount }, piece, block }
    },
  }
})
