/** The element as it is in the one-file scripts, without the panels that only the pages have. */
import { expect, it } from 'vitest'
import { type AttributeName, readAttribute, viewNames } from '../../web/element/attributes'
import { panels } from '../../web/panels/list'

it('passes over a panel that it has not, and refuses a word that is none', () => {
  const names = viewNames({ panels, otherPanels: ['nearest'] })
  const views = (text: string) => readAttribute('views' satisfies AttributeName, text, names)
  expect(names.known).toContain('morph')
  expect(names.known).not.toContain('nearest')
  expect(views('scene nearest verdict')).toEqual(['scene', 'verdict'])
  expect(views('all')).toEqual(panels.filter(panel => !panel.always && !panel.with).map(({ name }) => name))
  expect(() => views('scene nearer')).toThrow(/“nearer” is none of (?!.*\bnearest\b)/)
})
