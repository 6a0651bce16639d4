/**
 * Faces as vertices for a painter, made where the mesh is, so that whoever draws them has nothing left to do with each: the four corners in
 * cyclic order and the middle, about which four triangles lie. Those of a bent face meet there, so that it looks the same from both sides.
 * An instance for each face would be less to hand over, but software draws instances one by one, and takes several times as long.
 */
import { FACES, LOOPS } from '../mesh/face-loops'
import type { Faced } from './faced'
import type { FaceList } from './survey-jobs'

/** Vertices of a face. */
export const FACE_VERTICES = 5
/** Numbers of a vertex: x, y, z and the tone of its cell. */
export const VERTEX_NUMBERS = 4
/** The tone of a cell without a relative minimum. */
export const NO_TONE = 2

/**
 * A cell has one colour, and one that is invalid by a hair has to be seen among thousands: what is not valid begins here on the
 * negative side. At -1 and below it ends.
 */
const LEAST_NEGATIVE = 0.35

/** The least single precision number of full precision: what is positive stays so, also where it is handed to the painter. */
const LEAST_POSITIVE = 2 ** -126

/** The position on the two ramps of the colour map, from -1 to 1, never 0; NO_TONE for NaN. */
export function toneOf(relativeMinimum: number): number {
  if (Number.isNaN(relativeMinimum)) return NO_TONE
  if (relativeMinimum > 0) return Math.max(LEAST_POSITIVE, Math.min(relativeMinimum, 1))
  return -(LEAST_NEGATIVE + (1 - LEAST_NEGATIVE) * Math.min(-relativeMinimum, 1))
}

/** In units of the mesh less the origin. With the middles of their cells, faces can be drawn apart. */
export function faceList(
  { check, origin, middles: own }: Faced,
  faces: Uint32Array,
  hasMiddles: boolean,
): Pick<FaceList, 'vertices' | 'middles' | 'cells' | 'origin'> {
  const { points, cells: indices } = check.mesh
  const { relativeMinima } = check.answers
  const [ox, oy, oz] = origin
  const vertices = new Float32Array(FACE_VERTICES * VERTEX_NUMBERS * faces.length)
  const middles = hasMiddles ? new Float32Array(FACE_VERTICES * 3 * faces.length) : null
  const cells = new Uint32Array(faces.length)
  for (let i = 0, to = 0; i < faces.length; ++i) {
    const face = faces[i] as number
    const cell = (face / FACES) | 0
    const loop = 4 * (face - FACES * cell)
    const tone = check.isAnswered(cell) ? toneOf(relativeMinima[cell] as number) : NO_TONE
    let [x, y, z] = [0, 0, 0]
    for (let corner = loop; corner < loop + 4; ++corner, to += VERTEX_NUMBERS) {
      const point = 3 * (indices[8 * cell + (LOOPS[corner] as number)] as number)
      x += vertices[to] = (points[point] as number) - ox
      y += vertices[to + 1] = (points[point + 1] as number) - oy
      z += vertices[to + 2] = (points[point + 2] as number) - oz
      vertices[to + 3] = tone
    }
    vertices[to] = x / 4
    vertices[to + 1] = y / 4
    vertices[to + 2] = z / 4
    vertices[to + 3] = tone
    to += VERTEX_NUMBERS
    cells[i] = cell
    if (!middles) continue
    for (let vertex = 0, at = FACE_VERTICES * 3 * i; vertex < FACE_VERTICES; ++vertex)
      for (let axis = 0; axis < 3; ++axis) middles[at++] = own[3 * cell + axis] as number
  }
  return { vertices, middles, cells, origin }
}

/** Those whose corners are all finite. */
export function drawable({ check, middles, origin }: Faced, faces: Uint32Array): Uint32Array {
  const { points, cells } = check.mesh
  const canBeDrawn = (face: number) => {
    const cell = (face / FACES) | 0
    // Where a middle is finite, all vertices are.
    if (
      Number.isFinite(
        (middles[3 * cell] as number) + (middles[3 * cell + 1] as number) + (middles[3 * cell + 2] as number),
      )
    )
      return true
    const loop = 4 * (face - FACES * cell)
    for (let corner = loop; corner < loop + 4; ++corner) {
      const point = 3 * (cells[8 * cell + (LOOPS[corner] as number)] as number)
      for (let axis = 0; axis < 3; ++axis)
        if (!Number.isFinite((points[point + axis] as number) - (origin[axis] as number))) return false
    }
    return true
  }
  return faces.every(canBeDrawn) ? faces : faces.filter(canBeDrawn)
}

/** Each mesh and each step of it has middles of its own. */
const known = new WeakMap<Float32Array, Uint32Array>()

/** The faces on the boundary of the mesh that can be drawn, ascending. */
export function boundaryOf(faced: Faced): Uint32Array {
  let boundary = known.get(faced.middles)
  if (!boundary) {
    boundary = drawable(faced, faced.neighbours.boundary)
    known.set(faced.middles, boundary)
  }
  return boundary
}

/** For each vertex of each face of the boundary 1 where the face is hidden. */
export function hiddenOf(boundary: Uint32Array, isShown: (cell: number) => boolean): Uint8Array {
  const hidden = new Uint8Array(FACE_VERTICES * boundary.length)
  for (let i = 0; i < boundary.length; ++i) {
    if (isShown(((boundary[i] as number) / FACES) | 0)) continue
    for (let at = FACE_VERTICES * i; at < FACE_VERTICES * (i + 1); ++at) hidden[at] = 1
  }
  return hidden
}
