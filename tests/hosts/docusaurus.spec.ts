/** Docusaurus 3. */
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../package/documentation'
import { click, testGuest } from './guest'
import { installed, npmVersion, putFiles, run } from './host'

const config = `export default {
  title: 'A site',
  url: 'https://example.org',
  baseUrl: '/docusaurus/build/',
  onBrokenLinks: 'throw',
  presets: [['classic', { docs: { routeBasePath: '/' }, blog: false, pages: false }]],
}
`

testGuest({
  name: 'Docusaurus',
  version: () => npmVersion('docusaurus', '@docusaurus/core'),
  build: () => {
    const folder = installed('docusaurus')
    const [top, place] = snippetsOf('MDX') as [string, string]
    mkdirSync(join(folder, 'docs'))
    writeFileSync(join(folder, 'docusaurus.config.js'), config)
    writeFileSync(join(folder, 'docs/page.mdx'), `---\nslug: /\n---\n\n${top}\n\n# A page\n\n${place}\n`)
    putFiles(join(folder, 'static'))
    run(folder, 'docusaurus', 'build')
  },
  address: 'docusaurus/build/',
  turn: click('[class*=colorModeToggle] button, button[class*=toggleButton]'),
})
