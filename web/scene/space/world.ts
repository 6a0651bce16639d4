/**
 * World space, in which everything is drawn: physical coordinates (doubles of any size) minus a centre, divided by a size, so
 * that a fitted element fills [-1,1]^3 and single precision suffices from 1e-300 to 1e300.
 */
import { VERTEX_COUNT, type Vec3, type Vertices, vertexOf } from '../../model/hexahedron'
import { at, map3 } from './vec3'

/** The box that fills [-1,1]^3, physical. */
export interface World {
  readonly centre: Vec3
  /** Half of the longest side; 1 for eight equal points. */
  readonly size: number
}

/** Differences of coordinates overflow beyond this half-extent, so they are taken of coordinates made smaller first. */
const HUGE = 2 ** 1000
const SHRINK = 2 ** -16

/** Least and greatest coordinate of the vertices on one axis. */
function range(vertices: Vertices, axis: number): [number, number] {
  let least = Infinity
  let greatest = -Infinity
  for (let v = 0; v < VERTEX_COUNT; v++) {
    const value = vertices[3 * v + axis] as number
    least = Math.min(least, value)
    greatest = Math.max(greatest, value)
  }
  return [least, greatest]
}

/** Half of the sum, or the sum of halves where the sum overflows: halving a denormal would lose its last bit. */
function middle(a: number, b: number): number {
  const sum = a + b
  return Number.isFinite(sum) ? sum / 2 : a / 2 + b / 2
}

function halfDifference(a: number, b: number): number {
  const difference = b - a
  return Number.isFinite(difference) ? difference / 2 || difference : b / 2 - a / 2
}

export function worldOf(vertices: Vertices): World {
  const ranges = [range(vertices, 0), range(vertices, 1), range(vertices, 2)] as const
  const size = Math.max(...ranges.map(([least, greatest]) => halfDifference(least, greatest)))
  const centre = ranges.map(([least, greatest]) => middle(least, greatest)) as unknown as Vec3
  return { centre, size: size > 0 ? size : 1 }
}

/** The longest side of the bounding box; at most the greatest double. */
export function extentOf(vertices: Vertices): number {
  return Math.min(2 * worldOf(vertices).size, Number.MAX_VALUE)
}

/** Beyond this there is nothing to see, and single precision and the products of matrices still hold it. */
const FARTHEST = 1e9

/** A point farther out than the picture can tell is drawn nearer, on the same line from the centre. */
export function toWorld({ centre, size: physicalSize }: World, point: Vec3): Vec3 {
  const shrink = physicalSize > HUGE ? SHRINK : 1
  const x = finite(point[0] * shrink - centre[0] * shrink)
  const y = finite(point[1] * shrink - centre[1] * shrink)
  const z = finite(point[2] * shrink - centre[2] * shrink)
  const length = Math.max(Math.abs(x), Math.abs(y), Math.abs(z))
  const size = physicalSize * shrink
  if (length / size > FARTHEST) return [(x / length) * FARTHEST, (y / length) * FARTHEST, (z / length) * FARTHEST]
  return [x / size, y / size, z / size]
}

/** Inverse of `toWorld`; a coordinate that would overflow becomes the greatest double. */
export function toPhysical(world: World, point: Vec3): Vec3 {
  return map3(axis => finite(at(world.centre, axis) + at(point, axis) * world.size))
}

export function finite(value: number): number {
  return Math.max(-Number.MAX_VALUE, Math.min(Number.MAX_VALUE, value))
}

export function verticesInWorld(world: World, vertices: Vertices): Vec3[] {
  return Array.from({ length: VERTEX_COUNT }, (_, v) => toWorld(world, vertexOf(vertices, v)))
}
