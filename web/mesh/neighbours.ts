/** Which cells share a face, and which faces are the boundary of a mesh. */
import { FaceGroups } from './face-groups'
import { FACES } from './face-loops'
import { WaitingFaces } from './waiting-faces'

/** Faces of cells are numbered `6 * cell + face`. */
export interface Neighbours {
  /** The same face in the cell on its other side; -1 on the boundary. */
  readonly across: Int32Array<ArrayBuffer>
  /** The faces of one cell alone, ascending. */
  readonly boundary: Uint32Array<ArrayBuffer>
}

const NONE = -1

/** Cells between two looks at the clock: a tenth of a millisecond, or up to one where memory is slow. */
const CELLS_AT_ONCE = 1024

/** The parts of the time that counting, placing and joining take, together. */
const COUNTED = 0.1
const PLACED = 0.2
const JOINED = 0.95

/**
 * Two faces are the same if they have the same points in the same cyclic order, either way round: with another order the four points
 * bound another bilinear face. Of a face that more than two cells have, pairs are made in the file's order. `cells` are eight indices
 * of points each, all below `pointCount`.
 */
export function neighboursOf(cells: Uint32Array, pointCount: number): Neighbours {
  const joining = new Joining(cells, pointCount)
  joining.run(Infinity)
  return joining.neighbours as Neighbours
}

/** The same in steps, so that others may ask in between. */
export class Joining {
  /** Null until all is done. */
  neighbours: Neighbours | null = null
  readonly #steps: Generator<number, Neighbours, undefined>
  #part = 0

  constructor(cells: Uint32Array, pointCount: number) {
    // Engines subtract signed numbers without a look at their size: there are less than 2^31 points.
    this.#steps = joined(new Int32Array(cells.buffer, cells.byteOffset, cells.length), pointCount)
  }

  /** Goes on for some milliseconds. Returns about which part is done; 1 once all is. */
  run(milliseconds: number): number {
    const end = performance.now() + milliseconds
    while (!this.neighbours) {
      const { done, value } = this.#steps.next()
      if (done) {
        this.neighbours = value
        break
      }
      // Whoever begins anew in groups has soon caught up.
      this.#part = Math.max(this.#part, value)
      if (performance.now() >= end) return this.#part
    }
    return 1
  }
}

/**
 * A face waits in the list of its least point until its other side comes. In a mesh in order only those of a front through it wait,
 * and one pass is enough. Where more do than a cache holds, all faces are put into groups by their least points, and joined group after
 * group. In a group they stay in the file's order, so that the pairs are the same.
 */
function* joined(cells: Int32Array, pointCount: number): Generator<number, Neighbours, undefined> {
  const across = new Int32Array((FACES * cells.length) / 8)
  const paired = (yield* joinInOrder(cells, pointCount, across)) ?? (yield* joinInGroups(cells, pointCount, across))
  const boundary = new Uint32Array(across.length - paired)
  let found = 0
  for (const [from, to] of cuts(across.length / FACES)) {
    yield JOINED + (1 - JOINED) * ((FACES * from) / across.length)
    found = putBoundary(across, from, to, boundary, found)
  }
  return { across, boundary }
}

/** Returns how many faces are paired; null, and nothing is joined, if more wait than in a mesh in order. */
function* joinInOrder(
  cells: Int32Array,
  pointCount: number,
  across: Int32Array,
): Generator<number, number | null, undefined> {
  const count = cells.length / 8
  const waiting = new WaitingFaces(pointCount)
  const most = Math.max(MOST_WAITING, count / 4)
  for (const [from, to] of cuts(count)) {
    across.fill(NONE, FACES * from, FACES * to)
    waiting.join(cells, from, to, across)
    if (waiting.most > most) return null
    yield (JOINED * to) / count
  }
  return waiting.paired
}

/** Two megabytes of records. */
const MOST_WAITING = 65_536

function* joinInGroups(
  cells: Int32Array,
  pointCount: number,
  across: Int32Array,
): Generator<number, number, undefined> {
  const count = cells.length / 8
  const groups = new FaceGroups(cells, pointCount)
  for (const [from, to] of cuts(count)) {
    across.fill(NONE, FACES * from, FACES * to)
    groups.countCells(from, to)
    yield (COUNTED * to) / count
  }
  groups.makePlaces()
  for (const [from, to] of cuts(count)) {
    groups.placeCells(from, to)
    yield COUNTED + ((PLACED - COUNTED) * to) / count
  }
  for (let group = 0; group < groups.count; ++group) {
    groups.join(group, across)
    yield PLACED + ((JOINED - PLACED) * (group + 1)) / groups.count
  }
  return groups.paired
}

function* cuts(count: number): Generator<readonly [number, number], void, undefined> {
  for (let from = 0; from < count; from += CELLS_AT_ONCE) yield [from, Math.min(from + CELLS_AT_ONCE, count)]
}

/** Returns how many there are by now. */
function putBoundary(across: Int32Array, from: number, to: number, boundary: Uint32Array, count: number): number {
  let found = count
  for (let face = FACES * from; face < FACES * to; ++face) if (across[face] === NONE) boundary[found++] = face
  return found
}
