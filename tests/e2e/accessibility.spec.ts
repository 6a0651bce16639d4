import { expect, expectAxeFindsNothing, test } from './lens'

const phone = { width: 390, height: 844 }

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(`in the ${colorScheme} scheme`, () => {
    test.use({ colorScheme })

    test('axe finds nothing, valid or invalid, on a screen or a phone, in the help, where something is wrong', async ({
      lens,
      page,
    }) => {
      await lens.open()
      await test.step('invalid, on a screen', () => expectAxeFindsNothing(page))

      await test.step('valid, on a phone', async () => {
        await lens.set([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1])
        await expect(lens.verdict).toHaveText(/^VALID/)
        await page.setViewportSize(phone)
        await lens.settled()
        await expectAxeFindsNothing(page)
      })

      await test.step('in the help, which fits a small phone', async () => {
        await page.setViewportSize({ width: 360, height: 640 })
        await lens.button('Help').click()
        const help = page.locator('hex-lens .scene-help')
        await expect(help).toBeInViewport({ ratio: 1 })
        await lens.settled()
        const [shown, stage] = [await help.boundingBox(), await lens.scene.boundingBox()]
        expect(shown?.y).toBeGreaterThanOrEqual(stage?.y as number)
        await expectAxeFindsNothing(page)
        await lens.button('Help').click()
      })

      await test.step('where something is wrong', async () => {
        await page.evaluate(() => {
          location.hash = '#v1:broken'
          Object.defineProperty(navigator, 'clipboard', { value: undefined })
        })
        await expect(page.getByRole('alert').filter({ hasText: /link/i })).toBeVisible()
        await lens.button('Copy link').click()
        await lens.field(2, 'y').fill('')
        await expect(page.getByText('Vertex 2 y: A number is missing.')).toBeVisible()
        await expectAxeFindsNothing(page)
      })
    })
  })
}

test.describe('without the core', () => {
  test.use({ expectedErrors: /Failed to load resource/ })

  test('axe finds nothing', async ({ lens, page }) => {
    for (const part of ['**/*.wasm*', '**/*twin*']) await page.route(part, route => route.abort())
    await page.goto('./')
    await expect(lens.verdict).toHaveText(/^NO VERDICT/)
    await expectAxeFindsNothing(page)
  })
})
