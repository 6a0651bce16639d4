/**
 * A search under way: workers go through the stream of elements piece by piece, and what they find is taken in the stream's order, so
 * that after so many elements the finds are the same however many workers there are.
 */
import { Pool, runAlone, type WorkerPort } from '../../../core/workers'
import type { Vertices } from '../../../model/hexahedron'
import type { Climbed } from './climb'
import type { Polished } from './polish'
import type { Query } from './query'
import type { Find, Order } from './ranking'
import { BLOCK, type PieceFinds } from './search-piece'
import { Tally } from './tally'
import type { SearchJobs, SearchStart } from './worker'

export interface SearchWorkers {
  /** hexlens-batch.wasm or hexlens-scalar.wasm, compiled. */
  readonly module: WebAssembly.Module
  readonly count: number
  readonly spawn: () => WorkerPort
}

/**
 * Pieces grow and shrink so that a worker is heard of about ten times a second, whether an element takes a microsecond or, where each is
 * analysed exactly, milliseconds. What is found does not depend on it.
 */
const PIECE_MILLISECONDS = 100
const MOST_BLOCKS = 256

/** A worker's in sentences. */
const NAME = 'a worker of this page'

/** Milliseconds to wait, after a stop, for pieces under way. */
const PATIENCE = 1000

export class Search {
  readonly tally: Tally
  readonly #workers: SearchWorkers
  readonly #onNews: () => void
  readonly #onFailure: (reason: Error) => void
  #pool: Pool<SearchStart, SearchJobs>
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
    this.#pool = poolOf(query, workers)
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
    for (let ahead = 0; ahead < this.#pool.capacity; ++ahead) void this.#search()
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
    const old = this.#pool
    this.#pool = poolOf(this.query, this.#workers)
    old.stop(null)
  }

  /** Hands out a piece, and when that is done the next one. Pools that were left have nothing more to say. */
  async #search(): Promise<void> {
    const pool = this.#pool
    while (pool === this.#pool && this.#next < this.#most) {
      const piece = { first: this.#next, blocks: Math.min(this.#blocks, this.#most - this.#next) }
      this.#next += piece.blocks
      const finds = await pool.run('search', piece).catch(reason => {
        if (pool === this.#pool) this.#fail(reason)
      })
      if (finds && pool === this.#pool) this.#take(finds)
    }
  }

  #take(finds: PieceFinds): void {
    this.#measure(finds)
    this.#early.set(finds.piece.first, finds)
    const { tally } = this
    for (let next = this.#early.get(tally.blocks); next; next = this.#early.get(tally.blocks)) {
      this.#early.delete(tally.blocks)
      tally.take(next)
    }
    this.#settle()
    this.#onNews()
  }

  #measure({ piece, milliseconds }: PieceFinds): void {
    const fitting = (piece.blocks * PIECE_MILLISECONDS) / Math.max(milliseconds, 1)
    // No more than twice as many at a time: the first ones take long, and one may be an exception.
    this.#blocks = Math.floor(Math.max(1, Math.min(fitting, 2 * this.#blocks, MOST_BLOCKS)))
  }

  #settle(): void {
    if (this.tally.blocks === this.#next && this.#next >= this.#most) this.#isRunning = false
  }

  #fail(reason: Error): void {
    this.dispose()
    this.#onFailure(reason)
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
  { module, spawn }: ImprovingWorkers,
  { signal, onStep = () => {} }: ImprovementOptions<Polished> = {},
): Promise<Polished> {
  const worker = { name: NAME, spawn, start: { module, query } }
  return runAlone<SearchJobs, 'polish'>(worker, { kind: 'polish', given: vertices }, { signal, onProgress: onStep })
}

/** Climbs in a worker of its own. Rejects with the signal's reason, or if the worker fails. */
export function climbed(
  query: Query,
  vertices: Vertices,
  { module, spawn }: ImprovingWorkers,
  { signal, onStep = () => {} }: ImprovementOptions<Climbed> = {},
): Promise<Climbed> {
  const worker = { name: NAME, spawn, start: { module, query } }
  return runAlone<SearchJobs, 'climb'>(worker, { kind: 'climb', given: vertices }, { signal, onProgress: onStep })
}

function poolOf(query: Query, { module, count, spawn }: SearchWorkers): Pool<SearchStart, SearchJobs> {
  return new Pool({ name: NAME, size: count, spawn, start: { module, query } })
}
