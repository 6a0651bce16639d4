/** Cuts many cells into pieces for the workers: of the caller's lists they hold copies of their own. */
import { COORDINATE_COUNT } from '../../model/hexahedron'
import type { CoreErrorCode } from '../report'
import type { Piece } from './batch-core'

const VERTICES = 8

export interface Cut {
  readonly first: number
  readonly count: number
  readonly piece: Piece
  /** What is the matter with the cell behind the piece's last, if anything. */
  readonly fault: CoreErrorCode | null
}

/** Memory for coordinates, as it comes back from the workers. */
export class Recycled {
  readonly #lists: Float64Array[] = []

  give(list: Float64Array): void {
    if (list.length > 0) this.#lists.push(list)
  }

  /** A list of this length, with whatever is in it. */
  take(length: number): Float64Array {
    const at = this.#lists.findIndex(list => list.buffer.byteLength >= 8 * length)
    if (at < 0) return new Float64Array(length)
    const [list] = this.#lists.splice(at, 1) as [Float64Array]
    return new Float64Array(list.buffer as ArrayBuffer, 0, length)
  }
}

/** In order; the last is one with a fault, or the end of the cells. */
export function* pieces(
  points: Float64Array,
  cells: Uint32Array | null,
  cellsPerPiece: number,
  memory: Recycled,
): Generator<Cut> {
  const length = cells ? cells.length : points.length
  const perCell = cells ? VERTICES : COORDINATE_COUNT
  const total = Math.floor(length / perCell)
  const isWhole = length % perCell === 0 && points.length % 3 === 0
  let first = 0
  do {
    const wanted = Math.min(cellsPerPiece, total - first)
    const isLast = first + wanted === total
    const cut = cells ? indexedCut(points, cells, first, wanted, memory) : plainCut(points, first, wanted, memory)
    yield isLast && !isWhole && cut.fault === null ? { ...cut, fault: 'incomplete' } : cut
    if (cut.fault) return
    first += wanted
  } while (first < total)
}

function plainCut(points: Float64Array, first: number, count: number, memory: Recycled): Cut {
  const from = COORDINATE_COUNT * first
  const own = memory.take(COORDINATE_COUNT * count)
  own.set(points.subarray(from, from + COORDINATE_COUNT * count))
  return { first, count, piece: { points: own, cells: null, firstPoint: 0 }, fault: null }
}

/** The points between the least and the greatest index, or, where those are far apart, each cell's own eight. */
function indexedCut(points: Float64Array, cells: Uint32Array, first: number, wanted: number, memory: Recycled): Cut {
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
  const indices = cells.slice(VERTICES * first, VERTICES * (first + count))
  const span = 3 * (greatest - least + 1)
  if (count > 0 && span <= COORDINATE_COUNT * count) {
    const own = memory.take(span)
    own.set(points.subarray(3 * least, 3 * least + span))
    return { first, count, piece: { points: own, cells: indices, firstPoint: least }, fault }
  }
  const own = memory.take(COORDINATE_COUNT * count)
  for (let i = 0; i < indices.length; ++i)
    for (let axis = 0; axis < 3; ++axis) own[3 * i + axis] = points[3 * (indices[i] as number) + axis] as number
  return { first, count, piece: { points: own, cells: null, firstPoint: 0 }, fault }
}
