/** Workers for batches, each with its own instance of the core: pieces go to whichever is free. */
import type { Piece, PieceCounts } from './batch-core'
import { memoryOf, type WorkerPort } from './messages'

export interface Job {
  readonly piece: Piece
  /** For the answers; it may be where the piece lies. */
  readonly block: ArrayBuffer
  readonly wantsMinima: boolean
  /** Whose it is: cancelled together. */
  readonly caller: object
  /** Cells of the piece that are done so far. */
  onProgress(done: number): void
}

/** The job's block, with the answers in it, and the piece, as it was where a cell is none. */
export interface Finished {
  readonly counts: PieceCounts
  readonly piece: Piece
  readonly block: ArrayBuffer
}

/** Large beside what a message costs, small beside the memory of a page: 3 MB of coordinates. */
const CELLS_PER_PIECE = 16384

/** So that a worker has its next piece when it is done with one. */
const PIECES_AHEAD = 2

interface Task {
  readonly job: Job
  resolve(finished: Finished): void
  reject(reason: unknown): void
}

export class Pool {
  readonly size: number
  readonly cellsPerPiece: number
  readonly #spawn: () => WorkerPort
  readonly #module: WebAssembly.Module
  readonly #workers = new Set<PoolWorker>()

  /** Workers are started when they are needed. */
  constructor(module: WebAssembly.Module, size: number, spawn: () => WorkerPort, cellsPerPiece = CELLS_PER_PIECE) {
    this.size = size
    this.cellsPerPiece = cellsPerPiece
    this.#module = module
    this.#spawn = spawn
  }

  /** How many pieces can be under way at once. */
  get capacity(): number {
    return this.size * PIECES_AHEAD
  }

  /** All memory of the job is taken over by the worker. */
  run(job: Job): Promise<Finished> {
    return new Promise((resolve, reject) => this.#freest().take({ job, resolve, reject }))
  }

  /** Ends the workers and with them what they have at hand; `run` starts new ones. */
  stop(reason: unknown): void {
    for (const worker of this.#workers) worker.end(reason)
    this.#workers.clear()
  }

  /** Refuses what a caller has under way. A worker that has nothing else to do is ended, the others finish it for nothing. */
  cancel(caller: object, reason: unknown): void {
    for (const worker of this.#workers) if (worker.cancel(caller, reason)) this.#workers.delete(worker)
  }

  #freest(): PoolWorker {
    const [first, ...others] = this.#workers
    const freest = others.reduce((a, b) => (b && a && b.load < a.load ? b : a), first)
    if (freest && (freest.load === 0 || this.#workers.size >= this.size)) return freest
    const worker = new PoolWorker(this.#spawn(), this.#module, () => this.#workers.delete(worker))
    this.#workers.add(worker)
    return worker
  }
}

class PoolWorker {
  readonly #port: WorkerPort
  readonly #tasks: Task[] = []

  constructor(port: WorkerPort, module: WebAssembly.Module, onBroken: () => void) {
    this.#port = port
    port.onmessage = ({ data }) => {
      const [task] = this.#tasks
      if (data.kind === 'progress') task?.job.onProgress(data.done)
      else if (data.kind === 'classified') this.#tasks.shift()?.resolve(data)
      else this.#tasks.shift()?.reject(new Error(data.message))
    }
    port.onerror = ({ message }) => {
      onBroken()
      this.end(new Error(`A worker did not start or broke: ${message ?? 'no reason given'}`))
    }
    port.postMessage({ kind: 'start', module }, [])
  }

  get load(): number {
    return this.#tasks.length
  }

  take(task: Task): void {
    const { piece, block, wantsMinima } = task.job
    this.#tasks.push(task)
    this.#port.postMessage({ kind: 'classify', piece, block, wantsMinima }, memoryOf(task.job))
  }

  /** Whether the worker was ended. */
  cancel(caller: object, reason: unknown): boolean {
    const own = this.#tasks.filter(({ job }) => job.caller === caller)
    for (const { reject } of own) reject(reason)
    if (own.length === 0 || own.length < this.#tasks.length) return false
    this.end(reason)
    return true
  }

  end(reason: unknown): void {
    this.#port.terminate()
    for (const { reject } of this.#tasks.splice(0)) reject(reason)
  }
}
