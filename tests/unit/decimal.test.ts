import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  asDouble,
  decimalOf,
  formatJacdet,
  formatNumber,
  formatPoint,
  fractionOf,
  speakJacdet,
  speakNumber,
} from '../../web/model/decimal'

const finite = fc.double({ noDefaultInfinity: true, noNaN: true })
const moderate = fc.double({ min: 2 ** -500, max: 2 ** 500, noNaN: true })

describe('decimalOf', () => {
  it('is the engine’s own correctly rounded decimal where the value is a double', () => {
    fc.assert(
      fc.property(finite, fc.integer({ min: 1, max: 30 }), (value, digits) => {
        const expected = value === 0 ? '0' : value.toExponential(digits - 1)
        expect(decimalOf(value, 0, digits)).toBe(expected)
      }),
      {
        seed: 1,
        numRuns: 3000,
        examples: [
          [5e-324, 17],
          [Number.MAX_VALUE, 17],
        ],
      },
    )
  })

  it('does not care where the powers of two stand', () => {
    fc.assert(
      fc.property(moderate, fc.integer({ min: -500, max: 500 }), (value, exponent) => {
        expect(decimalOf(value * 2 ** exponent, -exponent, 17)).toBe(decimalOf(value, 0, 17))
      }),
      { seed: 2 },
    )
  })

  it('goes far outside the doubles', () => {
    expect(decimalOf(1, 10000, 17)).toBe('1.9950631168807584e+3010')
    expect(decimalOf(-1, -10000, 17)).toBe('-5.0123727492064520e-3011')
    expect(decimalOf(0, 5000, 17)).toBe('0')
    expect(() => decimalOf(Number.NaN, 0, 17)).toThrow(RangeError)
  })
})

describe('asDouble', () => {
  it('is the double that the value is, and null when it is none', () => {
    fc.assert(
      fc.property(moderate, fc.integer({ min: -500, max: 500 }), (value, exponent) => {
        expect(asDouble(value, exponent)).toBe(value * 2 ** exponent)
      }),
      { seed: 3 },
    )
    expect(asDouble(1, -1074)).toBe(5e-324)
    expect(asDouble(1, -1075)).toBeNull()
    expect(asDouble(1.5, -1074)).toBeNull()
    expect(asDouble(1.5, -1073)).toBe(3 * 5e-324)
    expect(asDouble(-1, 1023)).toBe(-(2 ** 1023))
    expect(asDouble(1, 1024)).toBeNull()
    expect(asDouble(5e-324, 2097)).toBe(2 ** 1023)
    expect(asDouble(0, 9999)).toBe(0)
  })
})

describe('numbers to be read', () => {
  it('have a true minus sign, no trailing zeros and no minus zero', () => {
    expect([0, -0, 1.25, -0.0208333333, 12345678, 0.1 + 0.2].map(formatNumber)).toEqual([
      '0',
      '0',
      '1.25',
      '−0.020833',
      '12345678',
      '0.3',
    ])
    expect([3.88e-12, -1e21, 5e-324].map(formatNumber)).toEqual(['3.88×10⁻¹²', '−1×10²¹', '4.9407×10⁻³²⁴'])
  })

  it('are spoken in plain ASCII', () => {
    expect([-0.03, 3.88e-12, -1e21].map(speakNumber)).toEqual(['-0.03', '3.88e-12', '-1e21'])
    expect(speakJacdet(-0.5, 0, 'biunit')).toBe('-0.0625')
  })

  it('stay within half a unit of their last digit', () => {
    fc.assert(
      fc.property(fc.double({ min: -1e300, max: 1e300, noNaN: true }), value => {
        const read = Number(speakNumber(value))
        expect(Math.abs(read - value)).toBeLessThanOrEqual(Math.abs(value) * 0.5001e-4 + Number.MIN_VALUE)
      }),
      { seed: 4, numRuns: 2000 },
    )
  })
})

describe('fractions', () => {
  it('are for small powers of two and small numerators, exactly', () => {
    expect([-0.0625, 0.5, 33 / 64, 1.5, 3, 1 / 128, 0.1, 1000.5].map(fractionOf)).toEqual([
      '−1/16',
      '1/2',
      '33/64',
      '3/2',
      null,
      null,
      null,
      null,
    ])
    expect(fractionOf(0.0625 + 2 ** -56)).toBeNull()
  })

  it('serve jacdets and points', () => {
    expect(formatJacdet(-0.0625, 0, 'unit')).toBe('−1/16')
    expect(formatJacdet(-0.5, 0, 'biunit')).toBe('−1/16')
    expect(formatJacdet(0.75, 1000, 'unit')).toBe('8.0363×10³⁰⁰')
    expect(formatPoint([0.5, 0, 0.41999])).toBe('(1/2, 0, 0.41999)')
  })
})
