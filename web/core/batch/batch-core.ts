/**
 * Batches in one thread: pieces of cells through hl_classify of the C core. The only place that sees the memory of
 * hexlens-batch.wasm; the contracts are those of wasm/include/hexlens.h.
 */
import { COORDINATE_COUNT } from '../../model/hexahedron'
import { CandidateList, type CandidateOptions, type Candidates } from './candidates'
import {
  type Answers,
  addressesOf,
  answersOf,
  bytesPerCell,
  emptyLists,
  type Lists,
  listsIn,
  putLists,
  type Wanted,
} from './lists'

/**
 * Some cells: with `cells`, eight indices each of the points, whose numbers begin at `firstPoint`; without, 24 coordinates each. Without
 * points, those that the core holds.
 */
export interface Piece {
  readonly points: Float64Array | null
  readonly cells: Uint32Array | null
  readonly firstPoint: number
}

export interface Counts {
  readonly validCount: number
  readonly invalidCount: number
  /** Cells with a coordinate that is not finite or an index that is not a point's; the others are answered all the same. */
  readonly unansweredCount: number
  /** The first of those; null if there is none. */
  readonly firstUnanswered: number | null
  /** Cells that integers decided; 0 unless the list `exact` or minima are asked for. */
  readonly exactCount: number
  /** Cells of the class inverted, with coincident vertices, and invalid ones that checks accept, in the lists that are asked for; else 0. */
  readonly invertedCount: number
  readonly coincidentCount: number
  readonly acceptedByCornersCount: number
  readonly acceptedByVtkCount: number
  /** Null unless it is asked for. It says nothing where a cell is unanswered. */
  readonly box: Box | null
}

/** Least x, y and z of some cells' vertices, then the greatest; infinities of no cell. */
export type Box = readonly [number, number, number, number, number, number]

export type PieceResult<W extends Wanted = Wanted> = Answers<W> & Counts & WithCandidates

export interface WithCandidates {
  /** Null where they were not asked for, or are too many. */
  readonly candidates: Candidates | null
}

export interface BatchOptions {
  /** Makes room for the answers to so many cells, when the cells are no longer read; else they get new lists. */
  readonly into?: (count: number) => Lists
  /** Called now and then with how many cells are done. */
  readonly onProgress?: (done: number) => void
  /** Only together with minima. */
  readonly worst?: CandidateOptions | null
}

export interface BatchCore {
  /** The cells are whole: a length that is not is the caller's mistake. */
  classify<W extends Wanted>(piece: Piece, wanted: W, options?: BatchOptions): PieceResult<W>
  /** Holds a copy of points for pieces that come without any. */
  hold(points: Float64Array): void
}

interface BatchExports {
  readonly memory: WebAssembly.Memory
  _initialize?(): void
  lists_address(): number
  counts_address(): number
  box_address(): number
  candidates_address(): number
  about_address(): number
  take_from(indices: number, count: number, first: number): void
  classify(
    coordinates: number,
    coordinateCount: number,
    indices: number,
    indexCount: number,
    hasBox: number,
    hasCandidates: number,
    limit: number,
  ): number
}

const VERTICES = 8
const COUNT_COUNT = 10
const HL_OK = 0
const WASM_PAGE = 65536

/** Cells that go into the core's memory at once: 200 kB, which a processor's second cache holds; AT_ONCE of exports_batch.c. */
const CELLS_PER_CUT = 1024

export function cellCount({ points, cells }: Piece): number {
  return cells ? Math.floor(cells.length / VERTICES) : Math.floor((points?.length ?? 0) / COORDINATE_COUNT)
}

/** `a` counts the cells before `first`, `b` those from there on. */
export function sumOfCounts(a: Counts, b: Counts, first: number): Counts {
  const found = [a.firstUnanswered, b.firstUnanswered === null ? null : first + b.firstUnanswered]
  const cells = found.filter(cell => cell !== null)
  return {
    validCount: a.validCount + b.validCount,
    invalidCount: a.invalidCount + b.invalidCount,
    unansweredCount: a.unansweredCount + b.unansweredCount,
    firstUnanswered: cells.length > 0 ? Math.min(...cells) : null,
    exactCount: a.exactCount + b.exactCount,
    invertedCount: a.invertedCount + b.invertedCount,
    coincidentCount: a.coincidentCount + b.coincidentCount,
    acceptedByCornersCount: a.acceptedByCornersCount + b.acceptedByCornersCount,
    acceptedByVtkCount: a.acceptedByVtkCount + b.acceptedByVtkCount,
    box: a.box && b.box ? boxOfBoth(a.box, b.box) : (a.box ?? b.box),
  }
}

function boxOfBoth(a: Box, b: Box): Box {
  return a.map((own, i) => (i < 3 ? Math.min : Math.max)(own, b[i] as number)) as unknown as Box
}

/** The counts alone, of an answer that has lists, too. */
export function countsOf(all: Counts): Counts {
  return Object.fromEntries(
    Object.keys(NOTHING_COUNTED).map(key => [key, all[key as keyof Counts]]),
  ) as unknown as Counts
}

export const NOTHING_COUNTED: Counts = {
  validCount: 0,
  invalidCount: 0,
  unansweredCount: 0,
  firstUnanswered: null,
  exactCount: 0,
  invertedCount: 0,
  coincidentCount: 0,
  acceptedByCornersCount: 0,
  acceptedByVtkCount: 0,
  box: null,
}

