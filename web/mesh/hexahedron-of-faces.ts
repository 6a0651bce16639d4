/**
 * The order of a cell's eight points from its six faces, as formats that know only faces have it. A face goes around anticlockwise seen
 * from outside, so the first one backwards is the bottom, and each of its points has one edge that leaves it: to the point above.
 */
import { rotations } from '../model/node-order'

/** Points of the six faces, four each. */
const POINTS = 24
/** The one of the faces 1 to 5 that is the lid, by the four that are sides, a bit each. */
const LIDS = new Map([1, 2, 3, 4, 5].map(lid => [0b111110 ^ (1 << lid), lid]))
/** The ranks of eight points as one number. */
const ROTATIONS = new Set(rotations.map(rotation => rotation.reduce((key, rank) => 8 * key + rank, 0)))

/** Eight points in VTK_HEXAHEDRON order, the first face as bottom with its point `first`; null if the faces are not those of a hexahedron. */
export function hexahedronOfFaces(faces: readonly (readonly number[])[], first = faces[0]?.[0]): number[] | null {
  if (faces.length !== 6 || faces.some(face => face.length !== 4)) return null
  return hexahedronOfSixFaces(faces.flat(), first as number)
}

/** The same of the points of six faces of four, one after the other. */
export function hexahedronOfSixFaces(faces: ArrayLike<number>, first: number): number[] | null {
  const eight: number[] = []
  let start = 3
  while (start >= 0 && faces[start] !== first) start--
  if (start < 0) return null
  for (let i = 0; i < 4; ++i) eight.push(faces[(start + 4 - i) % 4] as number)
  let sides = 0
  for (let i = 0; i < 4; ++i) {
    const [point, next] = [eight[i], eight[(i + 1) % 4]]
    // The face beside the bottom goes along the edge as the bottom does when it is seen from above.
    let at = 4
    while (at < POINTS && !(faces[at] === point && faces[after(at, 1)] === next)) at++
    if (at === POINTS) return null
    sides |= 1 << (at >> 2)
    const [above, aboveNext] = [faces[after(at, 3)] as number, faces[after(at, 2)] as number]
    if (i === 0) eight.push(above, aboveNext)
    else if (i < 3) eight.push(aboveNext)
    if (eight[4 + i] !== above || eight[4 + ((i + 1) % 4)] !== aboveNext) return null
  }
  const lid = LIDS.get(sides)
  if (lid === undefined || !isAround(faces, 4 * lid, eight)) return null
  for (let i = 0; i < 8; ++i) for (let j = 0; j < i; ++j) if (eight[i] === eight[j]) return null
  return numbered(eight)
}

/** The place among all points of the one that is `steps` further around a face. */
function after(at: number, steps: number): number {
  return (at & ~3) | ((at + steps) & 3)
}

/** True if the face that begins at `from` goes around the upper four. */
function isAround(faces: ArrayLike<number>, from: number, eight: readonly number[]): boolean {
  for (let turn = 0; turn < 4; ++turn) {
    let i = 0
    while (i < 4 && faces[from + ((turn + i) & 3)] === eight[4 + i]) i++
    if (i === 4) return true
  }
  return false
}

/** The eight in ascending order, if that is one of the 24 orders that the faces allow. */
function numbered(eight: number[]): number[] {
  let ranks = 0
  for (let i = 0; i < 8; ++i) {
    let rank = 0
    for (let j = 0; j < 8; ++j) if ((eight[j] as number) < (eight[i] as number)) rank++
    ranks = 8 * ranks + rank
  }
  return ROTATIONS.has(ranks) ? eight.sort((a, b) => a - b) : eight
}
