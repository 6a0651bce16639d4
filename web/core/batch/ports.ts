/** Workers as the pool sees them: a page's Worker, and a thread of Node. */
import type { Worker as Thread } from 'node:worker_threads'
import { whenReleased } from '../worker-lock'
import type { Reply, WorkerPort } from './messages'

/** `blocked` is said when a script was not loaded: browsers give no reason then. */
export function pagePort(worker: Worker, blocked: string): WorkerPort {
  const port: WorkerPort = {
    postMessage: (request, transfer) => worker.postMessage(request, transfer),
    onmessage: null,
    onbroken: null,
    terminate: () => worker.terminate(),
  }
  worker.onmessage = ({ data }: MessageEvent<Reply>) => {
    if (data.kind === 'started' && data.lock !== null) whenReleased(data.lock, () => port.onbroken?.(ENDED))
    port.onmessage?.({ data })
  }
  worker.onmessageerror = () => port.onbroken?.(UNREADABLE)
  worker.onerror = event => {
    event.preventDefault() // the rejected promise says it
    port.onbroken?.(event.message || blocked)
  }
  return port
}

const ENDED = 'it was ended.'
const UNREADABLE = 'its answer could not be read.'

/** A thread without work does not keep the process from ending. */
export function threadPort(thread: Thread): WorkerPort {
  let pieces = 0
  const port: WorkerPort = {
    postMessage(request, transfer) {
      thread.postMessage(request, transfer)
      if (request.kind === 'classify' && ++pieces === 1) thread.ref()
    },
    onmessage: null,
    onbroken: null,
    terminate: () => void thread.terminate(),
  }
  thread.unref()
  thread.on('message', (data: Reply) => {
    if (data.kind === 'classified' && --pieces === 0) thread.unref()
    port.onmessage?.({ data })
  })
  thread.on('messageerror', () => port.onbroken?.(UNREADABLE))
  thread.on('error', error => port.onbroken?.(String(error)))
  thread.on('exit', code => port.onbroken?.(`its thread ended with exit code ${code}.`))
  return port
}
