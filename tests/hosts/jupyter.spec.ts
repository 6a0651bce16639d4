/** The widget for notebooks, in JupyterLab. */
import { copyFileSync, readdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Page } from '@playwright/test'
import { Lens } from '../e2e/lens'
import { snippetsOf } from '../package/documentation'
import { documented } from '../unit/embed-fixture'
import { expectAxeFindsNothingInElement, expectComplete, expectDrag, expectRoom, isDark } from './guest'
import { dist, expect, hosts, nameHost, onceInRun, python, pythonVersion, root, run, site, test } from './host'
import { Lab, notebook, runCell } from './lab'

const folder = join(hosts, 'jupyter')
let lab: Lab | undefined

nameHost('JupyterLab', () => pythonVersion('jupyterlab'))
test.use({ viewport: { width: 1280, height: 900 } })

/** Opens a notebook with these cells and runs the first two, which show the element. */
async function open(page: Page, name: string, cells: readonly string[] = []): Promise<Lens> {
  writeFileSync(join(folder, name), JSON.stringify(notebook([...snippetsOf('Jupyter'), ...cells])))
  await lab?.open(page, name)
  await runCell(page, 1)
  const lens = new Lens(page)
  await expect(lens.verdict).toHaveText(/^INVALID/, { timeout: 60_000 })
  await lens.scene.evaluate(scene => scene.scrollIntoView({ block: 'center' }))
  await expectComplete(lens)
  return lens
}

test.beforeAll(async ({ playwright }) => {
  test.setTimeout(300_000)
  await onceInRun('jupyter', () => {
    const source = join(root, 'python')
    const wheels = site('jupyter', '.')
    for (const name of ['hexlens.anywidget.js', 'hexlens.mesh-worker.js'])
      copyFileSync(join(dist, name), join(source, 'hexlens', name))
    run(
      source,
      'uv',
      'build',
      '--quiet',
      '--wheel',
      '--offline',
      '--no-build-isolation',
      '--out-dir',
      wheels,
      '--python',
      join(python, 'python'),
    )
    const [wheel] = readdirSync(wheels).filter(name => name.endsWith('.whl')) as [string]
    const words = ['--quiet', '--offline', '--no-deps', '--reinstall', '--python', join(python, 'python')]
    run(source, 'uv', 'pip', 'install', ...words, join(wheels, wheel))
  })
  const request = await playwright.request.newContext()
  lab = await Lab.start(folder, request)
  await request.dispose()
})

test.afterEach(async () => {
  const { errors } = test.info()
  if (errors.length > 0 && lab) await test.info().attach('jupyter.log', { path: lab.log })
})

test.afterAll(async () => {
  await lab?.end()
})

test('what is moved moves the array, and what is assigned moves the picture', async ({ page }) => {
  const cells = [
    'import json\nprint(json.dumps([lens.vertices.ravel().tolist(), lens.valid]))',
    'v = lens.vertices.copy()\nv[0] = [-0.0, 5e-324, 0.1]\nlens.vertices = v',
  ]
  const lens = await open(page, 'moves.ipynb', cells)
  expect(await lens.vertices()).toEqual(documented.vertices)
  await lens.scene.focus()
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
})

test('it has room, a vertex is dragged, and axe finds nothing in it', async ({ page }) => {
  const lens = await open(page, 'looks.ipynb')
  await page.screenshot({ path: join(hosts, 'pictures', 'JupyterLab.png') })
  await expectDrag(lens)
  await expectAxeFindsNothingInElement(page)
  await expectRoom(lens)
})

test('keys that the element uses do nothing to the notebook', async ({ page }) => {
  const lens = await open(page, 'keys.ipynb')
  const cells = page.locator('.jp-Notebook .jp-Cell')
  await lens.scene.focus()
  // In the notebook they cut a cell, change its kind, search, save, and go from cell to cell.
  for (const key of ['x', 'm', 'f', 's', 'ArrowDown', 'ArrowUp', 'ArrowRight', 'Escape']) {
    await page.keyboard.press(key)
    await lens.nextFrame()
    await expect(lens.scene, key).toBeFocused()
    await expect(cells, key).toHaveCount(2)
  }
  await expect(page.locator('.jp-MarkdownCell, .jp-DocumentSearch-overlay')).toHaveCount(0)
  await expect(lens.element).toHaveCount(1)
})

test('its colours go with the theme of JupyterLab', async ({ page }) => {
  const themes = `${lab?.address}/lab/api/settings/@jupyterlab/apputils-extension:themes`
  for (const [name, dark] of [
    ['JupyterLab Dark', true],
    ['JupyterLab Light', false],
  ] as const) {
    const answer = await page.request.put(themes, { data: { raw: JSON.stringify({ theme: name }) } })
    expect(answer.status(), await answer.text()).toBe(204)
    const lens = await open(page, 'dark.ipynb')
    await expect.poll(() => isDark(lens.element.locator('.lens'))).toBe(dark)
    if (dark) await page.screenshot({ path: join(hosts, 'pictures', 'JupyterLab-dark.png') })
  }
})
