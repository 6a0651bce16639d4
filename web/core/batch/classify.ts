/**
 * Validity and boundary minima of many hexahedra on a pool of workers. Every verdict is exact, and every answer the same as one by
 * one, bit for bit, whatever the number of workers and whatever the machine's vectors.
 */
import type { CoreErrorCode, Result } from '../report'
import { type Answers, answersIn, answersLength, cellCount, emptyAnswers, type Piece, putAnswers } from './batch-core'
import { type Cut, isWhole, pieces, Recycled } from './pieces'
import type { Pool } from './pool'

export interface Progress {
  /** Cells. */
  readonly done: number
  readonly total: number
}

export interface ClassifyOptions {
  /** Boundary minima as well; they cost more than verdicts. */
  readonly minima?: boolean
  /** When it aborts, the promise rejects with its reason and the work ends. */
  readonly signal?: AbortSignal
  /** Called at least ten times a second. */
  readonly onProgress?: (progress: Progress) => void
}

export interface Classification extends Answers {
  readonly validCount: number
  /** How many cells exact arithmetic decided. */
  readonly exact: number
}

export interface StreamOptions extends Omit<ClassifyOptions, 'onProgress'> {
  /**
   * The chunks' memory goes to the workers, wherever a chunk has it to itself: nothing is copied then, and the chunk's lists are empty
   * afterwards. The answers lie in the memory of `points` if they fit, which they always do without `cells`, else in new memory: 43 bytes a
   * cell with minima, one without. So `valid.buffer` is memory for another chunk when they are no longer needed; its `byteLength` says for how
   * large a one. A chunk that is part of a longer list is copied.
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
   * order. Cells that are not ones are refused with the first of them, and nothing is answered then. The lists are read until the
   * promise is settled, and not changed.
   */
  classify(points: Float64Array, cells: Uint32Array | null, options?: ClassifyOptions): Promise<Result<Classification>>
  /**
   * The same for cells that are too many for the memory: chunk after chunk as they are asked for, answers in their order. The
   * stream ends after the first refusal, whose `cell` counts from the stream's first.
   */
  stream(
    chunks: Iterable<CellChunk> | AsyncIterable<CellChunk>,
    options?: StreamOptions,
  ): AsyncGenerator<Result<Classification>>
  /** Ends the workers; the promises of what is under way reject. A call afterwards starts new ones. */
  close(): void
}

export function classifierOn(pool: Pool): Classifier {
  return {
    classify: (points, cells, options = {}) => classify(pool, points, cells, options),
    stream: (chunks, options = {}) => stream(pool, chunks, options),
    close: () => pool.stop(new Error('The classifier was closed.')),
  }
}

interface Fault {
  readonly cell: number
  readonly code: CoreErrorCode
}

