/** The element as it is in the one-file scripts, where `web/package/no-page-parts.ts` stands in for what only the pages have. */
import { expect, it, vi } from 'vitest'
import { readAttribute } from '../../web/element/attributes'
import { parts } from '../../web/element/parts'
import { PANELS } from '../../web/model/state'

vi.mock('../../web/element/page-parts', () => import('../../web/package/no-page-parts'))

it('passes over a panel that it has not, and refuses a word that is none', () => {
  const names = parts.map(({ name }) => name)
  expect(names).toContain('morph')
  expect(PANELS.filter(panel => !names.includes(panel))).toEqual(['nearest'])
  expect(readAttribute('views', 'scene nearest verdict')).toEqual(['scene', 'verdict'])
  expect(readAttribute('views', 'all')).toEqual(parts.filter(({ always }) => !always).map(({ name }) => name))
  expect(() => readAttribute('views', 'scene nearer')).toThrow(/“nearer” is none of (?!.*\bnearest\b)/)
})
