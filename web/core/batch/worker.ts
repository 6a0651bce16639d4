/** A worker for batches, in a browser or in Node: one wasm instance, one piece after another. */
import { heldLock } from '../worker-lock'
import { type BatchCore, loadBatchCore } from './batch-core'
import { listsIn } from './lists'
import { memoryOf, type Reply, type Request } from './messages'

interface Scope {
  onmessage: ((event: { readonly data: Request }) => void) | null
  postMessage(reply: Reply, transfer: ArrayBuffer[]): void
}

const isInBrowser = 'postMessage' in globalThis
const scope = isInBrowser ? (globalThis as unknown as Scope) : threadScope()

/** A thread of Node has its messages elsewhere. */
function threadScope(): Scope {
  const port = process.getBuiltinModule('node:worker_threads').parentPort
  if (!port) throw new Error('This script is a worker for batches, and was not started as one.')
  port.on('message', data => scope.onmessage?.({ data }))
  return { onmessage: null, postMessage: (reply, transfer) => port.postMessage(reply, transfer) }
}

/** Milliseconds: progress is to be seen ten times a second. */
const PROGRESS_INTERVAL = 50

let started: Promise<BatchCore> | undefined

scope.onmessage = ({ data }) => {
  if (data.kind === 'start') started = start(data.module)
  const answered = data.kind === 'start' ? started : classify(data)
  answered?.catch(reason => scope.postMessage({ kind: 'failed', message: String(reason) }, []))
}

async function start(module: WebAssembly.Module): Promise<BatchCore> {
  const [core, lock] = await Promise.all([loadBatchCore(module), isInBrowser ? heldLock('hexlens-batch') : null])
  scope.postMessage({ kind: 'started', lock }, [])
  return core
}

async function classify({ piece, block, wanted }: Request & { readonly kind: 'classify' }): Promise<void> {
  if (!started) throw new Error('The worker was asked before it was started.')
  const batch = await started
  let shown = performance.now()
  const { validCount, invalidCount, unansweredCount, firstUnanswered, exactCount } = batch.classify(piece, wanted, {
    into: count => listsIn(block, count, wanted),
    onProgress: done => {
      const now = performance.now()
      if (now - shown < PROGRESS_INTERVAL) return
      shown = now
      scope.postMessage({ kind: 'progress', done }, [])
    },
  })
  const counts = { validCount, invalidCount, unansweredCount, firstUnanswered, exactCount }
  const reply = { kind: 'classified', counts, piece, block } as const
  scope.postMessage(reply, memoryOf(reply))
}
