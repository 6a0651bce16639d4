import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { formatNumber, fractionOf } from '../../web/model/decimal'
import { numberText, readNumber } from '../../web/model/number-text'
import { nearestDouble, type Rational, scaledDouble } from '../../web/model/rational'

const finite = fc.double({ noDefaultInfinity: true, noNaN: true })
const fraction = fc.tuple(fc.bigInt({ min: 0n, max: 10n ** 40n }), fc.bigInt({ min: 1n, max: 10n ** 40n }))

function numberOf(text: string): number {
  const read = readNumber(text)
  if (!read.ok) throw new Error(`${text}: ${read.error.message}`)
  return read.value
}

function refusalOf(text: string, limits = {}): string {
  const read = readNumber(text, limits)
  if (read.ok) throw new Error(`${text} is read as ${read.value}.`)
  return `${read.error.code}: ${read.error.message}`
}

describe('a number in a field', () => {
  it.each([
    ['1/3', 1 / 3],
    [' -1/8 ', -0.125],
    ['−1/8', -0.125],
    ['–2', -2],
    ['- 2', -2],
    ['+7', 7],
    ['1 / 3', 1 / 3],
    ['2⁄3', 2 / 3],
    ['1 1/2', 1.5],
    ['−1 1/2', -1.5],
    ['0.1/0.3', 1 / 3],
    ['½', 0.5],
    ['⅓', 1 / 3],
    ['-¼', -0.25],
    ['1¾', 1.75],
    ['1 ⅞', 1.875],
    ['.5', 0.5],
    ['5.', 5],
    ['007', 7],
    ['1e-3', 0.001],
    ['1E+3', 1000],
    ['2e−3', 0.002],
    ['3.88×10⁻¹²', 3.88e-12],
    ['3.88 × 10¹²', 3.88e12],
    ['0,5', 0.5],
    [',5', 0.5],
    ['-0,125', -0.125],
    ['0,125', 0.125],
    ['1,5', 1.5],
    ['1,25', 1.25],
    ['1,2345', 1.2345],
    ['1234,567', 1234.567],
    ['1,5/2', 0.75],
    ['1.234', 1.234],
    ['5e-324', 5e-324],
    ['1.7976931348623157e308', Number.MAX_VALUE],
    // Half way between two doubles, and just above it.
    ['9007199254740993', 9007199254740992],
    ['9007199254740993.00000000000000000001', 9007199254740994],
    ['-0', -0],
    ['0/5', 0],
  ] as const)('“%s” is %d', (text, value) => {
    expect(numberOf(text)).toBe(value)
  })

  it.each([
    ['', 'missing: A number is missing.'],
    ['  ', 'missing: A number is missing.'],
    ['1/', 'not-a-number: “1/” is not one number, such as −1.5, 1/3 or 2e-3.'],
    ['1/0', 'not-a-number: “1/0” divides by zero.'],
    ['1,234', 'ambiguous: “1,234” can mean 1.234 or 1234: write one of them.'],
    ['-12,345', 'ambiguous: “-12,345” can mean -12.345 or -12345: write one of them.'],
    ['1e999', 'out-of-range: “1e999” is outside the doubles, which are from 5e-324 to 1.8e308.'],
    ['1e-400', 'out-of-range: “1e-400” is outside the doubles, which are from 5e-324 to 1.8e308.'],
    ['1e99999999999', 'out-of-range: “1e99999999999” is outside the doubles, which are from 5e-324 to 1.8e308.'],
  ] as const)('“%s” is refused in a sentence', (text, sentence) => {
    expect(refusalOf(text)).toBe(sentence)
  })

  it.each(
    '1e|-|1/2/3|1/-2|1.234,5|1,234.5|1,234,567|1 000|1 2|1.5 1/2|10²|2²|NaN|Infinity|∞|0x10|1_000|three|1px|12%|1;2|--1|[1]|1..2|1,,2|e5|½½|½3|1½/2|٣'.split(
      '|',
    ),
  )('“%s” is refused, and never another number', text => {
    expect(refusalOf(text)).toMatch(/^not-a-number/)
  })

  it('quotes the beginning of a long text', () => {
    expect(refusalOf('[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]')).toContain('“[[0,0,0],[1,0,0],[1,1,0]…” is not one number')
    expect(refusalOf('9'.repeat(6000))).toMatch(/^not-a-number/)
  })

  it('is within the limits of its field, which a sentence says', () => {
    const height = { least: 160, most: 4000, isWhole: true } as const
    expect(readNumber('480', height)).toEqual({ ok: true, value: 480 })
    expect(readNumber('960/2', height)).toEqual({ ok: true, value: 480 })
    for (const text of ['159', '4001', '480.5', '1/3', '-480'])
      expect(refusalOf(text, height)).toBe(`out-of-range: “${text}” is not a whole number from 160 to 4000.`)
    expect(refusalOf('-1', { least: 0 })).toBe('out-of-range: “-1” is not a number of 0 or more.')
  })

  it('of any double, written in any usual way, is that double', () => {
    fc.assert(
      fc.property(finite, fc.constantFrom('-', '−', '–'), fc.boolean(), (value, minus, hasComma) => {
        const point = (text: string) =>
          hasComma && !/^-?[1-9]\d{0,2}\.\d{3}(?!\d)/.test(text) ? text.replace('.', ',') : text
        for (const text of [numberText(value), value.toExponential(), value.toPrecision(17)])
          expect(numberOf(point(text).replace(/^-/, minus))).toBe(Object.is(value, -0) && text !== '-0' ? 0 : value)
      }),
      { seed: 1, numRuns: 2000 },
    )
  })

  it('that the page prints is read back: fractions exactly, decimals as they are rounded', () => {
    fc.assert(
      fc.property(fc.integer({ min: -999, max: 999 }), fc.constantFrom(2, 4, 8, 16, 32, 64), finite, (p, q, value) => {
        expect(numberOf(fractionOf(p / q) ?? String(p / q))).toBe(p / q)
        const printed = formatNumber(value)
        if (Math.abs(value) > 1e-300 && Math.abs(value) < 1e308)
          expect(Math.abs(numberOf(printed) - value)).toBeLessThanOrEqual(5.1e-5 * Math.abs(value))
      }),
      { seed: 2, numRuns: 2000 },
    )
  })

  it('is the nearest double of a fraction: no other is nearer, and of two the even one', () => {
    const distance = (a: Rational, b: Rational) => {
      const difference = a.numerator * b.denominator - b.numerator * a.denominator
      return difference < 0n ? -difference : difference // over the same denominators
    }
    const bits = new DataView(new ArrayBuffer(8))
    const neighbours = (value: number) => {
      bits.setFloat64(0, value)
      const own = bits.getBigUint64(0)
      return [own - 1n, own + 1n]
        .filter(other => other >= 0n)
        .map(other => {
          bits.setBigUint64(0, other)
          return bits.getFloat64(0)
        })
        .filter(Number.isFinite)
    }
    const isEven = (value: number) => {
      bits.setFloat64(0, value)
      return (bits.getBigUint64(0) & 1n) === 0n
    }
    fc.assert(
      fc.property(fraction, fc.integer({ min: -1120, max: 900 }), ([p, q], power) => {
        const exact = {
          numerator: power > 0 ? p << BigInt(power) : p,
          denominator: power > 0 ? q : q << BigInt(-power),
        }
        const value = nearestDouble(exact)
        if (value === Number.POSITIVE_INFINITY) return
        const own = scaledDouble(value, 0)
        for (const other of neighbours(value)) {
          const rational = scaledDouble(other, 0)
          const [near, far] = [distance(own, exact) * rational.denominator, distance(rational, exact) * own.denominator]
          expect(near < far || (near === far && isEven(value))).toBe(true)
        }
      }),
      {
        seed: 3,
        numRuns: 2000,
        examples: [
          [[3n, 1n], -1075],
          [[1n, 1n], -1075],
          [[(1n << 54n) + 1n, 1n], 0],
        ],
      },
    )
  })
})
