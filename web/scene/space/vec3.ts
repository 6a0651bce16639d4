/** Arithmetic of points and vectors in space. */
import type { Axis, Vec3 } from '../../model/hexahedron'

export function at(point: Vec3, axis: number): number {
  return point[axis] as number
}

export function map3(of: (axis: Axis) => number): Vec3 {
  return [of(0), of(1), of(2)]
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

export function way(from: Vec3, to: Vec3): Vec3 {
  return [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

export function mix(a: Vec3, b: Vec3, share: number): Vec3 {
  return [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share]
}

export function samePoint(a: Vec3, b: Vec3): boolean {
  return a.every((value, axis) => value === b[axis])
}
