/** Bounds of the share of elements with a property, against sums of exact fractions. */
import { describe, expect, it } from 'vitest'
import { shareBounds, shareInWords } from '../../web/pages/search/share'

/** The probability of at most k among n at p = m/2^48: BigInt numerator, over 2^(48 n). */
function isAtMostLikely(k: number, n: number, p: number, limit: readonly [bigint, bigint]): boolean {
  const one = 2n ** 48n
  const m = BigInt(Math.round(p * 2 ** 48))
  let [sum, choices] = [0n, 1n]
  for (let i = 0; i <= k; ++i) {
    sum += choices * m ** BigInt(i) * (one - m) ** BigInt(n - i)
    choices = (choices * BigInt(n - i)) / BigInt(i + 1)
  }
  return sum * limit[1] <= limit[0] * one ** BigInt(n)
}

describe('the share of a distribution', () => {
  it('is by the rule of three where none was found', () => {
    for (const drawn of [1, 2, 10, 1024, 3_000_000, 1e12]) {
      const { least, greatest } = shareBounds(0, drawn)
      expect(least).toBe(0)
      expect(Math.abs((1 - greatest) ** drawn - 0.05)).toBeLessThan(drawn < 1e6 ? 1e-9 : 1e-3)
      expect(greatest).toBeLessThan(-Math.log(0.05) / drawn)
      expect(greatest * drawn).toBeGreaterThan(drawn === 1 ? 0.9 : 1.5)
    }
    expect(shareBounds(0, 1).greatest).toBeCloseTo(0.95, 14)
    expect(shareBounds(0, 3_000_000).greatest * 1e6).toBeCloseTo(0.998577, 6)
  })

  it('has a probability of 2.5 % beyond either bound, exactly', () => {
    const tail: readonly [bigint, bigint] = [25n, 1000n]
    for (const [found, drawn] of [
      [1, 2],
      [1, 10],
      [9, 10],
      [3, 200],
      [15, 300],
      [40, 300],
      [290, 300],
    ] as const) {
      const { least, greatest } = shareBounds(found, drawn)
      const name = `${found} of ${drawn}`
      expect(isAtMostLikely(found, drawn, greatest * (1 + 1e-9), tail), name).toBe(true)
      expect(isAtMostLikely(found, drawn, greatest * (1 - 1e-9), tail), name).toBe(false)
      // At least `found` with the property are at most the rest without it.
      const rest = 1 - least
      expect(isAtMostLikely(drawn - found, drawn, rest + least * 1e-9, tail), name).toBe(true)
      expect(isAtMostLikely(drawn - found, drawn, rest - least * 1e-9, tail), name).toBe(false)
    }
  })

  it('is near the normal bounds for many', () => {
    for (const [found, drawn] of [
      [19_506, 1_948_672],
      [5e7, 1e8],
      [1e6, 1e10],
    ] as const) {
      const share = found / drawn
      const deviation = Math.sqrt((share * (1 - share)) / drawn)
      const { least, greatest } = shareBounds(found, drawn)
      expect((greatest - share) / deviation).toBeCloseTo(1.96, 1)
      expect((share - least) / deviation).toBeCloseTo(1.96, 1)
    }
  })

  it('is said so that a rounded bound stays a bound', () => {
    const confidence = 'with 95 % confidence'
    expect(shareInWords(0, 3_000_000)).toBe(
      `At most 1 in 1,000,000 of the elements of this distribution have the property, ${confidence}.`,
    )
    expect(shareInWords(0, 1024)).toBe(
      `At most 0.293 % of the elements of this distribution have the property, ${confidence}.`,
    )
    expect(shareInWords(2, 4_000_000)).toBe(
      `Of the elements of this distribution, 1 in 16,600,000 to 1 in 553,000 have the property, ${confidence}.`,
    )
    expect(shareInWords(19_506, 1_948_672)).toBe(
      `Of the elements of this distribution, 0.987 % to 1.02 % have the property, ${confidence}.`,
    )
    expect(shareInWords(1024, 1024)).toBe(
      `At least 99.7 % of the elements of this distribution have the property, ${confidence}.`,
    )
  })
})
