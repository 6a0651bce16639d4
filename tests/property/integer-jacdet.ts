/**
 * jacdet in big integers from its definition, det of the trilinear map's three columns, for the property tests. It shares
 * nothing with web/core/exact: no Bernstein coefficients (3) to (7), but values at points, and polynomials through them.
 */
import type { Vertices } from '../../web/model/hexahedron'

/** Reference coordinates of vertices 0 to 7, from the order's definition. */
const CORNERS = ['000', '100', '110', '010', '001', '101', '111', '011']

type Vector = readonly [bigint, bigint, bigint]

/** A number `over[0] / over[1]`, the second positive. */
export type Fraction = readonly [bigint, bigint]

/** integer * 2^exponent */
export interface Dyadic {
  readonly integer: bigint
  readonly exponent: number
}

/** A hexahedron on integers: jacdet of the true one is jacdet of this one times 2^exponent. */
export interface IntegerHexahedron {
  /** `edges[direction][2 * m + n]`: the difference along xi, eta or zeta, m and n the other two coordinates in order. */
  readonly edges: readonly (readonly Vector[])[]
  readonly exponent: number
}

const double = new Float64Array(1)
const words = new Uint32Array(double.buffer)

/** The double, exactly. */
export function dyadicOf(value: number): Dyadic {
  double[0] = value
  const [low, high] = words as unknown as [number, number]
  const power = (high >>> 20) & 0x7ff
  const fraction = (high & 0xfffff) * 2 ** 32 + low
  const integer = BigInt(power === 0 ? fraction : fraction + 2 ** 52)
  return { integer: high >>> 31 ? -integer : integer, exponent: Math.max(power, 1) - 1075 }
}

export function integerHexahedron(vertices: Vertices): IntegerHexahedron {
  const points: bigint[][] = CORNERS.map(() => [])
  let exponent = 0
  for (const axis of [0, 1, 2]) {
    const parts = CORNERS.map((_, v) => dyadicOf(vertices[3 * v + axis] as number))
    const least = Math.min(...parts.filter(({ integer }) => integer !== 0n).map(part => part.exponent))
    for (const [v, part] of parts.entries())
      points[v]?.push(part.integer === 0n ? 0n : part.integer << BigInt(part.exponent - least))
    if (Number.isFinite(least)) exponent += least
  }
  const at = (corner: string) => points[CORNERS.indexOf(corner)] as unknown as Vector
  const difference = (from: string, to: string): Vector => {
    const [p, q] = [at(from), at(to)]
    return [q[0] - p[0], q[1] - p[1], q[2] - p[2]]
  }
  const others = ['00', '01', '10', '11']
  const edges = [0, 1, 2].map(direction =>
    others.map(other => {
      const [before, after] = [other.slice(0, direction), other.slice(direction)]
      return difference(`${before}0${after}`, `${before}1${after}`)
    }),
  )
  return { edges, exponent }
}

export function determinant(u: Vector, v: Vector, w: Vector): bigint {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0])
}

/** jacdet of the integer hexahedron at a rational point, times the square of the product of the three denominators. */
export function jacdetAt({ edges }: IntegerHexahedron, point: readonly Fraction[]): bigint {
  const columns = edges.map((four, direction) => {
    const [[m, dm], [n, dn]] = point.filter((_, axis) => axis !== direction) as [Fraction, Fraction]
    const weights = [(dm - m) * (dn - n), (dm - m) * n, m * (dn - n), m * n] as const
    return [0, 1, 2].map(
      axis =>
        (four[0]?.[axis] as bigint) * weights[0] +
        (four[1]?.[axis] as bigint) * weights[1] +
        (four[2]?.[axis] as bigint) * weights[2] +
        (four[3]?.[axis] as bigint) * weights[3],
    ) as unknown as Vector
  }) as [Vector, Vector, Vector]
  return determinant(...columns)
}

/** Columns, times 4, at the nine points of {0, 1/2, 1}^2 `[3 * m + n]`. */
function columnsAtHalves(edges: readonly Vector[]): Vector[] {
  const [e00, e01, e10, e11] = edges as [Vector, Vector, Vector, Vector]
  const four = (e: Vector): Vector => [e[0] << 2n, e[1] << 2n, e[2] << 2n]
  const sum = (e: Vector, f: Vector): Vector => [e[0] + f[0], e[1] + f[1], e[2] + f[2]]
  const twice = (e: Vector): Vector => [e[0] << 1n, e[1] << 1n, e[2] << 1n]
  const [low, high] = [sum(e00, e01), sum(e10, e11)]
  return [
    [four(e00), twice(low), four(e01)],
    [twice(sum(e00, e10)), sum(low, high), twice(sum(e01, e11))],
    [four(e10), twice(high), four(e11)],
  ].flat()
}

