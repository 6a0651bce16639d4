/**
 * Proofs that jacdet is positive, or is not, which anyone can check from the definitions: docs/certificates.md. Of an invalid
 * element a rational point with jacdet <= 0; of a valid one intervals on which a condition with few signs holds.
 */
import { edgeVertices, faces, VERTEX_COUNT, type Vertices, vertexOf, vertexReference } from '../../model/hexahedron'
import { fractionText, isLess, lowestTerms, productOf, type Rational, scaledInteger } from '../../model/rational'
import type { Core, Result } from '../report'
import {
  type ExactJacdet,
  exactEdge,
  exactFace,
  exactJacdet,
  exactVertex,
  type RationalPoint,
  valueAt,
} from './exact-jacdet'
import { exactBoundarySign, faceParabolas, type Sign } from './exact-sign'
import {
  commonDivisor,
  derivative,
  midpoint,
  type Polynomial,
  product,
  refinedTo,
  rootsInUnitInterval,
  signAtRoot,
  signOf,
  squareFree,
  sum,
} from './integer-polynomial'

/** Why jacdet is positive on the face for all t of an interval with dyadic ends: docs/certificates.md (C3) to (C6). */
export interface CertifiedInterval {
  readonly from: Rational
  readonly to: Rational
  readonly by: 'b' | '2a+b' | 'D' | 'middle'
}

/** Every Rational is in lowest terms. */
export type Certificate =
  | {
      readonly valid: false
      /** A point of the boundary of the closed cube. */
      readonly point: RationalPoint
      /** The value there, zero or negative; negative if any on the boundary is. */
      readonly jacdet: Rational
    }
  | {
      readonly valid: true
      /** Intervals of faces 0 to 5, each face's ascending, from 0 to 1 without gap or overlap. */
      readonly faces: readonly (readonly CertifiedInterval[])[]
    }

export const THEOREM =
  "If jacdet > 0 on the six faces then jacdet > 0 on the whole element (Knupp's conjecture, proved: P. Zhang, Validating Hexahedra through their Boundaries)."

/** Takes 24 finite doubles as they are. Always ends, however near the border the element is. */
export function certify(vertices: Vertices): Certificate {
  const sign = exactBoundarySign(vertices)
  const jacdet = exactJacdet(vertices)
  if (sign > 0) return { valid: true, faces: faces.map((_, face) => certifiedIntervals(exactFace(jacdet, face))) }
  const point = witness(jacdet, sign).map(lowestTerms) as unknown as RationalPoint
  return {
    valid: false,
    point,
    jacdet: lowestTerms(productOf(valueAt(jacdet, point), scaledInteger(1n, jacdet.exponent - 2))),
  }
}

/** The certificate of numbers that the core has a verdict on, or its refusal. */
export function certificateOf(core: Core, vertices: Vertices): Result<Certificate> {
  const result = core.isValid(vertices)
  return result.ok ? { ok: true, value: certify(vertices) } : result
}

/** The object that the command line prints and the page copies: docs/certificates.md, section 1. */
export function certificateJson(name: string, vertices: Vertices, certificate: Certificate): object {
  const points = Array.from({ length: VERTEX_COUNT }, (_, v) => vertexOf(vertices, v))
  const element = { name, vertices: points, valid: certificate.valid }
  if (!certificate.valid)
    return { ...element, point: certificate.point.map(fractionText), jacdet: fractionText(certificate.jacdet) }
  const written = ({ from, to, by }: CertifiedInterval) => ({ t: [fractionText(from), fractionText(to)], by })
  return { ...element, theorem: THEOREM, faces: certificate.faces.map(intervals => intervals.map(written)) }
}

/** A point where jacdet has the sign of the boundary minimum, -1 or 0: a vertex if one has it, else on an edge, else on a face. */
function witness(jacdet: ExactJacdet, sign: Sign): RationalPoint {
  const found = leastVertex(jacdet, sign) ?? leastOnEdges(jacdet, sign)
  if (found) return sign < 0 ? simplest(jacdet, found) : found
  return sign < 0 ? simplest(jacdet, leastOnFaces(jacdet)) : touchedOnFaces(jacdet)
}

/** The point with its coordinates rounded to as few bits as leave jacdet negative, as it is at the point itself. */
function simplest(jacdet: ExactJacdet, point: RationalPoint): RationalPoint {
  for (const bits of precisions()) {
    const near = point.map(coordinate => roundedTo(bits, coordinate)) as unknown as RationalPoint
    if (valueAt(jacdet, near).numerator < 0n) return near
  }
  throw new Error('jacdet is continuous.')
}

