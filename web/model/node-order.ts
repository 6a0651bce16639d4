/**
 * Reading eight points in another order. Of the cube's 48 symmetries 24 are rotations, which change no jacdet but its place;
 * so two orders that differ by a rotation say the same of an element.
 */
import { type Vec3, type Vertices, vertexOf, vertexReference } from './hexahedron'

/** Vertex i of the new order is vertex `permutation[i]` of the given one. */
export function reordered(vertices: Vertices, permutation: readonly number[]): Vertices {
  return permutation.flatMap(v => vertexOf(vertices, v))
}

const AXES: readonly Vec3[] = [
  [0, 1, 2],
  [0, 2, 1],
  [1, 0, 2],
  [1, 2, 0],
  [2, 0, 1],
  [2, 1, 0],
]

/** Parity of the axes' order. */
const IS_EVEN: readonly boolean[] = [true, false, false, true, true, false]

/** The cube's symmetries as permutations of its vertices: the 24 rotations, and the 24 that turn it inside out. */
export const rotations: readonly (readonly number[])[] = symmetries(true)
export const reflections: readonly (readonly number[])[] = symmetries(false)

function symmetries(areRotations: boolean): (readonly number[])[] {
  const found: (readonly number[])[] = []
  for (const [i, axes] of AXES.entries())
    for (const flipped of vertexReference) {
      const flips = flipped.reduce((sum, flip) => sum + flip, 0)
      if ((flips % 2 === 0) === (IS_EVEN[i] === areRotations)) found.push(symmetry(axes, flipped))
    }
  return found
}

function symmetry(axes: Vec3, flipped: Vec3): readonly number[] {
  return vertexReference.map(reference => {
    const image = axes.map((axis, a) => Math.abs((reference[axis] as number) - (flipped[a] as number)))
    return vertexReference.findIndex(other => other.every((x, a) => x === image[a]))
  })
}

/** One name for all orders that differ by a rotation: the first of them, as digits. */
export function orderClass(permutation: readonly number[]): string {
  return rotations.map(rotation => rotation.map(v => permutation[v]).join('')).sort()[0] as string
}

/** Groups of those that differ by a rotation, without those that are but a rotation of the order as given. */
export function distinctOrders<T extends { readonly permutation: readonly number[] }>(orders: readonly T[]): T[][] {
  const asGiven = orderClass([0, 1, 2, 3, 4, 5, 6, 7])
  const groups = new Map<string, T[]>()
  for (const order of orders) {
    const name = orderClass(order.permutation)
    if (name !== asGiven) groups.set(name, [...(groups.get(name) ?? []), order])
  }
  return [...groups.values()]
}
