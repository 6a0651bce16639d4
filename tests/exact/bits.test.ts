/** Any 24 finite doubles get an answer: random bit patterns, whose coordinates span all exponents there are. */
import fc from 'fast-check'
import { expect, it } from 'vitest'
import { rawBits } from '../property/hexahedra'
import { holdsFor, seed } from '../property/replay'
import { core, numbersIn } from '../unit/core-fixtures'
import { report, scaled, TIMEOUT } from './scale'

const COUNT = scaled(100_000)

/** Bounds in milliseconds; the test prints this machine's times beside them. */
const BOUNDS = { verdict: 0.4, report: 10 }

it(`${COUNT} random bit patterns are answered`, { timeout: TIMEOUT }, () => {
  const times = { verdict: [] as number[], report: [] as number[] }
  const timed = <T>(list: number[], run: () => T): T => {
    const begin = performance.now()
    const result = run()
    list.push(performance.now() - begin)
    return result
  }
  fc.assert(
    fc.property(rawBits, vertices => {
      holdsFor(vertices, () => {
        const decided = timed(times.verdict, () => core.isValid(vertices))
        const analyzed = timed(times.report, () => core.analyze(vertices))
        if (!decided.ok || !analyzed.ok) throw new Error('There is no answer.')
        if (decided.value !== analyzed.value.valid) throw new Error('Validity query and report differ.')
        expect(numbersIn(analyzed.value).every(Number.isFinite)).toBe(true)
      })
    }),
    { seed, numRuns: COUNT, endOnFailure: true },
  )
  expect(times.report.length).toBe(COUNT)
  for (const [what, list] of Object.entries(times)) {
    const sorted = list.toSorted((a, b) => a - b)
    const [median, greatest] = [sorted[COUNT >> 1], sorted[COUNT - 1]].map(x => (x as number).toFixed(3))
    report(
      `random bits, ${what}: median ${median} ms, greatest ${greatest} ms (bound ${BOUNDS[what as keyof typeof BOUNDS]} ms, seed ${seed})`,
    )
  }
})
