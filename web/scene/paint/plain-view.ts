/** The scene's first direction, from azimuth -58 and elevation 24 degrees, without perspective: for pictures that nobody turns. */
import type { Vec3, Vertices } from '../../model/hexahedron'
import { at } from '../space/vec3'
import { toWorld, verticesInWorld, worldOf } from '../space/world'
import type { FlatPoint } from './flat-tiles'

const [AZIMUTH, ELEVATION] = [-58, 24].map(degrees => (degrees * Math.PI) / 180) as [number, number]
const RIGHT: Vec3 = [-Math.sin(AZIMUTH), Math.cos(AZIMUTH), 0]
const UP: Vec3 = [
  -Math.sin(ELEVATION) * Math.cos(AZIMUTH),
  -Math.sin(ELEVATION) * Math.sin(AZIMUTH),
  Math.cos(ELEVATION),
]
const TOWARDS: Vec3 = [
  Math.cos(ELEVATION) * Math.cos(AZIMUTH),
  Math.cos(ELEVATION) * Math.sin(AZIMUTH),
  Math.sin(ELEVATION),
]

/** Of a point in the view frame. */
export function seen(point: Vec3): FlatPoint {
  return { x: dot(point, RIGHT), y: -dot(point, UP), depth: -dot(point, TOWARDS) }
}

/** The eight vertices in a frame of their own, and any other point in it. */
export function inOwnFrame(vertices: Vertices): { readonly points: readonly Vec3[]; place(point: Vec3): Vec3 } {
  const frame = worldOf(vertices)
  return { points: verticesInWorld(frame, vertices), place: point => toWorld(frame, point) }
}

function dot(a: Vec3, b: Vec3): number {
  return at(a, 0) * at(b, 0) + at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2)
}
