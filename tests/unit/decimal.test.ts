import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  asDouble,
  decimalOf,
  formatBound,
  formatJacdet,
  formatNumber,
  formatPoint,
  fractionOf,
  jacdetInFull,
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

  it('round ties to even, and what is only next to a tie to where it is', () => {
    expect([12345.5, 12344.5, -12344.5, 0.5].map(formatNumber)).toEqual(['12346', '12344', '−12344', '0.5'])
    expect(formatNumber(12344.500000000002)).toBe('12345')
    expect(formatNumber(12345.499999999998)).toBe('12345')
    expect(decimalOf(2.5, 0, 1)).toBe('2e+0')
    expect(decimalOf(2.5000000000000004, 0, 1)).toBe('3e+0')
    expect(decimalOf(5, -1074, 1)).toBe('2e-323')
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

describe('bounds', () => {
  it('have two digits, rounded up, on the cube and in the units of the number they belong to', () => {
    expect([1.7448542610765116e-13, 1.5e-13, 0.0123, 9.91e-13, 5e-324].map(x => formatBound(x, 0, 'unit'))).toEqual([
      '1.8×10⁻¹³',
      '1.5×10⁻¹³',
      '0.013',
      '1×10⁻¹²',
      '5×10⁻³²⁴',
    ])
    expect(formatBound(8e-13, 0, 'biunit')).toBe('1.1×10⁻¹³')
    expect(formatBound(1, 2000, 'unit')).toBe('1.2×10⁶⁰²')
  })

  it('are never below what they bound, and hardly above it', () => {
    fc.assert(
      fc.property(fc.double({ min: 1e-300, max: 1e7, noNaN: true }), value => {
        const shown = Number(plain(formatBound(value, 0, 'unit')))
        expect(shown).toBeGreaterThanOrEqual(value)
        expect(shown).toBeLessThanOrEqual(value * 1.1001)
      }),
      { seed: 5, numRuns: 2000 },
    )
  })

  it('and a number rounded to a side is never beyond it', () => {
    fc.assert(
      fc.property(fc.double({ min: -1e300, max: 1e300, noNaN: true }), value => {
        const [down, up] = (['down', 'up'] as const).map(side =>
          Number(plain(formatJacdet(value + 1e-9, 0, 'unit', side))),
        ) as [number, number]
        expect(down).toBeLessThanOrEqual(value + 1e-9)
        expect(up).toBeGreaterThanOrEqual(value + 1e-9)
        expect(up - down).toBeLessThanOrEqual(1.1e-4 * Math.abs(value + 1e-9))
      }),
      { seed: 6, numRuns: 2000 },
    )
    expect(formatJacdet(-0.010653409, 0, 'unit', 'up')).toBe('−0.010653')
    expect(formatJacdet(-0.010653409, 0, 'unit', 'down')).toBe('−0.010654')
    expect(formatJacdet(0.9999999999, 0, 'unit', 'down')).toBe('0.99999')
    expect(formatJacdet(-0.25, 0, 'unit', 'up')).toBe('−1/4')
  })
})

describe('jacdetInFull', () => {
  it('is the double itself on either cube, and a decimal where there is none', () => {
    expect(jacdetInFull(-0.1, 0, 'unit')).toBe('-0.1')
    expect(jacdetInFull(-0.1, 0, 'biunit')).toBe('-0.0125')
    expect(jacdetInFull(1.5, 2000, 'unit')).toBe(decimalOf(1.5, 2000, 17))
  })
})

/** The text as JavaScript reads it. */
function plain(text: string): string {
  const [mantissa, power] = text.split('×10')
  const digits = [...(power ?? '')].map(digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(digit)).map(digit => (digit < 0 ? '-' : digit))
  const decimal = mantissa?.includes('/')
    ? String(Number(mantissa.split('/')[0]?.replace('−', '-')) / Number(mantissa.split('/')[1]))
    : mantissa?.replace('−', '-')
  return power === undefined ? (decimal as string) : `${decimal}e${digits.join('')}`
}
