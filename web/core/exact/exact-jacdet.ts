/** jacdet's Bernstein coefficients as integers: the doubles as given are integers over powers of two, one for each axis. */
import { edgeVertices, faces, type Vertices, vertexReference } from '../../model/hexahedron'
import { bitLength, rounded } from './rational'

export interface ExactJacdet {
  /** Four times the 27 coefficients, over 2^exponent, `bernstein[9 * i + 3 * j + k]`; the cube's centre is left 0. */
  readonly bernstein: readonly bigint[]
  readonly exponent: number
  /** The twelve edge vectors; component r is its number times 2^axisExponents[r]. */
  readonly edges: readonly IntegerVector[]
  readonly axisExponents: readonly number[]
}

export type IntegerVector = readonly [bigint, bigint, bigint]

const bits = new DataView(new ArrayBuffer(8))

/** integer * 2^exponent, exactly. */
function integerOf(value: number): { integer: bigint; exponent: number } {
  bits.setFloat64(0, value)
  const word = bits.getBigUint64(0)
  const biased = Number((word >> 52n) & 0x7ffn)
  const fraction = word & 0xfffffffffffffn
  const magnitude = biased === 0 ? fraction : fraction | 0x10000000000000n
  return { integer: value < 0 ? -magnitude : magnitude, exponent: Math.max(biased, 1) - 1075 }
}

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
  const parts = vertexReference.map((_, v) => integerOf(vertices[3 * v + axis] as number))
  const used = parts.filter(({ integer }) => integer !== 0n).map(({ exponent }) => exponent)
  const exponent = used.length > 0 ? Math.min(...used) : 0
  const values = parts.map(part => (part.integer === 0n ? 0n : part.integer << BigInt(part.exponent - exponent)))
  return { values, exponent }
}

const at = (i: number, j: number, k: number) => 9 * i + 3 * j + k

/** By docs/algorithm.md (3) to (7). */
export function exactJacdet(vertices: Vertices): ExactJacdet {
  const axes = [0, 1, 2].map(axis => integersOnAxis(vertices, axis))
  const points = vertexReference.map((_, v) => axes.map(({ values }) => values[v]) as unknown as IntegerVector)
  const vectors = edgeVertices.map(([from, to]) => {
    const [p, q] = [points[from], points[to]] as [IntegerVector, IntegerVector]
    return [q[0] - p[0], q[1] - p[1], q[2] - p[2]] as const
  })
  const vector = (edge: number | undefined) => vectors[edge as number] as IntegerVector
  const u = (j: number, k: number) => vector([0, 4, 2, 6][2 * j + k])
  const v = (i: number, k: number) => vector([3, 7, 1, 5][2 * i + k])
  const w = (i: number, j: number) => vector([8, 10, 9, 11][2 * i + j])

  const bernstein = Array<bigint>(27).fill(0n)
  const add = (index: number, value: bigint) => {
    bernstein[index] = (bernstein[index] as bigint) + value
  }
  for (const i of [0, 1])
    for (const j of [0, 1]) {
      for (const k of [0, 1]) {
        const normal = cross(u(j, k), v(i, k))
        add(at(2 * i, 2 * j, 2 * k), 4n * dot(normal, w(i, j)))
        add(at(1, 2 * j, 2 * k), 2n * dot(normal, w(1 - i, j)))
        add(at(2 * i, 1, 2 * k), 2n * dot(normal, w(i, 1 - j)))
      }
      add(at(2 * i, 2 * j, 1), 2n * dot(plus(cross(u(j, 0), v(i, 1)), cross(u(j, 1), v(i, 0))), w(i, j)))
    }
  for (const { axis, side, s, t } of faces) {
    const stride = [9, 3, 1]
    const [S, T] = [stride[s] as number, stride[t] as number]
    const centre = 2 * side * (stride[axis] as number) + S + T
    const total = (...offsets: number[]) =>
      offsets.reduce((all, offset) => all + (bernstein[centre + offset] as bigint), 0n)
    bernstein[centre] = (2n * total(-S, S, -T, T) - total(-S - T, S + T, T - S, S - T)) / 4n
  }
  const axisExponents = axes.map(({ exponent }) => exponent)
  return { bernstein, exponent: axisExponents.reduce((a, b) => a + b), edges: vectors, axisExponents }
}

/** Sixteen times the 27 coefficients, over 2^exponent: with the cube's centre by docs/algorithm.md (7). */
export function sixteenths({ bernstein }: ExactJacdet): bigint[] {
  const sumOf = (ones: number) =>
    bernstein.reduce((all, coefficient, i) => (onesIn(i) === ones ? all + coefficient : all), 0n)
  return bernstein.map(coefficient => 4n * coefficient).with(at(1, 1, 1), sumOf(1) - sumOf(0))
}

/** A coefficient too small for the doubles beside the largest keeps its sign. */
const LEAST_POWER = -1000

/**
 * All 27 as doubles times 2^exponent, the largest of magnitude in [1/2, 1); each is off by `error` at most, its rounding, and
 * has its sign.
 */
export function roundedJacdet(jacdet: ExactJacdet) {
  const coefficients = sixteenths(jacdet)
  const bits = Math.max(...coefficients.map(bitLength))
  const inUnit = (numerator: bigint) => {
    const { mantissa, exponent: power } = rounded({ numerator, denominator: 1n }, -bits)
    return power < LEAST_POWER ? Math.sign(mantissa) * 2 ** LEAST_POWER : mantissa * 2 ** power
  }
  return {
    bernstein: coefficients.map(inUnit),
    exponent: bits === 0 ? 0 : jacdet.exponent - 4 + bits,
    error: bits === 0 ? 0 : 2 ** -53,
  }
}

/** How many of its three indices are 1: none of a corner, one of an edge's middle. */
function onesIn(index: number): number {
  return [9, 3, 1].filter(stride => Math.floor(index / stride) % 3 === 1).length
}

/** A face's nine, `[3 * i + j]` with i in s, j in t. */
export function exactFace({ bernstein }: ExactJacdet, face: number): bigint[] {
  const { axis, side, s, t } = faces[face] as (typeof faces)[number]
  const stride = [9, 3, 1] as const
  const origin = 2 * side * stride[axis]
  return [0, 1, 2].flatMap(i => [0, 1, 2].map(j => bernstein[origin + i * stride[s] + j * stride[t]] as bigint))
}

/** An edge's three, from its lower to its upper end. */
export function exactEdge({ bernstein }: ExactJacdet, edge: number): [bigint, bigint, bigint] {
  const [from, to] = (edgeVertices[edge] as readonly [number, number]).map(vertex => {
    const [i, j, k] = vertexReference[vertex] as readonly [number, number, number]
    return at(2 * i, 2 * j, 2 * k)
  }) as [number, number]
  return [from, (from + to) / 2, to].map(index => bernstein[index] as bigint) as [bigint, bigint, bigint]
}

export function exactVertex({ bernstein }: ExactJacdet, vertex: number): bigint {
  const [i, j, k] = vertexReference[vertex] as readonly [number, number, number]
  return bernstein[at(2 * i, 2 * j, 2 * k)] as bigint
}
