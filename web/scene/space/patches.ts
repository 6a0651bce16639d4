/** Points on the bilinear patches that the faces and the sections are. */
import { type FaceTopology, faces, type Vec3 } from '../../model/hexahedron'
import type { Section } from '../../views/scene-slices'
import { cross, mix, way } from './vec3'

/** The points at (s, t) = (0,0), (1,0), (0,1), (1,1). */
export type Corners = readonly [Vec3, Vec3, Vec3, Vec3]

export function faceCorners(vertices: readonly Vec3[], face: number): Corners {
  return (faces[face] as FaceTopology).vertices.map(v => vertices[v] as Vec3) as unknown as Corners
}

export function sectionCorners(vertices: readonly Vec3[], { axis, value }: Section): Corners {
  const [below, above] = [faceCorners(vertices, 2 * axis), faceCorners(vertices, 2 * axis + 1)]
  return below.map((from, k) => mix(from, above[k] as Vec3, value)) as unknown as Corners
}

export function patchPoint([a, b, c, d]: Corners, s: number, t: number): Vec3 {
  return mix(mix(a, b, s), mix(c, d, s), t)
}

/** A vector of any length at right angles to a patch at (s, t); zero where the patch is a line or a point. */
export function patchNormal([a, b, c, d]: Corners, s: number, t: number): Vec3 {
  return cross(mix(way(a, b), way(c, d), t), mix(way(a, c), way(b, d), s))
}

/** The point that the trilinear map of these vertices makes of (xi, eta, zeta). */
export function elementPoint(vertices: readonly Vec3[], [xi, eta, zeta]: Vec3): Vec3 {
  return patchPoint(sectionCorners(vertices, { axis: 0, value: xi }), eta, zeta)
}

export function facePoint(vertices: readonly Vec3[], face: number, s: number, t: number): Vec3 {
  return patchPoint(faceCorners(vertices, face), s, t)
}
