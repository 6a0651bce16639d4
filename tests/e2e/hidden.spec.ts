/** Hidden marks look hidden, and one press shows the minimum. */
import type { Locator } from '@playwright/test'
import { presets } from '../../web/model/presets'
import { expect, type Lens, test } from './lens'

/** The unit cube with vertex 6 pushed to (0.3, 0.3, 0.3): invalid, and seen from the front nearly all blue. */
const pushed = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0.3, 0.3, 0.3, 0, 1, 1]
const SIZES = [
  [1440, 900],
  [390, 844],
] as const

test.use({ pictureRatio: 1 })

const handle = (lens: Lens, vertex: number): Locator =>
  lens.page.locator('hex-lens .scene-pane .handle', { hasText: new RegExp(`^${vertex}$`) })
const ring = (lens: Lens): Locator => lens.page.locator('hex-lens .scene-pane .minimizer .ring')

/** Vertices whose handles are dashed. */
async function dashedHandles(lens: Lens): Promise<number[]> {
  const dashes = await lens.page
    .locator('hex-lens .scene-pane .handle')
    .evaluateAll(groups =>
      groups.map(group => [
        group.querySelector('.number')?.textContent,
        getComputedStyle(group.querySelector('.dot') as Element).strokeDasharray,
      ]),
    )
  return dashes.flatMap(([number, dash]) => (dash === 'none' ? [] : [Number(number)])).sort()
}

async function settled(lens: Lens): Promise<void> {
  await expect
    .poll(() => lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).complete))
    .toBe(true)
}

/** The share of clearly red pixels around a place of the picture, in a square of so many pixels. */
async function rednessAround(lens: Lens, mark: Locator, side: number): Promise<number> {
  const box = await mark.boundingBox()
  if (box === null) throw new Error('The mark is not on the page.')
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  return lens.element.evaluate(
    (element, { x, y, side }) => {
      const canvas = (element.shadowRoot as ShadowRoot).querySelector('canvas') as HTMLCanvasElement
      const { left, top, width } = canvas.getBoundingClientRect()
      const ratio = canvas.width / width
      const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height })
      const context = copy.getContext('2d') as CanvasRenderingContext2D
      context.drawImage(canvas, 0, 0)
      const size = Math.round(side * ratio)
      const pixels = context.getImageData((x - left) * ratio - size / 2, (y - top) * ratio - size / 2, size, size).data
      let red = 0
      for (let i = 0; i < pixels.length; i += 4) if ((pixels[i] as number) > (pixels[i + 2] as number) + 30) red++
      return red / (pixels.length / 4)
    },
    { x, y, side },
  )
}

for (const [width, height] of SIZES)
  test(`what faces hide is dashed, and one press shows the minimum, at ${width} x ${height}`, async ({
    lens,
    page,
  }) => {
    // On a phone the button comes when the hint has gone.
    await page.addInitScript(() => localStorage.setItem('hexlens-hint-done', ''))
    await page.setViewportSize({ width, height })
    await lens.open()
    await lens.set(pushed)
    await settled(lens)
    await expect(lens.verdict).toContainText('INVALID')
    expect(await dashedHandles(lens)).toEqual([3, 6])
    await expect(ring(lens)).not.toHaveCSS('stroke-dasharray', 'none')
    expect(await rednessAround(lens, ring(lens), 60)).toBe(0)
    // One looks through the faces: nothing is hidden.
    await lens.scene.press('t')
    await settled(lens)
    expect(await dashedHandles(lens)).toEqual([])
    await expect(ring(lens)).toHaveCSS('stroke-dasharray', 'none')
    await lens.scene.press('t')
    await lens.button('Show the minimum').click()
    await settled(lens)
    await expect(ring(lens)).toHaveCSS('stroke-dasharray', 'none')
    expect(await dashedHandles(lens)).not.toContain(6)
    expect(await rednessAround(lens, ring(lens), 60)).toBeGreaterThan(0.4)
    // Everything is in the picture after the turn.
    const pane = await lens.scene.boundingBox()
    for (let vertex = 0; vertex < 8; vertex++) {
      const box = await handle(lens, vertex).boundingBox()
      expect(box && pane && box.x > pane.x && box.x + box.width < pane.x + pane.width).toBe(true)
    }
  })

