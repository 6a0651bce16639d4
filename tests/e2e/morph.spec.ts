import type { Page } from '@playwright/test'
import { presets, presetVertices } from '../../web/model/presets'
import { elementAt } from '../../web/model/way'
import { expect, expectAxeFindsNothing, inSchemesAndWidths, type Lens, test } from './lens'

const cube = presetVertices(presets.find(({ id }) => id === 'cube') ?? presets[0])
const looksFine = presetVertices(presets[0])
const panelOf = (page: Page) => page.getByRole('region', { name: 'Morph' })
const sliderOf = (page: Page) => page.getByRole('slider', { name: 'Place between A and B' })

/** Opens the way from the unit cube to the first preset. */
async function openMorph(lens: Lens, page: Page): Promise<void> {
  await lens.open()
  await lens.button('Morph').click()
  await expect(panelOf(page)).toContainText('A and B are the same element')
  await lens.preset.selectOption('cube')
  await lens.button('Keep as A').click()
  await lens.preset.selectOption('looks-fine')
  await expect(panelOf(page)).not.toContainText('A and B are the same element')
}

async function shownTau(page: Page, row: string): Promise<number> {
  const text = await page.getByRole('row', { name: row }).textContent()
  return Number(/τ = ([\d.e-]+)/.exec(text ?? '')?.[1])
}

test('between two elements the verdict changes between neighbouring doubles, and a slide is one step to undo', async ({
  lens,
  page,
}) => {
  await openMorph(lens, page)

  await test.step('a slide is one step to undo, by pointer and by keys; preset and start stay', async () => {
    const slider = sliderOf(page)
    await expect(slider).toHaveValue('1')
    await slider.scrollIntoViewIfNeeded()
    const { x, y, width, height } = (await slider.boundingBox()) as {
      x: number
      y: number
      width: number
      height: number
    }
    await page.mouse.move(x + width - 8, y + height / 2)
    await page.mouse.down()
    for (const way of [0.8, 0.6, 0.4, 0.25]) await page.mouse.move(x + width * way, y + height / 2)
    await page.mouse.up()
    await expect(lens.verdict).toHaveText(/^VALID/)
    expect(Number(await slider.inputValue())).toBeLessThan(0.4)
    await lens.button('Undo').click()
    await expect(slider).toHaveValue('1')
    expect(await lens.vertices()).toEqual(looksFine)
    await slider.focus()
    await page.keyboard.press('Home')
    await expect(slider).toHaveValue('0')
    expect(await lens.vertices()).toEqual(cube)
    await page.keyboard.press('ArrowRight')
    await expect(panelOf(page)).toContainText('τ = 0.001')
    await lens.button('Undo').click()
    await expect.poll(() => lens.vertices()).toEqual(cube)
    await lens.button('Reset').click()
    await expect.poll(() => lens.vertices()).toEqual(looksFine)
  })

  await test.step('the last valid and the first invalid are neighbouring doubles', async () => {
    const [valid, invalid] = [await shownTau(page, 'Last valid'), await shownTau(page, 'First invalid')]
    expect(valid).toBeLessThan(invalid)
    expect([valid, invalid]).toContain((valid + invalid) / 2)
    await lens.button('Last valid').click()
    await expect(lens.verdict).toHaveText(/^VALID/)
    expect(await lens.vertices()).toEqual(elementAt(cube, looksFine, valid))
    await expect(lens.button('Last valid')).toHaveAttribute('aria-pressed', 'true')
    await lens.button('First invalid').click()
    await expect(lens.verdict).toHaveText(/^INVALID/)
    expect(await lens.vertices()).toEqual(elementAt(cube, looksFine, invalid))
    await expect(panelOf(page)).toContainText(`τ = ${invalid} invalid`)
    await expect(page.getByRole('img', { name: /^Boundary minimum from A, 1, to B, −/ })).toHaveAccessibleName(
      new RegExp(`the verdict changes at tau ${valid.toFixed(3)}$`),
    )
  })

  await test.step('the ends are kept while the element is elsewhere, and forgotten on request', async () => {
    await sliderOf(page).focus()
    await page.keyboard.press('Home')
    await lens.field(6, 'z').fill('1.5')
    await lens.field(6, 'z').press('Enter')
    await expect(panelOf(page)).toContainText('The element is not on the way from A to B')
    await lens.button('Keep as B').click()
    await expect(panelOf(page)).toContainText('no change of the verdict was found')
    await lens.button('Forget both').click()
    await expect(lens.button('Forget both')).toHaveCount(0)
    await expect(page.getByRole('button', { name: 'First invalid' })).toBeVisible()
  })
})

test('axe finds nothing in the open panel, which fits', async ({ lens, page }) => {
  await openMorph(lens, page)
  await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page, '#panel-morph'))
})
