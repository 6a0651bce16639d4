import type { Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, test } from './lens'

/** The unit cube with vertex 6 past vertex 5: jacdet is -1/2 at vertex 5, 1 at vertex 1. */
const past = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 2, -0.5, 1.5, 0, 1, 1]

const boxOf = (page: Page) => page.locator('hex-lens .scene-pane .volume-box')
const hatchOf = (page: Page) => boxOf(page).locator('.hatch')
const readoutOf = (page: Page) => page.locator('hex-lens .readout text:visible')

/** A point of the edge from vertex 5 to vertex 1 on the screen. */
async function onEdge(page: Page, way: number): Promise<[number, number]> {
  const [from, to] = await Promise.all(
    [5, 1].map(async vertex => {
      const handle = page.locator('hex-lens .scene-pane .handle', { hasText: new RegExp(`^${vertex}$`) })
      const box = await handle.locator('.dot').boundingBox()
      if (box === null) throw new Error('It is not on the page.')
      return [box.x + box.width / 2, box.y + box.height / 2]
    }),
  )
  const between = (k: 0 | 1) => (from?.[k] as number) * (1 - way) + (to?.[k] as number) * way
  return [between(0), between(1)]
}

test('the keyboard has the box said', async ({ lens, page }) => {
  await lens.open()
  await lens.set(past)
  await lens.scene.press('p')
  await expect(page.locator('hex-lens .scene-said')).toHaveText(/^Minimum, vertex 5: jacdet -0\.5, inside out\. xi 1,/)
  await expect(hatchOf(page)).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(boxOf(page)).toBeHidden()
})

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(`in the ${colorScheme} scheme on a screen`, () => {
    test.use({ colorScheme, viewport: { width: 1440, height: 900 } })

    test('the box at a point is inside out and hatched where jacdet is negative, and only there', async ({
      lens,
      page,
    }) => {
      await lens.open()
      await lens.set(past)
      await lens.button('Reference cube').click()
      await expect(boxOf(page)).toBeHidden()

      await page.mouse.move(...(await onEdge(page, 0.02)))
      await expect(readoutOf(page)).toHaveText([/^J = −[\d./]+: inside out$/, /^\(ξ, η, ζ\)/, /^\(x, y, z\)/])
      await expect(hatchOf(page)).toBeVisible()
      await expect(hatchOf(page)).toHaveAttribute('d', /^M/)
      const words = page.locator('hex-lens .scene-pane .probe', { hasText: /volume × −[\d./]+linear image, enlarged/ })
      await expect(words).toHaveCount(1)
      const littleCube = page.locator('hex-lens .reference .volume-box')
      await expect(littleCube.locator('.faces')).toBeVisible()
      await expect(littleCube.locator('.hidden')).toHaveAttribute('d', /^M/)
      await expect(littleCube.locator('.hatch')).toBeHidden()
      await expectAxeFindsNothing(page)

      await page.mouse.move(...(await onEdge(page, 0.8)))
      await expect(readoutOf(page)).toHaveText([/^J = 0\.\d+$/, /^\(ξ, η, ζ\)/, /^\(x, y, z\)/])
      await expect(boxOf(page).locator('.faces')).toBeVisible()
      await expect(hatchOf(page)).toBeHidden()
    })
  })

  test.describe(`in the ${colorScheme} scheme on a phone`, () => {
    test.use({ colorScheme, viewport: { width: 390, height: 844 }, hasTouch: true })

    test('a tap shows the box, inside out and hatched where jacdet is negative', async ({ lens, page }) => {
      await lens.open()
      await lens.set(past)
      await page.touchscreen.tap(...(await onEdge(page, 0.25)))
      await expect(readoutOf(page)).toHaveText([/^J\([^)]*\) = −[\d.]+$/, /^inside out at \(/])
      await expect(hatchOf(page)).toBeVisible()
      await expectAxeFindsNothing(page)
      await page.touchscreen.tap(...(await onEdge(page, 0.7)))
      await expect(readoutOf(page)).toHaveText([/^J\([^)]*\) = 0\.\d+$/, /^at \(/])
      await expect(hatchOf(page)).toBeHidden()
    })
  })
}
