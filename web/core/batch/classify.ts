/**
 * Validity and boundary minima of many hexahedra on a pool of workers, and what else is asked of them. Every verdict is exact, and every
 * answer the same as one by one, bit for bit, whatever the number of workers and whatever the machine's vectors.
 */
import type { CoreError, Result } from '../report'
import { Pool, type PoolOptions, unlessAborted } from '../workers'
import { type Counts, cellCount, NOTHING_COUNTED, type Piece, sumOfCounts, type WithCandidates } from './batch-core'
import type { BatchJobs } from './batch-jobs'
import { type Answers, answersOf, bytesPerCell, emptyLists, listsIn, putLists, type Wanted, wantedOf } from './lists'
import { type Cut, isWhole, pieces, Recycled } from './pieces'

export interface Progress {
  /** Cells. */
  readonly done: number
  readonly total: number
}

/** Lists beside the verdicts, each alone: `{ minima: true, volumes: true }`; and how the work is watched. */
export interface ClassifyOptions extends Wanted {
  /** When it aborts, the promise rejects with its reason and the work ends. */
  readonly signal?: AbortSignal
  /** Called at least ten times a second. */
  readonly onProgress?: (progress: Progress) => void
}

/** Lists that were not asked for are null. */
export type Classification<W extends Wanted = Wanted> = Answers<W> & Counts & Partial<WithCandidates>

export interface StreamOptions extends Omit<ClassifyOptions, 'onProgress'> {
  /**
   * The chunks' memory goes to the workers, wherever a chunk has it to itself: nothing is copied then, and the chunk's lists are empty
   * afterwards. The answers lie in the memory of `points` if they fit, which they always do without `cells`, else in new memory: a byte a
   * cell, 42 more with minima, 66 with all lists. So `valid.buffer` is memory for another chunk when they are no longer needed; its
   * `byteLength` says for how large a one. A chunk that is part of a longer list is copied.
   */
  readonly handOver?: boolean
}

/** Some cells of a stream: with `cells`, eight indices each of these points; without, 24 coordinates each. */
export interface CellChunk {
  readonly points: Float64Array
  readonly cells?: Uint32Array | null
}

/**
 * If a worker is ended from outside, throws, does not start or runs out of memory, the calls that had cells there reject with an Error
 * whose message is a sentence; calls on other workers go on, and the next call starts another worker.
 */
export interface Classifier {
  /**
   * With `cells`, each is eight indices of points of three coordinates; without (null), each is 24 coordinates; in VTK_HEXAHEDRON
   * order. A cell with a coordinate that is not finite or an index that is not a point's is unanswered, and does not stop the others:
   * `unansweredCount`, `firstUnanswered`, and with `statuses` why. Lists of a wrong length are refused. The lists are read until the
   * promise is settled, and not changed.
   */
  classify<W extends ClassifyOptions>(
    points: Float64Array,
    cells: Uint32Array | null,
    options?: W,
  ): Promise<Result<Classification<W>>>
  /**
   * The same for cells that are too many for the memory: chunk after chunk as they are asked for, answers in their order, each with
   * its chunk's counts. The stream ends after the first chunk that is refused; the refusal's `cell` counts from the stream's first.
   */
  stream<W extends StreamOptions>(
    chunks: Iterable<CellChunk> | AsyncIterable<CellChunk>,
    options?: W,
  ): AsyncGenerator<Result<Classification<W>>>
  /** Ends the workers; the promises of what is under way reject. A call afterwards starts new ones. */
  close(): void
}

/** Large beside what a message costs, small beside the memory of a page: 3 MB of coordinates. */
const CELLS_PER_PIECE = 16384

interface ClassifierWorkers extends Omit<PoolOptions<WebAssembly.Module>, 'name'> {
  readonly cellsPerPiece?: number
}

class BatchPool extends Pool<WebAssembly.Module, BatchJobs> {
  readonly cellsPerPiece: number

  constructor({ cellsPerPiece = CELLS_PER_PIECE, ...workers }: ClassifierWorkers) {
    super({ ...workers, name: 'A worker for batches' })
    this.cellsPerPiece = cellsPerPiece
  }
}

/** `start` is the compiled module. */
export function classifierOn(workers: ClassifierWorkers): Classifier {
  const pool = new BatchPool(workers)
  return {
    classify: (points, cells, options) => classify(pool, points, cells, options ?? {}),
    stream: (chunks, options) => stream(pool, chunks, options ?? {}),
    close: () => pool.stop(new Error('The classifier was closed.')),
  } as Classifier
}

