/** The verdict's words on its own certainty, against the reports. */
import { describe, expect, it } from 'vitest'
import { approximation, lowerInside } from '../../web/core/inside'
import type { Report } from '../../web/core/report'
import { certainBy, noLowerInside } from '../../web/panels/minimum/certainty'
import { cases, caseVertices, core, depthGuardCases, randomHexahedron, randomSource } from './core-fixtures'

function reportOf(vertices: readonly number[]): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

const random = randomSource(71)
const reports = [
  ...cases.map(({ vertices }) => reportOf(vertices.flat())),
  ...depthGuardCases.map(({ vertices }) => reportOf(vertices.flat())),
  ...Array.from({ length: 500 }, () => reportOf(randomHexahedron(random, 0.4))),
]

describe('how the verdict became certain', () => {
  it('is a positive bound for every valid element and a negative witness for every invalid one', () => {
    for (const report of reports) {
      const words = certainBy(report, 'unit')
      if (report.decidedBy === 'exact') expect(words).toContain('exact arithmetic')
      else if (report.valid) expect(words).toMatch(/^error bounds: all J ≥ [^−]+$/)
      else expect(words).toMatch(/^a witness: J ≤ −.+ there$/)
    }
  })

  it('follows the reference cube', () => {
    const report = reportOf(caseVertices('pub/corner_pos/three_moved'))
    expect(certainBy(report, 'unit')).toBe('a witness: J ≤ −0.020833 there')
    expect(certainBy(report, 'biunit')).toBe('a witness: J ≤ −0.0026041 there')
  })
})

describe('the minimum inside', () => {
  it('is never lower for a valid element', () => {
    for (const report of reports) if (report.valid) expect(lowerInside(report)).toBeNull()
  })

  it('is within its error of both ends of the bracket', () => {
    for (const { volumeMinimum } of reports) {
      const { value, error } = approximation(volumeMinimum)
      expect(value - error).toBeLessThanOrEqual(volumeMinimum.lower)
      expect(value + error).toBeGreaterThanOrEqual(volumeMinimum.upper)
    }
  })

  it('is −1/4 in the paper’s counterexample, where the boundary has 0', () => {
    const report = reportOf(caseVertices('pub/nonstrict/paper'))
    const inside = lowerInside(report)
    expect(report.boundaryMinimum).toBe(0)
    expect(inside?.point).toEqual([0.5, 0.5, 0.5])
    expect(inside && approximation(inside).value).toBe(-0.25)
  })

  it('is said to be no lower where the bracket cannot tell', () => {
    const report = reportOf(caseVertices('pub/corner_pos/three_moved'))
    expect(lowerInside(report)).toBeNull()
    expect(noLowerInside(report, 'unit')).toMatch(/^nowhere lower, to within [\d.]+×10⁻¹²$/)
  })
})
