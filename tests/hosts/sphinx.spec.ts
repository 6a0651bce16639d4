/** Sphinx with the themes that are used most, in reStructuredText and, in its own theme, in MyST. */
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../package/documentation'
import { click, expectDocumented, type Guest, testGuest } from './guest'
import { expect, pythonVersion, root, run, site, test } from './host'

interface Theme {
  readonly name: string
  /** The theme, as conf.py and PyPI call it; without one, Sphinx's own. */
  readonly theme?: readonly [string, string]
  readonly turn?: Guest['turn']
  readonly says?: RegExp
}

const themes: readonly Theme[] = [
  { name: 'Sphinx' },
  {
    name: 'Sphinx, furo',
    theme: ['furo', 'furo'],
    turn: click('.theme-toggle'),
  },
  {
    name: 'Sphinx, pydata',
    theme: ['pydata_sphinx_theme', 'pydata-sphinx-theme'],
    turn: async (page, scheme) => {
      await click('.theme-switch-button')(page)
      await click(`.theme-change-button[data-mode=${scheme}]`)(page)
    },
    says: /^Got invalid theme mode/,
  },
  { name: 'Sphinx, Read the Docs', theme: ['sphinx_rtd_theme', 'sphinx-rtd-theme'] },
]

function build(folder: string, settings: string): void {
  const [conf, rst] = snippetsOf('Sphinx') as [string, string]
  const [both, myst] = snippetsOf('MyST in Sphinx') as [string, string]
  expect(both).toContain(conf)
  writeFileSync(join(folder, 'conf.py'), `project = "A site"\n${both}\n${settings}\n`)
  writeFileSync(join(folder, 'index.rst'), `A page\n======\n\n${rst}\n\n.. toctree::\n\n   myst\n`)
  writeFileSync(join(folder, 'myst.md'), `# A page\n\n${myst}\n`)
  run(folder, 'sphinx-build', '-q', '-W', '.', 'html')
}

for (const { name, theme, turn, says } of themes) {
  const folder = theme ? theme[0] : 'sphinx'
  testGuest({
    name,
    version: () => pythonVersion(theme ? theme[1] : 'sphinx'),
    build: () => build(site(folder, '_static'), theme ? settingsOf(folder, theme[0]) : ''),
    address: `${folder}/html/index.html`,
    ...(turn ? { turn } : {}),
    ...(says ? { says } : {}),
  })
}

test('in MyST', async ({ lens }) => {
  test.info().annotations.push({ type: 'host', description: `MyST in Sphinx\t${pythonVersion('myst-parser')}` })
  await lens.open('sphinx/html/myst.html')
  await expectDocumented(lens)
})

/** furo says nothing of its scheme to the page: the recipe does. */
function settingsOf(folder: string, theme: string): string {
  if (theme !== 'furo') return `html_theme = "${theme}"`
  const [recipe] = snippetsOf('Dark pages') as [string]
  writeFileSync(join(root, 'build/hosts', folder, '_static/dark.css'), recipe)
  return 'html_theme = "furo"\nhtml_css_files = ["dark.css"]'
}
