/** The widget for notebooks, in JupyterLab. */
import { copyFileSync, cpSync, readdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { Lens } from '../../e2e/lens'
import { snippetsOf } from '../../package/documentation'
import { documented } from '../../unit/embed-fixture'
import { dist, expect, nameHost, onceInRun, python, pythonVersion, root, run, site, test } from '../host'
import { Lab, notebook, runCell } from './lab'

const folder = join(root, 'build/hosts/jupyter')
let lab: Lab | undefined

nameHost('JupyterLab', () => pythonVersion('jupyterlab'))

test.beforeAll(async ({ playwright }) => {
  test.setTimeout(300_000)
  await onceInRun('jupyter', () => {
    const source = join(site('jupyter', '.'), 'python')
    cpSync(join(root, 'python'), source, { recursive: true })
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
      '--python',
      join(python, 'python'),
    )
    const [wheel] = readdirSync(join(source, 'dist')).filter(name => name.endsWith('.whl')) as [string]
    const words = ['--quiet', '--offline', '--no-deps', '--reinstall', '--python', join(python, 'python')]
    run(source, 'uv', 'pip', 'install', ...words, join(source, 'dist', wheel))
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
    ...snippetsOf('Jupyter'),
    'import json\nprint(json.dumps([lens.vertices.ravel().tolist(), lens.valid]))',
    'v = lens.vertices.copy()\nv[0] = [-0.0, 5e-324, 0.1]\nlens.vertices = v',
  ]
  writeFileSync(join(folder, 'moves.ipynb'), JSON.stringify(notebook(cells)))
  await lab?.open(page, 'moves.ipynb')
  const lens = new Lens(page)
  await runCell(page, 1)
  await expect(lens.verdict).toHaveText(/^INVALID/, { timeout: 60_000 })
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
