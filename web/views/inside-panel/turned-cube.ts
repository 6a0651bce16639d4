/** The reference cube turned about its upright axis and seen from a little above, without perspective. */
import { type Vec3, vertexReference } from '../../model/hexahedron'

export interface Turned {
  /** To the right, upwards, towards the eye; the middle of the cube is the origin. */
  readonly right: Vec3
  readonly up: Vec3
  readonly eye: Vec3
}

const ELEVATION = (24 * Math.PI) / 180

export function turnedBy(degrees: number): Turned {
  const angle = (degrees * Math.PI) / 180
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)]
  const [rise, run] = [Math.sin(ELEVATION), Math.cos(ELEVATION)]
  return { right: [cos, sin, 0], up: [-rise * sin, rise * cos, run], eye: [run * sin, -run * cos, rise] }
}

export function along(axis: Vec3, [x, y, z]: Vec3): number {
  return axis[0] * (x - 0.5) + axis[1] * (y - 0.5) + axis[2] * (z - 0.5)
}

/** The vertex behind which nothing of the cube is: its three edges are hidden. */
export function hiddenVertex({ eye }: Turned): number {
  const depths = vertexReference.map(point => along(eye, point))
  return depths.indexOf(Math.min(...depths))
}
