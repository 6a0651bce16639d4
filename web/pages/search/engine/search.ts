/**
 * A search under way: workers go through the stream of elements piece by piece, and what they find is taken in the stream's order, so
 * that after so many elements the finds are the same however many workers there are.
 */
import type { Vertices } from '../../../model/hexahedron'
import type { Climbed } from './climb'
import type { Improved, Reply, WorkerPort } from './messages'
import type { Polished } from './polish'
import type { Query } from './query'
import type { Find, Order } from './ranking'
import { BLOCK, type PieceFinds } from './search-piece'
import { Tally } from './tally'

export interface SearchWorkers {
  /** hexlens-batch.wasm or hexlens-scalar.wasm, compiled. */
  readonly module: WebAssembly.Module
  readonly count: number
  readonly spawn: () => WorkerPort
}

/** A worker has its next piece when it is done with one. */
const PIECES_AHEAD = 2

/**
 * Pieces grow and shrink so that a worker is heard of about ten times a second, whether an element takes a microsecond or, where each is
 * analysed exactly, milliseconds. What is found does not depend on it.
 */
const PIECE_MILLISECONDS = 100
const MOST_BLOCKS = 256

/** Milliseconds to wait, after a stop, for pieces under way. */
const PATIENCE = 1000

export class Search {
  readonly tally: Tally
  readonly #workers: SearchWorkers
  readonly #onNews: () => void
  readonly #onFailure: (reason: Error) => void
  readonly #ports: WorkerPort[] = []
  /** The time at which each worker last answered or was begun. */
  readonly #heard = new Map<WorkerPort, number>()
  /** Pieces done before an earlier one, by their first blocks. */
  readonly #early = new Map<number, PieceFinds>()
  /** Blocks: the next to be handed out, where to end, and how many a piece has. */
  #next: number
  #most = Infinity
  #blocks = 1
  #isRunning = false

  /**
   * `onNews` is told whenever there is more; `onFailure` once, where a worker does not start or breaks: the search is over then. It goes
   * on where the tally ends.
   */
  constructor(
    query: Query,
    workers: SearchWorkers,
    onNews: () => void,
    onFailure: (reason: Error) => void,
    tally = new Tally(query),
  ) {
    this.tally = tally
    this.#next = tally.blocks
    this.#workers = workers
    this.#onNews = onNews
    this.#onFailure = onFailure
  }

  get isRunning(): boolean {
    return this.#isRunning
  }

  get query(): Query {
    return this.tally.query
  }

  /** Elements looked at, all of the stream up to there. */
  get elements(): number {
    return this.tally.elements
  }

  /** Elements that have the property. */
  get found(): number {
    return this.tally.found
  }

  finds(order: Order): readonly Find[] {
    return this.tally.finds(order)
  }

