/** MDX, rendered on a server and brought to life by React. */
import { cpSync, symlinkSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import mdx from '@mdx-js/rollup'
import { build, type InlineConfig } from 'vite'
import { snippetsOf } from '../package/documentation'
import { expectDocumented } from './guest'
import { elsewhere, expect, html, nameHost, root, site, test, versionOf } from './host'

nameHost('MDX', () => versionOf(join(root, 'node_modules/@mdx-js/rollup')))

test('what the server rendered comes to life', async ({ lens }) => {
  const folder = site('mdx', 'public')
  const modules = join(folder, 'node_modules')
  cpSync(join(elsewhere, 'node_modules'), modules, { recursive: true })
  for (const name of ['react', 'react-dom', 'scheduler'])
    symlinkSync(join(root, 'node_modules', name), join(modules, name))
  // Without a name of its own the site would be a part of this project.
  writeFileSync(join(folder, 'package.json'), '{ "name": "site", "private": true, "type": "module" }\n')
  const [top, place] = snippetsOf('MDX') as [string, string]
  writeFileSync(join(folder, 'page.mdx'), `${top}\n\n# A page\n\n${place}\n`)
  writeFileSync(
    join(folder, 'server.js'),
    "import { createElement } from 'react'\nimport { renderToString } from 'react-dom/server'\nimport Page from './page.mdx'\nexport const html = renderToString(createElement(Page))\n",
  )
  writeFileSync(
    join(folder, 'client.js'),
    "import { createElement } from 'react'\nimport { hydrateRoot } from 'react-dom/client'\nimport Page from './page.mdx'\nhydrateRoot(document.getElementById('root'), createElement(Page))\n",
  )
  const config = {
    root: folder,
    configFile: false,
    logLevel: 'error',
    plugins: [mdx()],
    base: './',
  } satisfies InlineConfig
  await build({ ...config, build: { ssr: 'server.js', outDir: 'server' } })
  const { html: rendered } = await import(join(folder, 'server/server.js'))
  expect(rendered).toContain('<hex-lens')
  writeFileSync(
    join(folder, 'index.html'),
    html('', `<div id="root">${rendered}</div><script type="module" src="/client.js"></script>`),
  )
  await build({ ...config, build: { outDir: 'site' } })
  await lens.open('mdx/site/index.html')
  await expectDocumented(lens)
})
