import type { Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, inSchemesAndWidths, type Lens, test } from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const panelOf = (page: Page) => page.getByRole('region', { name: 'Inside' })
const mapOf = (page: Page) => page.getByRole('img', { name: /^Map of jacdet on the section/ })

async function openInside(lens: Lens, page: Page, preset?: string): Promise<void> {
  await lens.open()
  if (preset) await lens.preset.selectOption(preset)
  await lens.button('Inside').click()
  await expect(mapOf(page)).toBeVisible()
}

/** How many pixels of a canvas are redder than blue, or bluer than red, by far. */
async function hues(page: Page, selector: string): Promise<{ red: number; blue: number }> {
  return page.locator(`hex-lens ${selector} canvas`).evaluate(element => {
    const canvas = element as HTMLCanvasElement
    const { data } = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(
      0,
      0,
      canvas.width,
      canvas.height,
    )
    let [red, blue] = [0, 0]
    for (let i = 0; i < data.length; i += 4) {
      const [r, b, alpha] = [data[i] as number, data[i + 2] as number, data[i + 3] as number]
      if (alpha > 200 && r > b + 25) red++
      if (alpha > 200 && b > r + 10) blue++
    }
    return { red: red / (data.length / 4), blue: blue / (data.length / 4) }
  })
}

test('what is inside: where it is lower than the boundary, the section, the surface', async ({ lens, page }) => {
  await openInside(lens, page, 'non-strict')

  await test.step('the paper’s counterexample: zero on the boundary, −1/4 at the centre', async () => {
    await lens.preset.selectOption('non-strict')
    const panel = panelOf(page)
    await expect(panel).toContainText('On the boundary the jacdet is never below zero, yet inside it falls to −1/4.')
    const minima = page.getByRole('table', { name: 'Boundary minimum and volume minimum' })
    await expect(minima.getByRole('row', { name: /^On the boundary/ })).toContainText('0')
    await expect(minima.getByRole('row', { name: /^In the whole element −1\/4/ })).toContainText('at (1/2, 1/2, 1/2)')
    expect((await hues(page, '.section-map')).red).toBeGreaterThan(0.5)
    expect((await hues(page, '.surface')).red).toBeGreaterThan(0.1)
    await expect(page.getByRole('img', { name: 'Surface jacdet = 0 in the reference cube' })).toBeVisible()
  })

  await test.step('pointing at the section tells jacdet there, by pointer or keys', async () => {
    await mapOf(page).hover()
    await expect(panelOf(page)).toContainText('J = −1/4 at (1/2, 1/2, 1/2)')
    await page.mouse.move(5, 5)
    await expect(panelOf(page)).not.toContainText('J = −1/4 at')
    await mapOf(page).focus()
    await page.keyboard.press('ArrowRight')
    await expect(panelOf(page)).toContainText(/J = −[\d./]+ at \(9\/16, 1\/2, 1\/2\)/)
    await page.keyboard.press('Escape')
    await expect(panelOf(page)).not.toContainText('at (9/16')
  })

  await test.step('the cube turns by keys and by pointer', async () => {
    const turn = page.getByRole('slider', { name: 'Turn the cube' })
    await turn.focus()
    await page.keyboard.press('ArrowRight')
    await expect(turn).toHaveValue('30')
    const canvas = page.locator('hex-lens .surface canvas')
    await canvas.scrollIntoViewIfNeeded()
    const { x, y, width } = (await canvas.boundingBox()) as { x: number; y: number; width: number }
    await page.mouse.move(x + width / 2, y + 50)
    await page.mouse.down()
    await page.mouse.move(x + width / 4, y + 50)
    await page.mouse.up()
    await expect(turn).toHaveValue('75')
    await expect(lens.button('Undo')).toBeEnabled()
  })

  await test.step('the section slides by keys along any axis, and goes to the minimum', async () => {
    await lens.preset.selectOption('looks-fine')
    await expect(mapOf(page)).toHaveAccessibleName('Map of jacdet on the section ζ = 0.5')
    await page.getByRole('slider', { name: 'Section at ζ' }).focus()
    await page.keyboard.press('ArrowRight')
    await expect(mapOf(page)).toHaveAccessibleName('Map of jacdet on the section ζ = 0.51')
    await expect(panelOf(page)).toContainText('The minimum is not on this section')
    await page.getByRole('radio', { name: 'ζ' }).focus()
    await page.keyboard.press('ArrowLeft')
    await expect(page.getByRole('slider', { name: 'Section at η' })).toHaveValue('0.51')
    const before = (await hues(page, '.section-map')).red
    const go = page.getByRole('button', { name: /^Go to the minimum/ })
    await go.click()
    await expect(go).toBeDisabled()
    await expect(mapOf(page)).toHaveAccessibleName('Map of jacdet on the section η = 0.59091')
    await expect(page.getByRole('slider', { name: 'Section at η' })).toBeFocused()
    expect((await hues(page, '.section-map')).red).toBeGreaterThan(before)
  })

  await test.step('a valid element: the boundary is enough, and the section is shown all the same', async () => {
    await lens.set(cube)
    await expect(panelOf(page)).toContainText('by the theorem nothing inside is lower')
    await expect(panelOf(page)).toContainText('J is zero nowhere inside')
    const { red, blue } = await hues(page, '.section-map')
    expect([red, blue > 0.9]).toEqual([0, true])
  })
})

test('axe finds nothing in the open panel, which fits', async ({ lens, page }) => {
  await openInside(lens, page)
  await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page, '#panel-inside'))
})
