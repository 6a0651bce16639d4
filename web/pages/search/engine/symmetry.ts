/**
 * Symmetries that an element can have: a motion of the reference cube and of space alike, p(g v) = A p(v). Each is a power of one
 * permutation of the axes with signs, so that images are exact.
 */
import { type Axis, VERTEX_COUNT, type Vec3, vertexReference } from '../../../model/hexahedron'

export interface Symmetry {
  /** The name on the page. */
  readonly title: string
  /** Relative to the centre: component r of the image is signs[r] times component sources[r]. */
  readonly sources: readonly [Axis, Axis, Axis]
  readonly signs: readonly [1 | -1, 1 | -1, 1 | -1]
}

export const symmetries = {
  none: { title: 'none', sources: [0, 1, 2], signs: [1, 1, 1] },
  mirror: { title: 'a mirror, ξ to 1 − ξ', sources: [0, 1, 2], signs: [-1, 1, 1] },
  point: { title: 'through the centre', sources: [0, 1, 2], signs: [-1, -1, -1] },
  'half-turn': { title: 'half a turn about ζ', sources: [0, 1, 2], signs: [-1, -1, 1] },
  'third-turn': { title: 'a third of a turn about a diagonal', sources: [2, 0, 1], signs: [1, 1, 1] },
  'quarter-turn': { title: 'a quarter turn about ζ', sources: [1, 0, 2], signs: [-1, 1, 1] },
  'quarter-turn-mirrored': { title: 'a quarter turn about ζ, mirrored', sources: [1, 0, 2], signs: [-1, 1, -1] },
} as const satisfies Record<string, Symmetry>

export type SymmetryName = keyof typeof symmetries

/** Vertices that the symmetry takes into each other: each is the image of the one before, the first that of the last. */
export type Orbit = readonly number[]

export function orbitsOf(symmetry: Symmetry): Orbit[] {
  const orbits: Orbit[] = []
  for (let first = 0; first < VERTEX_COUNT; ++first) {
    if (orbits.some(orbit => orbit.includes(first))) continue
    const orbit = [first]
    for (let v = imageVertex(symmetry, first); v !== first; v = imageVertex(symmetry, v)) orbit.push(v)
    orbits.push(orbit)
  }
  return orbits
}

/** The image of a point; `doubled` is the sum of opposite coordinates, twice the centre's, on each axis. */
export function imageOf({ sources, signs }: Symmetry, point: Vec3, doubled: number): Vec3 {
  const component = (r: Axis) => {
    const value = point[sources[r]]
    return signs[r] > 0 ? value : doubled - value
  }
  return [component(0), component(1), component(2)]
}

function imageVertex(symmetry: Symmetry, vertex: number): number {
  const image = imageOf(symmetry, vertexReference[vertex] as Vec3, 1)
  return vertexReference.findIndex(point => point.every((x, axis) => x === image[axis]))
}
