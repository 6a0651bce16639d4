/** Sphinx, in reStructuredText and in MyST. */
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../../package/documentation'
import { expectDocumented } from '../guest'
import { expect, nameHost, onceInRun, pythonVersion, run, site, test } from '../host'

nameHost('Sphinx', () => pythonVersion('sphinx'))

test.beforeAll(() => {
  test.setTimeout(300_000)
  onceInRun('sphinx', () => {
    const folder = site('sphinx', '_static')
    const [settings, rst] = snippetsOf('Sphinx') as [string, string]
    const [conf, myst] = snippetsOf('MyST in Sphinx') as [string, string]
    expect(conf).toContain(settings)
    writeFileSync(join(folder, 'conf.py'), `project = "A site"\n${conf}\n`)
    writeFileSync(join(folder, 'index.rst'), `A page\n======\n\n${rst}\n\n.. toctree::\n\n   myst\n`)
    writeFileSync(join(folder, 'myst.md'), `# A page\n\n${myst}\n`)
    run(folder, 'sphinx-build', '-q', '-W', '.', 'html')
  })
})

test('in reStructuredText and in MyST the element is right', async ({ lens }) => {
  await expectDocumented(lens, 'sphinx/html/index.html')
  await expectDocumented(lens, 'sphinx/html/myst.html')
})
