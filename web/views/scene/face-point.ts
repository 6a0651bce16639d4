/** Points on the bilinear faces. */
import { type FaceTopology, faces, type Vec3 } from '../../model/hexahedron'
import { at, map3 } from './view-frame'

export function facePoint(vertices: readonly Vec3[], face: number, s: number, t: number): Vec3 {
  const [a, b, c, d] = (faces[face] as FaceTopology).vertices.map(v => vertices[v] as Vec3) as [Vec3, Vec3, Vec3, Vec3]
  return map3(axis => {
    const at0 = at(a, axis) + (at(b, axis) - at(a, axis)) * s
    const at1 = at(c, axis) + (at(d, axis) - at(c, axis)) * s
    return at0 + (at1 - at0) * t
  })
}
