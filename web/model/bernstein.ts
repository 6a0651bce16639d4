/**
 * Indices of jacdet's 27 Bernstein coefficients: (i, j, k) at 9i + 3j + k for xi, eta, zeta, 0, 1
 * or 2 for lower end, middle, upper end. As in wasm/src/topology.h; tests/unit/bernstein.test.ts
 * compares with what the core computes.
 */
import { edgeVertices, faces, type Vec3, vertexReference } from './hexahedron'

export const BERNSTEIN_COUNT = 27

/** Steps from a coefficient to the next along xi, eta and zeta. */
export const bernsteinStrides = [9, 3, 1] as const

export function bernsteinIndex(i: number, j: number, k: number): number {
  return 9 * i + 3 * j + k
}

/** (i, j, k) of each. */
export const bernsteinIndices: readonly Vec3[] = Array.from({ length: BERNSTEIN_COUNT }, (_, n) => [
  Math.floor(n / 9),
  Math.floor(n / 3) % 3,
  n % 3,
])

/** Indices that are 1: 0 at a vertex, 1 in an edge's middle, 2 in a face's, 3 in the cube's. */
export const bernsteinMiddles: readonly number[] = bernsteinIndices.map(
  indices => indices.filter(index => index === 1).length,
)

/** The vertices' own, which are values of jacdet. */
export const vertexBernstein: readonly number[] = vertexReference.map(([i, j, k]) =>
  bernsteinIndex(2 * i, 2 * j, 2 * k),
)

/** An edge's three, from its lower to its upper end. */
export const edgeBernstein: readonly Vec3[] = edgeVertices.map(([from, to]) => {
  const [lower, upper] = [vertexBernstein[from] as number, vertexBernstein[to] as number]
  return [lower, (lower + upper) / 2, upper]
})

/** A face's nine, `[3 * i + j]` with i in s, j in t. */
export const faceBernstein: readonly (readonly number[])[] = faces.map(({ axis, side, s, t }) =>
  [0, 1, 2].flatMap(i =>
    [0, 1, 2].map(j => 2 * side * bernsteinStrides[axis] + i * bernsteinStrides[s] + j * bernsteinStrides[t]),
  ),
)
