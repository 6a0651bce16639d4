/**
 * The distance of an element from jacdet = 0 at one reference point: the least move of one vertex
 * (N3), or of all together (N5), that makes it zero there. With Bernstein coefficients in place of
 * values it is a bound over a patch of the face: (N4), (N6).
 */
import type { Vec3 } from '../../../model/hexahedron'
import { type Columns, columnsAt, dot, map3, responseAt, shapeGradients } from './scaled-element'

/** The numbers that a distance depends on, or their Bernstein coefficients over a patch. */
export type Entries = readonly number[]

/** One kind of move: its numbers, and the distance if each is off by at most `slack`. */
export interface DistanceKind {
  readonly entriesAt: (edges: readonly Vec3[], point: Vec3) => Entries
  readonly distance: (entries: Entries, slack: number) => number
}

/** jacdet and its gradient: J / |g|, in which J and the components of g may be off. */
export function ofVertex(vertex: number): DistanceKind {
  return {
    entriesAt: (edges, point) => {
      const { jacdet, gradients } = responseAt(edges, point)
      return [jacdet, ...(gradients[vertex] as Vec3)]
    },
    distance: ([jacdet, x, y, z], slack) => {
      const length = Math.hypot(x as number, y as number, z as number) + 2 * slack
      return ((jacdet as number) - slack) / length
    },
  }
}

/** The least |DF u| / |G u|, from upper triangles of DF^T DF and G^T G; G has the rows dN_v. */
export const ofAllVertices: DistanceKind = {
  entriesAt: (edges, point) => {
    const columns = columnsAt(edges, point)
    const gradients = shapeGradients(point)
    const columnsOfG = map3(axis => gradients.map(gradient => gradient[axis]))
    return [
      ...upperTriangle((i, j) => dot(columns[i], columns[j])),
      ...upperTriangle((i, j) =>
        columnsOfG[i].reduce((sum, value, v) => sum + value * (columnsOfG[j][v] as number), 0),
      ),
    ]
  },
  distance: (entries, slack) => Math.sqrt(leastQuotient(entries, 4 * slack)?.value ?? 0),
}

function upperTriangle(entry: (i: 0 | 1 | 2, j: 0 | 1 | 2) => number): number[] {
  return [entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)]
}

/**
 * The least u^T A u / u^T B u and its u, where A - slack I is positive definite, else null. By A = L L^T it is one over the
 * greatest eigenvalue of L^-1 B L^-T; a B that is nowhere positive leaves it infinite.
 */
function leastQuotient(entries: Entries, slack: number): { value: number; direction: Vec3 } | null {
  const [a00, a01, a02, a11, a12, a22, b00, b01, b02, b11, b12, b22] = entries as unknown as number[] & { length: 12 }
  const l00 = Math.sqrt((a00 as number) - slack)
  const l10 = (a01 as number) / l00
  const l20 = (a02 as number) / l00
  const l11 = Math.sqrt((a11 as number) - slack - l10 * l10)
  const l21 = ((a12 as number) - l20 * l10) / l11
  const l22 = Math.sqrt((a22 as number) - slack - l20 * l20 - l21 * l21)
  if (!(l00 > 0 && l11 > 0 && l22 > 0)) return null
  const forward = ([x, y, z]: Vec3): Vec3 => {
    const first = x / l00
    const second = (y - l10 * first) / l11
    return [first, second, (z - l20 * first - l21 * second) / l22]
  }
  const [c0, c1, c2] = [
    forward([(b00 as number) + slack, b01 as number, b02 as number]),
    forward([b01 as number, (b11 as number) + slack, b12 as number]),
    forward([b02 as number, b12 as number, (b22 as number) + slack]),
  ]
  const rows = map3(i => forward([c0[i], c1[i], c2[i]]))
  const { value, vector } = greatestEigenvalue(rows)
  if (value <= 0) return { value: Number.POSITIVE_INFINITY, direction: vector }
  const z = vector[2] / l22
  const y = (vector[1] - l21 * z) / l11
  return { value: 1 / value, direction: [(vector[0] - l10 * y - l20 * z) / l00, y, z] }
}

