/** MkDocs with its own theme. */
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { snippetsOf } from '../../package/documentation'
import { expectDocumented } from '../guest'
import { nameHost, onceInRun, pythonVersion, run, site, test } from '../host'

nameHost('MkDocs', () => pythonVersion('mkdocs'))

test.beforeAll(() => {
  test.setTimeout(300_000)
  onceInRun('mkdocs', () => {
    const folder = site('mkdocs', 'docs')
    const [config, page] = snippetsOf('MkDocs') as [string, string]
    // MkDocs' own theme would ask another host for a highlighter.
    const theme = 'theme: {name: mkdocs, highlightjs: false}'
    writeFileSync(join(folder, 'mkdocs.yml'), `site_name: A site\n${theme}\n${config}\n`)
    writeFileSync(join(folder, 'docs/index.md'), `# A page\n\n${page}\n`)
    run(folder, 'mkdocs', 'build', '--quiet', '--strict')
  })
})

test('the element is right', async ({ lens }) => {
  await expectDocumented(lens, 'mkdocs/site/index.html')
})