/** Power of two of jacdetAtHalves, on top of the hexahedron's own. */
export const HALVES_EXPONENT = -6

/** 64 times jacdet of the integer hexahedron at the 26 boundary points of {0, 1/2, 1}^3, `[9 * i + 3 * j + k]`; 0 for the centre. */
export function jacdetAtHalves({ edges }: IntegerHexahedron): bigint[] {
  const [u, v, w] = edges.map(columnsAtHalves) as [Vector[], Vector[], Vector[]]
  const values: bigint[] = []
  for (let i = 0; i < 3; ++i)
    for (let j = 0; j < 3; ++j)
      for (let k = 0; k < 3; ++k)
        values.push(
          i === 1 && j === 1 && k === 1
            ? 0n
            : determinant(u[3 * j + k] as Vector, v[3 * i + k] as Vector, w[3 * i + j] as Vector),
        )
  return values
}

/** A quadratic by its Bernstein coefficients on an interval of t. */
export type Quadratic = readonly [bigint, bigint, bigint]

/**
 * A face as parabolas f(s,t) = a(t) s^2 + b(t) s + c(t) on an interval of t, by the quadratics
 *     start = c = f(0,t),   middle = 2c + b,   end = a + b + c = f(1,t),
 * all three times one positive number.
 */
export interface FaceParabolas {
  readonly start: Quadratic
  readonly middle: Quadratic
  readonly end: Quadratic
}

/** Power of two in a face's quadratics, on top of that of the integer hexahedron. */
export const FACE_EXPONENT = HALVES_EXPONENT - 1

/** Twice the Bernstein coefficients of the quadratic with these values at 0, 1/2, 1. */
function through(x: bigint, y: bigint, z: bigint): Quadratic {
  return [x << 1n, (y << 2n) - x - z, z << 1n]
}

/** Face 0..5: -xi, +xi, -eta, +eta, -zeta, +zeta; s and t are the other two in the order xi, eta, zeta. On all of [0,1]. */
export function faceParabolas(atHalves: readonly bigint[], face: number): FaceParabolas {
  const strides = [9, 3, 1]
  const [fixed] = strides.splice(face >> 1, 1) as [number]
  const [S, T] = strides as [number, number]
  const first = 2 * fixed * (face & 1)
  const value = (i: number, j: number) => atHalves[first + i * S + j * T] as bigint
  const along = (row: (j: number) => bigint) => through(row(0), row(1), row(2))
  return {
    start: along(j => value(0, j)),
    // f(1/2) = a/4 + b/2 + c, so 4 f(1/2) - f(0) - f(1) = b + 2c.
    middle: along(j => (value(1, j) << 2n) - value(0, j) - value(2, j)),
    end: along(j => value(2, j)),
  }
}

/** The face on [from, to] / denominator, times its square: the quadratic's polar form. */
export function restricted({ start, middle, end }: FaceParabolas, from: bigint, to: bigint, denominator: bigint) {
  const [m, n] = [denominator - from, denominator - to]
  const weights = [
    [m * m, 2n * m * from, from * from],
    [m * n, m * to + n * from, from * to],
    [n * n, 2n * n * to, to * to],
  ] as const
  const on = ([x, y, z]: Quadratic) => weights.map(([k, l, o]) => k * x + l * y + o * z) as unknown as Quadratic
  return { start: on(start), middle: on(middle), end: on(end) }
}

/** The face times 2^bits: large integers leave room for finer bounds. */
export function shifted({ start, middle, end }: FaceParabolas, bits: number): FaceParabolas {
  const up = ([x, y, z]: Quadratic): Quadratic => [x << BigInt(bits), y << BigInt(bits), z << BigInt(bits)]
  return { start: up(start), middle: up(middle), end: up(end) }
}

/** Reasons why the face is positive on the interval, named as in web/core/exact/certificate.ts. */
export type Reason = 'b' | '2a+b' | 'D' | 'middle'

