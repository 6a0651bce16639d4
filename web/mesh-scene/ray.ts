/** The face that a ray meets first. */
import type { Vec3 } from '../model/hexahedron'
import type { Ray } from '../scene/space/camera'
import { FACE_VERTICES, VERTEX_NUMBERS } from '../survey/face-list'
import type { FaceList } from '../survey/survey-jobs'

export interface FaceHit {
  /** An index of the list. */
  readonly face: number
  readonly cell: number
  /** Along the ray, in lengths of its direction. */
  readonly distance: number
}

const NUMBERS = FACE_VERTICES * VERTEX_NUMBERS

/**
 * Faces are the four triangles about their middle with which they are drawn; cells that are drawn whole have shrunk to `size` of theirs.
 * `hidden`: for each vertex 1 where its face is not there, or null.
 */
export function firstHit(
  { vertices, middles, cells }: FaceList,
  hidden: Uint8Array | null,
  { origin, direction }: Ray,
  size: number,
): FaceHit | null {
  const own = new Float64Array(12)
  const middle = new Float64Array(3)
  let [nearest, face] = [Infinity, -1]
  for (let i = 0; i < cells.length; ++i) {
    if (hidden?.[FACE_VERTICES * i] === 1) continue
    for (let axis = 0; axis < 3; ++axis) {
      const at = NUMBERS * i + axis
      const about = middles === null ? 0 : (1 - size) * (middles[3 * FACE_VERTICES * i + axis] as number)
      const part = middles === null ? 1 : size
      const from = origin[axis as 0]
      for (let corner = 0; corner < 4; ++corner)
        own[3 * corner + axis] = about + part * (vertices[at + VERTEX_NUMBERS * corner] as number) - from
      middle[axis] = about + part * (vertices[at + 4 * VERTEX_NUMBERS] as number) - from
    }
    if (!mayHit(own, middle, direction, nearest)) continue
    for (let corner = 0; corner < 4; ++corner) {
      const distance = hitOf(own, 3 * corner, 3 * ((corner + 1) & 3), middle, direction)
      if (distance >= nearest) continue
      nearest = distance
      face = i
    }
  }
  return face < 0 ? null : { face, cell: cells[face] as number, distance: nearest }
}

/** By the ball about the middle through the farthest corner. */
function mayHit(own: Float64Array, middle: Float64Array, direction: Vec3, nearest: number): boolean {
  const [x, y, z] = middle as unknown as [number, number, number]
  let radius = 0
  for (let at = 0; at < 12; at += 3) {
    const dx = (own[at] as number) - x
    const dy = (own[at + 1] as number) - y
    const dz = (own[at + 2] as number) - z
    radius = Math.max(radius, dx * dx + dy * dy + dz * dz)
  }
  const square = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]
  const along = (x * direction[0] + y * direction[1] + z * direction[2]) / square
  const off = x * x + y * y + z * z - along * along * square
  return off <= radius * (1 + 1e-9) && along - Math.sqrt(radius / square) < nearest
}

/** Möller and Trumbore: the distance to the triangle of two corners and the middle, seen from the origin; infinity if it is missed. */
function hitOf(own: Float64Array, a: number, b: number, middle: Float64Array, [dx, dy, dz]: Vec3): number {
  const [mx, my, mz] = middle as unknown as [number, number, number]
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
