/** The scene's first direction, from azimuth -58 and elevation 24 degrees, without perspective: for pictures that nobody turns. */
import type { Vec3 } from '../../model/hexahedron'
import { dot } from '../space/vec3'
import type { FlatPoint } from './flat-tiles'

const [AZIMUTH, ELEVATION] = [-58, 24].map(degrees => (degrees * Math.PI) / 180) as [number, number]
export const RIGHT: Vec3 = [-Math.sin(AZIMUTH), Math.cos(AZIMUTH), 0]
export const UP: Vec3 = [
  -Math.sin(ELEVATION) * Math.cos(AZIMUTH),
  -Math.sin(ELEVATION) * Math.sin(AZIMUTH),
  Math.cos(ELEVATION),
]
/** From the middle to the eye, of length 1. */
export const TOWARDS: Vec3 = [
  Math.cos(ELEVATION) * Math.cos(AZIMUTH),
  Math.cos(ELEVATION) * Math.sin(AZIMUTH),
  Math.sin(ELEVATION),
]

/** A point of world space as it is seen. */
export function seen(point: Vec3): FlatPoint {
  return { x: dot(point, RIGHT), y: -dot(point, UP), depth: -dot(point, TOWARDS) }
}
