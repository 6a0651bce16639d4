/** A page of a framework: rendered on a server, brought to life by the browser, with the element in the hands of its state. */
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { documented } from '../unit/embed-fixture'
import { expectComplete, expectDrag, testGuest } from './guest'
import { expect, html, installed, nameHost, npmVersion, run, test } from './host'

export interface Framework {
  readonly name: string
  /** The folder in tests/hosts, and the package whose version counts. */
  readonly folder: string
  readonly package: string
  /**
   * `vite.config.js`; `server.js`, which exports the rendered `page`; `client.js`, which brings `#root` to life; and what
   * these need. The page has a button "In and out" for the element.
   */
  readonly files: () => Readonly<Record<string, string>>
}

export function testFramework(framework: Framework): void {
  const { name, folder, files } = framework
  const address = `${folder}/dist/index.html`
  const version = () => npmVersion(folder, framework.package)
  testGuest({ name, version, address, build: () => build(folder, files()) })

  test.describe(`${name}, with state`, () => {
    nameHost(name, version)
    test.use({ viewport: { width: 1280, height: 900 } })

    test('comes to life without a warning; what events bring may be given back', async ({ lens, page }) => {
      const warnings: string[] = []
      page.on('console', message => {
        if (message.type() === 'warning' && !/WebGL|GPU/.test(message.text())) warnings.push(message.text())
      })
      await lens.open(address)
      expect(await lens.vertices()).toEqual(documented.vertices)
      await lens.scene.evaluate(scene => scene.scrollIntoView({ block: 'center' }))
      await expectDrag(lens, 6)
      const first = await lens.vertices()
      await expectDrag(lens, 2)
      await page.keyboard.press('Control+z')
      await expect.poll(() => lens.vertices()).toEqual(first)
      await page.keyboard.press('Control+z')
      await expect.poll(() => lens.vertices()).toEqual(documented.vertices)
      await page.keyboard.press('Control+Shift+Z')
      await expect.poll(() => lens.vertices()).toEqual(first)
      expect(warnings).toEqual([])
    })

    test('taken out it leaves nothing behind', async ({ lens, page }) => {
      await lens.open(address)
      const client = await page.context().newCDPSession(page)
      await client.send('Performance.enable')
      const inAndOut = async (times: number) => {
        for (let i = 0; i < times; i++) {
          await lens.button('In and out').click()
          await expect(lens.element).toHaveCount(0)
          await lens.button('In and out').click()
          await expectComplete(lens)
        }
      }
      const measure = async () => {
        await client.send('HeapProfiler.collectGarbage')
        await client.send('HeapProfiler.collectGarbage')
        const { metrics } = await client.send('Performance.getMetrics')
        const value = (name: string) => metrics.find(metric => metric.name === name)?.value as number
        return { nodes: value('Nodes'), listeners: value('JSEventListeners') }
      }
      await inAndOut(6)
      const early = await measure()
      await inAndOut(12)
      // One element has a hundred listeners and a thousand nodes; what is drawn late comes and goes.
      await expect(async () => {
        const late = await measure()
        expect(late.listeners - early.listeners).toBeLessThanOrEqual(20)
        expect(late.nodes - early.nodes).toBeLessThanOrEqual(200)
      }).toPass({ timeout: 60_000 })
    })
  })
}

/** In the frameworks' builds for development, which warn. */
function build(name: string, files: Readonly<Record<string, string>>): void {
  const folder = installed(name)
  const write = (file: string, text: string) => writeFileSync(join(folder, file), text)
  for (const [file, text] of Object.entries(files)) write(file, text)
  write(
    'render.js',
    "import { writeFileSync } from 'node:fs'\nimport { page } from './server/server.js'\nwriteFileSync('page.html', await page)\n",
  )
  const vite = (...words: string[]) => run(folder, 'env', 'NODE_ENV=development', 'vite', 'build', ...words)
  const both = ['--mode', 'development', '--logLevel', 'error', '--base', './']
  vite('--ssr', 'server.js', '--outDir', 'server', ...both)
  run(folder, 'env', 'NODE_ENV=development', 'node', 'render.js')
  const rendered = readFileSync(join(folder, 'page.html'), 'utf8')
  expect(rendered).toContain('<hex-lens')
  write('index.html', html('', `<div id="root">${rendered}</div><script type="module" src="./client.js"></script>`))
  vite('--outDir', 'dist', ...both)
}
