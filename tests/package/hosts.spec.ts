/** The snippets of docs/embedding.md that need no foreign host, with the packed files, in a browser; tests/hosts has the others. */
import { copyFileSync, cpSync, mkdirSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Lens } from '../e2e/lens'
import { documented } from '../unit/embed-fixture'
import { snippetsOf } from './documentation'
import { elsewhere, expect, root, test } from './elsewhere'

test.describe.configure({ mode: 'parallel' })

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
