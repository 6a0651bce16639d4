/** "Copy embed" gives authors the lines of docs/embedding.md. */
import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { attributesOf, cameraText, embeddableViews, verticesText } from '../../web/panels/embed/embed-lines'
import { hosts } from '../../web/panels/embed/hosts'
import { panels } from '../../web/panels/list'
import { documented } from './embed-fixture'

const text = readFileSync(new URL('../../docs/embedding.md', import.meta.url), 'utf8')
const sections = new Map(text.split(/^## /m).map(section => [section.slice(0, section.indexOf('\n')), section]))

for (const { title, setup, snippet } of hosts) {
  it(`the lines for ${title} are in docs/embedding.md`, () => {
    const section = sections.get(title)
    for (const { language, text } of [...setup, snippet(documented)]) {
      expect(section).toMatch(new RegExp(`^(\`{3,4})${language}\n`, 'm'))
      expect(section).toContain(`\n${text}\n`)
    }
  })
}

it('numbers are written so that they read back bit for bit', () => {
  const hard = documented.vertices
    .with(0, -0)
    .with(5, 5e-324)
    .with(9, 0.1 + 0.2)
    .with(23, -1.7976931348623157e308)
  const read = verticesText(hard)
    .split(/[\s,]+/)
    .map(Number)
  expect(read.every((value, i) => Object.is(value, hard[i]))).toBe(true)
  const jupyter = hosts.find(({ id }) => id === 'jupyter')
  expect(jupyter?.snippet({ ...documented, vertices: hard }).text).toContain('[-0.0, 1, 0],')
})

it('what a label says does not end its attribute, and what an element has by itself is not said', () => {
  const label = 'a "b" <c> & d'
  const html = hosts[0]?.snippet({ ...documented, label, views: ['scene', 'verdict'], theme: 'dark', readonly: true })
  expect(html?.text).toContain('label="a &quot;b&quot; &lt;c&gt; &amp; d"')
  expect(html?.text).not.toContain('views=')
  expect(html?.text).toMatch(/^ {2}theme="dark"\n {2}readonly$/m)
  expect(attributesOf({ ...documented, views: [] })).toContainEqual(['views', 'none'])
})

it('every panel can be chosen, but for what is always there and the panel that asks', () => {
  const chosen = panels.filter(panel => !panel.always && !panel.with && panel.name !== 'embed').map(({ name }) => name)
  expect(embeddableViews.map(({ name }) => name).toSorted()).toEqual(chosen.toSorted())
})

it('a view is said as azimuth, elevation and zoom', () => {
  expect(cameraText({ direction: [1, -1, Math.SQRT2], zoom: 1.23456, pan: [0, 0, 0] })).toBe('-45 45 1.23')
  expect(cameraText({ direction: [0, 0, 2], zoom: 1, pan: [0, 0, 0] })).toBe('0 90 1')
})