const isPositive = (values: readonly bigint[]) => values.every(value => value > 0n)
const difference = (x: Quadratic, y: Quadratic): Quadratic => [x[0] - y[0], x[1] - y[1], x[2] - y[2]]
const doubled = (x: Quadratic): Quadratic => [x[0] << 1n, x[1] << 1n, x[2] << 1n]

/** b = middle - 2 start */
const slopeAtStart = ({ start, middle }: FaceParabolas) => difference(middle, doubled(start))
/** 2a + b = 2 end - middle */
const slopeAtEnd = ({ middle, end }: FaceParabolas) => difference(doubled(end), middle)

/** Six times the Bernstein coefficients of degree 4. */
function product(x: Quadratic, y: Quadratic): bigint[] {
  return [
    6n * x[0] * y[0],
    3n * (x[0] * y[1] + x[1] * y[0]),
    x[0] * y[2] + 4n * x[1] * y[1] + x[2] * y[0],
    3n * (x[1] * y[2] + x[2] * y[1]),
    6n * x[2] * y[2],
  ]
}

/** 6 (4ac - b^2) = 6 (4 start end - middle^2), as (2c + b)^2 = 4c^2 + 4bc + b^2 and 4c (a + b + c) - that = 4ac - b^2. */
function discriminant({ start, middle, end }: FaceParabolas): bigint[] {
  const squares = product(middle, middle)
  return product(start, end).map((value, i) => 4n * value - (squares[i] as bigint))
}

/** The edges s = 0 and s = 1 are positive by their coefficients. */
export function endsArePositive({ start, end }: FaceParabolas): boolean {
  return isPositive(start) && isPositive(end)
}

/**
 * With positive ends each of these makes f(.,t) positive on [0,1]: b >= 0 or 2a + b <= 0, the slopes at s = 0 and s = 1, put
 * the least value at an end, for either sign of a; D > 0 with c > 0 asks for a > 0, and D/(4a) is the least value of the
 * parabola; c + b/2 > 0 leaves three positive coefficients in s.
 */
export const isPositiveBy: Readonly<Record<Reason, (face: FaceParabolas) => boolean>> = {
  b: face => slopeAtStart(face).every(value => value >= 0n),
  '2a+b': face => slopeAtEnd(face).every(value => value <= 0n),
  D: face => isPositive(discriminant(face)),
  middle: ({ middle }) => isPositive(middle),
}

/** With positive ends, b >= 0 and 2a + b <= 0 each imply `middle`, which is a mean of an end and of what they leave. */
const REASONS: readonly Reason[] = ['middle', 'D']

/** value * 2^-exponent rounded down. */
export function floored({ integer, exponent }: Dyadic, unit: number): bigint {
  return exponent >= unit ? integer << BigInt(exponent - unit) : integer >> BigInt(unit - exponent)
}

/** Halvings: a dip of 2^-k of the face is found or refuted after about k/2 of them. */
const MOST_HALVINGS = 200

/**
 * True if the face is above `bound` (an integer in the units of its quadratics), proved by
 * bisection in t. The bound must not be the least value itself: neither answer would ever come.
 */
export function faceIsAbove({ start, middle, end }: FaceParabolas, bound: bigint, halvings = MOST_HALVINGS): boolean {
  const lowered = (quadratic: Quadratic, by: bigint): Quadratic => [
    quadratic[0] - by,
    quadratic[1] - by,
    quadratic[2] - by,
  ]
  return isPositiveFace(
    { start: lowered(start, bound), middle: lowered(middle, 2n * bound), end: lowered(end, bound) },
    halvings,
  )
}

function isPositiveFace(face: FaceParabolas, halvings: number): boolean {
  if (endsArePositive(face) && REASONS.some(reason => isPositiveBy[reason](face))) return true
  const { start, middle, end } = face
  if ([0, 2].some(t => !isPositiveParabola(start[t] as bigint, middle[t] as bigint, end[t] as bigint))) return false
  if (halvings === 0) throw new Error('The bound is too close to the least value of the face.')
  return (
    isPositiveFace(restricted(face, 0n, 1n, 2n), halvings - 1) &&
    isPositiveFace(restricted(face, 1n, 2n, 2n), halvings - 1)
  )
}

/** True if the parabola at one t is positive. */
function isPositiveParabola(start: bigint, middle: bigint, end: bigint): boolean {
  return start > 0n && end > 0n && (middle > 0n || middle * middle < 4n * start * end)
}
