import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { decodePermalink, encodePermalink } from '../../web/model/permalink'
import { unitCube } from './core-fixtures'

const AWKWARD = [0.1 + 0.2, 5e-324, -0, Number.MAX_VALUE, -Number.MIN_VALUE, 1e21, 1e-7, 123456789012345680000, 1 / 3]

function sameBits(a: readonly number[], b: readonly number[]): boolean {
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]))
}

describe('a link', () => {
  it('is readable', () => {
    expect(encodePermalink(unitCube)).toBe('v=1&vertices=0,0,0,1,0,0,1,1,0,0,1,0,0,0,1,1,0,1,1,1,1,0,1,1')
  })

  it('holds any 24 finite doubles bit for bit, with and without its #, percent-encoded or not', () => {
    const anyDouble = fc.oneof(fc.double({ noDefaultInfinity: true, noNaN: true }), fc.constantFrom(...AWKWARD))
    fc.assert(
      fc.property(fc.array(anyDouble, { minLength: 24, maxLength: 24 }), vertices => {
        const link = encodePermalink(vertices)
        expect(link).toMatch(/^[-\w=&.,]+$/)
        for (const text of [link, `#${link}`, `#${encodeURIComponent(link)}`]) {
          const result = decodePermalink(text)
          expect(result.ok && sameBits(result.value, vertices)).toBe(true)
        }
      }),
      { seed: 20260606, numRuns: 2000 },
    )
  })

  it('is not made of anything else', () => {
    expect(() => encodePermalink(unitCube.slice(1))).toThrow(RangeError)
    expect(() => encodePermalink(unitCube.with(3, Number.NaN))).toThrow(RangeError)
  })
})

describe('a broken link gets a sentence', () => {
  const numbers = unitCube.join(',')
  const broken: [string, string, RegExp][] = [
    ['', 'absent', /no element/],
    ['#', 'absent', /no element/],
    ['#section', 'malformed', /should read/],
    [`vertices=${numbers}`, 'malformed', /should read/],
    ['v=1', 'malformed', /should read/],
    [`v=1&vertices=${numbers}&vertices=${numbers}`, 'malformed', /should read/],
    [`v=1&vertices=${numbers}&more=1`, 'malformed', /should read/],
    ['v=1&vertices=%E0%A4%A', 'malformed', /should read/],
    [`v=2&vertices=${numbers}`, 'unknown-version', /version “2”/],
    ['v=1&vertices=', 'wrong-count', /0 numbers where 24/],
    [`v=1&vertices=${numbers.slice(2)}`, 'wrong-count', /23 numbers where 24/],
    [`v=1&vertices=${numbers},5`, 'wrong-count', /25 numbers where 24/],
    [`v=1&vertices=x${numbers}`, 'not-a-number', /Number 1 of the link, “x0”/],
    [`v=1&vertices=${numbers.slice(0, -1)}`, 'not-a-number', /Number 24 of the link, “”/],
    [`v=1&vertices=0x1${numbers.slice(1)}`, 'not-a-number', /“0x1”/],
    [`v=1&vertices=Infinity${numbers.slice(1)}`, 'not-a-number', /“Infinity”/],
    [`v=1&vertices=1e999${numbers.slice(1)}`, 'not-finite', /“1e999”, is too large/],
  ]
  for (const [fragment, code, message] of broken)
    it(`${code}: ${fragment.slice(0, 40)}`, () => {
      const result = decodePermalink(fragment)
      expect(result).toMatchObject({ ok: false, error: { code } })
      if (!result.ok) expect(result.error.message).toMatch(message)
    })

  it('and no text at all makes it throw', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), text => {
        decodePermalink(text)
        decodePermalink(`v=1&vertices=${text}`)
      }),
      { seed: 20260607 },
    )
  })
})
