/** Rotations and frames as finite element codes state them. */
import type { Move } from './node-model'

export type Vector = readonly [number, number, number]

export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
export const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
export const scaled = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by]
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

/** The vector of length one in this direction; null if there is none. */
export function unit(a: Vector): Vector | null {
  const length = Math.hypot(...a)
  return length > 0 && Number.isFinite(length) ? scaled(a, 1 / length) : null
}

/** Exact at quarter turns. */
export function cosineAndSine(degrees: number): readonly [number, number] {
  const turn = ((degrees % 360) + 360) % 360
  if (turn === 0) return [1, 0]
  if (turn === 90) return [0, 1]
  if (turn === 180) return [-1, 0]
  if (turn === 270) return [0, -1]
  const angle = (turn * Math.PI) / 180
  return [Math.cos(angle), Math.sin(angle)]
}

/** An origin and three axes of length one. */
export interface Frame {
  readonly origin: Vector
  readonly axes: readonly [Vector, Vector, Vector]
}

export function outOfFrame({ origin, axes }: Frame, [x, y, z]: Vector): Vector {
  return [0, 1, 2].map(
    i => (origin[i] as number) + x * at(axes[0], i) + y * at(axes[1], i) + z * at(axes[2], i),
  ) as unknown as Vector
}

const at = (vector: Vector, i: number): number => vector[i] as number

export interface Rotation {
  /** Two points of the axis, which points from the one to the other. */
  readonly from: Vector
  readonly to: Vector
  readonly degrees: number
}

/** First the translation, then the rotation by the right hand. Null if the axis has no direction. */
export function rigidMove(translation: Vector, rotation: Rotation | null): Move | null {
  const [tx, ty, tz] = translation
  if (rotation === null || rotation.degrees === 0)
    return (points, i) => {
      points[i] = (points[i] as number) + tx
      points[i + 1] = (points[i + 1] as number) + ty
      points[i + 2] = (points[i + 2] as number) + tz
    }
  const axis = unit(minus(rotation.to, rotation.from))
  if (axis === null) return null
  const [c, s] = cosineAndSine(rotation.degrees)
  const [ax, ay, az] = rotation.from
  return (points, i) => {
    const p: Vector = [
      (points[i] as number) + tx - ax,
      (points[i + 1] as number) + ty - ay,
      (points[i + 2] as number) + tz - az,
    ]
    const along = scaled(axis, dot(axis, p) * (1 - c))
    const moved = add(add(scaled(p, c), scaled(cross(axis, p), s)), along)
    points[i] = ax + moved[0]
    points[i + 1] = ay + moved[1]
    points[i + 2] = az + moved[2]
  }
}
