/** Each host's snippet as docs/embedding.md has it, in that host, with the packed files, in a browser. */
import { execFileSync, spawn } from 'node:child_process'
import { copyFileSync, cpSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:net'
import { join } from 'node:path'
import mdx from '@mdx-js/rollup'
import type { Page } from '@playwright/test'
import { build, type InlineConfig } from 'vite'
import { Lens } from '../e2e/lens'
import { documented } from '../unit/embed-fixture'
import { snippetsOf } from './documentation'
import { elsewhere, expect, root, test } from './elsewhere'

test.describe.configure({ mode: 'parallel' })

const hosts = join(root, 'build/hosts/bin')
const dist = join(elsewhere, 'node_modules/hexlens/dist')

/** A new folder for a site, with the script and the picture where the host wants them. */
function site(name: string, files: string): string {
  const folder = join(elsewhere, name)
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(join(folder, files), { recursive: true })
  copyFileSync(join(dist, 'hexlens.iife.js'), join(folder, files, 'hexlens.iife.js'))
  copyFileSync(join(root, 'tests/visual/snapshots/index-desktop.png'), join(folder, files, 'hexlens.png'))
  return folder
}

function html(head: string, body: string): string {
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A page</title><link rel="icon" href="data:,">${head}</head><body><h1>A page</h1>${body}</body></html>`
}

async function expectDocumented(lens: Lens, address: string): Promise<void> {
  await lens.open(address)
  await expect(lens.verdict).toHaveText(/^INVALID/)
  expect(await lens.vertices()).toEqual(documented.vertices)
  await expect(lens.page.getByRole('group', { name: documented.label })).toBeVisible()
}

test('plain HTML; without scripts the picture and the link remain', async ({ lens, browser, page }) => {
  const folder = site('html', '.')
  const [head, body] = snippetsOf('HTML') as [string, string]
  writeFileSync(join(folder, 'index.html'), html(head, body))
  await expectDocumented(lens, 'html/')
  const plain = await browser.newPage({ javaScriptEnabled: false })
  await plain.goto(page.url())
  await expect(plain.getByRole('img', { name: documented.label })).toBeVisible()
  await expect(plain.getByRole('link')).toHaveAttribute('href', documented.link)
  await plain.close()
})

test('an iframe, as high as what it shows', async ({ page }) => {
  const folder = site('iframe', '.')
  cpSync(join(dist, 'app'), join(folder, 'hexlens'), { recursive: true })
  writeFileSync(join(folder, 'index.html'), html('', snippetsOf('iframe').join('\n')))
  await page.goto('iframe/')
  const frame = page.frameLocator('iframe')
  await expect(frame.getByRole('status', { name: 'Verdict' })).toHaveText(/^INVALID/)
  const content = frame.locator('hex-lens')
  expect(await content.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).vertices)).toEqual(
    documented.vertices,
  )
  const height = () => content.evaluate(element => Math.ceil(element.getBoundingClientRect().height))
  await expect.poll(async () => (await page.locator('iframe').boundingBox())?.height).toBe(await height())
  const before = await height()
  await page.setViewportSize({ width: 420, height: 640 })
  await expect.poll(height).not.toBe(before)
  await expect.poll(async () => (await page.locator('iframe').boundingBox())?.height).toBe(await height())
})

test('Sphinx, in reStructuredText and in MyST', async ({ lens }) => {
  test.setTimeout(120_000)
  const folder = site('sphinx', '_static')
  const [, rst] = snippetsOf('Sphinx') as [string, string]
  const [conf, myst] = snippetsOf('MyST in Sphinx') as [string, string]
  expect(conf).toContain(snippetsOf('Sphinx')[0])
  writeFileSync(join(folder, 'conf.py'), `project = "A site"\n${conf}\n`)
  writeFileSync(join(folder, 'index.rst'), `A page\n======\n\n${rst}\n\n.. toctree::\n\n   myst\n`)
  writeFileSync(join(folder, 'myst.md'), `# A page\n\n${myst}\n`)
  execFileSync(join(hosts, 'sphinx-build'), ['-q', '-W', folder, join(folder, 'html')])
  await expectDocumented(lens, 'sphinx/html/index.html')
  await expectDocumented(lens, 'sphinx/html/myst.html')
})

test('MkDocs', async ({ lens }) => {
  const folder = site('mkdocs', 'docs')
  const [config, page] = snippetsOf('MkDocs') as [string, string]
  // MkDocs' own theme would ask another host for a highlighter.
  writeFileSync(join(folder, 'mkdocs.yml'), `site_name: A site\ntheme: {name: mkdocs, highlightjs: false}\n${config}\n`)
  writeFileSync(join(folder, 'docs/index.md'), `# A page\n\n${page}\n`)
  execFileSync(join(hosts, 'mkdocs'), ['build', '--quiet', '--strict'], { cwd: folder })
  await expectDocumented(lens, 'mkdocs/site/index.html')
})

test('MDX, rendered on the server and brought to life by React', async ({ lens }) => {
  const folder = site('mdx', 'public')
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
  for (const name of ['react', 'react-dom', 'scheduler']) {
    const link = join(elsewhere, 'node_modules', name)
    rmSync(link, { recursive: true, force: true })
    symlinkSync(join(root, 'node_modules', name), link)
  }
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
  await expectDocumented(lens, 'mdx/site/index.html')
})

