/**
 * Error bounds of the doubles of a report, times 2^exponent: docs/algorithm.md 4, 8 and 9. Infinite
 * if an element was decided exactly: (M1) then bounds the minimum's error alone.
 */
import { edgesAlong, edgeVertices, type Vec3, type Vertices, vertexOf } from '../model/hexahedron'
import type { Report } from './report'

/**
 * The error of any value made from the 27 Bernstein coefficients by few means, times 2^exponent. In
 * scaled units (M1) has boundaryMinimumError >= 36uR + 12uM, and these are off by at most 100uR +
 * 40uM, the cube's centre of (8R) and (V2).
 */
export function valueError({ decidedBy, boundaryMinimumError }: Report): number {
  return decidedBy === 'filter' ? 4 * boundaryMinimumError : Number.POSITIVE_INFINITY
}

/** (M1) for minus jacdet, whose faces may take on 4000uM each. */
export function boundaryMaximumError(report: Report): number {
  return valueError(report) + 2 ** -41 * Math.max(...report.bernstein.map(Math.abs))
}

/** A column at the centre is too short, beside the longest edge, for the error of its mean. */
const SHORTEST_COLUMN = 2 ** -6

/** Lengths are off by 5u of themselves, at the centre by 5u of the longest edge: 2^-44 in each of three columns, and in ours. */
const LENGTHS_ERROR = 2 ** -40

/** The scaled Jacobian's error: that of jacdet over three lengths, and that of the lengths. */
export function scaledJacobianError(report: Report): number {
  if (report.exponent !== 0) return Number.POSITIVE_INFINITY
  const edges = edgeVertices.map(([from, to]) => difference(report.vertices, from, to))
  const lengths = edges.map(edge => Math.hypot(...edge))
  const centre = edgesAlong.map(parallel => Math.hypot(...meanOf(parallel.map(edge => edges[edge] as Vec3))))
  if (Math.min(...centre) < SHORTEST_COLUMN * Math.max(...lengths)) return Number.POSITIVE_INFINITY
  const shortest = edgesAlong.map((parallel, direction) =>
    Math.min(centre[direction] as number, ...parallel.map(edge => lengths[edge] as number)),
  )
  const product = shortest.reduce((all, length) => all * length, 1)
  const error = (valueError(report) / product) * (1 + LENGTHS_ERROR) + LENGTHS_ERROR
  return product > Number.MIN_VALUE / Number.EPSILON ? error : Number.POSITIVE_INFINITY
}

function difference(vertices: Vertices, from: number, to: number): Vec3 {
  const start = vertexOf(vertices, from)
  return vertexOf(vertices, to).map((value, axis) => value - (start[axis] as number)) as unknown as Vec3
}

function meanOf(vectors: readonly Vec3[]): number[] {
  return [0, 1, 2].map(axis => vectors.reduce((sum, vector) => sum + (vector[axis] as number), 0) / vectors.length)
}
