/** A worker for batches: one wasm instance, one piece after another. */
import { type BatchCore, cellCount, loadBatchCore, type Piece } from './batch-core'
import type { Answer, Request } from './messages'

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
  else
    classify(data.piece, data.wantsMinima).catch(reason =>
      scope.postMessage({ kind: 'failed', message: String(reason) }, []),
    )
}

async function classify(piece: Piece, wantsMinima: boolean): Promise<void> {
  if (!core) throw new Error('The worker was asked before it was started.')
  const batch = await core
  let shown = performance.now()
  const result = batch.classify(piece, wantsMinima, cell => {
    const now = performance.now()
    if (now - shown < PROGRESS_INTERVAL) return
    shown = now
    scope.postMessage({ kind: 'progress', done: Math.min(cell, cellCount(piece)) }, [])
  })
  const { valid, minima } = result
  const lists = [piece.points, valid, ...(minima ? Object.values(minima) : [])] as { buffer: ArrayBuffer }[]
  scope.postMessage(
    { kind: 'classified', result, points: piece.points },
    lists.map(({ buffer }) => buffer),
  )
}