/** 1, 2, 3, 4, 6, 8, 12, 16, 24 and on. */
function* precisions(): Generator<bigint, never> {
  yield 1n
  for (let bits = 2n; ; bits *= 2n) {
    yield bits
    yield bits + bits / 2n
  }
}

function roundedTo(bits: bigint, { numerator, denominator }: Rational): Rational {
  return { numerator: ((numerator << (bits + 1n)) + denominator) / (2n * denominator), denominator: 1n << bits }
}

const whole = (value: number | bigint): Rational => ({ numerator: BigInt(value), denominator: 1n })

function leastVertex(jacdet: ExactJacdet, sign: Sign): RationalPoint | null {
  const values = vertexReference.map((_, vertex) => exactVertex(jacdet, vertex))
  const least = values.reduce((a, b) => (b < a ? b : a))
  if (signOf(least) !== sign) return null
  return vertexReference[values.indexOf(least)]?.map(whole) as unknown as RationalPoint
}

/** The least of the edges' candidates (9), at a rational point. */
function leastOnEdges(jacdet: ExactJacdet, sign: Sign): RationalPoint | null {
  const candidates = edgeVertices.flatMap(([from, to], edge) => {
    const [q0, q1, q2] = exactEdge(jacdet, edge)
    const numerator = q0 * q2 - q1 * q1
    if (q1 >= q0 || q1 >= q2 || signOf(numerator) !== sign) return []
    const denominator = q0 - 2n * q1 + q2
    const point = vertexReference[from]?.map((x, axis) =>
      x === vertexReference[to]?.[axis] ? whole(x) : { numerator: q0 - q1, denominator },
    ) as unknown as RationalPoint
    return [{ point, value: { numerator, denominator } }]
  })
  return leastOf(candidates)?.point ?? null
}

function leastOf<T extends { readonly value: Rational }>(candidates: readonly T[]): T | undefined {
  return candidates.reduce<T | undefined>((a, b) => (a === undefined || isLess(b.value, a.value) ? b : a), undefined)
}

/** The least value near the roots of P (12), if a face is negative, but no vertex and no edge. */
function leastOnFaces(jacdet: ExactJacdet): RationalPoint {
  const roots = faces.flatMap((_, face) => {
    const parabolas = faceParabolas(exactFace(jacdet, face))
    const { a, b, c, n } = parabolas
    const g = sum(product(a, derivative(c)), product(b, derivative(b)), -2n)
    const quartic = squareFree(sum(product(a, g), product(derivative(a), product(b, b))))
    return rootsInUnitInterval(quartic)
      .filter(root => signAtRoot(b, quartic, root) < 0 && signAtRoot(n, quartic, root) > 0)
      .map(root => ({ face, parabolas, quartic, root }))
  })
  for (let bits = 64; ; bits *= 2) {
    const near = roots.flatMap(({ face, parabolas, quartic, root }) => {
      const { low, high } = refinedTo(quartic, root, bits)
      const { numerator, shift } = low === high ? low : midpoint(low, high)
      const point = atParabolaVertex(face, parabolas, { numerator, denominator: 1n << BigInt(shift) })
      return point ? [{ point, value: valueAt(jacdet, point) }] : []
    })
    const least = leastOf(near)
    if (least && least.value.numerator < 0n) return least.point
  }
}

/** The zero at the one root of gcd(D, D'), if only faces attain it: docs/certificates.md (C8). */
function touchedOnFaces(jacdet: ExactJacdet): RationalPoint {
  for (const face of faces.keys()) {
    const parabolas = faceParabolas(exactFace(jacdet, face))
    const t = rootOfLinear(commonDivisor(parabolas.d, derivative(parabolas.d)))
    const point = t && atParabolaVertex(face, parabolas, t)
    if (point) return point
  }
  throw new Error('A least value of zero is attained.')
}

/** The root if it is in (0,1). */
function rootOfLinear(p: Polynomial): Rational | null {
  if (p.length !== 2) return null
  const [p0, p1] = p as readonly [bigint, bigint]
  const t = p1 < 0n ? { numerator: p0, denominator: -p1 } : { numerator: -p0, denominator: p1 }
  return t.numerator > 0n && t.numerator < t.denominator ? t : null
}

