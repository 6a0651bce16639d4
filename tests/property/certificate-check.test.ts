/** The checker of certificates accepts what is right and refuses what is not; the certificates here are made by hand. */
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { type Certificate, type CertifiedInterval, certify } from '../../web/core/exact/certificate'
import type { Vertices } from '../../web/model/hexahedron'
import type { Rational } from '../../web/model/rational'
import { caseVertices, unitCube } from '../unit/core-fixtures'
import { borderCrossing } from './border'
import { flawOf } from './certificate-check'
import { replayed } from './replay'

const over = (numerator: number, denominator = 1): Rational => ({
  numerator: BigInt(numerator),
  denominator: BigInt(denominator),
})
const [ZERO, HALF, ONE] = [over(0), over(1, 2), over(1)]
const interval = (from: Rational, to: Rational, by: CertifiedInterval['by']): CertifiedInterval => ({ from, to, by })

/** One list of intervals for all faces, but another for one of them. */
function valid(common: readonly CertifiedInterval[], face = 0, own = common): Certificate {
  return { valid: true, faces: [0, 1, 2, 3, 4, 5].map(f => (f === face ? own : common)) }
}

const ALL = [interval(ZERO, ONE, 'middle')]
const mirrored = unitCube.map((x, i) => (i % 3 === 0 ? -x : x))

describe('the checker accepts', () => {
  const halves = [interval(ZERO, HALF, 'b'), interval(HALF, ONE, '2a+b')]
  const overlapping = [interval(ZERO, over(3, 4), 'middle'), interval(HALF, ONE, 'middle')]
  for (const [name, intervals] of Object.entries({ 'one interval': ALL, 'two intervals': halves, overlapping }))
    it(`the cube by ${name}`, () => expect(flawOf(valid(ALL, 3, intervals), unitCube)).toBeNull())

  it('the mirrored cube by a point', () => {
    const certificate: Certificate = { valid: false, point: [HALF, over(1, 3), ONE], jacdet: over(-1) }
    expect(flawOf(certificate, mirrored)).toBeNull()
  })

  it('units far from 1', () => {
    const small = mirrored.map(x => x * 2 ** -20)
    const jacdet = { numerator: -1n, denominator: 1n << 60n }
    expect(flawOf({ valid: false, point: [ZERO, ZERO, ZERO], jacdet }, small)).toBeNull()
    const large = mirrored.map(x => x * 2 ** 20)
    expect(
      flawOf({ valid: false, point: [ZERO, ZERO, ZERO], jacdet: { ...over(-1), numerator: -(1n << 60n) } }, large),
    ).toBeNull()
  })
})

describe('the checker refuses', () => {
  const refused: Readonly<Record<string, readonly CertifiedInterval[]>> = {
    'no interval': [],
    'an end before 1': [interval(ZERO, HALF, 'b')],
    'a start after 0': [interval(HALF, ONE, 'b')],
    'a gap': [interval(ZERO, over(1, 4), 'b'), interval(HALF, ONE, 'b')],
    'an interval turned round': [interval(ZERO, ONE, 'b'), interval(ONE, ZERO, 'b')],
    'an interval beyond 1': [interval(ZERO, over(2), 'b')],
    'a denominator below 0': [interval({ numerator: 0n, denominator: -1n }, ONE, 'b')],
    // The cube has a = b = 0.
    'a condition that does not hold': [interval(ZERO, ONE, 'D')],
    'a condition that does not exist': [interval(ZERO, ONE, 'convex' as 'D')],
  }
  for (const [name, intervals] of Object.entries(refused))
    it(name, () => expect(flawOf(valid(ALL, 4, intervals), unitCube)).toMatch(/^face 4: /))

  it('five faces', () => {
    expect(flawOf({ valid: true, faces: [ALL, ALL, ALL, ALL, ALL] }, unitCube)).not.toBeNull()
  })

  it('points that prove nothing', () => {
    const point = (...at: readonly [Rational, Rational, Rational]) =>
      ({ valid: false, point: at, jacdet: ONE }) as const
    expect(flawOf(point(ZERO, ZERO, ZERO), unitCube)).toMatch(/positive/)
    expect(flawOf(point(over(2), ZERO, ZERO), mirrored)).toMatch(/cube/)
    expect(flawOf(point(over(-1, 2), ZERO, ZERO), mirrored)).toMatch(/cube/)
    expect(flawOf(point(ZERO, ZERO, ZERO), mirrored)).toMatch(/another number/)
  })

  it('every condition on a face that dips below zero between positive edges', () => {
    const dipping = caseVertices('pub/touch_face/0_minus_ulp')
    for (const by of ['b', '2a+b', 'D', 'middle'] as const)
      for (const pieces of [1, 8])
        expect(flawOf(valid(inPieces(pieces, by)), dipping), `${by} in ${pieces}`).not.toBeNull()
  })

  it('the certificate of a neighbour on the other side of the border', () => {
    fc.assert(
      fc.property(borderCrossing('all', 'vertex', 'coordinate'), ({ valid, invalid }) => {
        const flaw = (of: Vertices, given: Vertices) => flawOf(certify(of), given)
        expect([flaw(valid, valid), flaw(invalid, invalid)]).toEqual([null, null])
        expect([flaw(valid, invalid), flaw(invalid, valid)]).not.toContain(null)
      }),
      replayed(300),
    )
  })
})

function inPieces(count: number, by: CertifiedInterval['by']): CertifiedInterval[] {
  return Array.from({ length: count }, (_, n) => interval(over(n, count), over(n + 1, count), by))
}
