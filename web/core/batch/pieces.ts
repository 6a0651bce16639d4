/** Cuts many cells into pieces for the workers: copies of the caller's lists, each piece in a block of memory of its own. */
import { COORDINATE_COUNT } from '../../model/hexahedron'
import type { Piece } from './batch-core'
import { bytesPerCell, type Wanted } from './lists'

const VERTICES = 8

export interface Cut {
  readonly first: number
  readonly count: number
  readonly piece: Piece
  /** The piece's memory, with room for the answers to it. */
  readonly block: ArrayBuffer
}

/** Blocks as they come back from the workers. */
export class Recycled {
  readonly #blocks: ArrayBuffer[] = []

  give(block: ArrayBuffer): void {
    this.#blocks.push(block)
  }

  /** A block of at least this length in bytes, with whatever is in it. */
  take(length: number): ArrayBuffer {
    const at = this.#blocks.findIndex(block => block.byteLength >= length)
    return at < 0 ? new ArrayBuffer(length) : (this.#blocks.splice(at, 1)[0] as ArrayBuffer)
  }
}

interface Lists {
  readonly points: Float64Array
  readonly cells: Uint32Array | null
}

/** The size of the pieces, and the memory for them. */
export interface PieceOptions {
  readonly cellsPerPiece: number
  readonly wanted: Wanted
  readonly memory: Recycled
}

/** True if no coordinate or index is left over behind the last cell and the last point. */
export function isWhole(points: Float64Array, cells: Uint32Array | null): boolean {
  return points.length % 3 === 0 && (cells ? cells.length % VERTICES : points.length % COORDINATE_COUNT) === 0
}

/** All cells in order; they are whole. */
export function* pieces({ points, cells }: Lists, options: PieceOptions): Generator<Cut> {
  const total = cells ? cells.length / VERTICES : points.length / COORDINATE_COUNT
  for (let first = 0; first < total; first += options.cellsPerPiece) {
    const count = Math.min(options.cellsPerPiece, total - first)
    yield cells ? indexedCut(points, cells, first, count, options) : plainCut(points, first, count, options)
  }
}

/** Lists for so many cells, coordinates and indices, with whatever is in them. */
function memoryFor({ memory, wanted }: PieceOptions, count: number, coordinates: number, indices: number) {
  const length = 8 * coordinates + 4 * indices
  const block = memory.take(Math.max(length, count * bytesPerCell(wanted)))
  return {
    block,
    points: new Float64Array(block, 0, coordinates),
    cells: new Uint32Array(block, 8 * coordinates, indices),
  }
}

function plainCut(points: Float64Array, first: number, count: number, options: PieceOptions): Cut {
  const from = COORDINATE_COUNT * first
  const own = memoryFor(options, count, COORDINATE_COUNT * count, 0)
  own.points.set(points.subarray(from, from + COORDINATE_COUNT * count))
  return { first, count, piece: { points: own.points, cells: null, firstPoint: 0 }, block: own.block }
}

/** The points between the least and the greatest index, or, where those are far apart, each cell's own eight. */
function indexedCut(
  points: Float64Array,
  cells: Uint32Array,
  first: number,
  count: number,
  options: PieceOptions,
): Cut {
  const pointCount = points.length / 3
  const indices = cells.subarray(VERTICES * first, VERTICES * (first + count))
  let [least, greatest, hasOthers] = [pointCount, -1, false]
  for (const index of indices) {
    if (index >= pointCount) hasOthers = true
    else {
      if (index < least) least = index
      if (index > greatest) greatest = index
    }
  }
  const span = 3 * Math.max(0, greatest - least + 1)
  if (span <= COORDINATE_COUNT * count) {
    const own = memoryFor(options, count, span, indices.length)
    own.points.set(points.subarray(3 * least, 3 * least + span))
    own.cells.set(indices)
    return { first, count, piece: { points: own.points, cells: own.cells, firstPoint: least }, block: own.block }
  }
  const own = memoryFor(options, count, COORDINATE_COUNT * count, hasOthers ? indices.length : 0)
  for (let i = 0; i < indices.length; ++i) {
    const index = indices[i] as number
    for (let axis = 0; axis < 3; ++axis) own.points[3 * i + axis] = points[3 * index + axis] ?? Number.NaN
    if (hasOthers) own.cells[i] = index < pointCount ? i : NO_POINT
  }
  const piece = { points: own.points, cells: hasOthers ? own.cells : null, firstPoint: 0 }
  return { first, count, piece, block: own.block }
}

/** No list has so many points. */
const NO_POINT = 0xffffffff
