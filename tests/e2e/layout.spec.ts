import type { Locator } from '@playwright/test'
import { expect, expectLargeTargets, expectNoSidewaysOverflow, test } from './lens'

async function boxOf(locator: Locator) {
  const box = await locator.boundingBox()
  if (box === null) throw new Error('Not on the page.')
  return box
}

test('the picture is largest, the verdict in view, and nothing scrolls sideways', async ({ lens, page }) => {
  await page.setViewportSize({ width: 1440, height: 900 })
  await lens.open()
  await lens.settled()

  await test.step('on a desktop the verdict is beside the picture, and the page does not scroll', async () => {
    const scene = await boxOf(lens.scene)
    const verdict = await boxOf(lens.verdict)
    expect(scene.width).toBeGreaterThan(900)
    expect(scene.height).toBeGreaterThan(800)
    expect(verdict.x).toBeGreaterThanOrEqual(scene.x + scene.width)
    await expectNoSidewaysOverflow(page)
    const down = await page.evaluate(() => {
      const { scrollHeight, clientHeight } = document.documentElement
      return scrollHeight - clientHeight
    })
    expect(down).toBe(0)
  })

  for (const width of [360, 390, 768])
    await test.step(`at ${width} pixels the picture comes first, the verdict under it, the rest below`, async () => {
      await page.setViewportSize({ width, height: 844 })
      await lens.settled()
      const scene = await boxOf(lens.scene)
      const verdict = await boxOf(lens.verdict)
      const vertices = await boxOf(page.getByRole('group', { name: 'Vertices' }))
      expect(verdict.y).toBeGreaterThanOrEqual(scene.y + scene.height)
      expect(verdict.y).toBeLessThan(844)
      expect(vertices.y).toBeGreaterThanOrEqual(verdict.y + verdict.height)
      await expectNoSidewaysOverflow(page)
      await expect(lens.preset).toBeInViewport({ ratio: 1 })
      await expect(lens.button('Copy link')).toBeInViewport({ ratio: 1 })
    })

  await test.step('everything to press is at least 24 pixels each way', async () => {
    await page.setViewportSize({ width: 960, height: 640 })
    await lens.settled()
    await expectLargeTargets(lens.element.locator('button, input, select'))
  })
})

test('on a large screen what is opened stands beside the verdict, and all is larger', async ({ lens, page }) => {
  await page.setViewportSize({ width: 2560, height: 1440 })
  await lens.open()
  await lens.button('Algorithm 1, step by step').click()
  const panel = page.getByRole('region', { name: 'Algorithm 1, step by step' })
  await expect(panel.getByRole('list', { name: 'All steps' })).toBeVisible()
  await lens.settled()
  const [scene, verdict, opened] = [await boxOf(lens.scene), await boxOf(lens.verdict), await boxOf(panel)]
  expect(verdict.x).toBeGreaterThanOrEqual(scene.x + scene.width)
  expect(opened.x).toBeGreaterThanOrEqual(verdict.x + verdict.width)
  expect(scene.width).toBeGreaterThan(verdict.width + opened.width)
  await expectNoSidewaysOverflow(page)
  const sizeOf = (selector: string) =>
    page
      .locator(`hex-lens ${selector}`)
      .first()
      .evaluate(element => Number.parseFloat(getComputedStyle(element).fontSize))
  expect(await sizeOf('.checks td')).toBeGreaterThan(14)
  // Marks and words in the scene as well: its handles are 12 units wide, and dragging follows the pointer.
  const handle = await boxOf(page.locator('hex-lens .handle .dot').first())
  expect(handle.width).toBeGreaterThan(13)
  const before = await lens.vertices()
  await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2)
  await page.mouse.down()
  await page.mouse.move(handle.x + handle.width / 2 + 40, handle.y + handle.height / 2 - 30, { steps: 2 })
  await lens.nextFrame()
  const after = await boxOf(page.locator('hex-lens .handle.selected .dot'))
  await page.mouse.up()
  expect(await lens.vertices()).not.toEqual(before)
  expect(after.x - handle.x).toBeCloseTo(40, -1)
  expect(after.y - handle.y).toBeCloseTo(-30, -1)
})
