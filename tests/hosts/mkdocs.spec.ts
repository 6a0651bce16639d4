/** MkDocs with its own theme and with Material. */
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../package/documentation'
import { click, testGuest } from './guest'
import { pythonVersion, run, site } from './host'

/** Neither theme is to ask another host, for a highlighter or for fonts. */
const MKDOCS = 'theme: {name: mkdocs, highlightjs: false}'
const MATERIAL = `theme:
  name: material
  font: false
  palette:
    - scheme: default
      toggle: {icon: material/brightness-7, name: Dark}
    - scheme: slate
      toggle: {icon: material/brightness-4, name: Light}
plugins: [search]`

function build(folder: string, theme: string): void {
  const [config, page] = snippetsOf('MkDocs') as [string, string]
  writeFileSync(join(folder, 'mkdocs.yml'), `site_name: A site\n${theme}\n${config}\n`)
  writeFileSync(join(folder, 'docs/index.md'), `# A page\n\n${page}\n`)
  // Material has two more pages for its keys to turn to.
  for (const name of ['first', 'second']) writeFileSync(join(folder, `docs/${name}.md`), `# The ${name}\n`)
  run(folder, 'mkdocs', 'build', '--quiet', '--strict')
}

testGuest({
  name: 'MkDocs',
  version: () => pythonVersion('mkdocs'),
  build: () => build(site('mkdocs', 'docs'), MKDOCS),
  address: 'mkdocs/site/index.html',
})

testGuest({
  name: 'MkDocs Material',
  version: () => pythonVersion('mkdocs-material'),
  build: () => build(site('material', 'docs'), MATERIAL),
  address: 'material/site/index.html',
  turn: click('[data-md-component=palette] label'),
})