test('Jupyter: what is moved moves the array, and what is assigned moves the picture', async ({ page }) => {
  test.setTimeout(180_000)
  const folder = site('jupyter', '.')
  const python = join(folder, 'python')
  cpSync(join(root, 'python'), python, { recursive: true })
  for (const name of ['hexlens.anywidget.js', 'hexlens.mesh-worker.js'])
    copyFileSync(join(dist, name), join(python, 'hexlens', name))
  execFileSync(
    join(hosts, 'uv'),
    [
      'pip',
      'install',
      '--quiet',
      '--offline',
      '--no-deps',
      '--no-build-isolation',
      '--reinstall',
      '--python',
      join(hosts, 'python'),
      python,
    ],
    { env: { ...process.env, PATH: `${hosts}:${process.env.PATH}` } },
  )
  const cells = [
    ...snippetsOf('Jupyter'),
    'import json\nprint(json.dumps([lens.vertices.ravel().tolist(), lens.valid]))',
    'v = lens.vertices.copy()\nv[0] = [-0.0, 5e-324, 0.1]\nlens.vertices = v',
  ]
  writeFileSync(join(folder, 'page.ipynb'), JSON.stringify(notebook(cells)))
  const port = await freePort()
  const settings = [
    '--no-browser',
    '--allow-root',
    `--port=${port}`,
    '--ServerApp.port_retries=0',
    '--IdentityProvider.token=',
    `--ServerApp.root_dir=${folder}`,
    '--LabApp.news_url=None',
    '--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate',
  ]
  const jupyter = spawn(join(hosts, 'jupyter'), ['lab', ...settings], {
    stdio: 'ignore',
    env: {
      ...process.env,
      JUPYTER_CONFIG_DIR: join(folder, 'config'),
      JUPYTER_RUNTIME_DIR: join(folder, 'runtime'),
      JUPYTER_DATA_DIR: join(folder, 'data'),
      IPYTHONDIR: join(folder, 'ipython'),
    },
  })
  const ended = new Promise(resolve => jupyter.once('exit', resolve))
  try {
    const lab = `http://127.0.0.1:${port}`
    await expect
      .poll(
        () =>
          page.request.get(`${lab}/api`).then(
            response => response.ok(),
            () => false,
          ),
        { timeout: 60_000 },
      )
      .toBe(true)
    await page.goto(`${lab}/lab/tree/page.ipynb`)
    const lens = new Lens(page)
    await runCell(page, 0)
    await runCell(page, 1)
    await expect(lens.verdict).toHaveText(/^INVALID/, { timeout: 60_000 })
    expect(await lens.vertices()).toEqual(documented.vertices)
    await lens.scene.focus()
    // In the notebook these keys cut the cell, change its kind, and search.
    for (const key of ['x', 'm', 'f', 's']) await page.keyboard.press(key)
    await expect(page.locator('.jp-CodeCell')).toHaveCount(cells.length)
    await expect(lens.scene).toBeFocused()
    await page.keyboard.press('7')
    await page.keyboard.press('ArrowRight')
    await lens.nextFrame()
    const moved = await lens.vertices()
    expect(moved).not.toEqual(documented.vertices)
    await runCell(page, 2)
    const printed = await page.locator('.jp-CodeCell').nth(2).locator('.jp-OutputArea-output').innerText()
    expect(JSON.parse(printed)).toEqual([moved, false])
    await runCell(page, 3)
    await expect
      .poll(() =>
        lens
          .vertices()
          .then(vertices => vertices.slice(0, 3).map(value => (Object.is(value, -0) ? '-0' : String(value)))),
      )
      .toEqual(['-0', '5e-324', '0.1'])
    // The kernel sends the script that reads.
    await lens.element.evaluate(element =>
      (element as HTMLElementTagNameMap['hex-lens']).offer('0 0 0 2 0 0 2 1 0 0 1 0 0 0 1 2 0 1 2 1 1 0 1 1'),
    )
    await expect
      .poll(() => lens.vertices())
      .toEqual([0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 1, 2, 1, 1, 0, 1, 1])
  } finally {
    jupyter.kill()
    await ended
  }
})

/** JupyterLab takes no keys before the notebook has its kernel. */
async function runCell(page: Page, index: number): Promise<void> {
  const cell = page.locator('.jp-CodeCell').nth(index)
  const prompt = cell.locator('.jp-InputPrompt')
  await expect(async () => {
    await cell.locator('.cm-content').click()
    await page.keyboard.press('Control+Enter')
    await expect(prompt).not.toHaveText('[ ]:', { timeout: 3_000 })
  }).toPass({ timeout: 120_000 })
  await expect(prompt).toHaveText(/\[\d+\]:/, { timeout: 120_000 })
}

function notebook(cells: readonly string[]): object {
  return {
    nbformat: 4,
    nbformat_minor: 5,
    metadata: { kernelspec: { name: 'python3', display_name: 'Python 3', language: 'python' } },
    cells: cells.map((source, i) => ({
      cell_type: 'code',
      id: `cell-${i}`,
      metadata: {},
      execution_count: null,
      outputs: [],
      source,
    })),
  }
}

function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const socket = createServer().on('error', reject)
    socket.listen(0, '127.0.0.1', () => {
      const { port } = socket.address() as { port: number }
      socket.close(() => resolve(port))
    })
  })
}
