/** Has an input read by a worker of its own. Whatever ends the worker becomes a sentence. */
import { whenReleased } from '../core/worker-lock'
import type { ReadingReply } from './messages'
import type { PastedInput } from './pasted-input'

export type ReadingOutcome = Extract<ReadingReply, { kind: 'read' | 'refused' }>
export type ReadingProgress = Extract<ReadingReply, { kind: 'progress' }>

/** The worker's source: each build has it somewhere else. */
export interface ReadingWorker {
  /** Rejects where there is none to be had. */
  start(): Promise<Worker>
  /** The likely reason if its script does not load. */
  readonly blocked: string
}

export interface ReadInputOptions {
  readonly readingWorker: () => Promise<ReadingWorker>
  readonly signal: AbortSignal
  readonly onProgress: (progress: ReadingProgress) => void
}

/** Milliseconds that a worker may take to start: a slow network brings its script. */
const START_WITHIN = 60_000

/** Never settles once the signal has aborted; the worker is ended then. */
export async function readInput(
  input: PastedInput,
  { readingWorker, signal, onProgress }: ReadInputOptions,
): Promise<ReadingOutcome> {
  let worker: Worker
  let blocked: string
  try {
    const source = await readingWorker()
    blocked = source.blocked
    worker = await source.start()
  } catch (reason) {
    return refusal(`${NEEDS_WORKER} (${reason instanceof Error ? reason.message : reason}).`)
  }
  return new Promise(resolve => {
    const deadline = setTimeout(() => end(refusal(`${NEEDS_WORKER} in ${START_WITHIN / 1000} s.`)), START_WITHIN)
    const end = (outcome: ReadingOutcome) => {
      stop()
      resolve(outcome)
    }
    const stop = () => {
      clearTimeout(deadline)
      worker.terminate()
    }
    let hasStarted = false
    worker.onmessage = ({ data }: MessageEvent<ReadingReply>) => {
      if (data.kind === 'progress') return onProgress(data)
      if (data.kind !== 'started') return end(data)
      hasStarted = true
      clearTimeout(deadline)
      if (data.lock !== null) whenReleased(data.lock, () => end(refusal(`${ENDED}.`)))
    }
    worker.onmessageerror = () => end(refusal(`${ENDED}: its answer could not be read.`))
    worker.onerror = event => {
      event.preventDefault() // the sentence says it
      end(refusal(hasStarted ? `${ENDED}: ${event.message}` : `${NEEDS_WORKER}: ${blocked}.`))
    }
    if (signal.aborted) stop()
    signal.addEventListener('abort', stop)
    worker.postMessage(input)
  })
}

const NEEDS_WORKER = 'Nothing was read: the worker that reads did not start'
const ENDED = 'Nothing was read: the worker that reads has ended, perhaps for want of memory'

function refusal(message: string): ReadingOutcome {
  return { kind: 'refused', message, missing: [] }
}
