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
  await expect(panelOf(page)).toContainText('the box around the element')
  await lens.preset.selectOption('cube')
  await lens.button('Keep as A').click()
  await lens.preset.selectOption('looks-fine')
  await expect(panelOf(page)).toContainText('kept')
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

test('it starts between two different elements, and plays when it is asked to', async ({ lens, page }) => {
  await lens.open()
  await lens.button('Morph').click()
  const panel = panelOf(page)

  await test.step('from the box around the element, which the verdict shows, to the element', async () => {
    await expect(panel).toContainText('the box around the element')
    await expect(panel).toContainText('the element as it is')
    await expect(page.getByRole('button', { name: 'First invalid' })).toBeVisible()
    await expect(sliderOf(page)).toHaveValue('1')
    for (let frame = 0; frame < 10; frame++) await lens.nextFrame()
    expect(await lens.vertices()).toEqual(looksFine)
  })

  await test.step('a cube is its own box: it goes to one with a vertex pushed in', async () => {
    await lens.preset.selectOption('cube')
    await expect(panel).toContainText('the element with vertex 6 pushed in')
    await expect(page.getByRole('button', { name: 'First invalid' })).toBeVisible()
    await expect(sliderOf(page)).toHaveValue('0')
  })

  await test.step('played it comes to B by itself, as one step to undo', async () => {
    await lens.button('Play').click()
    await expect(lens.button('Pause')).toBeVisible()
    await expect(sliderOf(page)).toHaveValue('1')
    await expect(lens.button('Play')).toBeVisible()
    await expect(lens.verdict).toHaveText(/^INVALID/)
    expect((await lens.vertices()).slice(18, 21)).toEqual([0.25, 0.25, 0.25])
    await lens.button('Undo').click()
    await expect.poll(() => lens.vertices()).toEqual(cube)
  })

  await test.step('it pauses where it is; Escape takes it back; who moves the element ends it', async () => {
    const between = /^0\.[0-9]+$/
    await lens.button('Play').click()
    await expect(sliderOf(page)).toHaveValue(between)
    await lens.button('Pause').click()
    await expect(lens.button('Play')).toBeVisible()
    await lens.nextFrame()
    const paused = await sliderOf(page).inputValue()
    for (let frame = 0; frame < 10; frame++) await lens.nextFrame()
    await expect(sliderOf(page)).toHaveValue(paused)
    await lens.button('Play').click()
    await page.keyboard.press('Escape')
    await expect(sliderOf(page)).toHaveValue(paused)
    await lens.button('Play').click()
    await expect(lens.button('Pause')).toBeVisible()
    await lens.set(looksFine)
    await expect(lens.button('Play')).toBeVisible()
    expect(await lens.vertices()).toEqual(looksFine)
  })

  await test.step('who wants little motion sees eight places', async () => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await sliderOf(page).focus()
    await page.keyboard.press('Home')
    const seen = new Set<number>()
    await page.exposeFunction('sawPlace', (place: number) => seen.add(place))
    await lens.element.evaluate(element => {
      element.addEventListener('hex-input', () => {
        const slider = (element.shadowRoot as ShadowRoot).querySelector<HTMLInputElement>('.morph [type=range]')
        requestAnimationFrame(() =>
          (globalThis as unknown as { sawPlace(place: number): void }).sawPlace(Number(slider?.value)),
        )
      })
    })
    await lens.button('Play').click()
    await expect(sliderOf(page)).toHaveValue('1')
    await expect.poll(() => seen.has(1)).toBe(true)
    for (const place of seen) expect(8 * place).toBe(Math.round(8 * place))
  })
})

test('axe finds nothing in the open panel, which fits', async ({ lens, page }) => {
  await openMorph(lens, page)
  await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page, '#panel-morph'))
})
