/**
 * Checks verdict certificates with the exact arithmetic of integer-jacdet.ts: nothing of web/core/exact but its types. A
 * certificate is an argument with nothing left to find, so this is a list of signs.
 */
import type { Certificate } from '../../web/core/exact/certificate'
import type { Vertices } from '../../web/model/hexahedron'
import type { Rational } from '../../web/model/rational'
import {
  endsArePositive,
  type FaceParabolas,
  faceParabolas,
  type IntegerHexahedron,
  integerHexahedron,
  isPositiveBy,
  jacdetAt,
  jacdetAtHalves,
  restricted,
} from './integer-jacdet'

type Point = readonly [Rational, Rational, Rational]
type Interval = Extract<Certificate, { valid: true }>['faces'][number][number]

/** The flaw of the certificate; null if the hexahedron is as valid as the certificate says. */
export function flawOf(certificate: Certificate, vertices: Vertices): string | null {
  const hex = integerHexahedron(vertices)
  if (!certificate.valid) return flawOfPoint(hex, certificate.point, certificate.jacdet)
  if (certificate.faces.length !== 6) return `there are ${certificate.faces.length} faces`
  const atHalves = jacdetAtHalves(hex)
  for (const [face, intervals] of certificate.faces.entries()) {
    const flaw = flawOfFace(faceParabolas(atHalves, face), intervals)
    if (flaw) return `face ${face}: ${flaw}`
  }
  return null
}

function flawOfPoint(hex: IntegerHexahedron, point: Point, jacdet: Rational): string | null {
  if (point.some(x => x.denominator <= 0n || x.numerator < 0n || x.numerator > x.denominator))
    return 'the point is not in the cube'
  const numerator = jacdetAt(
    hex,
    point.map(x => [x.numerator, x.denominator]),
  )
  if (numerator > 0n) return 'jacdet is positive at the point'
  const product = point.reduce((all, { denominator }) => all * denominator, 1n)
  const power = BigInt(Math.abs(hex.exponent))
  const exact = hex.exponent < 0 ? [numerator, (product * product) << power] : [numerator << power, product * product]
  const isSame =
    jacdet.denominator > 0n && (exact[0] as bigint) * jacdet.denominator === jacdet.numerator * (exact[1] as bigint)
  return isSame ? null : 'jacdet at the point is another number'
}

function flawOfFace(face: FaceParabolas, intervals: readonly Interval[]): string | null {
  let reached: Rational = { numerator: 0n, denominator: 1n }
  for (const [n, { from, to, by }] of intervals.entries()) {
    if (from.denominator <= 0n || to.denominator <= 0n) return `interval ${n}: a denominator is not positive`
    if (!isAtMost(from, reached)) return `interval ${n}: it leaves a gap before it`
    if (from.numerator < 0n || to.numerator > to.denominator || isAtMost(to, from))
      return `interval ${n}: it is not an interval of [0,1]`
    const piece = onInterval(face, from, to)
    if (!endsArePositive(piece)) return `interval ${n}: an edge is not positive by its coefficients`
    if (!isPositiveBy[by]?.(piece)) return `interval ${n}: ${by} does not hold`
    reached = to
  }
  return reached.numerator === reached.denominator ? null : 'the intervals end before 1'
}

function isAtMost(x: Rational, y: Rational): boolean {
  return x.numerator * y.denominator <= y.numerator * x.denominator
}

function onInterval(face: FaceParabolas, from: Rational, to: Rational): FaceParabolas {
  if (from.numerator === 0n && to.numerator === to.denominator) return face
  if (from.denominator === to.denominator) return restricted(face, from.numerator, to.numerator, to.denominator)
  const [low, high] = [from.numerator * to.denominator, to.numerator * from.denominator]
  return restricted(face, low, high, from.denominator * to.denominator)
}
