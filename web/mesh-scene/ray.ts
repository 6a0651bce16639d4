/** The face that a ray meets first. */
import type { Vec3 } from '../model/hexahedron'
import type { Ray } from '../scene/space/camera'
import { FACE_VERTICES, VERTEX_NUMBERS } from '../survey/face-list'
import type { FaceList } from '../survey/survey-jobs'
import type { FaceBins } from './face-bins'

export interface FaceHit {
  /** An index of the list. */
  readonly face: number
  readonly cell: number
  /** Along the ray, in lengths of its direction. */
  readonly distance: number
}

const NUMBERS = FACE_VERTICES * VERTEX_NUMBERS

/** A list, and where all its faces are. */
export interface Binned {
  readonly faces: FaceList
  readonly bins: readonly Pick<FaceBins, 'meet'>[]
}

/**
 * Faces are the four triangles about their middle with which they are drawn; cells that are drawn whole have shrunk to `size` of theirs.
 * `hidden`: for each vertex 1 where its face is not there, or null.
 */
export function firstHit(
  { faces: { vertices, middles, cells }, bins }: Binned,
  hidden: Uint8Array | null,
  ray: Ray,
  size: number,
): FaceHit | null {
  const own = new Float64Array(3 * FACE_VERTICES)
  let [nearest, face] = [Infinity, -1]
  const look = (i: number) => {
    if (hidden?.[FACE_VERTICES * i] === 1) return nearest
    for (let axis = 0; axis < 3; ++axis) {
      const about = middles === null ? 0 : (1 - size) * (middles[3 * FACE_VERTICES * i + axis] as number)
      const part = middles === null ? 1 : size
      const from = ray.origin[axis as 0]
      for (let vertex = 0; vertex < FACE_VERTICES; ++vertex)
        own[3 * vertex + axis] =
          about + part * (vertices[NUMBERS * i + VERTEX_NUMBERS * vertex + axis] as number) - from
    }
    for (let corner = 0; corner < 4; ++corner) {
      const distance = hitOf(own, 3 * corner, 3 * ((corner + 1) & 3), ray.direction)
      if (distance >= nearest) continue
      nearest = distance
      face = i
    }
    return nearest
  }
  for (const some of bins) some.meet(ray, nearest, look)
  return face < 0 ? null : { face, cell: cells[face] as number, distance: nearest }
}

const MIDDLE = 12

/** Möller and Trumbore: the distance to the triangle of two corners and the middle, seen from the origin; infinity if it is missed. */
function hitOf(own: Float64Array, a: number, b: number, [dx, dy, dz]: Vec3): number {
  const mx = own[MIDDLE] as number
  const my = own[MIDDLE + 1] as number
  const mz = own[MIDDLE + 2] as number
  const ex = (own[a] as number) - mx
  const ey = (own[a + 1] as number) - my
  const ez = (own[a + 2] as number) - mz
  const fx = (own[b] as number) - mx
  const fy = (own[b + 1] as number) - my
  const fz = (own[b + 2] as number) - mz
  const px = dy * fz - dz * fy
  const py = dz * fx - dx * fz
  const pz = dx * fy - dy * fx
  const determinant = ex * px + ey * py + ez * pz
  if (determinant === 0) return Infinity
  const u = -(mx * px + my * py + mz * pz) / determinant
  const qx = -(my * ez - mz * ey)
  const qy = -(mz * ex - mx * ez)
  const qz = -(mx * ey - my * ex)
  const v = (dx * qx + dy * qy + dz * qz) / determinant
  const distance = (fx * qx + fy * qy + fz * qz) / determinant
  return u >= 0 && v >= 0 && u + v <= 1 && distance > 0 ? distance : Infinity
}
