/** Workers as a pool sees them: a page's Worker, and a thread of Node. */
import type { Worker as Thread } from 'node:worker_threads'
import type { Reply, WorkerPort } from './workers'

const UNREADABLE = 'its answer could not be read.'
const NOT_LOADED = 'its script was not loaded, or a policy of the page forbids it.'

/** `blocked` is said when a script was not loaded: browsers give no reason then. */
export function pagePort(worker: Worker, blocked = NOT_LOADED): WorkerPort {
  const port: WorkerPort = {
    postMessage: (request, transfer) => worker.postMessage(request, transfer),
    onreply: null,
    onbroken: null,
    terminate: () => worker.terminate(),
  }
  worker.onmessage = ({ data }: MessageEvent<Reply>) => {
    // A page that is being left has no more locks.
    if (data.kind === 'started' && data.lock !== null)
      navigator.locks.request(data.lock, () => port.onbroken?.(null)).catch(() => {})
    port.onreply?.(data)
  }
  worker.onmessageerror = () => port.onbroken?.(UNREADABLE)
  worker.onerror = event => {
    event.preventDefault() // the rejected promise says it
    port.onbroken?.(event.message || blocked)
  }
  return port
}

/** A thread without work does not keep the process from ending. */
export function threadPort(thread: Thread): WorkerPort {
  let jobs = 0
  const port: WorkerPort = {
    postMessage(request, transfer) {
      thread.postMessage(request, transfer)
      if (request.kind !== 'start' && request.kind !== 'back' && ++jobs === 1) thread.ref()
    },
    onreply: null,
    onbroken: null,
    terminate: () => void thread.terminate(),
  }
  thread.unref()
  thread.on('message', (reply: Reply) => {
    if (reply.kind === 'answer' && --jobs === 0) thread.unref()
    port.onreply?.(reply)
  })
  thread.on('messageerror', () => port.onbroken?.(UNREADABLE))
  thread.on('error', error => port.onbroken?.(String(error)))
  thread.on('exit', code => port.onbroken?.(`its thread ended with exit code ${code}.`))
  return port
}
