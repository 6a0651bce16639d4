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
    const cell = `cell ${c}: ${report.vertices}`
    expect(valid[c] === 1, cell).toBe(report.valid)
    if (minima) {
      const { minimizer, boundaryMinimum, cornerMinimum } = report
      const exponent = minima.exponents[c] as number
      expect(minima.minimizers.subarray(3 * c, 3 * c + 3), cell).toEqual(Float64Array.from(minimizer.point))
      expectSame(minima.values[c] as number, exponent, boundaryMinimum, report, cell)
      expectSame(minima.cornerMinima[c] as number, exponent, cornerMinimum, report, cell)
    }
    if (relativeMinima) expect(relativeMinima[c], cell).toBe(report.relativeMinimum ?? Number.NaN)
    if (volumes) expect([volumes.values[c], volumes.exponents[c]], cell).toEqual([report.volume, report.volumeExponent])
    if (classes) expect(CLASSES[classes[c] as number], cell).toBe(report.class)
    if (acceptedBy)
      expect(acceptedBy[c], cell).toBe(
        report.checks.reduce((bits, { passes }, check) => bits | (passes ? 1 << check : 0), 0),
      )
    if (exact) expect(exact[c] === 1, cell).toBe(report.decidedBy === 'exact')
    if (statuses) expect(STATUSES[statuses[c] as number], cell).toBeUndefined()
  }
}

/** The same number, with an exponent of its own: a report has more numbers to bring to one. */
function expectSame(value: number, exponent: number, reported: number, report: Report, cell: string): void {
  const isStandIn = report.exponent !== 0 && Math.abs(reported) === LEAST_NORMAL
  if (isStandIn) expect(Math.sign(value), cell).toBe(Math.sign(reported))
  else if (exponent === report.exponent) expect(value, cell).toBe(reported)
  else expect(normalized(value, exponent), cell).toEqual(normalized(reported, report.exponent))
}

/** A report with an exponent may stand for a smaller number. */
const LEAST_NORMAL = 2 ** -1022

/** The mantissa, of magnitude from 1 to 2, and the power of two that it is times. */
function normalized(value: number, exponent: number): [number, number] {
  if (value === 0) return [0, 0]
  let [mantissa, power] = [value, exponent]
  for (; Math.abs(mantissa) >= 2; ++power) mantissa /= 2
  for (; Math.abs(mantissa) < 1; --power) mantissa *= 2
  return [mantissa, power]
}
