/** Cuts many cells into pieces for the workers: copies of the caller's lists, each piece in a block of memory of its own. */
import { COORDINATE_COUNT } from '../../model/hexahedron'
import type { CoreErrorCode } from '../report'
import { answersLength, type Piece } from './batch-core'

const VERTICES = 8

export interface Cut {
  readonly first: number
  readonly count: number
  readonly piece: Piece
  /** Where the piece lies, with room for the answers to it. */
  readonly block: ArrayBuffer
  /** What is the matter with the cell behind the piece's last, if anything. */
  readonly fault: CoreErrorCode | null
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

/** What pieces are cut with. */
export interface Knife {
  readonly cellsPerPiece: number
  readonly wantsMinima: boolean
  readonly memory: Recycled
}

/** Whether behind the last cell, and the last point, nothing is left over. */
export function isWhole(points: Float64Array, cells: Uint32Array | null): boolean {
  return points.length % 3 === 0 && (cells ? cells.length % VERTICES : points.length % COORDINATE_COUNT) === 0
}

/** In order; the last is one with a fault, or the end of the cells. */
export function* pieces(lists: Lists, knife: Knife): Generator<Cut> {
  const { points, cells } = lists
  const length = cells ? cells.length : points.length
  const perCell = cells ? VERTICES : COORDINATE_COUNT
  const total = Math.floor(length / perCell)
  let first = 0
  do {
    const wanted = Math.min(knife.cellsPerPiece, total - first)
    const isLast = first + wanted === total
    const cut = cells ? indexedCut(points, cells, first, wanted, knife) : plainCut(points, first, wanted, knife)
    yield isLast && !isWhole(points, cells) && cut.fault === null ? { ...cut, fault: 'incomplete' } : cut
    if (cut.fault) return
    first += wanted
  } while (first < total)
}

/** For so many cells with so many coordinates and indices: lists with whatever is in them. */
function room({ memory, wantsMinima }: Knife, count: number, coordinates: number, indices: number) {
  const length = 8 * coordinates + 4 * indices
  const block = memory.take(Math.max(length, answersLength(count, wantsMinima)))
  return {
    block,
    points: new Float64Array(block, 0, coordinates),
    cells: new Uint32Array(block, 8 * coordinates, indices),
  }
}

function plainCut(points: Float64Array, first: number, count: number, knife: Knife): Cut {
  const from = COORDINATE_COUNT * first
  const own = room(knife, count, COORDINATE_COUNT * count, 0)
  own.points.set(points.subarray(from, from + COORDINATE_COUNT * count))
  return { first, count, piece: { points: own.points, cells: null, firstPoint: 0 }, block: own.block, fault: null }
}

/** The points between the least and the greatest index, or, where those are far apart, each cell's own eight. */
function indexedCut(points: Float64Array, cells: Uint32Array, first: number, wanted: number, knife: Knife): Cut {
  const pointCount = Math.floor(points.length / 3)
  let [least, greatest, count] = [pointCount, -1, 0]
  for (; count < wanted; ++count) {
    let [low, high] = [least, greatest]
    for (let i = VERTICES * (first + count); i < VERTICES * (first + count + 1); ++i) {
      const index = cells[i] as number
      if (index < low) low = index
      if (index > high) high = index
    }
    if (high >= pointCount) break
    least = low
    greatest = high
  }
  const fault = count < wanted ? 'no-such-point' : null
  const indices = cells.subarray(VERTICES * first, VERTICES * (first + count))
  const span = 3 * (greatest - least + 1)
  if (count > 0 && span <= COORDINATE_COUNT * count) {
    const own = room(knife, count, span, indices.length)
    own.points.set(points.subarray(3 * least, 3 * least + span))
    own.cells.set(indices)
    return { first, count, piece: { points: own.points, cells: own.cells, firstPoint: least }, block: own.block, fault }
  }
  const own = room(knife, count, COORDINATE_COUNT * count, 0)
  for (let i = 0; i < indices.length; ++i)
    for (let axis = 0; axis < 3; ++axis) own.points[3 * i + axis] = points[3 * (indices[i] as number) + axis] as number
  return { first, count, piece: { points: own.points, cells: null, firstPoint: 0 }, block: own.block, fault }
}
