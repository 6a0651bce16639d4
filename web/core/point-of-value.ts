/** A point of the boundary with a given jacdet, to be looked at. In doubles: drawn and read, never a verdict. */
import type { Vec3 } from '../model/hexahedron'
import type { Report } from './report'
import { valueInside } from './section'

const CENTRE = 1 / 2
/** Halvings after which doubles between 0 and 1 are told apart. */
const HALVINGS = 53
/** Nearer to the centre than this a way has no clear trace on the boundary. */
const TOO_NEAR = 1 / 8

/**
 * A point on the way from the minimizer to the maximizer, along which jacdet takes every value in
 * between; others are clamped to these. The way is straight, and seen from the centre projected on
 * the boundary. A value that only the inside has is found there, on the straight way from the least
 * of all.
 */
export function pointOfValue(report: Report, value: number): Vec3 {
  const { minimizer, maximizer, boundaryMinimum, boundaryMinimumError, volumeMinimum, bernstein } = report
  const isLowerInside = volumeMinimum.upper < boundaryMinimum - boundaryMinimumError
  if (value >= maximizer.value) return maximizer.point
  if (value <= minimizer.value && !isLowerInside) return minimizer.point
  if (value <= volumeMinimum.upper) return volumeMinimum.point
  const way =
    value < minimizer.value
      ? (at: number) => straight(volumeMinimum.point, minimizer.point, at)
      : wayBetween(minimizer.point, maximizer.point)
  let [below, above] = [0, 1]
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (below + above) / 2
    if (valueInside(bernstein, way(middle)) < value) below = middle
    else above = middle
  }
  return way(above)
}

function straight(a: Vec3, b: Vec3, at: number): Vec3 {
  return map(axis => a[axis] + (b[axis] - a[axis]) * at)
}

/** A straight way through the centre makes a detour through the middle of a face. */
function wayBetween(from: Vec3, to: Vec3): (at: number) => Vec3 {
  if (fromCentre(straight(from, to, 1 / 2)) > TOO_NEAR) return at => onBoundary(straight(from, to, at))
  const distances = from.map(x => Math.abs(x - CENTRE))
  const across = distances.indexOf(Math.min(...distances))
  const detour = map(axis => (axis === across ? 1 : CENTRE))
  return at => onBoundary(at < 1 / 2 ? straight(from, detour, 2 * at) : straight(detour, to, 2 * at - 1))
}

/** Along the ray from the centre; its farthest coordinate becomes 0 or 1 exactly. */
function onBoundary(point: Vec3): Vec3 {
  const farthest = fromCentre(point)
  return map(axis => {
    const offset = point[axis] - CENTRE
    if (Math.abs(offset) === farthest) return offset < 0 ? 0 : 1
    return Math.max(0, Math.min(1, CENTRE + (offset * CENTRE) / farthest))
  })
}

/** The greatest of the three distances. */
function fromCentre(point: Vec3): number {
  return Math.max(...point.map(x => Math.abs(x - CENTRE)))
}

function map(of: (axis: 0 | 1 | 2) => number): Vec3 {
  return [of(0), of(1), of(2)]
}
