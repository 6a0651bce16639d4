/**
 * Batches in one thread: a piece of cells through the C core, and what its doubles leave open through exact arithmetic. The only
 * place that sees the memory of hexlens-batch.wasm; the contracts are those of hl_classify in wasm/include/hexlens.h.
 */
import { COORDINATE_COUNT } from '../../model/hexahedron'
import { type CoreExports, coreOf } from '../core'
import { exactBoundarySign } from '../exact/exact-sign'
import type { CoreErrorCode } from '../report'

/**
 * Some cells: with `cells`, eight indices each of the points, whose numbers begin at `firstPoint`; without, 24 coordinates each.
 */
export interface Piece {
  readonly points: Float64Array
  readonly cells: Uint32Array | null
  readonly firstPoint: number
}

/** One entry a cell. Values are jacdets on [0,1]^3, times 2^exponent, which is 0 wherever the doubles have room for the values. */
export interface Minima {
  readonly values: Float64Array
  /** Where it is attained: xi, eta, zeta. */
  readonly minimizers: Float64Array
  /** The least jacdet at the eight vertices. */
  readonly cornerMinima: Float64Array
  readonly exponents: Int16Array
}

/** One entry a cell. */
export interface Answers {
  /** 1 for a valid cell, 0 for an invalid one: exact, every one. */
  readonly valid: Uint8Array
  readonly minima: Minima | null
}

export interface PieceCounts {
  readonly validCount: number
  /** How many cells exact arithmetic decided. */
  readonly exact: number
  /** The first cell that is not one; those before it are answered. */
  readonly fault: { readonly cell: number; readonly code: CoreErrorCode } | null
}

export type PieceResult = Answers & PieceCounts

export interface BatchOptions {
  /** Makes room for the answers to so many cells, when the cells are no longer read: else, and where a cell is none, they get new lists. */
  readonly into?: (count: number) => Answers
  /** Called after each cell that exact arithmetic decided, with its index. */
  readonly onExact?: (cell: number) => void
}

export interface BatchCore {
  classify(piece: Piece, wantsMinima: boolean, options?: BatchOptions): PieceResult
}

interface BatchExports extends CoreExports {
  readonly memory: WebAssembly.Memory
  counts_address(): number
  classify(
    coordinates: number,
    coordinateCount: number,
    indices: number,
    indexCount: number,
    verdicts: number,
    minima: number,
    minimizers: number,
    cornerMinima: number,
    exponents: number,
  ): number
}

const VERTICES = 8
const HL_VALID = 1
const HL_UNDECIDED = 0
/** By hl_status, from HL_NOT_FINITE on. */
const FAULTS: Record<number, CoreErrorCode> = { 1: 'not-finite', 3: 'incomplete', 4: 'no-such-point' }
const WASM_PAGE = 65536

/** As many coordinates go into the core's memory at once as a processor's second cache holds beside the rest: 200 kB. */
const CELLS_PER_CUT = 1024

export function cellCount({ points, cells }: Piece): number {
  return cells ? Math.floor(cells.length / VERTICES) : Math.floor(points.length / COORDINATE_COUNT)
}

export function emptyAnswers(count: number, wantsMinima: boolean): Answers {
  return answersIn(new ArrayBuffer(answersLength(count, wantsMinima)), count, wantsMinima)
}

/** In bytes. */
export function answersLength(count: number, wantsMinima: boolean): number {
  return count * (wantsMinima ? 1 + 2 + 5 * 8 : 1)
}

/** The answers to so many cells as they lie in a block, from a byte on. */
export function answersIn(block: ArrayBuffer, count: number, wantsMinima: boolean, from = 0): Answers {
  if (!wantsMinima) return { valid: new Uint8Array(block, from, count), minima: null }
  const doubles = (first: number, length: number) => new Float64Array(block, from + 8 * first * count, length * count)
  return {
    valid: new Uint8Array(block, from + 42 * count, count),
    minima: {
      values: doubles(0, 1),
      minimizers: doubles(1, 3),
      cornerMinima: doubles(4, 1),
      exponents: new Int16Array(block, from + 40 * count, count),
    },
  }
}

/** Puts answers into longer lists, as those to the cells from `first` on. */
export function putAnswers({ valid, minima }: Answers, into: Answers, first: number): void {
  into.valid.set(valid, first)
  if (!minima || !into.minima) return
  into.minima.values.set(minima.values, first)
  into.minima.minimizers.set(minima.minimizers, 3 * first)
  into.minima.cornerMinima.set(minima.cornerMinima, first)
  into.minima.exponents.set(minima.exponents, first)
}

