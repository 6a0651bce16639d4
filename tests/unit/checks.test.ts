/** The checks as the page describes them, against those that the core asks. */
import { expect, it } from 'vitest'
import type { CheckId } from '../../web/core/report'
import { checks } from '../../web/panels/checks/check-words'
import { core, unitCube } from './core-fixtures'

it('every check of a report is described in words, and no other', () => {
  const result = core.analyze(unitCube)
  const asked = result.ok ? result.value.checks.map(({ id }) => id) : []
  expect(asked).toHaveLength(8)
  expect(Object.keys(checks).toSorted()).toEqual(asked.toSorted())
  for (const { name, looksAt } of Object.values(checks)) {
    expect(name).not.toBe('')
    expect(looksAt).toMatch(/^[A-Z].*\.$/)
  }
})

it('what the scene marks of each is as many points of the cube as the check says, or the edges', () => {
  const counts: Readonly<Record<CheckId, number>> = {
    corners: 8,
    'corners-and-centre': 9,
    'gauss-2': 8,
    'gauss-3': 27,
    edges: 0,
    bernstein: 20,
    subdivision: 27,
    tangents: 64,
  }
  for (const [id, { marks }] of Object.entries(checks)) {
    const different = new Set(marks.points.map(point => point.join()))
    expect([id, different.size, marks.edges]).toEqual([id, counts[id as CheckId], id === 'edges'])
    for (const x of marks.points.flat()) expect(x >= 0 && x <= 1, id).toBe(true)
  }
})

it('the Gauss points marked are those at which the core has the least jacdet', () => {
  const vertices = unitCube.map((x, i) => x + Math.sin(7 * i) / 4)
  const report = core.analyze(vertices)
  if (!report.ok) throw new Error(report.error.message)
  for (const id of ['gauss-2', 'gauss-3'] as const) {
    const values = checks[id].marks.points.map(point => {
      const there = core.jacobian(vertices, point)
      return there.ok ? there.value.jacdet : Number.NaN
    })
    const value = report.value.checks.find(check => check.id === id)?.value as number
    expect(Math.abs(Math.min(...values) - value)).toBeLessThan(2 ** -48)
  }
})
