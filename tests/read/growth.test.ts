/**
 * Texts of one fragment, again and again: four times as much takes about four times as long, where quadratic work would take sixteen times.
 * Times are compared in npm run test:read alone; npm test reads some of them at a size at which quadratic work takes minutes.
 */
import { expect, it } from 'vitest'
import { FRAGMENTS, filled } from './mutations'
import { type Ended, ended } from './reading'

const isWhole = process.env.HEXLENS_READ === 'whole'
const SMALL = 1_000_000
const LARGE = 4 * SMALL
const SAMPLE = 250_000
const EVERY = 8
/** The most that the larger text may take, in times of the smaller: 4 is linear, 16 quadratic. */
const MOST_GROWTH = 10
/** So short times are measured badly. */
const SHORT = 150

/** The fastest of a few, for the machine may be busy. */
function fastest(fragment: string, size: number): Ended {
  const bytes = filled(new TextEncoder().encode(fragment), size)
  const all = Array.from({ length: isWhole ? 2 : 1 }, () => ended('made', bytes))
  return all.reduce((best, next) => (next.milliseconds < best.milliseconds ? next : best))
}

const fragments = FRAGMENTS.filter((_, i) => isWhole || i % EVERY === 0)

it.each(fragments)('reads %j in a time that grows with it', { timeout: 600_000 }, fragment => {
  const sample = fastest(fragment, SAMPLE)
  expect(sample.fault).toBeNull()
  if (!isWhole) return
  const [small, large] = [fastest(fragment, SMALL), fastest(fragment, LARGE)]
  expect(large.fault).toBeNull()
  expect(large.milliseconds).toBeLessThan(MOST_GROWTH * Math.max(SHORT, small.milliseconds))
})
