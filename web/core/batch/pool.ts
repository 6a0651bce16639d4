/** Workers for batches, each with its own instance of the core: pieces go to whichever is free. */
import type { Counts, Piece } from './batch-core'
import type { Wanted } from './lists'
import { memoryOf, type Reply, type WorkerPort } from './messages'

export interface Job {
  readonly piece: Piece
  /** Memory for the answers; the piece may lie in it. */
  readonly block: ArrayBuffer
  readonly wanted: Wanted
  /** The caller: jobs of one are cancelled together. */
  readonly caller: object
  /** Cells of the piece that are done so far. */
  onProgress(done: number): void
}

/** The job's block, with the answers in it, and the piece's memory. */
export interface Finished {
  readonly counts: Counts
  readonly piece: Piece
  readonly block: ArrayBuffer
}

/** Large beside what a message costs, small beside the memory of a page: 3 MB of coordinates. */
const CELLS_PER_PIECE = 16384

/** A worker has its next piece when it is done with one. */
const PIECES_AHEAD = 2

interface Task {
  readonly job: Job
  resolve(finished: Finished): void
  reject(reason: unknown): void
}

/** A guard against waiting for ever, not a measurement: a script may come over a slow line. */
const START_WITHIN = 60_000

interface PoolOptions {
  readonly cellsPerPiece?: number
  /** Milliseconds. */
  readonly startWithin?: number
}

/**
 * A worker that fails, or is ended from outside, leaves the pool; the jobs that it had are refused with a sentence, those of other
 * workers go on. `run` starts another.
 */
export class Pool {
  readonly size: number
  readonly cellsPerPiece: number
  readonly #spawn: () => WorkerPort
  readonly #module: WebAssembly.Module
  readonly #startWithin: number
  readonly #workers = new Set<PoolWorker>()

  /** Workers are started when they are needed. */
  constructor(module: WebAssembly.Module, size: number, spawn: () => WorkerPort, options: PoolOptions = {}) {
    this.size = size
    this.cellsPerPiece = options.cellsPerPiece ?? CELLS_PER_PIECE
    this.#module = module
    this.#spawn = spawn
    this.#startWithin = options.startWithin ?? START_WITHIN
  }

  /** Pieces that can be under way at once. */
  get capacity(): number {
    return this.size * PIECES_AHEAD
  }

  /** All memory of the job is taken over by the worker. */
  run(job: Job): Promise<Finished> {
    return new Promise((resolve, reject) => this.#freest().take({ job, resolve, reject }))
  }

  /** Ends the workers and with them what they have at hand; `run` starts new ones. */
  stop(reason: unknown): void {
    for (const worker of [...this.#workers]) worker.end(reason)
  }

  /** Refuses what a caller has under way. A worker that has nothing else to do is ended, the others finish it for nothing. */
  cancel(caller: object, reason: unknown): void {
    for (const worker of [...this.#workers]) worker.cancel(caller, reason)
  }

  #freest(): PoolWorker {
    const [first, ...others] = this.#workers
    const freest = others.reduce((a, b) => (b && a && b.load < a.load ? b : a), first)
    if (freest && (freest.load === 0 || this.#workers.size >= this.size)) return freest
    const worker = new PoolWorker(this.#started(), this.#startWithin, () => this.#workers.delete(worker))
    this.#workers.add(worker)
    return worker
  }

  #started(): WorkerPort {
    let port: WorkerPort | undefined
    try {
      port = this.#spawn()
      port.postMessage({ kind: 'start', module: this.#module }, [])
      return port
    } catch (reason) {
      port?.terminate()
      throw failure('did not start', reason instanceof Error ? reason.message : String(reason))
    }
  }
}

class PoolWorker {
  readonly #port: WorkerPort
  readonly #onEnd: () => void
  readonly #tasks: Task[] = []
  readonly #deadline: ReturnType<typeof setTimeout>
  #problem = 'did not start'

  /** The port's worker was told to start. */
  constructor(port: WorkerPort, startWithin: number, onEnd: () => void) {
    this.#port = port
    this.#onEnd = onEnd
    port.onmessage = ({ data }) => this.#take(data)
    port.onbroken = reason => this.#fail(reason)
    this.#deadline = setTimeout(() => this.#fail(`it has not answered for ${startWithin / 1000} s.`), startWithin)
  }

  get load(): number {
    return this.#tasks.length
  }

  take(task: Task): void {
    const { piece, block, wanted } = task.job
    this.#port.postMessage({ kind: 'classify', piece, block, wanted }, memoryOf(task.job))
    this.#tasks.push(task)
  }

  cancel(caller: object, reason: unknown): void {
    const own = this.#tasks.filter(({ job }) => job.caller === caller)
    for (const { reject } of own) reject(reason)
    if (own.length > 0 && own.length === this.#tasks.length) this.end(reason)
  }

  end(reason: unknown): void {
    clearTimeout(this.#deadline)
    this.#port.onmessage = null
    this.#port.onbroken = null
    this.#port.terminate()
    this.#onEnd()
    for (const { reject } of this.#tasks.splice(0)) reject(reason)
  }

  #take(reply: Reply): void {
    if (reply.kind === 'started') {
      clearTimeout(this.#deadline)
      this.#problem = 'ended before it had answered'
    } else if (reply.kind === 'progress') this.#tasks[0]?.job.onProgress(reply.done)
    else if (reply.kind === 'classified') this.#tasks.shift()?.resolve(reply)
    else this.#fail(reply.message)
  }

  #fail(reason: string): void {
    this.end(failure(this.#problem, reason))
  }
}

/** Engines word it differently: "could not allocate memory", "Array buffer allocation failed", "JS heap out of memory". */
const MEMORY = /memory|allocat/i

function failure(problem: string, reason: string): Error {
  return new Error(`A worker for batches ${MEMORY.test(reason) ? 'ran out of memory' : problem}: ${reason}`)
}
