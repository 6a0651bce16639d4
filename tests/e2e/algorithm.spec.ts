import type { Page } from '@playwright/test'
import { presets, presetVertices } from '../../web/model/presets'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, type Lens, test } from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

async function openPanel({ page }: Lens): Promise<ReturnType<typeof partsOf>> {
  await page.getByRole('button', { name: 'Algorithm 1, step by step', exact: true }).click()
  const parts = partsOf(page)
  await expect(parts.list).toBeVisible()
  return parts
}

function partsOf(page: Page) {
  const panel = page.getByRole('region', { name: 'Algorithm 1, step by step' })
  const list = panel.getByRole('list', { name: 'All steps' })
  return {
    panel,
    list,
    current: list.locator('[aria-current=step]'),
    sentence: panel.locator('.sentence'),
    lit: page.locator('hex-lens .highlight:not([display])'),
  }
}

test('the steps are followed by buttons, by keys, by changes; what runs stops', async ({ lens, page }) => {
  await lens.open()

  await test.step('each step says what it does and lights up its part of the element', async () => {
    await expect(partsOf(page).lit).toHaveCount(0)
    const { panel, list, current, sentence, lit } = await openPanel(lens)
    await expect(list.getByRole('button')).toHaveCount(26)
    await expect(sentence).toHaveText(/^Vertex 0: J\s=\s1\/8, the first value, so M\s=\s1\/8\./)
    await expect(lit).toHaveAttribute('data-part', 'vertex-0')
    await lens.button('Forward').click()
    await expect(current).toHaveText(/Vertex 1/)
    await expect(lit).toHaveAttribute('data-part', 'vertex-1')
    await list.getByRole('button', { name: /^Edge 6–7/ }).click()
    await expect(sentence).toHaveText(/so M becomes −0\.010653\./)
    await expect(lit).toHaveAttribute('data-part', 'edge-6')
    await lens.button('Last').click()
    await expect(sentence).toHaveText(/^Face \+ζ: .*the boundary minimum is −0\.010653\.$/)
    await expect(lit).toHaveAttribute('data-part', 'face-5')
    await expect(panel).toContainText('26 of 26')
    await expect(lens.button('Forward')).toHaveAttribute('aria-disabled', 'true')
    await lens.button('First').click()
    await expect(current).toHaveText(/Vertex 0/)
    await expect(lens.button('Undo')).toBeDisabled()
  })

  await test.step('the arrows walk through the list, which is one stop of Tab', async () => {
    const { list, current } = partsOf(page)
    await expect(list.locator('[tabindex="0"]')).toHaveCount(1)
    await current.focus()
    await page.keyboard.press('End')
    await expect(current).toBeFocused()
    await expect(current).toHaveText(/Face \+ζ/)
    await page.keyboard.press('ArrowUp')
    await expect(current).toHaveText(/Face −ζ/)
    await expect(current).toBeFocused()
    await expect(current).toBeInViewport()
    await page.keyboard.press('Home')
    await expect(current).toHaveText(/Vertex 0/)
  })

  await test.step('closing the panel puts out the light and stops the play', async () => {
    const { panel, current, lit } = partsOf(page)
    await lens.button('Play').click()
    await panel.getByRole('button', { name: 'Algorithm 1, step by step' }).click()
    await expect(lit).toHaveCount(0)
    await lens.page.waitForTimeout(1000)
    await panel.getByRole('button', { name: 'Algorithm 1, step by step' }).click()
    await expect(current).toHaveText(/Vertex 0/)
    await expect(lit).toHaveAttribute('data-part', 'vertex-0')
    await expect(lens.button('Play')).toBeVisible()
  })

  await test.step('the steps follow a change, and the reference cube', async () => {
    const { sentence } = partsOf(page)
    await page.getByRole('button', { name: /\[0,1\]/ }).click()
    await expect(sentence).toHaveText(/^Vertex 0: J\s=\s1\/64/)
    await lens.set(cube)
    await expect(sentence).toHaveText(/^Vertex 0: J\s=\s1\/8/)
  })

  await test.step('either query and either variant can be followed', async () => {
    await lens.set(presetVertices(presets[0]))
    const { panel, list, sentence } = partsOf(page)
    await expect(list.getByText('skipped')).not.toHaveCount(0)
    await panel.getByRole('combobox', { name: 'by' }).selectOption('Roots')
    await expect(list.getByText('skipped')).toHaveCount(0)
    await panel.getByRole('combobox', { name: 'Find' }).selectOption('only whether it is valid')
    await lens.button('Last').click()
    await expect(list.getByRole('button')).toHaveCount(15)
    await expect(sentence).toHaveText(/^Edge 6–7: .* is not positive\. The query stops here: the element is invalid\.$/)
    await lens.set(cube)
    await expect(list.getByRole('button')).toHaveCount(26)
    await lens.button('Last').click()
    await expect(sentence).toHaveText(/Every value is positive: the element is valid\.$/)
  })

  await test.step('there is nothing to play where less motion is asked for', async () => {
    await lens.button('First').click()
    await lens.button('Play').click()
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await expect(lens.button('Pause')).toHaveCount(0)
    await expect(lens.button('Play')).toHaveCount(0)
    await expect(lens.button('Forward')).toBeVisible()
  })
})

test('playing goes on by itself, pauses at the end, and stops when the element changes', async ({ lens, page }) => {
  await page.clock.install()
  await lens.open()
  const { current } = await openPanel(lens)
  // Time passes from here on only when told to, however slow the machine is.
  await page.clock.pauseAt(await page.evaluate(() => Date.now() + 1000))
  await lens.button('Play').click()
  await page.clock.runFor(850)
  await expect(current).toHaveText(/Vertex 1/)
  await page.clock.runFor(850)
  await expect(current).toHaveText(/Vertex 2/)
  await lens.element.evaluate((element, given) => {
    ;(element as HTMLElementTagNameMap['hex-lens']).vertices = given
  }, cube)
  await page.clock.runFor(100)
  await expect(lens.button('Play')).toBeVisible()
  await page.clock.runFor(5000)
  await expect(current).toHaveText(/Vertex 2/)
  await lens.button('Last').click()
  await lens.button('Back').click()
  await page.clock.runFor(100)
  await lens.button('Play').click()
  await page.clock.runFor(2000)
  await expect(current).toHaveText(/Face \+ζ/)
  await expect(lens.button('Play')).toBeVisible()
})

test('axe finds nothing in the open panel, which fits', async ({ lens }) => {
  await lens.open()
  const { panel, list } = await openPanel(lens)
  await inSchemesAndWidths(lens, async () => {
    for (const preset of [presets[0], presets[4] ?? presets[0]]) {
      await lens.set(presetVertices(preset))
      await list.getByRole('button').nth(22).click()
      await expectAxeFindsNothing(lens.page, '#panel-algorithm')
    }
    await expectLargeTargets(panel.getByRole('button'))
  })
})
