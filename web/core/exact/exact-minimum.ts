/**
 * The boundary minimum in integers, its sign exact: docs/algorithm.md 7. The candidates
 * are those of Algorithm 1; their values are exact rationals, on faces at ever finer enclosures of the roots of P.
 */
import { edgeVertices, faces, type Vec3, type Vertices, vertexReference } from '../../model/hexahedron'
import { isLess, magnitude, type Rational } from '../../model/rational'
import type { CandidateKind } from '../report'
import { type ExactJacdet, exactEdge, exactFace, exactJacdet, exactVertex } from './exact-jacdet'
import { exactBoundarySign, faceParabolas, type Sign } from './exact-sign'
import {
  type Dyadic,
  derivative,
  type IsolatedRoot,
  midpoint,
  type Polynomial,
  product,
  refinedTo,
  rootsInUnitInterval,
  signAtRoot,
  squareFree,
  sum,
  valueOver,
} from './integer-polynomial'
import { rounded, unitDouble } from './rounding'

export interface ExactCandidate {
  readonly kind: CandidateKind
  readonly id: number
  /** Reference coordinates to 2^-64. */
  readonly point: Vec3
  /**
   * jacdet there is mantissa * 2^exponent: vertices, edges and the minimum to 2^-52 of themselves, another face candidate
   * as far as shows that it is not the minimum.
   */
  readonly mantissa: number
  readonly exponent: number
}

export interface ExactBoundary {
  readonly sign: Sign
  readonly jacdet: ExactJacdet
  /** Vertices, then edges, then faces. */
  readonly candidates: readonly ExactCandidate[]
  /** The least of them; its mantissa is exactly 0 where the sign is. */
  readonly minimizer: ExactCandidate
  /** jacdet there before it is rounded: in value + [-error, 0], over the power of two of four times the ExactJacdet's. */
  readonly least: { readonly value: Rational; readonly error: Rational }
}

/** `value` and `error` are over four times the power of two of the ExactJacdet; the jacdet is in value + [-error, 0]. */
interface Enclosed {
  readonly kind: CandidateKind
  readonly id: number
  readonly point: Vec3
  readonly value: Rational
  readonly error: Rational
}

/** A root of P at which the parabola's vertex is strictly inside the face. */
interface InnerRoot {
  readonly face: number
  readonly parabolas: ReturnType<typeof faceParabolas>
  readonly quartic: Polynomial
  interval: IsolatedRoot
}

const NONE: Rational = { numerator: 0n, denominator: 1n }

/** Relative error of an enclosure that is fine enough: a rounding to double then adds 2^-53. */
const ENCLOSURE_BITS = 60n

export function exactBoundary(vertices: Vertices): ExactBoundary {
  const jacdet = exactJacdet(vertices)
  const sign = exactBoundarySign(vertices)
  const fixed = [...vertexCandidates(jacdet), ...edgeCandidates(jacdet)]
  const leastFixed = leastOf(fixed).value
  // A face that is nowhere lower than vertices and edges has no candidate.
  const isSkipped = (face: number) =>
    exactFace(jacdet, face).every(numerator => !isLess({ numerator, denominator: 1n }, leastFixed))
  const roots = faces.flatMap((_, face) => (isSkipped(face) ? [] : innerRoots(exactFace(jacdet, face), face)))
  for (let bits = 128; ; bits *= 2) {
    const enclosed = roots.map(root => faceCandidate(root, bits))
    const candidates = [...fixed, ...enclosed.filter(candidate => candidate !== null)]
    const least = leastOf(candidates)
    const isSettled = enclosed.every(candidate => candidate !== null && isFine(candidate, least, jacdet, sign, bits))
    if (!isSettled) continue
    const shown = candidates.map(({ kind, id, point, value, error }) => {
      const touches = sign === 0 && !isLess(error, value)
      return { kind, id, point, ...rounded(touches ? NONE : value, jacdet.exponent - 2) }
    })
    // A touched zero is enclosed from above only, and another value may undercut that.
    const touched = sign === 0 ? shown.find(({ mantissa }) => mantissa === 0) : undefined
    const minimizer = touched ?? (shown[candidates.indexOf(least)] as ExactCandidate)
    const known = touched ? { value: NONE, error: NONE } : least
    return { sign, jacdet, candidates: shown, minimizer, least: known }
  }
}

function leastOf(candidates: readonly Enclosed[]): Enclosed {
  return candidates.reduce((a, b) => (isLess(b.value, a.value) ? b : a))
}

/**
 * True if a candidate cannot be the minimizer, or is known well enough. A touched zero is enclosed
 * from above only; the exact sign says that it is attained.
 */
