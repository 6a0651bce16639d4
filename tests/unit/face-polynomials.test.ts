import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { facePolynomials, leastInRow, powerCoefficients, valueAt, vertexInS } from '../../web/core/face-polynomials'
import type { FaceReport, Report } from '../../web/core/report'
import { core, randomHexahedron, randomSource } from './core-fixtures'

/** f(s,t) straight from the nine coefficients. */
function faceValue(bernstein: readonly number[], s: number, t: number): number {
  const along = [0, 1, 2].map(i => valueAt(bernstein.slice(3 * i, 3 * i + 3), t))
  return valueAt(along, s)
}

function randomFaces(): { face: FaceReport; report: Report }[] {
  const random = randomSource(7)
  return Array.from({ length: 12 }, () => core.analyze(randomHexahedron(random, 0.4))).flatMap(result =>
    result.ok ? result.value.faces.map(face => ({ face, report: result.value })) : [],
  )
}

const places = [0, 0.125, 0.3, 0.5, 0.77, 1]

describe('the polynomials of a face', () => {
  it('make up jacdet on it', () => {
    for (const { face } of randomFaces()) {
      const { a, b, c, exponent } = facePolynomials(face.bernstein)
      const greatest = Math.max(...face.bernstein.map(Math.abs))
      for (const s of places) {
        for (const t of places) {
          const value = (valueAt(a, t) * s * s + valueAt(b, t) * s + valueAt(c, t)) * 2 ** exponent
          expect(Math.abs(value - faceValue(face.bernstein, s, t))).toBeLessThan(1e-13 * greatest)
        }
      }
    }
  })

  it('have D = 4ac − b², and s* and a at the core’s roots', () => {
    let roots = 0
    for (const { face } of randomFaces()) {
      const polynomials = facePolynomials(face.bernstein)
      const { a, b, c, d, exponent } = polynomials
      for (const t of places) {
        expect(valueAt(d, t)).toBeCloseTo(4 * valueAt(a, t) * valueAt(c, t) - valueAt(b, t) ** 2, 12)
      }
      for (const { t, a: atRoot, s } of face.roots) {
        roots++
        expect(valueAt(a, t) * 2 ** exponent).toBeCloseTo(atRoot, 10)
        const vertex = vertexInS(polynomials, t)
        if (s === null) expect(atRoot).toBeLessThanOrEqual(0)
        else expect(Math.abs((vertex ?? Number.NaN) - s)).toBeLessThan(1e-9 * Math.max(1, Math.abs(s)))
      }
    }
    expect(roots).toBeGreaterThan(20)
  })

  it('give P as the core has it', () => {
    const slopeOf = (bernstein: readonly number[], t: number) =>
      valueAt(
        bernstein.slice(1).map((value, i) => (bernstein.length - 1) * (value - (bernstein[i] as number))),
        t,
      )
    for (const { face } of randomFaces()) {
      const { a, b, c, exponent } = facePolynomials(face.bernstein)
      for (const t of places) {
        const [at, bt] = [valueAt(a, t), valueAt(b, t)]
        const quartic = 4 * at * at * slopeOf(c, t) - 2 * at * bt * slopeOf(b, t) + slopeOf(a, t) * bt * bt
        const reported = valueAt(face.quartic, t) * 2 ** (face.quarticExponent - 3 * exponent)
        expect(Math.abs(quartic - reported)).toBeLessThan(1e-11)
      }
    }
  })

  it('tell the least place of a row', () => {
    for (const { face } of randomFaces()) {
      const polynomials = facePolynomials(face.bernstein)
      for (const t of places) {
        const least = faceValue(face.bernstein, leastInRow(polynomials, t), t)
        for (let i = 0; i <= 8; i++) {
          expect(least).toBeLessThanOrEqual(faceValue(face.bernstein, i / 8, t) + 1e-12)
        }
      }
    }
  })

  it('stay in range for a face of any size', () => {
    const bernstein = [1, -2, 3, 4, -5, 6, -7, 8, 9]
    const usual = facePolynomials(bernstein)
    for (const power of [-1000, -500, 500, 1000]) {
      const scaled = facePolynomials(bernstein.map(value => value * 2 ** power))
      expect(scaled).toEqual({ ...usual, exponent: usual.exponent + power })
    }
    expect(facePolynomials(Array(9).fill(0)).d).toEqual([0, 0, 0, 0, 0])
  })
})

describe('powers of t', () => {
  it('are the same polynomial', () => {
    const coefficients = fc.array(fc.integer({ min: -1000, max: 1000 }), { minLength: 1, maxLength: 5 })
    fc.assert(
      fc.property(coefficients, fc.integer({ min: 0, max: 16 }), (bernstein, sixteenths) => {
        const t = sixteenths / 16
        const sum = powerCoefficients(bernstein).reduce((total, value, power) => total + value * t ** power, 0)
        expect(sum).toBeCloseTo(valueAt(bernstein, t), 8)
      }),
    )
  })

  it('are small integers where they should be', () => {
    expect(powerCoefficients([1, 1, 1])).toEqual([1, 0, 0])
    expect(powerCoefficients([0, 0, 1])).toEqual([0, 0, 1])
    expect(powerCoefficients([0, 0, 0, 0, 1])).toEqual([0, 0, 0, 0, 1])
  })
})