async function classify(
  pool: Pool,
  points: Float64Array,
  cells: Uint32Array | null,
  { minima: wantsMinima = false, signal, onProgress }: ClassifyOptions,
): Promise<Result<Classification>> {
  signal?.throwIfAborted()
  const total = cellCount({ points, cells, firstPoint: 0 })
  const answers = emptyAnswers(total, wantsMinima)
  const memory = new Recycled()
  const partlyDone = new Map<Cut, number>()
  let [fault, done, exact, validCount] = [null as Fault | null, 0, 0, 0]

  const noteFault = (found: Fault | null) => {
    if (found && (!fault || found.cell < fault.cell)) fault = found
  }
  const showProgress = () => onProgress?.({ done: done + [...partlyDone.values()].reduce((a, b) => a + b, 0), total })

  async function run(cut: Cut): Promise<void> {
    const { first, count, piece, block } = cut
    if (cut.fault) noteFault({ cell: first + count, code: cut.fault })
    const onPartDone = (cellsDone: number) => {
      partlyDone.set(cut, cellsDone)
      showProgress()
    }
    const { counts, ...back } = await pool.run({ piece, block, wantsMinima, caller: memory, onProgress: onPartDone })
    if (counts.fault) noteFault({ cell: first + counts.fault.cell, code: counts.fault.code })
    putAnswers(answersIn(back.block, count, wantsMinima), answers, first)
    memory.give(back.block)
    validCount += counts.validCount
    exact += counts.exact
    partlyDone.delete(cut)
    done += count
    showProgress()
  }

  const onAbort = () => pool.cancel(memory, signal?.reason)
  signal?.addEventListener('abort', onAbort)
  try {
    const underWay = new Set<Promise<void>>()
    for (const cut of pieces({ points, cells }, { cellsPerPiece: pool.cellsPerPiece, wantsMinima, memory })) {
      if (fault) break // what is under way lies before it and may hold an earlier one
      if (cut.count === 0 && cut.fault === null) continue
      const running = run(cut).finally(() => underWay.delete(running))
      running.catch(() => {}) // whoever waits for it hears of it
      underWay.add(running)
      if (underWay.size >= pool.capacity) await Promise.race(underWay)
      signal?.throwIfAborted()
    }
    await Promise.all(underWay)
  } catch (reason) {
    pool.cancel(memory, reason)
    throw reason
  } finally {
    signal?.removeEventListener('abort', onAbort)
  }
  if (fault) return refusal(fault, points, cells)
  return { ok: true, value: { ...answers, validCount, exact } }
}

async function* stream(
  pool: Pool,
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

/** As one piece, whose memory the worker gets; the answers then lie in it, if it has room for them. */
async function classifyWhole(
  pool: Pool,
  piece: Piece,
  { minima: wantsMinima = false, signal }: ClassifyOptions,
): Promise<Result<Classification>> {
  signal?.throwIfAborted()
  const count = cellCount(piece)
  const length = answersLength(count, wantsMinima)
  const own = piece.points.buffer as ArrayBuffer
  const block = own.byteLength >= length ? own : new ArrayBuffer(length)
  const job = { piece, block, wantsMinima, caller: {}, onProgress: () => {} }
  const onAbort = () => pool.cancel(job.caller, signal?.reason)
  signal?.addEventListener('abort', onAbort)
  try {
    const { counts, ...back } = await pool.run(job)
    const { validCount, exact, fault } = counts
    if (fault) return refusal(fault, back.piece.points, back.piece.cells)
    return { ok: true, value: { ...answersIn(back.block, count, wantsMinima), validCount, exact } }
  } finally {
    signal?.removeEventListener('abort', onAbort)
  }
}

function inStream(error: { code: CoreErrorCode; message: string; cell?: number }, before: number) {
  if (error.cell === undefined) return error
  const cell = before + error.cell
  return { ...error, cell, message: error.message.replace(`Cell ${error.cell}`, `Cell ${cell}`) }
}

/** The first cell that is none, in a sentence. */
function refusal({ cell, code }: Fault, points: Float64Array, cells: Uint32Array | null): Result<never> {
  const refuse = (message: string) => ({ ok: false as const, error: { code, message: `Cell ${cell}${message}`, cell } })
  const index = (v: number) => (cells ? (cells[8 * cell + v] as number) : 8 * cell + v)
  const eight = [0, 1, 2, 3, 4, 5, 6, 7]
  if (code === 'incomplete')
    return refuse(
      cells
        ? ' is incomplete: eight indices make one, and three coordinates a point.'
        : ' is incomplete: 24 coordinates make one.',
    )
  if (code === 'no-such-point') {
    const vertex = eight.find(v => index(v) >= Math.floor(points.length / 3)) as number
    return refuse(`, vertex ${vertex}: there is no point ${index(vertex)}.`)
  }
  for (const v of eight)
    for (let axis = 0; axis < 3; ++axis)
      if (!Number.isFinite(points[3 * index(v) + axis]))
        return refuse(`, vertex ${v} ${'xyz'[axis]} is not a finite number.`)
  throw new Error(`Cell ${cell} was refused and is finite.`)
}
