/**
 * The order of a cell's eight points from its six faces, as formats that know only faces have it. A face goes around anticlockwise seen
 * from outside, so the first one backwards is the bottom, and each of its points has one edge that leaves it: to the point above.
 */
import { rotations } from '../model/node-order'

/** Eight points in VTK_HEXAHEDRON order, the first face as bottom with its point `first`; null if the faces are not those of a hexahedron. */
export function hexahedronOfFaces(faces: readonly (readonly number[])[], first = faces[0]?.[0]): number[] | null {
  if (faces.length !== 6 || faces.some(face => face.length !== 4)) return null
  // An edge belongs to two faces, which go along it in opposite directions.
  const next = new Map<string, number>()
  for (const [f, face] of faces.entries()) {
    for (const [i, point] of face.entries()) {
      const edge = `${point} ${face[(i + 1) % 4]}`
      if (next.has(edge)) return null
      next.set(edge, f)
    }
  }
  const backwards = [...(faces[0] as readonly number[])].reverse()
  const start = backwards.indexOf(first as number)
  const bottom = backwards.map((_, i) => backwards[(start + i) % 4] as number)
  const points = new Set(faces.flat())
  if (start < 0 || points.size !== 8) return null
  const top: number[] = []
  for (const [i, point] of bottom.entries()) {
    // The face beside the bottom that goes along the edge as `bottom` does, from `point` to the next one.
    const f = next.get(`${point} ${bottom[(i + 1) % 4]}`)
    const face = f === undefined ? undefined : faces[f]
    if (face === undefined || f === 0) return null
    top.push(face[(face.indexOf(point) + 3) % 4] as number)
  }
  const eight = [...bottom, ...top]
  if (new Set(eight).size !== 8) return null
  const sides = [0, 1, 2, 3].every(i => next.has(`${top[i]} ${bottom[i]}`) && next.has(`${bottom[i]} ${top[i]}`))
  const lid = next.get(`${top[0]} ${top[1]}`)
  const face = lid === undefined ? undefined : faces[lid]
  return sides && face !== undefined && top.every(point => face.includes(point)) ? numbered(eight) : null
}

/** The eight in ascending order, if that is one of the 24 orders that the faces allow. */
function numbered(eight: readonly number[]): number[] {
  const ascending = eight.toSorted((a, b) => a - b)
  const isTurned = rotations.some(rotation => rotation.every((v, i) => ascending[v] === eight[i]))
  return isTurned ? ascending : [...eight]
}