function isFine(
  { value, error }: Enclosed,
  least: Enclosed,
  { bernstein }: ExactJacdet,
  sign: Sign,
  bits: number,
): boolean {
  const lowest = {
    numerator: value.numerator * error.denominator - error.numerator * value.denominator,
    denominator: value.denominator * error.denominator,
  }
  if (!isLess(lowest, least.value)) return true
  const size =
    sign === 0
      ? { numerator: greatestMagnitude(bernstein), denominator: 1n << BigInt(bits >> 1) }
      : { numerator: magnitude(least.value.numerator), denominator: least.value.denominator << ENCLOSURE_BITS }
  return !isLess(size, error)
}

function greatestMagnitude(values: readonly bigint[]): bigint {
  return values.reduce((a, b) => (magnitude(b) > a ? magnitude(b) : a), 0n)
}

function vertexCandidates(jacdet: ExactJacdet): Enclosed[] {
  return vertexReference.map((point, id) => ({
    kind: 'vertex',
    id,
    point,
    value: { numerator: exactVertex(jacdet, id), denominator: 1n },
    error: NONE,
  }))
}

function edgeCandidates(jacdet: ExactJacdet): Enclosed[] {
  return edgeVertices.flatMap(([from, to], id): Enclosed[] => {
    const [q0, q1, q2] = exactEdge(jacdet, id)
    if (q1 >= q0 || q1 >= q2) return []
    const denominator = q0 - 2n * q1 + q2
    const along = unitDouble({ numerator: q0 - q1, denominator })
    const [start, end] = [vertexReference[from] as Vec3, vertexReference[to] as Vec3]
    const point = start.map((x, axis) => (x === end[axis] ? x : along)) as unknown as Vec3
    return [{ kind: 'edge', id, point, value: { numerator: q0 * q2 - q1 * q1, denominator }, error: NONE }]
  })
}

/** P/4 = a (ac' - 2BB') + a'B^2, docs/algorithm.md (12). */
function quarterQuartic({ a, b, c }: ReturnType<typeof faceParabolas>): Polynomial {
  const g = sum(product(a, derivative(c)), product(b, derivative(b)), -2n)
  return sum(product(a, g), product(derivative(a), product(b, b)))
}

function innerRoots(beta: readonly bigint[], face: number): InnerRoot[] {
  const parabolas = faceParabolas(beta)
  const quartic = squareFree(quarterQuartic(parabolas))
  return rootsInUnitInterval(quartic)
    .filter(root => signAtRoot(parabolas.b, quartic, root) < 0 && signAtRoot(parabolas.n, quartic, root) > 0)
    .map(interval => ({ face, parabolas, quartic, interval }))
}

/**
 * The value at (s*(t), t) for a t within 2^-bits of the root, or null while s* of such a t is not inside. Along s* the value
 * has slope P/(4a^2), and P vanishes at the root, so over a width w it changes by at most w^2 max|P'| / (4 min a^2), (E1).
 */
function faceCandidate(root: InnerRoot, bits: number): Enclosed | null {
  const { a, b, n, d } = root.parabolas
  root.interval = refinedTo(root.quartic, root.interval, bits)
  const { low, high } = root.interval
  const t = low === high ? low : midpoint(low, high)
  const [atB, atN, atA] = [valueOver(b, t, 2), valueOver(n, t, 2), valueOver(a, t, 1)]
  const leastA = [valueOver(a, low, 1) << BigInt(high.shift), valueOver(a, high, 1) << BigInt(low.shift)]
  if (atB >= 0n || atN <= 0n || leastA.some(value => value <= 0n)) return null
  const shift = BigInt(t.shift)
  const s = unitDouble({ numerator: -atB, denominator: atA << shift })
  const value = { numerator: valueOver(d, t, 4), denominator: atA << (3n * shift) }
  return { kind: 'face', id: root.face, point: liftedPoint(root.face, s, t), value, error: errorOver(root, leastA) }
}

function errorOver({ parabolas, interval: { low, high } }: InnerRoot, leastA: readonly bigint[]): Rational {
  if (low === high) return NONE
  const slope = derivative(quarterQuartic(parabolas)).reduce((all, coefficient) => all + magnitude(coefficient), 0n)
  const width = (high.numerator << BigInt(low.shift)) - (low.numerator << BigInt(high.shift))
  const least = leastA.reduce((x, y) => (y < x ? y : x))
  // width and a are over 2^(low.shift + high.shift), and so they cancel.
  return { numerator: width * width * slope, denominator: least * least }
}

function liftedPoint(face: number, s: number, t: Dyadic): Vec3 {
  const topology = faces[face] as (typeof faces)[number]
  const point: [number, number, number] = [topology.side, topology.side, topology.side]
  point[topology.s] = s
  point[topology.t] = unitDouble({ numerator: t.numerator, denominator: 1n << BigInt(t.shift) })
  return point
}
