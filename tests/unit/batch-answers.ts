/** A batch's answers against the reports of its cells. */
import { expect } from 'vitest'
import { type Answers, STATUSES } from '../../web/core/batch/lists'
import type { Report } from '../../web/core/report'
import { CLASSES } from '../../web/core/unpack'

export const ALL_LISTS = {
  minima: true,
  relativeMinima: true,
  volumes: true,
  classes: true,
  acceptedBy: true,
  exact: true,
  statuses: true,
} as const

/** Every list that was asked for, bit for bit. Minima are asked for wherever `exact` is: without, verdicts alone are decided. */
export function expectAsReports(reports: readonly Report[], answers: Answers): void {
  const { valid, minima, relativeMinima, volumes, classes, acceptedBy, exact, statuses } = answers
  expect(valid.length).toBe(reports.length)
  for (const [c, report] of reports.entries()) {
    // Calls of expect, and texts for them, would take most of the time.
    const expectSame = (what: string, answered: unknown, reported: unknown) => {
      if (!Object.is(answered, reported)) expect(answered, `${what} of cell ${c}: ${report.vertices}`).toBe(reported)
    }
    expectSame('validity', valid[c] === 1, report.valid)
    if (minima) {
      const { minimizer, boundaryMinimum, cornerMinimum } = report
      const exponent = minima.exponents[c] as number
      for (const axis of [0, 1, 2] as const)
        expectSame('minimizer', minima.minimizers[3 * c + axis], minimizer.point[axis])
      const expectSameNumber = (what: string, value: number, reported: number) => {
        const isStandIn = report.exponent !== 0 && Math.abs(reported) === LEAST_NORMAL
        const [answer, number] = isStandIn
          ? [Math.sign(value), Math.sign(reported)]
          : atOneExponent([value, exponent], [reported, report.exponent])
        expectSame(what, answer, number)
      }
      expectSameNumber('minimum', minima.values[c] as number, boundaryMinimum)
      expectSameNumber('corner minimum', minima.cornerMinima[c] as number, cornerMinimum)
    }
    if (relativeMinima) expectSame('relative minimum', relativeMinima[c], report.relativeMinimum ?? Number.NaN)
    if (volumes) {
      expectSame('volume', volumes.values[c], report.volume)
      expectSame('exponent of the volume', volumes.exponents[c], report.volumeExponent)
    }
    if (classes) expectSame('class', CLASSES[classes[c] as number], report.class)
    if (acceptedBy) {
      const bits = report.checks.reduce((bits, { passes }, check) => bits | (passes ? 1 << check : 0), 0)
      expectSame('accepting checks', acceptedBy[c], bits)
    }
    if (exact) expectSame('decision', exact[c] === 1, report.decidedBy === 'exact')
    if (statuses) expectSame('status', STATUSES[statuses[c] as number], undefined)
  }
}

/** A report with an exponent may stand for a smaller number. */
const LEAST_NORMAL = 2 ** -1022

type Scaled = readonly [value: number, exponent: number]

/** The two numbers, comparable: each may have an exponent of its own, since a report has more numbers to bring to one. */
function atOneExponent(one: Scaled, other: Scaled): readonly [unknown, unknown] {
  return one[1] === other[1] ? [one[0], other[0]] : [String(normalized(one)), String(normalized(other))]
}

/** The mantissa, of magnitude from 1 to 2, and the power of two that it is times. */
function normalized([value, exponent]: Scaled): Scaled {
  if (value === 0) return [0, 0]
  let [mantissa, power] = [value, exponent]
  for (; Math.abs(mantissa) >= 2; ++power) mantissa /= 2
  for (; Math.abs(mantissa) < 1; --power) mantissa *= 2
  return [mantissa, power]
}