async function classify(
  pool: BatchPool,
  points: Float64Array,
  cells: Uint32Array | null,
  { signal, onProgress, ...options }: ClassifyOptions,
): Promise<Result<Classification>> {
  signal?.throwIfAborted()
  if (!isWhole(points, cells)) return { ok: false, error: incomplete(points, cells) }
  const wanted = wantedOf(options)
  const total = cellCount({ points, cells, firstPoint: 0 })
  const lists = emptyLists(total, wanted)
  const memory = new Recycled()
  const partlyDone = new Map<Cut, number>()
  let [done, counts] = [0, NOTHING_COUNTED]

  const showProgress = () => onProgress?.({ done: done + [...partlyDone.values()].reduce((a, b) => a + b, 0), total })

  async function run(cut: Cut): Promise<void> {
    const { first, count, piece, block } = cut
    const onPieceProgress = (cellsDone: number) => {
      partlyDone.set(cut, cellsDone)
      showProgress()
    }
    const options = { caller: memory, onProgress: onPieceProgress }
    const back = await pool.run('classify', { piece, block, wanted }, options)
    counts = sumOfCounts(counts, back.counts, first)
    putLists(listsIn(back.block, count, wanted), lists, first)
    memory.give(back.block)
    partlyDone.delete(cut)
    done += count
    showProgress()
  }

  async function runAll(): Promise<void> {
    const underWay = new Set<Promise<void>>()
    for (const cut of pieces({ points, cells }, { cellsPerPiece: pool.cellsPerPiece, wanted, memory })) {
      const running = run(cut).finally(() => underWay.delete(running))
      running.catch(() => {}) // whoever waits for it hears of it
      underWay.add(running)
      if (underWay.size >= pool.capacity) await Promise.race(underWay)
      signal?.throwIfAborted()
    }
    await Promise.all(underWay)
  }

  const cancel = (reason: unknown) => pool.cancel(memory, reason)
  try {
    await unlessAborted(signal, cancel, runAll)
  } catch (reason) {
    cancel(reason)
    throw reason
  }
  return { ok: true, value: { ...answersOf(lists), ...counts } }
}

async function* stream(
  pool: BatchPool,
  chunks: Iterable<CellChunk> | AsyncIterable<CellChunk>,
  { handOver = false, ...options }: StreamOptions,
): AsyncGenerator<Result<Classification>> {
  const underWay: { result: Promise<Result<Classification>>; count: number }[] = []
  let before = 0
  async function* next() {
    const { result, count } = underWay.shift() as (typeof underWay)[number]
    const answer = await result
    yield answer.ok ? answer : { ok: false as const, error: inStream(answer.error, before) }
    before += count
    return answer.ok
  }
  for await (const { points, cells = null } of chunks) {
    const piece = { points, cells, firstPoint: 0 }
    const count = cellCount(piece)
    const isHandedOver = handOver && count > 0 && isWhole(points, cells) && [points, cells].every(hasMemoryToItself)
    const result = isHandedOver ? classifyWhole(pool, piece, options) : classify(pool, points, cells, options)
    result.catch(() => {}) // whoever waits for it hears of it
    underWay.push({ result, count })
    if (underWay.length >= pool.capacity && !(yield* next())) return
  }
  while (underWay.length > 0) if (!(yield* next())) return
}

function hasMemoryToItself(list: Float64Array | Uint32Array | null): boolean {
  return list === null || (list.byteLength === list.buffer.byteLength && list.buffer instanceof ArrayBuffer)
}

/** One piece, whose memory the worker gets; the answers lie in it, if it has room for them. */
async function classifyWhole(
  pool: BatchPool,
  piece: Piece,
  { signal, ...options }: ClassifyOptions,
): Promise<Result<Classification>> {
  const wanted = wantedOf(options)
  const count = cellCount(piece)
  const length = count * bytesPerCell(wanted)
  const own = (piece.points as Float64Array).buffer as ArrayBuffer
  const caller = {}
  const cancel = (reason: unknown) => pool.cancel(caller, reason)
  const { counts, block } = await unlessAborted(signal, cancel, () => {
    const block = own.byteLength >= length ? own : new ArrayBuffer(length)
    return pool.run('classify', { piece, block, wanted }, { caller })
  })
  return { ok: true, value: { ...answersOf(listsIn(block, count, wanted)), ...counts } }
}

function inStream(error: CoreError, before: number): CoreError {
  if (error.cell === undefined) return error
  const cell = before + error.cell
  return { ...error, cell, message: error.message.replace(`Cell ${error.cell}`, `Cell ${cell}`) }
}

/** Lists of a wrong length, in a sentence. */
function incomplete(points: Float64Array, cells: Uint32Array | null): CoreError {
  const cell = cellCount({ points, cells, firstPoint: 0 })
  const code = 'incomplete'
  if (!cells) return { code, cell, message: `Cell ${cell} is incomplete: 24 coordinates make one.` }
  if (cells.length % 8 > 0) return { code, cell, message: `Cell ${cell} is incomplete: eight indices make one.` }
  return { code, message: `The last point is incomplete: three coordinates make one, and there are ${points.length}.` }
}
