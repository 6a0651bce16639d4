/** Further nodes of cells of 20 or 27: at the middles of edges, of faces and of the whole. */
import { digitRows } from './digit-rows'

/** The corners at whose middle each node lies: edges in VTK's order, faces -xi, +xi, -eta, +eta, -zeta, +zeta, the whole. */
export const EDGE_MIDDLES = digitRows('01 12 23 30 45 56 67 74 04 15 26 37')
export const FACE_MIDDLES = digitRows('0374 1265 0154 3267 0123 4567')
export const ALL_MIDDLES = [...EDGE_MIDDLES, ...FACE_MIDDLES, ...digitRows('01234567')]

/** True if a point is within the tolerance of the mean of others; false for NaN. */
export function isAtMean(
  coordinate: (point: number, axis: number) => number,
  point: number,
  others: readonly number[],
  tolerance: number,
): boolean {
  for (let axis = 0; axis < 3; ++axis) {
    let sum = 0
    for (const other of others) sum += coordinate(other, axis)
    if (!(Math.abs(coordinate(point, axis) - sum / others.length) <= tolerance)) return false
  }
  return true
}

/**
 * True if the further nodes lie at the middles, in any order. `corners` and `others` are indices of
 * points. A middle is a sum of up to eight coordinates and a division, each within half a unit in
 * the last place, and so are printed coordinates of 16 digits: 2^-48 of the largest coordinate is
 * above all of these. Null for cells that have neither 12 nor 19 further nodes.
 */
export function areAtMiddles(
  coordinate: (point: number, axis: number) => number,
  corners: readonly number[],
  others: readonly number[],
): boolean | null {
  const middles = others.length === 12 ? EDGE_MIDDLES : others.length === 19 ? ALL_MIDDLES : null
  if (middles === null) return null
  let size = 0
  for (const corner of corners)
    for (let axis = 0; axis < 3; ++axis) size = Math.max(size, Math.abs(coordinate(corner, axis)))
  const tolerance = size * 2 ** -48
  const wanted = middles.map(middle => middle.map(i => corners[i] as number))
  const isAt = (point: number, mean: readonly number[]) => isAtMean(coordinate, point, mean, tolerance)
  return (
    wanted.every((mean, i) => isAt(others[i] as number, mean) || others.some(other => isAt(other, mean))) &&
    others.every((other, i) => isAt(other, wanted[i] as number[]) || wanted.some(mean => isAt(other, mean)))
  )
}
