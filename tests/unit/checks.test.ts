/** The checks as the page describes them, against those that the core asks. */
import { expect, it } from 'vitest'
import { checks } from '../../web/content/checks'
import { core, unitCube } from './core-fixtures'

it('every check of a report is described in words, and no other', () => {
  const result = core.analyze(unitCube)
  const asked = result.ok ? result.value.checks.map(({ id }) => id) : []
  expect(asked).toHaveLength(7)
  expect(Object.keys(checks).toSorted()).toEqual(asked.toSorted())
  for (const { name, looksAt } of Object.values(checks)) {
    expect(name).not.toBe('')
    expect(looksAt).toMatch(/^[A-Z].*\.$/)
  }
})