const EMPTY_BOX: Box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity]

/** Starts the core in a compiled hexlens-batch.wasm or hexlens-scalar.wasm. */
export async function loadBatchCore(module: WebAssembly.Module): Promise<BatchCore> {
  const instance = await WebAssembly.instantiate(module, {})
  const wasm = instance.exports as unknown as BatchExports
  wasm._initialize?.()
  const { memory } = wasm
  const start = memory.buffer.byteLength
  /** Doubles that are held, and the room for them. */
  let [heldCount, held] = [0, 0]

  /** Addresses of lists of these sizes in bytes, one after the other in memory that nothing else uses. */
  function reserve(sizes: readonly number[]): number[] {
    let next = start + 8 * held
    const addresses = sizes.map(size => {
      const address = next
      next += Math.ceil(size / 64) * 64
      return address
    })
    const missing = next - memory.buffer.byteLength
    if (missing > 0) memory.grow(Math.ceil(missing / WASM_PAGE))
    return addresses
  }

  function hold(points: Float64Array): void {
    held = 0
    reserve([points.byteLength])
    new Float64Array(memory.buffer, start, points.length).set(points)
    held = Math.ceil(points.length / 8) * 8
    heldCount = points.length
  }

  function classify(piece: Piece, wanted: Wanted, { into, onProgress, worst = null }: BatchOptions = {}): PieceResult {
    const { points, cells } = piece
    const count = cellCount(piece)
    const coordinateCount = points?.length ?? heldCount
    const [atOwn, atCells, atLists] = reserve([
      cells ? (points?.byteLength ?? 0) : 8 * COORDINATE_COUNT * Math.min(CELLS_PER_CUT, count),
      cells?.byteLength ?? 0,
      count * bytesPerCell(wanted),
    ]) as [number, number, number]
    const atPoints = points ? atOwn : start
    if (cells) {
      if (points) new Float64Array(memory.buffer, atPoints, points.length).set(points)
      new Uint32Array(memory.buffer, atCells, cells.length).set(cells)
      // An index before the first point becomes one that is far too large.
      if (piece.firstPoint > 0) wasm.take_from(atCells, cells.length, piece.firstPoint)
    }
    const lists = listsIn(memory.buffer, count, wanted, atLists)
    const box = new Float64Array(memory.buffer, wasm.box_address(), EMPTY_BOX.length)
    box.set(EMPTY_BOX)
    const list = worst && new CandidateList(worst)
    let counts = NOTHING_COUNTED
    for (let first = 0, end = 0; first < count; first = end) {
      end = Math.min(first + CELLS_PER_CUT, count)
      const addresses = addressesOf(lists, first)
      new Uint32Array(memory.buffer, wasm.lists_address(), addresses.length).set(addresses)
      counts = sumOfCounts(counts, cells ? indexed(first, end) : plain(first, end), first)
      if (list) takeCandidates(list, first)
      onProgress?.(end)
    }
    const answers = into ? into(count) : emptyLists(count, wanted)
    putLists(lists, answers, 0)
    return {
      ...answersOf(answers),
      ...counts,
      box: wanted.box ? ([...box] as unknown as Box) : null,
      candidates: list?.candidates ?? null,
    }

    function plain(first: number, end: number): Counts {
      const part = (points as Float64Array).subarray(COORDINATE_COUNT * first, COORDINATE_COUNT * end)
      new Float64Array(memory.buffer, atPoints, part.length).set(part)
      return counted(wasm.classify(atPoints, part.length, 0, 0, ...flags()), end - first)
    }

    function indexed(first: number, end: number): Counts {
      const at = atCells + 4 * VERTICES * first
      const status = wasm.classify(atPoints, coordinateCount, at, VERTICES * (end - first), ...flags())
      return counted(status, end - first)
    }

    function flags() {
      return [Number(wanted.box === true), Number(list !== null), list?.limit ?? 0] as const
    }
  }

  function counted(status: number, count: number): Counts {
    if (status !== HL_OK) throw new Error(`The core answered a batch with the status ${status}.`)
    const numbers = new Uint32Array(memory.buffer, wasm.counts_address(), COUNT_COUNT)
    const [validCount, invalidCount, unansweredCount, exactCount, first, ...more] = numbers as unknown as Ten
    const [invertedCount, coincidentCount, acceptedByCornersCount, acceptedByVtkCount] = more
    return {
      validCount,
      invalidCount,
      unansweredCount,
      firstUnanswered: first < count ? first : null,
      exactCount,
      invertedCount,
      coincidentCount,
      acceptedByCornersCount,
      acceptedByVtkCount,
      box: null,
    }
  }

  /** The candidates of the last call go into the list. */
  function takeCandidates(list: CandidateList, first: number): void {
    const [count] = new Uint32Array(memory.buffer, wasm.counts_address() + 4 * (COUNT_COUNT - 1), 1)
    const about = new Float32Array(memory.buffer, wasm.about_address(), CELLS_PER_CUT)
    for (const cell of new Uint32Array(memory.buffer, wasm.candidates_address(), count)) {
      const own = about[cell] as number
      list.take(first + cell, Number.isNaN(own) ? -Infinity : own)
    }
  }

  return { classify: classify as BatchCore['classify'], hold }
}

type Ten = [number, number, number, number, number, number, number, number, number, number]
