/** Half of the hexahedra on which verdicts are checked by certificates; the verdict-border tests have the other half. */
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { FAMILIES, type Family, families } from './hexahedra'
import { replayed } from './replay'
import { drawn, emptyTally, holdsVerdictLaw, TIMEOUT } from './verdict-law'

const EACH = drawn(10_000)

/** Those with exact zeros take longer. */
const countOf = (family: Family) => (family === 'touched' ? drawn(2000) : EACH)

/** The least numbers of each verdict, and of those decided by exact arithmetic, in whole. */
const LEAST: Readonly<Record<Family, { valid: number; invalid: number; exact: number }>> = {
  displaced: { valid: 1000, invalid: 1000, exact: 0 },
  raw: { valid: 1000, invalid: 1000, exact: 5 },
  scaled: { valid: 1000, invalid: 1000, exact: 0 },
  'small-integers': { valid: 1000, invalid: 1000, exact: 100 },
  degenerate: { valid: 1000, invalid: 1000, exact: 1000 },
  touched: { valid: 40, invalid: 1000, exact: 600 },
}

describe('verdicts are certain and certified', () => {
  for (const family of FAMILIES)
    it(`on ${countOf(family)} hexahedra, ${family}`, { timeout: TIMEOUT }, () => {
      const tally = emptyTally()
      fc.assert(
        fc.property(families[family], vertices => holdsVerdictLaw(vertices, tally)),
        replayed(countOf(family)),
      )
      expect(tally.total).toBeGreaterThanOrEqual(countOf(family))
      for (const [what, least] of Object.entries(LEAST[family]))
        expect(tally[what as keyof (typeof LEAST)[Family]], what).toBeGreaterThanOrEqual(drawn(least))
    })
})
