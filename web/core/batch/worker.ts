/** A worker for batches: one wasm instance, one piece after another. */
import { answersIn, type BatchCore, cellCount, loadBatchCore } from './batch-core'
import { type Answer, memoryOf, type Request } from './messages'

interface Scope {
  onmessage: ((event: { readonly data: Request }) => void) | null
  postMessage(answer: Answer, transfer: ArrayBuffer[]): void
}

const scope = globalThis as unknown as Scope

/** In milliseconds: progress is to be seen ten times a second. */
const PROGRESS_INTERVAL = 50

let core: Promise<BatchCore> | undefined

scope.onmessage = ({ data }) => {
  if (data.kind === 'start') core = loadBatchCore(data.module)
  else classify(data).catch(reason => scope.postMessage({ kind: 'failed', message: String(reason) }, []))
}

async function classify({ piece, block, wantsMinima }: Request & { readonly kind: 'classify' }): Promise<void> {
  if (!core) throw new Error('The worker was asked before it was started.')
  const batch = await core
  let shown = performance.now()
  const { validCount, exact, fault } = batch.classify(piece, wantsMinima, {
    into: count => answersIn(block, count, wantsMinima),
    onExact: cell => {
      const now = performance.now()
      if (now - shown < PROGRESS_INTERVAL) return
      shown = now
      scope.postMessage({ kind: 'progress', done: Math.min(cell, cellCount(piece)) }, [])
    },
  })
  const answer = { kind: 'classified', counts: { validCount, exact, fault }, piece, block } as const
  scope.postMessage(answer, memoryOf(answer))
}
