/** reveal.js, which scales its slides to the window. */
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Page } from '@playwright/test'
import type { Lens } from '../e2e/lens'
import { snippetsOf } from '../package/documentation'
import { expectAxeFindsNothingInElement, expectDocumented, expectDrag } from './guest'
import { expect, hosts, installed, nameHost, npmVersion, onceInRun, putFiles, test } from './host'

const SCRIPT = `<script type="module">
import Reveal from './node_modules/reveal.js/dist/reveal.mjs'
const deck = new Reveal({ width: 960, height: 700, margin: 0, minScale: 0.1, maxScale: 4, transition: 'none' })
await deck.initialize()
globalThis.deck = deck
</script>`

nameHost('reveal.js', () => npmVersion('reveal', 'reveal.js'))

test.beforeAll(async () => {
  test.setTimeout(300_000)
  await onceInRun('reveal.js', () => {
    const folder = installed('reveal')
    const [head, slide] = snippetsOf('Slides') as [string, string]
    const sheets = ['reveal.css', 'theme/white.css'].map(
      name => `<link rel="stylesheet" href="node_modules/reveal.js/dist/${name}">`,
    )
    const slides = ['<section><h2>First</h2></section>', slide, '<section><h2>Last</h2></section>']
    putFiles(folder)
    writeFileSync(
      join(folder, 'index.html'),
      `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Slides</title><link rel="icon" href="data:,">${sheets.join('')}${head}</head><body><div class="reveal"><div class="slides">${slides.join('\n')}</div></div>${SCRIPT}</body></html>`,
    )
  })
})

const slideOf = (page: Page) =>
  page.evaluate(() => (globalThis as unknown as { deck: { getIndices(): { h: number } } }).deck.getIndices().h)

/** Opens the middle slide in a window in which the slides are shown at this scale. */
async function openAt(lens: Lens, scale: number): Promise<void> {
  const { page } = lens
  await page.setViewportSize({ width: 960 * scale, height: 700 * scale })
  await page.goto('reveal/index.html#/1')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await expect(lens.scene).toBeVisible()
  await expect.poll(() => slideOf(page)).toBe(1)
  const shown = () =>
    lens.element.evaluate(element => element.getBoundingClientRect().width / (element as HTMLElement).offsetWidth)
  await expect.poll(shown).toBeCloseTo(scale, 2)
}

for (const scale of [0.5, 1, 2])
  test(`a vertex is dragged on slides at ${scale} times their size`, async ({ lens, page }) => {
    await openAt(lens, scale)
    await expectDocumented(lens)
    await page.screenshot({ path: join(hosts, 'pictures', `reveal.js-${scale}.png`) })
    await expectDrag(lens)
    if (scale === 1) await expectAxeFindsNothingInElement(page)
  })

test('keys that the element uses do not turn the slide, and others do', async ({ lens, page }) => {
  await openAt(lens, 1)
  await lens.scene.focus()
  for (const key of ['ArrowRight', 'ArrowLeft', 'ArrowDown', 'PageDown', 'f', 's', 'p']) {
    await page.keyboard.press(key)
    await lens.nextFrame()
    expect([key, await slideOf(page)]).toEqual([key, 1])
  }
  await expect(lens.scene).toBeFocused()
  expect(await page.evaluate(() => document.fullscreenElement)).toBeNull()
  await page.evaluate(() => (document.activeElement as HTMLElement).blur())
  await page.keyboard.press('ArrowRight')
  await expect.poll(() => slideOf(page)).toBe(2)
})

test('Escape with nothing to take back is the overview of the slides', async ({ lens, page }) => {
  await openAt(lens, 1)
  await lens.scene.focus()
  await page.keyboard.press('Escape')
  await expect(page.locator('.reveal.overview')).toHaveCount(1)
})
