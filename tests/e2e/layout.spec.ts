import type { Locator } from '@playwright/test'
import { expect, expectLargeTargets, sidewaysOverflow, test } from './lens'

async function boxOf(locator: Locator) {
  const box = await locator.boundingBox()
  if (box === null) throw new Error('Not on the page.')
  return box
}

test('the picture is largest, the verdict in view, and nothing scrolls sideways', async ({ lens, page }) => {
  await page.setViewportSize({ width: 1440, height: 900 })
  await lens.open()

  await test.step('on a desktop the verdict is beside the picture, and the page does not scroll', async () => {
    const scene = await boxOf(lens.scene)
    const verdict = await boxOf(lens.verdict)
    expect(scene.width).toBeGreaterThan(900)
    expect(scene.height).toBeGreaterThan(800)
    expect(verdict.x).toBeGreaterThanOrEqual(scene.x + scene.width)
    expect(await sidewaysOverflow(page)).toBe(0)
    const down = await page.evaluate(() => {
      const { scrollHeight, clientHeight } = document.documentElement
      return scrollHeight - clientHeight
    })
    expect(down).toBe(0)
  })

  for (const width of [360, 390, 768])
    await test.step(`at ${width} pixels the picture comes first, the verdict under it, the rest below`, async () => {
      await page.setViewportSize({ width, height: 844 })
      await lens.nextFrame()
      const scene = await boxOf(lens.scene)
      const verdict = await boxOf(lens.verdict)
      const vertices = await boxOf(page.getByRole('group', { name: 'Vertices' }))
      expect(verdict.y).toBeGreaterThanOrEqual(scene.y + scene.height)
      expect(verdict.y).toBeLessThan(844)
      expect(vertices.y).toBeGreaterThanOrEqual(verdict.y + verdict.height)
      expect(await sidewaysOverflow(page)).toBe(0)
      await expect(lens.preset).toBeInViewport({ ratio: 1 })
      await expect(lens.button('Copy link')).toBeInViewport({ ratio: 1 })
    })

  await test.step('everything to press is at least 24 pixels each way', async () => {
    await page.setViewportSize({ width: 960, height: 640 })
    await lens.nextFrame()
    await expectLargeTargets(lens.element.locator('button, input, select'))
  })
})
