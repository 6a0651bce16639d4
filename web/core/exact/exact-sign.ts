/**
 * The sign of the boundary minimum, exactly: docs/algorithm.md 7. No tolerance and no depth: Sturm's theorem decides, and
 * every loop ends because distinct real numbers separate.
 */
import { edgeVertices, faces, type Vertices, vertexReference } from '../../model/hexahedron'
import { type ExactJacdet, exactEdge, exactFace, exactJacdet, exactVertex } from './exact-jacdet'
import {
  isNegativeBeside,
  type Polynomial,
  pointsBetween,
  polynomial,
  product,
  rootsInUnitInterval,
  signAt,
  signAtRoot,
  signOf,
  squareFree,
  sum,
} from './integer-polynomial'

export type Sign = -1 | 0 | 1

/** -1, 0 or 1: some jacdet on the boundary is negative; none is, but one is zero; all are positive (the element is valid). */
export function exactBoundarySign(vertices: Vertices): Sign {
  const jacdet = exactJacdet(vertices)
  const signs: (() => Sign)[] = [
    ...vertexReference.map((_, v) => () => signOf(exactVertex(jacdet, v))),
    ...edgeVertices.map((_, e) => () => edgeSign(jacdet, e)),
    ...faces.map((_, f) => () => faceSign(exactFace(jacdet, f))),
  ]
  let least: Sign = 1
  for (const signAt of signs) {
    const sign = signAt()
    if (sign < 0) return -1
    if (sign < least) least = sign
  }
  return least
}

/** The sign of the least value strictly inside an edge whose ends are not negative; 1 where the ends are lower. */
function edgeSign(jacdet: ExactJacdet, edge: number): Sign {
  const [q0, q1, q2] = exactEdge(jacdet, edge)
  return q1 < 0n ? signOf(q0 * q2 - q1 * q1) : 1
}

/** The polynomial in t with Bernstein coefficients q0, q1, q2. */
function fromBernstein(q0: bigint, q1: bigint, q2: bigint): Polynomial {
  return polynomial(q0, 2n * (q1 - q0), q0 - 2n * q1 + q2)
}

/** The face's parabolas in s, as polynomials in t: f = a s^2 + 2B s + c with N = a + B, and d = ac - B^2 = D/4. */
export function faceParabolas(beta: readonly bigint[]) {
  const row = (i: number) => beta.slice(3 * i, 3 * i + 3) as [bigint, bigint, bigint]
  const difference = (i: number) =>
    row(i + 1).map((value, j) => value - (row(i)[j] as bigint)) as [bigint, bigint, bigint]
  const b = fromBernstein(...difference(0))
  const n = fromBernstein(...difference(1))
  const c = fromBernstein(...row(0))
  const a = sum(n, b, -1n)
  return { a, b, n, c, d: sum(product(a, c), product(b, b), -1n) }
}

/**
 * The sign of the least value strictly inside a face whose edges are not negative; 1 where the edges are lower or equal.
 * A value below both ends of its parabola lies at the parabola's vertex, inside where B < 0 < N, and is d/a there. So the
 * set {B < 0 < N} is searched for d < 0 and d = 0: at one point of each of its intervals, and at the roots of d in it.
 */
function faceSign(beta: readonly bigint[]): Sign {
  if (beta.every(coefficient => coefficient > 0n)) return 1
  const { b, n, d } = faceParabolas(beta)
  const ends = squareFree(product(b, n))
  if (ends.length === 0) return 1
  let least: Sign = 1
  for (const point of pointsBetween(ends, rootsInUnitInterval(ends)))
    if (signAt(b, point) < 0 && signAt(n, point) > 0) least = Math.min(least, signAt(d, point)) as Sign
  if (least < 0) return -1
  const simple = squareFree(d)
  for (const root of rootsInUnitInterval(simple)) {
    if (signAtRoot(b, simple, root) >= 0 || signAtRoot(n, simple, root) <= 0) continue
    if (isNegativeBeside(d, root)) return -1
    least = 0
  }
  return least
}
