/** Whether the further nodes of a cell of 20 or 27 nodes lie at the middles of its edges and faces, in whatever order they are. */

const EDGES = [
  [0, 1],
  [1, 2],
  [2, 3],
  [3, 0],
  [4, 5],
  [5, 6],
  [6, 7],
  [7, 4],
  [0, 4],
  [1, 5],
  [2, 6],
  [3, 7],
] as const
const FACES = [
  [0, 3, 7, 4],
  [1, 2, 6, 5],
  [0, 1, 5, 4],
  [3, 2, 6, 7],
  [0, 1, 2, 3],
  [4, 5, 6, 7],
] as const
const ALL = [0, 1, 2, 3, 4, 5, 6, 7] as const
const MIDDLES_OF_20: readonly (readonly number[])[] = EDGES
const MIDDLES_OF_27: readonly (readonly number[])[] = [...EDGES, ...FACES, ALL]

/**
 * `corners` and `others` are indices of points. A middle is a sum of up to eight coordinates and a division, each within half a unit in
 * the last place, and so are printed coordinates of 16 digits: 2^-48 of the largest coordinate is above all of these. Null for cells that
 * have neither 12 nor 19 further nodes.
 */
export function areAtMiddles(
  coordinate: (point: number, axis: number) => number,
  corners: readonly number[],
  others: readonly number[],
): boolean | null {
  const middles = others.length === 12 ? MIDDLES_OF_20 : others.length === 19 ? MIDDLES_OF_27 : null
  if (middles === null) return null
  let size = 0
  for (const corner of corners)
    for (let axis = 0; axis < 3; ++axis) size = Math.max(size, Math.abs(coordinate(corner, axis)))
  const tolerance = size * 2 ** -48
  const wanted = middles.map(middle =>
    [0, 1, 2].map(axis => middle.reduce((sum, i) => sum + coordinate(corners[i] as number, axis), 0) / middle.length),
  )
  const isAt = (point: number, place: readonly number[]) =>
    place.every((value, axis) => Math.abs(coordinate(point, axis) - value) <= tolerance)
  return (
    wanted.every((place, i) => isAt(others[i] as number, place) || others.some(other => isAt(other, place))) &&
    others.every((other, i) => isAt(other, wanted[i] as number[]) || wanted.some(place => isAt(other, place)))
  )
}
