/** Cells of formats that know only faces, and the cells on both sides of each: hexahedra in order, others by their faces. */
import { hexahedronOfSixFaces } from './hexahedron-of-faces'
import type { MeshBuilder, OtherCell } from './mesh-builder'

/** In place of a cell. */
export const NO_CELL = 0xffffffff

export interface Faces {
  /** The points of face f: `points` from `ends[f - 1]` to `ends[f]`. */
  readonly points: Uint32Array
  readonly ends: Uint32Array
}

/** Cells by the number of their faces of three and of four points. */
const OTHER: ReadonlyMap<string, OtherCell> = new Map([
  ['4 0', 'tetrahedron'],
  ['4 1', 'pyramid'],
  ['2 3', 'wedge'],
])

/**
 * Adds the cells: face f goes around anticlockwise seen from outside of cell `outward[f]` and from inside of cell `inward[f]`, where the lists have
 * one. Ids count from `firstId`. Returns the place of each cell among the hexahedra, one more than it, or 0.
 */
export function cellsOfFaces(
  builder: MeshBuilder,
  faces: Faces,
  outward: Uint32Array,
  inward: Uint32Array,
  firstId: number,
): Uint32Array {
  const { points, ends } = faces
  const faceCount = ends.length
  for (let i = 0; i < points.length; ++i)
    if ((points[i] as number) >= builder.pointCount)
      builder.refuse(`a face names point ${(points[i] as number) + firstId}; there are ${builder.pointCount} points.`)
  let cellCount = 0
  for (const list of [outward, inward])
    for (let f = 0; f < list.length; ++f) {
      const cell = list[f] as number
      if (cell >= cellCount && cell !== NO_CELL) cellCount = cell + 1
    }
  if (cellCount > 2 * faceCount)
    builder.refuse(`a face is of cell ${cellCount - 1 + firstId}; ${faceCount} faces are of fewer cells.`)
  // Counted first, then all faces of a cell one after the other: twice their number, and one more if it is seen from inside.
  const starts = new Uint32Array(cellCount + 1)
  for (const list of [outward, inward])
    for (let f = 0; f < list.length; ++f) if (list[f] !== NO_CELL) increment(starts, (list[f] as number) + 1)
  for (let cell = 0; cell < cellCount; ++cell)
    starts[cell + 1] = (starts[cell + 1] as number) + (starts[cell] as number)
  const next = starts.slice(0, cellCount)
  const all = new Uint32Array(starts[cellCount] as number)
  for (let f = 0; f < faceCount; ++f)
    for (const [side, list] of [outward, inward].entries()) {
      const cell = f < list.length ? (list[f] as number) : NO_CELL
      if (cell !== NO_CELL) all[increment(next, cell)] = 2 * f + side
    }
  const places = new Uint32Array(cellCount)
  const six = new Uint32Array(24)
  for (let cell = 0; cell < cellCount; ++cell) {
    const [from, to] = [starts[cell] as number, starts[cell + 1] as number]
    const eight = hexahedronAt(faces, all, from, to, six)
    if (eight !== null) places[cell] = builder.hexahedron(eight, cell + firstId) + 1
    else if (from < to) builder.otherCell(otherAt(ends, all, from, to))
  }
  return places
}

/** Counts one more; returns the count before. */
function increment(counts: Uint32Array, at: number): number {
  const before = counts[at] as number
  counts[at] = before + 1
  return before
}

/** The eight points of a cell whose faces are in `all`; `six` is room for the points of six faces. */
function hexahedronAt({ points, ends }: Faces, all: Uint32Array, from: number, to: number, six: Uint32Array) {
  if (to - from !== 6) return null
  for (let i = 0; i < 6; ++i) {
    const half = all[from + i] as number
    const face = half >>> 1
    const first = face === 0 ? 0 : (ends[face - 1] as number)
    if ((ends[face] as number) - first !== 4) return null
    const isBackwards = (half & 1) === 1
    for (let v = 0; v < 4; ++v) six[4 * i + v] = points[first + (isBackwards ? (4 - v) % 4 : v)] as number
  }
  return hexahedronOfSixFaces(six, six[0] as number)
}

function otherAt(ends: Uint32Array, all: Uint32Array, from: number, to: number): OtherCell {
  const counts = [0, 0]
  for (let i = from; i < to; ++i) {
    const face = (all[i] as number) >>> 1
    const size = (ends[face] as number) - (face === 0 ? 0 : (ends[face - 1] as number))
    if (size !== 3 && size !== 4) return 'polyhedron'
    counts[size - 3] = (counts[size - 3] as number) + 1
  }
  return OTHER.get(counts.join(' ')) ?? 'polyhedron'
}