test('a key and a method show the minimum too, at once if the reader wants no motion', async ({ lens, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await lens.open()
  await lens.set(pushed)
  await settled(lens)
  const direction = () =>
    lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).state.camera?.direction ?? null)
  expect(await direction()).toBeNull()
  await lens.scene.press('m')
  await lens.nextFrame()
  const shown = await direction()
  // From the side that vertex 6 was pushed in from, (1, 1, 1).
  expect(shown?.reduce((sum, coordinate) => sum + coordinate, 0)).toBeGreaterThan(1)
  await expect(ring(lens)).toHaveCSS('stroke-dasharray', 'none')
  await lens.scene.press('Home')
  await settled(lens)
  await expect(ring(lens)).not.toHaveCSS('stroke-dasharray', 'none')
  await lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).showMinimum())
  await lens.nextFrame()
  expect(await direction()).toEqual(shown)
})

test('a minimum inside is shown by one press on its number, cut open', async ({ lens, page }) => {
  await lens.open()
  await lens.preset.selectOption({ label: 'Zero on the faces, negative inside' })
  await settled(lens)
  const value = page.locator('hex-lens .scene-pane .minimizer .value')
  await expect(value).toHaveText('min J = 0')
  await value.click()
  await settled(lens)
  await expect(value).toHaveText('min J inside = −1/4')
  const { faceDisplay, section } = await lens.element.evaluate(
    element => (element as HTMLElementTagNameMap['hex-lens']).state,
  )
  expect({ faceDisplay, section }).toEqual({ faceDisplay: 'inside', section: { axis: 2, value: 0.5 } })
})

test('a preset that is negative on its faces shows where at first', async ({ lens }) => {
  await lens.open()
  for (const { id, valid } of presets.filter(preset => preset.valid === false)) {
    await lens.element.evaluate((element, preset) => {
      ;(element as HTMLElementTagNameMap['hex-lens']).preset = preset
    }, id)
    await settled(lens)
    const minimum = await lens.element.evaluate(
      element => (element as HTMLElementTagNameMap['hex-lens']).report?.boundaryMinimum ?? 0,
    )
    expect(valid).toBe(false)
    if (minimum < 0) await expect(ring(lens), id).toHaveCSS('stroke-dasharray', 'none')
  }
})

test('Alt draws its grid while it is held, and a handle dragged out of sight comes back', async ({ lens, page }) => {
  await lens.open()
  await lens.preset.selectOption({ label: 'Unit cube' })
  await settled(lens)
  const grid = page.locator('hex-lens .scene-pane .grid')
  const middle = async () => {
    const box = await handle(lens, 6).locator('.dot').boundingBox()
    if (box === null) throw new Error('Vertex 6 has no handle.')
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
  }
  const from = await middle()
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.keyboard.down('Alt')
  await page.mouse.move(from.x - 40, from.y + 30, { steps: 3 })
  await expect(grid).toBeVisible()
  await page.keyboard.up('Alt')
  await expect(grid).toBeHidden()
  const pane = await lens.scene.boundingBox()
  if (pane === null) throw new Error('The scene has no box.')
  const outside = { x: pane.x + pane.width + 150, y: from.y }
  await page.mouse.move(outside.x, outside.y, { steps: 3 })
  // While the button is down nothing moves under the pointer.
  await expect.poll(async () => Math.abs((await middle()).x - outside.x)).toBeLessThan(3)
  await page.mouse.up()
  await expect.poll(async () => (await middle()).x).toBeLessThan(pane.x + pane.width)
})

test('numbers of vertices lie on no other number and on no other handle', async ({ lens, page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await lens.open()
  await lens.set(pushed)
  await settled(lens)
  for (const key of ['m', 'a', 'w', 'd', 'd', 's', 'd']) {
    await lens.scene.press(key)
    await settled(lens)
    const overlaps = await lens.page.locator('hex-lens .scene-pane .handle').evaluateAll(groups => {
      const boxes = groups.map(group => ({
        number: (group.querySelector('.number') as SVGTextElement).getBBox(),
        own: (group as SVGGElement).transform.baseVal.getItem(0).matrix,
        text: group.textContent,
      }))
      const at = ({ number, own }: (typeof boxes)[number]) => ({
        x: own.e + number.x + number.width / 2,
        y: own.f + number.y + number.height / 2,
      })
      return boxes.flatMap((one, i) =>
        boxes.flatMap((other, j) => {
          if (i === j || one.text === '' || other.text === '') return []
          const [a, b] = [at(one), at(other)]
          const isOnNumber = Math.hypot(a.x - b.x, a.y - b.y) < 11
          const isOnHandle = Math.hypot(a.x - other.own.e, a.y - other.own.f) < 9
          return isOnNumber || isOnHandle ? [`${one.text} on ${other.text}`] : []
        }),
      )
    })
    expect(overlaps, `after ${key}`).toEqual([])
  }
})
