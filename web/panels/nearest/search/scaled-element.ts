/**
 * The element about its vertex 0 in units of its own size, and jacdet there as a function of its
 * vertices: columns of DF, what jacdet gains when a vertex moves (N2), its Bernstein coefficients
 * on the faces. docs/algorithm.md 12.
 */

import { timesPowerOfTwo } from '../../../core/power-of-two'
import {
  edgeAxes,
  edgeVertices,
  faces,
  type Vec3,
  type Vertices,
  vertexOf,
  vertexReference,
} from '../../../model/hexahedron'

/** Lengths are times 2^-exponent: the largest component of an edge is in [1/2, 1). */
export interface ScaledElement {
  readonly edges: readonly Vec3[]
  readonly exponent: number
}

/** Null if all vertices are in one point. */
export function scaledElement(vertices: Vertices): ScaledElement | null {
  // The difference of two huge coordinates may not be a double; that of their halves is one.
  const half = Math.max(...vertices.map(Math.abs)) >= 2 ** 1022 ? 1 : 0
  const edges = edgeVertices.map(([from, to]) =>
    map3(axis => edgeComponent(vertexOf(vertices, from)[axis], vertexOf(vertices, to)[axis], half)),
  )
  const largest = Math.max(...edges.flat().map(Math.abs))
  if (largest === 0) return null
  const exponent = Math.floor(Math.log2(largest)) + 1
  return {
    edges: edges.map(edge => map3(axis => timesPowerOfTwo(edge[axis], -exponent))),
    exponent: exponent + half,
  }
}

function edgeComponent(from: number, to: number, half: number): number {
  return half === 0 ? to - from : to / 2 - from / 2
}

/** The edges of the element with each vertex moved, in its own units. */
export function movedEdges({ edges }: ScaledElement, moves: readonly Vec3[]): Vec3[] {
  return edges.map((edge, e) => {
    const [from, to] = edgeVertices[e] as readonly [number, number]
    return map3(axis => edge[axis] + ((moves[to] as Vec3)[axis] - (moves[from] as Vec3)[axis]))
  })
}

/** The columns of DF: each the mean of four edges. */
export type Columns = readonly [Vec3, Vec3, Vec3]

export function columnsAt(edges: readonly Vec3[], point: Vec3): Columns {
  const sums = [0, 1, 2].map(() => [0, 0, 0])
  for (const [e, edge] of edges.entries()) {
    const along = edgeAxes[e] as number
    const start = vertexReference[edgeVertices[e]?.[0] ?? 0] as Vec3
    const weight = point.reduce((all, x, axis) => (axis === along ? all : all * (start[axis] === 1 ? x : 1 - x)), 1)
    const sum = sums[along] as number[]
    for (const axis of [0, 1, 2] as const) sum[axis] = (sum[axis] as number) + weight * edge[axis]
  }
  return sums as unknown as Columns
}

/** dN_v of the eight shape functions N_v. */
export function shapeGradients(point: Vec3): Vec3[] {
  return vertexReference.map(corner => {
    const factors = map3(axis => (corner[axis] === 1 ? point[axis] : 1 - point[axis]))
    const sign = map3(axis => (corner[axis] === 1 ? 1 : -1))
    return [
      sign[0] * factors[1] * factors[2],
      sign[1] * factors[0] * factors[2],
      sign[2] * factors[0] * factors[1],
    ] as const
  })
}

/** jacdet at a point, and its gradient by each vertex: exact for any move of one vertex (N2). */
export interface JacdetResponse {
  readonly jacdet: number
  readonly gradients: readonly Vec3[]
}

export function responseAt(edges: readonly Vec3[], point: Vec3): JacdetResponse {
  const columns = columnsAt(edges, point)
  const normals = cofactors(columns)
  const gradients = shapeGradients(point).map(gradient =>
    map3(axis => normals[0][axis] * gradient[0] + normals[1][axis] * gradient[1] + normals[2][axis] * gradient[2]),
  )
  return { jacdet: dot(columns[2], normals[2]), gradients }
}

/** F_eta x F_zeta, F_zeta x F_xi, F_xi x F_eta. */
function cofactors([xi, eta, zeta]: Columns): Columns {
  return [cross(eta, zeta), cross(zeta, xi), cross(xi, eta)]
}

/** Bernstein coefficients `[3 * i + j]` from values at 0, 1/2, 1 in s and t, of degree (2,2). */
function bernsteinOf(values: readonly number[]): number[] {
  const row = (a: number, b: number, c: number) => [a, 2 * b - (a + c) / 2, c]
  const inT = [0, 3, 6].flatMap(i => row(...(values.slice(i, i + 3) as [number, number, number])))
  const inS = [0, 1, 2].map(j => row(...([0, 3, 6].map(i => inT[i + j]) as [number, number, number])))
  return [0, 1, 2].flatMap(i => inS.map(column => column[i] as number))
}

/** Bernstein coefficients on a face, of degree (2,2): nine lists as long as those of `at`. */
export function bernsteinOnFace(face: number, at: (point: Vec3) => readonly number[]): number[][] {
  const values = [0, 0.5, 1].flatMap(s => [0, 0.5, 1].map(t => at(pointOnFace(face, s, t))))
  const byEntry = (values[0] as readonly number[]).map((_, n) => bernsteinOf(values.map(value => value[n] as number)))
  return values.map((_, i) => byEntry.map(coefficients => coefficients[i] as number))
}

export function pointOnFace(face: number, s: number, t: number): Vec3 {
  const topology = faces[face] as (typeof faces)[number]
  const point: [number, number, number] = [topology.side, topology.side, topology.side]
  point[topology.s] = s
  point[topology.t] = t
  return point
}

/** The next points along the three axes, in the cube. */
export function neighbours(point: Vec3, step: number): Vec3[] {
  return [0, 1, 2].flatMap(axis =>
    [-step, step].map(
      way => point.with(axis, Math.max(0, Math.min(1, (point[axis] as number) + way))) as unknown as Vec3,
    ),
  )
}

export function map3<T>(entry: (axis: 0 | 1 | 2) => T): readonly [T, T, T] {
  return [entry(0), entry(1), entry(2)]
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