  /** Begins, or goes on where it was stopped; until so many elements have been looked at, if that is said. */
  start(elements = Infinity): void {
    this.#most = Math.ceil(elements / BLOCK)
    if (this.#isRunning || this.#next >= this.#most) return
    this.#isRunning = true
    while (this.#ports.length < this.#workers.count) this.#ports.push(this.#begin())
    for (const port of this.#ports) this.#heard.set(port, performance.now())
    for (let ahead = 0; ahead < PIECES_AHEAD; ++ahead) for (const port of this.#ports) this.#send(port)
  }

  /** Takes in what is under way and nothing more; what takes too long is left, to be done anew when the search goes on. */
  stop(patience = PATIENCE): void {
    if (!this.#isRunning) return
    this.#most = 0
    this.#settle()
    if (this.#isRunning) setTimeout(() => this.#leave(), patience)
    else this.#onNews()
  }

  #leave(): void {
    if (!this.#isRunning || this.#most > 0) return
    this.dispose()
    this.#onNews()
  }

  /** Ends the workers. What was found stays, and `start` begins others. */
  dispose(): void {
    this.#isRunning = false
    this.#next = this.tally.blocks
    this.#early.clear()
    for (const port of this.#ports.splice(0)) {
      port.onmessage = null
      port.terminate()
    }
  }

  #begin(): WorkerPort {
    const port = this.#workers.spawn()
    port.onmessage = ({ data }) => this.#take(port, data)
    port.onerror = ({ message }) => this.#fail(brokenWorker(message))
    port.postMessage({ kind: 'start', module: this.#workers.module })
    port.postMessage({ kind: 'query', query: this.query })
    return port
  }

  #send(port: WorkerPort): void {
    const blocks = Math.min(this.#blocks, this.#most - this.#next)
    if (blocks <= 0) return
    port.postMessage({ kind: 'piece', piece: { first: this.#next, blocks } })
    this.#next += blocks
  }

  #take(port: WorkerPort, reply: Reply): void {
    if (reply.kind === 'failed') this.#fail(reply.message)
    if (reply.kind !== 'result') return
    this.#measure(port, reply.result)
    this.#send(port)
    this.#early.set(reply.result.piece.first, reply.result)
    const { tally } = this
    for (let result = this.#early.get(tally.blocks); result; result = this.#early.get(tally.blocks)) {
      this.#early.delete(tally.blocks)
      tally.take(result)
    }
    this.#settle()
    this.#onNews()
  }

  #measure(port: WorkerPort, { piece }: PieceFinds): void {
    const now = performance.now()
    const took = now - (this.#heard.get(port) ?? now)
    this.#heard.set(port, now)
    const fitting = (piece.blocks * PIECE_MILLISECONDS) / Math.max(took, 1)
    // No more than twice as many at a time: the first ones take long, and one may be an exception.
    this.#blocks = Math.floor(Math.max(1, Math.min(fitting, 2 * this.#blocks, MOST_BLOCKS)))
  }

  #settle(): void {
    if (this.tally.blocks === this.#next && this.#next >= this.#most) this.#isRunning = false
  }

  #fail(message: string): void {
    this.dispose()
    this.#onFailure(new Error(message))
  }
}

interface ImprovementOptions<Improved> {
  readonly signal?: AbortSignal
  /** Told of the best so far. */
  readonly onStep?: (improved: Improved) => void
}

type ImprovingWorkers = Pick<SearchWorkers, 'module' | 'spawn'>

/** Polishes in a worker of its own. Rejects with the signal's reason, or if the worker fails. */
export function polished(
  query: Query,
  vertices: Vertices,
  workers: ImprovingWorkers,
  options: ImprovementOptions<Polished> = {},
): Promise<Polished> {
  return improved('polish', query, vertices, workers, options)
}

/** Climbs in a worker of its own. Rejects with the signal's reason, or if the worker fails. */
export function climbed(
  query: Query,
  vertices: Vertices,
  workers: ImprovingWorkers,
  options: ImprovementOptions<Climbed> = {},
): Promise<Climbed> {
  return improved('climb', query, vertices, workers, options)
}

function improved<Kind extends keyof Improved>(
  kind: Kind,
  query: Query,
  vertices: Vertices,
  { module, spawn }: ImprovingWorkers,
  { signal, onStep = () => {} }: ImprovementOptions<Improved[Kind]>,
): Promise<Improved[Kind]> {
  const port = spawn()
  return new Promise<Improved[Kind]>((resolve, reject) => {
    signal?.throwIfAborted()
    signal?.addEventListener('abort', () => reject(signal.reason))
    port.onerror = ({ message }) => reject(new Error(brokenWorker(message)))
    port.onmessage = ({ data }) => {
      if (data.kind === 'better') onStep(data.improved as Improved[Kind])
      if (data.kind === 'best') resolve(data.improved as Improved[Kind])
      if (data.kind === 'failed') reject(new Error(data.message))
    }
    port.postMessage({ kind: 'start', module })
    port.postMessage({ kind, query, vertices })
  }).finally(() => port.terminate())
}

function brokenWorker(reason = 'the browser gives no reason'): string {
  return `a worker did not start or broke (${reason}).`
}
