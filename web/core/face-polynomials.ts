/**
 * One face's jacdet as parabolas in s: f(s,t) = a(t) s² + b(t) s + c(t), and D = 4ac − b², which is positive where the
 * parabola never reaches zero: docs/algorithm.md (10), (11), (13). Drawn and read, never a verdict.
 */

/** Coefficients of the Bernstein polynomials of their degree on [0,1]. */
export interface FacePolynomials {
  /** a, b and c are their numbers times 2^exponent, d times 2^(2 exponent). */
  readonly exponent: number
  readonly a: readonly [number, number]
  readonly b: readonly [number, number, number]
  readonly c: readonly [number, number, number]
  readonly d: readonly [number, number, number, number, number]
}

type Quadratic = readonly [number, number, number]

/** `bernstein[3 * i + j]`: i in s, j in t. The largest becomes about 1: products stay in range. */
export function facePolynomials(bernstein: readonly number[]): FacePolynomials {
  const greatest = Math.max(...bernstein.map(Math.abs))
  const exponent = greatest > 0 ? Math.floor(Math.log2(greatest)) : 0
  const unit = bernstein.map(value => value * 2 ** -exponent)
  const row = (i: number) => unit.slice(3 * i, 3 * i + 3) as unknown as Quadratic
  const [c, middle, end] = [row(0), row(1), row(2)]
  const half = difference(middle, c)
  const rest = difference(end, middle)
  const a = [rest[0] - half[0], rest[2] - half[2]] as const
  const b = [2 * half[0], 2 * half[1], 2 * half[2]] as const
  const ac = product([a[0], (a[0] + a[1]) / 2, a[1]], c)
  const bb = product(b, b)
  const d = ac.map((value, i) => 4 * value - (bb[i] as number)) as unknown as FacePolynomials['d']
  return { exponent, a, b, c, d }
}

/** De Casteljau's scheme. */
export function valueAt(bernstein: readonly number[], t: number): number {
  const values = bernstein.slice()
  for (let count = values.length - 1; count > 0; count--) {
    for (let i = 0; i < count; i++) values[i] = (1 - t) * (values[i] as number) + t * (values[i + 1] as number)
  }
  return values[0] as number
}

/** Coefficients of 1, t, t², …: differences at the first coefficient, times binomial coefficients. */
export function powerCoefficients(bernstein: readonly number[]): number[] {
  const degree = bernstein.length - 1
  let differences = bernstein
  let binomial = 1
  return bernstein.map((_, power) => {
    const coefficient = binomial * (differences[0] as number)
    differences = differences.slice(1).map((value, i) => value - (differences[i] as number))
    binomial = (binomial * (degree - power)) / (power + 1)
    return coefficient
  })
}

/** s* = −b/(2a), where the parabola at t is least; null where it is not convex. */
export function vertexInS({ a, b }: FacePolynomials, t: number): number | null {
  const curvature = valueAt(a, t)
  return curvature > 0 ? -valueAt(b, t) / (2 * curvature) : null
}

/** The s in [0,1] at which f(s,t) is least. */
export function leastInRow(face: FacePolynomials, t: number): number {
  const vertex = vertexInS(face, t)
  if (vertex !== null) return Math.max(0, Math.min(1, vertex))
  return valueAt(face.a, t) + valueAt(face.b, t) < 0 ? 1 : 0
}

function difference(x: Quadratic, y: Quadratic): Quadratic {
  return [x[0] - y[0], x[1] - y[1], x[2] - y[2]]
}

/** (13) for two quadratics. */
function product(x: Quadratic, y: Quadratic): number[] {
  return [
    x[0] * y[0],
    (x[0] * y[1] + x[1] * y[0]) / 2,
    (x[0] * y[2] + 4 * x[1] * y[1] + x[2] * y[0]) / 6,
    (x[1] * y[2] + x[2] * y[1]) / 2,
    x[2] * y[2],
  ]
}