/** (s*(t), t) on the face, s* = -B/a; null unless it is strictly inside. */
function atParabolaVertex(
  face: number,
  parabolas: ReturnType<typeof faceParabolas>,
  t: Rational,
): RationalPoint | null {
  // The common denominator of both is that of t squared: it cancels.
  const [b, n] = [parabolas.b, parabolas.n].map(([p0 = 0n, p1 = 0n, p2 = 0n]) => {
    return (p0 * t.denominator + p1 * t.numerator) * t.denominator + p2 * t.numerator * t.numerator
  }) as [bigint, bigint]
  if (b >= 0n || n <= 0n) return null
  const topology = faces[face] as (typeof faces)[number]
  const point = [whole(topology.side), whole(topology.side), whole(topology.side)] as [Rational, Rational, Rational]
  point[topology.s] = { numerator: -b, denominator: n - b }
  point[topology.t] = t
  return point
}

/** Rows beta_0, beta_1, beta_2 of (C2) on an interval of t, times a power of two that does not matter. */
type Row = readonly [bigint, bigint, bigint]
type Rows = readonly [Row, Row, Row]

interface Subinterval {
  readonly from: Rational
  readonly to: Rational
  readonly rows: Rows
}

/**
 * [0,1] bisected until a condition holds on each subinterval. By docs/certificates.md (C7) this
 * ends on a positive face. A list, not a recursion: subintervals can be smaller than a stack is
 * deep. The lowest subinterval is its last.
 */
function certifiedIntervals(beta: readonly bigint[]): CertifiedInterval[] {
  const rows = [0, 3, 6].map(i => beta.slice(i, i + 3)) as unknown as Rows
  const subintervals: Subinterval[] = [{ from: whole(0), to: whole(1), rows }]
  const intervals: CertifiedInterval[] = []
  for (let subinterval = subintervals.pop(); subinterval; subinterval = subintervals.pop()) {
    const { from, to } = subinterval
    const by = conditionOn(subinterval.rows)
    if (by) {
      intervals.push({ from, to, by })
      continue
    }
    const middle = halfway(from, to)
    const halves = subinterval.rows.map(halved)
    const [lower, upper] = [0, 1].map(half => halves.map(row => row[half])) as unknown as [Rows, Rows]
    subintervals.push({ from: middle, to, rows: upper }, { from, to: middle, rows: lower })
  }
  return intervals
}

/** The first of (C4), (C5), (C3) and (C6) that shows in the signs of Bernstein coefficients: simple reasons first. */
function conditionOn([c, middle, end]: Rows): CertifiedInterval['by'] | null {
  if (!(isPositive(c) && isPositive(end))) return null
  if (middle.every((value, j) => value >= (c[j] as bigint))) return 'b'
  if (middle.every((value, j) => value >= (end[j] as bigint))) return '2a+b'
  if (isPositive(middle)) return 'middle'
  const b = middle.map((value, j) => value - (c[j] as bigint)) as unknown as Row
  const a = end.map((value, j) => value - (middle[j] as bigint) - (b[j] as bigint)) as unknown as Row
  const squared = timesBernstein(b, b)
  return timesBernstein(a, c).every((value, m) => value > (squared[m] as bigint)) ? 'D' : null
}

function isPositive(row: Row): boolean {
  return row.every(value => value > 0n)
}

/** The product's five Bernstein coefficients, the m-th times C(4,m): docs/algorithm.md (13). */
function timesBernstein([x0, x1, x2]: Row, [y0, y1, y2]: Row): bigint[] {
  return [x0 * y0, 2n * (x0 * y1 + x1 * y0), x0 * y2 + 4n * x1 * y1 + x2 * y0, 2n * (x1 * y2 + x2 * y1), x2 * y2]
}

/** De Casteljau's scheme at 1/2, everything times 4. */
function halved([q0, q1, q2]: Row): [Row, Row] {
  const middle = q0 + 2n * q1 + q2
  return [
    [4n * q0, 2n * (q0 + q1), middle],
    [middle, 2n * (q1 + q2), 4n * q2],
  ]
}

/** (2k+1)/2^(n+1) of neighbours k/2^n and (k+1)/2^n, all in lowest terms. */
function halfway(from: Rational, to: Rational): Rational {
  const denominator = from.denominator > to.denominator ? from.denominator : to.denominator
  const over = (x: Rational) => x.numerator * (denominator / x.denominator)
  return { numerator: over(from) + over(to), denominator: 2n * denominator }
}
