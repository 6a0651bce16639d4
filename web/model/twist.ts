/** By how much the top of an element is turned against its bottom. */
import type { Vertices } from './hexahedron'

export interface Twist {
  /** In [-180, 180], counter-clockwise where the top is turned so, seen against z. */
  readonly degrees: number
  /** Of the doubles given; 360 where the angle means nothing. */
  readonly error: number
}

const BOTTOM = [0, 1, 2, 3]
const TOP = [4, 5, 6, 7]
/** Of sums of eight products of differences from means, in units of 2^-53 of the square of the largest coordinate: below. */
const SUM_ERROR = 1024 * 2 ** -53
/** Engines' atan2 is good to a few units in the last place; this is 2^9 of them. */
const ANGLE_ERROR = 2 ** -44

/**
 * Seen along z, both about their middles: the turn that brings vertices 0 to 3 nearest to 4 to 7 in the sense of least squares. With
 * a_i, b_i their places, it is the angle of (sum a_i . b_i, sum a_i x b_i).
 *
 * Error: with coordinates up to X a component of a or b is at most 2X and off by 10uX, a product of two by 44uX^2, and eight of them with
 * the roundings of their sum by less than 1024uX^2.
 */
export function twistOf(vertices: Vertices): Twist {
  const size = Math.max(
    ...[...BOTTOM, ...TOP].flatMap(v => [0, 1].map(axis => Math.abs(vertices[3 * v + axis] as number))),
  )
  const scaled = vertices.map(value => (size > 0 ? value / size : 0))
  const [bottom, top] = [aboutMiddle(scaled, BOTTOM), aboutMiddle(scaled, TOP)]
  let [dot, cross] = [0, 0]
  for (const [i, [ax, ay]] of bottom.entries()) {
    const [bx, by] = top[i] as readonly [number, number]
    dot += ax * bx + ay * by
    cross += ax * by - ay * bx
  }
  const length = Math.hypot(dot, cross)
  const inDegrees = 180 / Math.PI
  const degrees = Math.atan2(cross, dot) * inDegrees
  if (length <= 4 * SUM_ERROR) return { degrees, error: 360 }
  return { degrees, error: (2 * SUM_ERROR * inDegrees) / length + 180 * ANGLE_ERROR }
}

function aboutMiddle(vertices: Vertices, four: readonly number[]): (readonly [number, number])[] {
  const [x, y] = [0, 1].map(axis => four.reduce((sum, v) => sum + (vertices[3 * v + axis] as number) / 4, 0)) as [
    number,
    number,
  ]
  return four.map(v => [(vertices[3 * v] as number) - x, (vertices[3 * v + 1] as number) - y])
}
