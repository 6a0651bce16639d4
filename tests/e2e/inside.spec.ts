import type { Locator, Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, inSchemesAndWidths, type Lens, test } from './lens'

// Room for the reference cube beside the element.
test.use({ pictureRatio: 1, viewport: { width: 1100, height: 640 } })

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const panelOf = (page: Page) => page.getByRole('region', { name: 'Inside' })
const mapOf = (page: Page) => page.getByRole('img', { name: /^Map of jacdet on the section/ })

async function openInside(lens: Lens, page: Page, preset?: string): Promise<void> {
  await lens.open()
  if (preset) await lens.preset.selectOption(preset)
  await lens.button('Inside').click()
  await expect(mapOf(page)).toBeVisible()
}

/** The shares of a picture's pixels that are far redder than blue, and far bluer than red. */
async function hues(page: Page, pane: Locator): Promise<{ red: number; blue: number }> {
  const picture = (await pane.screenshot()).toString('base64')
  return page.evaluate(async base64 => {
    const image = Object.assign(new Image(), { src: `data:image/png;base64,${base64}` })
    await image.decode()
    const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height })
    const context = canvas.getContext('2d') as CanvasRenderingContext2D
    context.drawImage(image, 0, 0)
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height)
    let [red, blue] = [0, 0]
    for (let i = 0; i < data.length; i += 4) {
      const [r, b] = [data[i] as number, data[i + 2] as number]
      if (r > b + 25) red++
      if (b > r + 10) blue++
    }
    return { red: red / (data.length / 4), blue: blue / (data.length / 4) }
  }, picture)
}

const referenceOf = (page: Page) => page.getByRole('application', { name: /^The reference cube/ })

test('what is inside: where it is lower than the boundary, the section, in space', async ({ lens, page }) => {
  await openInside(lens, page, 'non-strict')

  await test.step('the paper’s counterexample: zero on the boundary, −1/4 at the centre, and what is negative in space', async () => {
    const panel = panelOf(page)
    await expect(panel).toContainText('J ≥ 0 on the boundary, yet inside it falls to −1/4.')
    const minima = page.getByRole('table', { name: 'Boundary minimum and volume minimum' })
    await expect(minima.getByRole('row', { name: /^On the boundary/ })).toContainText('0')
    await expect(minima.getByRole('row', { name: /^In the whole element −1\/4/ })).toContainText('at (1/2, 1/2, 1/2)')
    await expect(panel).toContainText('Red: the surface J = 0')
    await expect(lens.scene).toContainText('min J inside = −1/4')
    await expect(page.getByRole('img', { name: /^Colours of jacdet: maximum 1, zero, minimum −1\/4/ })).toBeVisible()
    expect((await hues(page, mapOf(page))).red).toBeGreaterThan(0.5)
    const inElement = await hues(page, lens.scene)
    expect(inElement.red).toBeGreaterThan(0.02)
    await page.getByRole('checkbox', { name: 'and in the reference cube' }).check()
    await expect(referenceOf(page)).toBeVisible()
    const inCube = await hues(page, referenceOf(page))
    expect(inCube.red).toBeGreaterThan(0.02)
    // The section cuts away what it hides: less of the surface is left the lower it lies.
    await page.getByRole('slider', { name: 'Section at ζ' }).fill('0.1')
    await lens.nextFrame()
    expect((await hues(page, referenceOf(page))).red).toBeLessThan(0.7 * inCube.red)
    await page.getByRole('slider', { name: 'Section at ζ' }).fill('0.5')
  })

  await test.step('it is shown in the scene with its panel, by a choice, a box and a key', async () => {
    const shown = page.getByRole('combobox', { name: 'Faces shown' })
    const box = page.getByRole('checkbox', { name: 'in the element' })
    await expect(shown).toHaveValue('inside')
    await box.uncheck()
    await expect(shown).toHaveValue('opaque')
    await expect(lens.scene).toContainText('min J = 0')
    await lens.scene.focus()
    await page.keyboard.press('i')
    await expect(box).toBeChecked()
    // Pointing at the section where it is in space marks the same point on its map.
    const { x, y, width, height } = (await referenceOf(page).boundingBox()) as {
      x: number
      y: number
      width: number
      height: number
    }
    await page.mouse.move(x + width / 2, y + height / 2)
    await expect(panelOf(page)).toContainText(/J = −[\d.]+ at \([\d./]+, [\d./]+, 1\/2\)/)
    await lens.button('Inside').click()
    await expect(shown).toHaveValue('opaque')
    await lens.button('Inside').click()
    await expect(shown).toHaveValue('inside')
    await page.getByRole('checkbox', { name: 'and in the reference cube' }).uncheck()
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
    const before = (await hues(page, mapOf(page))).red
    const go = page.getByRole('button', { name: /^Go to the minimum/ })
    await go.click()
    await expect(go).toBeDisabled()
    await expect(mapOf(page)).toHaveAccessibleName('Map of jacdet on the section η = 0.59091')
    await expect(page.getByRole('slider', { name: 'Section at η' })).toBeFocused()
    expect((await hues(page, mapOf(page))).red).toBeGreaterThan(before)
  })

  await test.step('a valid element: the boundary is enough, and the section is shown all the same', async () => {
    await lens.set(cube)
    await expect(panelOf(page)).toContainText('By the theorem nothing inside is lower')
    await expect(panelOf(page)).toContainText('J is zero nowhere inside')
    const { red, blue } = await hues(page, mapOf(page).locator('canvas'))
    expect([red, blue > 0.9]).toEqual([0, true])
    expect((await hues(page, lens.scene)).red).toBe(0)
  })
})

test('axe finds nothing in the open panel, which fits', async ({ lens, page }) => {
  await openInside(lens, page)
  await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page, '#panel-inside'))
})
