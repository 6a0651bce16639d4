/** jacdet's Bernstein coefficients as integers: the doubles as given are integers over powers of two, one for each axis. */

import {
  BERNSTEIN_COUNT,
  bernsteinIndex,
  bernsteinIndices,
  bernsteinMiddles,
  edgeBernstein,
  faceBernstein,
  vertexBernstein,
} from '../../model/bernstein'
import { type Axis, edgeVertices, type Vec3, type Vertices, vertexReference } from '../../model/hexahedron'
import { dyadicOf, type Rational, scaledDouble } from '../../model/rational'
import { rounded } from './rounding'

export interface ExactJacdet {
  /** Four times the 27 coefficients, over 2^exponent; the cube's centre is left 0. */
  readonly bernstein: readonly bigint[]
  readonly exponent: number
  /** The twelve edge vectors; component r is its number times 2^axisExponents[r]. */
  readonly edges: readonly IntegerVector[]
  readonly axisExponents: readonly number[]
}

export type RationalPoint = readonly [Rational, Rational, Rational]

export type IntegerVector = readonly [bigint, bigint, bigint]

function cross(a: IntegerVector, b: IntegerVector): IntegerVector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

function dot(a: IntegerVector, b: IntegerVector): bigint {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

function plus(a: IntegerVector, b: IntegerVector): IntegerVector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/** The coordinates on one axis as integers over a common power of two. */
function integersOnAxis(vertices: Vertices, axis: number): { values: bigint[]; exponent: number } {
  const dyadics = vertexReference.map((_, v) => dyadicOf(vertices[3 * v + axis] as number))
  const used = dyadics.filter(({ integer }) => integer !== 0n).map(({ exponent }) => exponent)
  const exponent = used.length > 0 ? Math.min(...used) : 0
  const values = dyadics.map(dyadic =>
    dyadic.integer === 0n ? 0n : dyadic.integer << BigInt(dyadic.exponent - exponent),
  )
  return { values, exponent }
}

/** The edges U_jk, V_ik and W_ij, at 2j + k, 2i + k and 2i + j, each by the coefficient in its middle. */
const EDGES = [0, 1, 2].map(axis =>
  [0, 2].flatMap(first =>
    [0, 2].map(second => {
      const middle = bernsteinIndex(...([first, second].toSpliced(axis, 0, 1) as [number, number, number]))
      return edgeBernstein.findIndex(edge => edge[1] === middle)
    }),
  ),
)

/** The coefficients (3) to (7) of docs/algorithm.md. */
export function exactJacdet(vertices: Vertices): ExactJacdet {
  const axes = [0, 1, 2].map(axis => integersOnAxis(vertices, axis))
  const points = vertexReference.map((_, v) => axes.map(({ values }) => values[v]) as unknown as IntegerVector)
  const vectors = edgeVertices.map(([from, to]) => {
    const [p, q] = [points[from], points[to]] as [IntegerVector, IntegerVector]
    return [q[0] - p[0], q[1] - p[1], q[2] - p[2]] as const
  })
  const along = (axis: Axis, a: number, b: number) => vectors[EDGES[axis]?.[2 * a + b] as number] as IntegerVector
  const u = (j: number, k: number) => along(0, j, k)
  const v = (i: number, k: number) => along(1, i, k)
  const w = (i: number, j: number) => along(2, i, j)

  const bernstein = Array<bigint>(BERNSTEIN_COUNT).fill(0n)
  const add = (index: number, value: bigint) => {
    bernstein[index] = (bernstein[index] as bigint) + value
  }
  for (const i of [0, 1])
    for (const j of [0, 1]) {
      for (const k of [0, 1]) {
        const normal = cross(u(j, k), v(i, k))
        add(bernsteinIndex(2 * i, 2 * j, 2 * k), 4n * dot(normal, w(i, j)))
        add(bernsteinIndex(1, 2 * j, 2 * k), 2n * dot(normal, w(1 - i, j)))
        add(bernsteinIndex(2 * i, 1, 2 * k), 2n * dot(normal, w(i, 1 - j)))
      }
      add(bernsteinIndex(2 * i, 2 * j, 1), 2n * dot(plus(cross(u(j, 0), v(i, 1)), cross(u(j, 1), v(i, 0))), w(i, j)))
    }
  for (const nine of faceBernstein) {
    const total = (...indices: number[]) =>
      indices.reduce((all, index) => all + (bernstein[nine[index] as number] as bigint), 0n)
    bernstein[nine[4] as number] = (2n * total(1, 3, 5, 7) - total(0, 2, 6, 8)) / 4n
  }
  const axisExponents = axes.map(({ exponent }) => exponent)
  return { bernstein, exponent: axisExponents.reduce((a, b) => a + b), edges: vectors, axisExponents }
}

/** Sixteen times the 27 coefficients, over 2^exponent: with the cube's centre by docs/algorithm.md (7). */
export function sixteenths({ bernstein }: ExactJacdet): bigint[] {
  const sumOf = (middles: number) =>
    bernstein.reduce((all, coefficient, i) => (bernsteinMiddles[i] === middles ? all + coefficient : all), 0n)
  return bernstein.map(coefficient => 4n * coefficient).with(bernsteinIndex(1, 1, 1), sumOf(1) - sumOf(0))
}

/** A face's nine, `[3 * i + j]` with i in s, j in t. */
export function exactFace({ bernstein }: ExactJacdet, face: number): bigint[] {
  return (faceBernstein[face] as readonly number[]).map(index => bernstein[index] as bigint)
}

/** An edge's three, from its lower to its upper end. */
export function exactEdge({ bernstein }: ExactJacdet, edge: number): [bigint, bigint, bigint] {
  return edgeBernstein[edge]?.map(index => bernstein[index]) as [bigint, bigint, bigint]
}

export function exactVertex({ bernstein }: ExactJacdet, vertex: number): bigint {
  return bernstein[vertexBernstein[vertex] as number] as bigint
}

/** jacdet at a point of the boundary, over the ExactJacdet's power of two and its factor 4. */
export function valueAt({ bernstein }: ExactJacdet, point: RationalPoint): Rational {
  const weights = point.map(({ numerator: x, denominator: d }) => [(d - x) * (d - x), 2n * x * (d - x), x * x])
  const weightOf = (n: number) =>
    weights.reduce((all, ofAxis, axis) => all * (ofAxis[bernsteinIndices[n]?.[axis] as number] as bigint), 1n)
  const numerator = bernstein.reduce((all, coefficient, n) => all + coefficient * weightOf(n), 0n)
  return { numerator, denominator: point.reduce((all, { denominator: d }) => all * d * d, 1n) }
}

/** jacdet at any point of the cube, times 2^exponent, correctly rounded: unlike one in doubles it has the right sign. */
export function exactJacdetAt(vertices: Vertices, point: Vec3): { jacdet: number; exponent: number } {
  const exact = exactJacdet(vertices)
  const exactPoint = point.map(coordinate => scaledDouble(coordinate, 0)) as unknown as RationalPoint
  const value = valueAt({ ...exact, bernstein: sixteenths(exact) }, exactPoint)
  const { mantissa, exponent } = rounded(value, exact.exponent - 4)
  return { jacdet: mantissa, exponent }
}
