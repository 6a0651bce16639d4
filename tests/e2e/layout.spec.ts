import type { Locator, Page } from '@playwright/test'
import { expect, test } from './lens'

async function boxOf(locator: Locator) {
  const box = await locator.boundingBox()
  if (box === null) throw new Error('Not on the page.')
  return box
}

const overflow = (page: Page) =>
  page.evaluate(() => {
    const { scrollWidth, clientWidth, scrollHeight, clientHeight } = document.documentElement
    return { sideways: scrollWidth - clientWidth, down: scrollHeight - clientHeight }
  })

test('on a desktop the picture is largest, the verdict beside it, and the page does not scroll', async ({
  lens,
  page,
}) => {
  await page.setViewportSize({ width: 1440, height: 900 })
  await lens.open()
  const scene = await boxOf(lens.scene)
  const verdict = await boxOf(lens.verdict)
  expect(scene.width).toBeGreaterThan(900)
  expect(scene.height).toBeGreaterThan(800)
  expect(verdict.x).toBeGreaterThanOrEqual(scene.x + scene.width)
  expect(await overflow(page)).toEqual({ sideways: 0, down: 0 })
})

for (const width of [360, 390, 768]) {
  test(`at ${width} pixels the picture comes first, the verdict under it, the rest below`, async ({ lens, page }) => {
    await page.setViewportSize({ width, height: 844 })
    await lens.open()
    const scene = await boxOf(lens.scene)
    const verdict = await boxOf(lens.verdict)
    const vertices = await boxOf(page.getByRole('group', { name: 'Vertices' }))
    expect(verdict.y).toBeGreaterThanOrEqual(scene.y + scene.height)
    expect(verdict.y).toBeLessThan(844)
    expect(vertices.y).toBeGreaterThanOrEqual(verdict.y + verdict.height)
    expect((await overflow(page)).sideways).toBe(0)
    await expect(lens.preset).toBeInViewport({ ratio: 1 })
    await expect(lens.button('Copy link')).toBeInViewport({ ratio: 1 })
  })
}

test('everything to press is at least 24 pixels each way', async ({ lens, page }) => {
  await lens.open()
  for (const target of await page.locator('hex-lens').locator('button, input, select').all()) {
    if (!(await target.isVisible())) continue
    const box = await boxOf(target)
    expect(Math.min(box.width, box.height), await target.innerText()).toBeGreaterThanOrEqual(24)
  }
})
