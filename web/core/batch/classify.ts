/**
 * Validity and boundary minima of many hexahedra on a pool of workers. Every verdict is exact, and every answer the same as one by
 * one, bit for bit, whatever the number of workers and whatever the machine's vectors.
 */
import { COORDINATE_COUNT } from '../../model/hexahedron'
import type { CoreErrorCode, Result } from '../report'
import { emptyMinima, type Minima, type PieceResult } from './batch-core'
import { type Cut, pieces, Recycled } from './pieces'
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

export interface Classification {
  /** 1 for a valid cell, 0 for an invalid one. */
  readonly valid: Uint8Array
  readonly validCount: number
  readonly minima: Minima | null
  /** How many cells exact arithmetic decided. */
  readonly exact: number
}

/** Some cells of a stream: with `cells`, eight indices each of these points; without, 24 coordinates each. */
export interface CellChunk {
  readonly points: Float64Array
  readonly cells?: Uint32Array | null
}

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
    options?: Omit<ClassifyOptions, 'onProgress'>,
  ): AsyncGenerator<Result<Classification>>
  /** Ends the workers; what is under way is refused. */
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
  const total = Math.floor(cells ? cells.length / 8 : points.length / COORDINATE_COUNT)
  const valid = new Uint8Array(total)
  const minima = wantsMinima ? emptyMinima(total) : null
  const memory = new Recycled()
  const partlyDone = new Map<Cut, number>()
  let [fault, done, exact, validCount] = [null as Fault | null, 0, 0, 0]

  const noteFault = (found: Fault | null) => {
    if (found && (!fault || found.cell < fault.cell)) fault = found
  }
  const showProgress = () => onProgress?.({ done: done + [...partlyDone.values()].reduce((a, b) => a + b, 0), total })

  async function run(cut: Cut): Promise<void> {
    const { first, count, piece } = cut
    if (cut.fault) noteFault({ cell: first + count, code: cut.fault })
    const onPartDone = (cellsDone: number) => {
      partlyDone.set(cut, cellsDone)
      showProgress()
    }
    const { result, points: used } = await pool.run({ piece, wantsMinima, caller: memory, onProgress: onPartDone })
    memory.give(used)
    if (result.fault) noteFault({ cell: first + result.fault.cell, code: result.fault.code })
    put(result, valid, minima, first)
    validCount += result.validCount
    exact += result.exact
    partlyDone.delete(cut)
    done += count
    showProgress()
  }

  const onAbort = () => pool.cancel(memory, signal?.reason)
  signal?.addEventListener('abort', onAbort)
  try {
    const underWay = new Set<Promise<void>>()
    for (const cut of pieces(points, cells, pool.cellsPerPiece, memory)) {
      if (fault) break // what is under way lies before it and may hold an earlier one
      if (cut.count === 0 && cut.fault === null) continue
      const running = run(cut).finally(() => underWay.delete(running))
      underWay.add(running)
      if (underWay.size >= pool.capacity) await Promise.race(underWay)
      signal?.throwIfAborted()
    }
    await Promise.all(underWay)
  } finally {
    signal?.removeEventListener('abort', onAbort)
  }
  if (fault) return refusal(fault, points, cells)
  return { ok: true, value: { valid, validCount, minima, exact } }
}

/** Puts a piece's answers in their place. */
function put(result: PieceResult, valid: Uint8Array, minima: Minima | null, first: number): void {
  valid.set(result.valid, first)
  if (minima && result.minima) {
    minima.values.set(result.minima.values, first)
    minima.minimizers.set(result.minima.minimizers, 3 * first)
    minima.cornerMinima.set(result.minima.cornerMinima, first)
    minima.exponents.set(result.minima.exponents, first)
  }
}

async function* stream(
  pool: Pool,
  chunks: Iterable<CellChunk> | AsyncIterable<CellChunk>,
  { minima = false, signal }: Omit<ClassifyOptions, 'onProgress'>,
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
    const count = Math.floor(cells ? cells.length / 8 : points.length / COORDINATE_COUNT)
    const result = classify(pool, points, cells, { minima, ...(signal ? { signal } : {}) })
    result.catch(() => {}) // whoever waits for it hears of it
    underWay.push({ result, count })
    if (underWay.length > pool.size && !(yield* next())) return
  }
  while (underWay.length > 0) if (!(yield* next())) return
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
