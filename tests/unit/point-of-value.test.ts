import { describe, expect, it } from 'vitest'
import { pointOfValue } from '../../web/core/point-of-value'
import { valueInside } from '../../web/core/section'
import { presets, presetVertices } from '../../web/model/presets'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'

const random = randomSource(20261126)
const awkward = Array.from({ length: 30 }, () => randomHexahedron(random, 0.5))
const elements = [...presets.map(preset => presetVertices(preset)), ...awkward, unitCube]

function reportOf(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

describe('a point of a value', () => {
  it('lies on the boundary and has it', () => {
    for (const vertices of elements) {
      const report = reportOf(vertices)
      const { boundaryMinimum: least, boundaryMaximum: greatest, bernstein } = report
      const largest = Math.max(...bernstein.map(Math.abs))
      for (let i = 0; i <= 16; i++) {
        const value = least + ((greatest - least) * i) / 16
        const point = pointOfValue(report, value)
        expect(point.every(x => x >= 0 && x <= 1) && point.some(x => x === 0 || x === 1), `${vertices}: ${point}`).toBe(
          true,
        )
        expect(Math.abs(valueInside(bernstein, point) - value)).toBeLessThan(1e-12 * largest)
      }
    }
  })

  it('is the minimizer or the maximizer where the value is beyond them', () => {
    const report = reportOf(presetVertices(presets[0]))
    expect(pointOfValue(report, -Infinity)).toBe(report.minimizer.point)
    expect(pointOfValue(report, Infinity)).toBe(report.maximizer.point)
  })

  it('is inside where the boundary has no such value', () => {
    const report = reportOf(presetVertices(presets.find(({ id }) => id === 'non-strict') ?? presets[0]))
    expect(pointOfValue(report, -1 / 4)).toEqual([1 / 2, 1 / 2, 1 / 2])
    const point = pointOfValue(report, -1 / 8)
    expect(point.every(x => x > 0 && x < 1)).toBe(true)
    expect(valueInside(report.bernstein, point)).toBeCloseTo(-1 / 8, 12)
  })

  it('goes round the centre where the two are opposite each other', () => {
    // Two tetrahedral ends: least at vertex 0, greatest at vertex 6.
    const report = reportOf(unitCube.map((x, i) => (i >= 18 && i < 21 ? 2 * x : x)))
    const from = { ...report.minimizer, point: [0, 0, 0] as const, value: valueInside(report.bernstein, [0, 0, 0]) }
    const to = { ...report.maximizer, point: [1, 1, 1] as const, value: valueInside(report.bernstein, [1, 1, 1]) }
    const value = (from.value + to.value) / 2
    const point = pointOfValue({ ...report, minimizer: from, maximizer: to }, value)
    expect(point.some(x => x === 0 || x === 1)).toBe(true)
    expect(valueInside(report.bernstein, point)).toBeCloseTo(value, 12)
  })
})