/** Starts the core in a compiled hexlens-batch.wasm or hexlens-scalar.wasm. */
export async function loadBatchCore(module: WebAssembly.Module): Promise<BatchCore> {
  const instance = await WebAssembly.instantiate(module, {})
  const wasm = instance.exports as unknown as BatchExports
  const core = coreOf(wasm)
  const { memory } = wasm
  const start = memory.buffer.byteLength

  /** Addresses of lists of these sizes in bytes, one after the other in memory that nothing else uses. */
  function reserve(sizes: readonly number[]): number[] {
    let next = start
    const addresses = sizes.map(size => {
      const address = next
      next += Math.ceil(size / 64) * 64
      return address
    })
    const missing = next - memory.buffer.byteLength
    if (missing > 0) memory.grow(Math.ceil(missing / WASM_PAGE))
    return addresses
  }

  function classify(
    piece: Piece,
    wantsMinima: boolean,
    { into = count => emptyAnswers(count, wantsMinima), onExact = () => {} }: BatchOptions = {},
  ): PieceResult {
    const { points, cells } = piece
    const count = cellCount(piece)
    const perCut = cells ? count : Math.min(CELLS_PER_CUT, count)
    const [atPoints, atCells, atAnswers] = reserve([
      8 * (cells ? points.length : COORDINATE_COUNT * perCut),
      cells?.byteLength ?? 0,
      answersLength(count, wantsMinima),
    ]) as [number, number, number]
    if (cells) copyIndices(cells, piece.firstPoint, new Uint32Array(memory.buffer, atCells, cells.length))
    const own = answersIn(memory.buffer, count, wantsMinima, atAnswers)
    const { valid, minima } = own
    let [first, undecided] = [0, 0]
    let fault: PieceCounts['fault'] = null
    do {
      const end = Math.min(first + perCut, count)
      const part = cells ? points : points.subarray(COORDINATE_COUNT * first, COORDINATE_COUNT * end)
      new Float64Array(memory.buffer, atPoints, part.length).set(part)
      const status = wasm.classify(
        atPoints,
        part.length,
        cells ? atCells : 0,
        cells?.length ?? 0,
        addressOf(valid, first),
        addressOf(minima?.values, first),
        addressOf(minima?.minimizers, 3 * first),
        addressOf(minima?.cornerMinima, first),
        addressOf(minima?.exponents, first),
      )
      const [left = 0, firstBad = 0] = new Uint32Array(memory.buffer, wasm.counts_address(), 2)
      const code = FAULTS[status]
      if (status !== 0 && code === undefined) throw new Error(`The core answered with an unknown status, ${status}.`)
      undecided += left
      if (code) fault = { cell: first + firstBad, code }
      first = end
    } while (first < count && fault === null)
    if (!cells && !fault && points.length % COORDINATE_COUNT > 0) fault = { cell: count, code: 'incomplete' }
    const done = fault?.cell ?? count
    if (undecided > 0) decideExactly(piece, done, valid, minima, onExact)
    let validCount = 0
    for (let c = 0; c < count; ++c) validCount += valid[c] = c < done && valid[c] === HL_VALID ? 1 : 0
    const answers = fault ? emptyAnswers(count, wantsMinima) : into(count)
    putAnswers(own, answers, 0)
    return { ...answers, validCount, exact: undecided, fault }
  }

  /** Those whose verdict is HL_UNDECIDED get HL_VALID or another one, and their minima from the report of exact arithmetic. */
  function decideExactly(
    piece: Piece,
    count: number,
    verdicts: Uint8Array,
    minima: Minima | null,
    onExact: (cell: number) => void,
  ): void {
    for (let c = verdicts.indexOf(HL_UNDECIDED); c >= 0 && c < count; c = verdicts.indexOf(HL_UNDECIDED, c + 1)) {
      const vertices = verticesOf(piece, c)
      const isValid = minima ? exactMinimum(vertices, c, minima) : exactBoundarySign(vertices) > 0
      verdicts[c] = isValid ? HL_VALID : HL_VALID + 1
      onExact(c)
    }
  }

  function exactMinimum(vertices: readonly number[], c: number, minima: Minima): boolean {
    const result = core.analyze(vertices)
    if (!result.ok) throw new Error(result.error.message)
    const { valid, boundaryMinimum, minimizer, cornerMinimum, exponent } = result.value
    minima.values[c] = boundaryMinimum
    minima.minimizers.set(minimizer.point, 3 * c)
    minima.cornerMinima[c] = cornerMinimum
    minima.exponents[c] = exponent
    return valid
  }

  return { classify }
}

/** 0 for no list. */
function addressOf(list: Float64Array | Int16Array | Uint8Array | undefined, first: number): number {
  return list ? list.byteOffset + first * list.BYTES_PER_ELEMENT : 0
}

/** An index before `firstPoint` becomes one that is far too large. */
function copyIndices(from: Uint32Array, firstPoint: number, to: Uint32Array): void {
  if (firstPoint === 0) to.set(from)
  else for (let i = 0; i < from.length; ++i) to[i] = (from[i] as number) - firstPoint
}

export function verticesOf({ points, cells, firstPoint }: Piece, cell: number): number[] {
  if (!cells) return Array.from(points.subarray(COORDINATE_COUNT * cell, COORDINATE_COUNT * (cell + 1)))
  const vertices: number[] = []
  for (let v = 0; v < VERTICES; ++v) {
    const at = 3 * ((cells[VERTICES * cell + v] as number) - firstPoint)
    vertices.push(points[at] as number, points[at + 1] as number, points[at + 2] as number)
  }
  return vertices
}