const ROTATIONS = [
  [0, 1],
  [0, 2],
  [1, 2],
] as const
/** Jacobi's method converges quadratically; this many sweeps leave nothing of 3 x 3 doubles. */
const SWEEPS = 8

/** The greatest eigenvalue of a symmetric matrix, by Jacobi's rotations. */
function greatestEigenvalue(rows: readonly [Vec3, Vec3, Vec3]): { value: number; vector: Vec3 } {
  const a = rows.map(row => [...row])
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ]
  const at = (m: number[][], i: number, j: number) => (m[i] as number[])[j] as number
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    let isDiagonal = true
    for (const [p, q] of ROTATIONS) {
      if (Math.abs(at(a, p, q)) <= 2 ** -60 * (Math.abs(at(a, p, p)) + Math.abs(at(a, q, q)))) continue
      isDiagonal = false
      const theta = (at(a, q, q) - at(a, p, p)) / (2 * at(a, p, q))
      const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1))
      const c = 1 / Math.hypot(t, 1)
      const s = t * c
      for (const m of [a, v]) rotateColumns(m, p, q, c, s)
      rotateRows(a, p, q, c, s)
    }
    if (isDiagonal) break
  }
  const values = [0, 1, 2].map(i => at(a, i, i))
  const best = values.indexOf(Math.max(...values))
  return { value: values[best] as number, vector: map3(i => at(v, i, best)) }
}

function rotateColumns(m: number[][], p: number, q: number, c: number, s: number): void {
  for (const row of m) {
    const [x, y] = [row[p] as number, row[q] as number]
    row[p] = c * x - s * y
    row[q] = s * x + c * y
  }
}

function rotateRows(m: number[][], p: number, q: number, c: number, s: number): void {
  const [x, y] = [m[p] as number[], m[q] as number[]]
  for (const j of [0, 1, 2]) {
    const [xj, yj] = [x[j] as number, y[j] as number]
    x[j] = c * xj - s * yj
    y[j] = s * xj + c * yj
  }
}

/** A smaller number cannot be told from zero, and its sign may be wrong. */
const LEAST_JACDET = 2 ** -60

/** The move of one vertex of a valid element, of length J / |g| (N3). */
export function moveOfVertex(edges: readonly Vec3[], point: Vec3, vertex: number): Vec3[] {
  const { jacdet, gradients } = responseAt(edges, point)
  const gradient = gradients[vertex] as Vec3
  const factor = -Math.max(jacdet, LEAST_JACDET) / dot(gradient, gradient)
  return gradients.map((_, v) => (v === vertex ? map3(axis => factor * gradient[axis]) : [0, 0, 0]))
}

/** The move of all vertices of a valid element that makes jacdet zero to first order. */
export function moveDownhill(edges: readonly Vec3[], point: Vec3): Vec3[] {
  const { jacdet, gradients } = responseAt(edges, point)
  const square = gradients.reduce((sum, gradient) => sum + dot(gradient, gradient), 0)
  const factor = -Math.max(jacdet, LEAST_JACDET) / square
  return gradients.map(gradient => map3(axis => factor * gradient[axis]))
}

/** The move of all vertices along DF u that takes it to zero (N5). Null if DF is singular. */
export function moveOfAll(edges: readonly Vec3[], point: Vec3): Vec3[] | null {
  const least = leastQuotient(ofAllVertices.entriesAt(edges, point), 0)
  if (least === null) return null
  const { direction } = least
  const image = applied(columnsAt(edges, point), direction)
  const weights = shapeGradients(point).map(gradient => dot(gradient, direction))
  const square = weights.reduce((sum, weight) => sum + weight * weight, 0)
  return weights.map(weight => map3(axis => (-weight * image[axis]) / square))
}

function applied(columns: Columns, [x, y, z]: Vec3): Vec3 {
  return map3(axis => columns[0][axis] * x + columns[1][axis] * y + columns[2][axis] * z)
}
