import type { Locator, Page } from '@playwright/test'
import { type Vec3, vertexReference } from '../../web/model/hexahedron'
import { expect, expectAxeFindsNothing, inSchemesAndWidths, type Lens, test } from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
/** An element that is the cube in no direction, so that (x, y, z) and (xi, eta, zeta) differ. */
const wedge = [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 1, 0, 0, 0, 1, 2, 0, 1, 2, 2, 1, 0, 1, 1]

const referenceOf = (page: Page) => page.getByRole('application', { name: /^The reference cube/ })
const toggleOf = (lens: Lens) => lens.button('Reference cube')
const readoutOf = (page: Page) => page.locator('hex-lens .readout')

async function middleOf(locator: Locator): Promise<{ x: number; y: number }> {
  const box = await locator.boundingBox()
  if (box === null) throw new Error('It is not on the page.')
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}

/** Numbers of a text such as "(1/2, −0.25, 1)". */
function numbersOf(text: string): number[] {
  return [...text.replaceAll('−', '-').matchAll(/-?\d+(?:\.\d+)?(?:\/\d+)?/g)].map(([number]) => {
    const [numerator, denominator = 1] = number.split('/').map(Number) as [number, number?]
    return numerator / denominator
  })
}

async function readout(page: Page): Promise<{ jacdet: number; reference: number[]; position: number[] }> {
  const [jacdet = '', reference = '', position = ''] = await readoutOf(page).locator('text').allTextContents()
  const pointOf = (line: string) => numbersOf(line.slice(line.lastIndexOf('(')))
  return {
    jacdet: numbersOf(jacdet.slice(jacdet.indexOf('=')))[0] as number,
    reference: pointOf(reference),
    position: pointOf(position),
  }
}

type Vector = [number, number, number]

/** The trilinear map and its determinant, on their own. */
function mapOf(vertices: readonly number[], point: readonly number[]): { position: Vector; jacdet: number } {
  const at = (p: readonly number[]) =>
    vertices.reduce<Vector>(
      (sum, coordinate, i) => {
        const weights = (vertexReference[Math.floor(i / 3)] as Vec3).map((c, k) => (c ? p[k] : 1 - (p[k] as number)))
        sum[i % 3] = (sum[i % 3] as number) + coordinate * weights.reduce<number>((w, x) => w * (x as number), 1)
        return sum
      },
      [0, 0, 0],
    )
  // The map is linear along each axis, so a difference is a derivative.
  const column = (axis: number): Vector => {
    const from = at(point.with(axis, 0))
    return at(point.with(axis, 1)).map((x, k) => x - (from[k] as number)) as Vector
  }
  const [a, b, c] = [column(0), column(1), column(2)]
  const [bc0, bc1, bc2] = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]]
  return { position: at(point), jacdet: a[0] * bc0 + a[1] * bc1 + a[2] * bc2 }
}

async function expectTrueReadout(lens: Lens): Promise<number[]> {
  const { jacdet, reference, position } = await readout(lens.page)
  const truth = mapOf(await lens.vertices(), reference)
  expect(jacdet).toBeCloseTo(truth.jacdet, 3)
  position.forEach((x, axis) => {
    expect(x).toBeCloseTo(truth.position[axis] as number, 3)
  })
  return reference
}

function pictures(page: Page): Promise<number> {
  return page.locator('hex-lens .scene').evaluate(scene => Number((scene as HTMLElement).dataset.frames))
}

test('what is pointed at, by keyboard or pointer, is marked with its numbers', async ({ lens, page }) => {
  await lens.open()

  await test.step('by keyboard the minimizer comes first, then every candidate, each said once; Escape clears', async () => {
    const report = await lens.element.evaluate(element => {
      const { minimizer, candidates } = (element as HTMLElementTagNameMap['hex-lens']).report as NonNullable<
        HTMLElementTagNameMap['hex-lens']['report']
      >
      return { minimizer, count: new Set(candidates.map(({ point }) => point.join())).size }
    })
    const said = page.locator('hex-lens .scene-pane > .said')
    await lens.scene.focus()
    await page.keyboard.press('p')
    await expect(said).toHaveText(
      /^Minimum, edge 4-7: jacdet -0\.01065\d*, inside out\. xi 0, eta 0\.5909\d*, zeta 1\. x /,
    )
    expect((await readout(page)).jacdet).toBeCloseTo(report.minimizer.value, 4)
    const places = new Set<string>()
    for (let n = 1; n < report.count; n++) {
      await page.keyboard.press('p')
      await expect(said).toHaveText(/^Candidate, /)
      await lens.nextFrame()
      places.add((await readout(page)).reference.join())
      await expectTrueReadout(lens)
    }
    expect(places.size).toBe(report.count - 1)
    await page.keyboard.press('p')
    await expect(said).toHaveText(/^Minimum/)
    await page.keyboard.press('Escape')
    await expect(readoutOf(page)).toBeHidden()
    await expect(said).toBeEmpty()
  })

  await test.step('what is pointed at is marked, with its numbers and columns, and WebGL draws nothing for it', async () => {
    await lens.set(wedge)
    const drawn = await pictures(page)
    const { x, y } = await middleOf(lens.scene)
    await page.mouse.move(x, y)
    await expect(readoutOf(page)).toBeVisible()
    const first = await expectTrueReadout(lens)
    expect(first.some(coordinate => coordinate === 0 || coordinate === 1)).toBe(true)
    const point = await middleOf(page.locator('hex-lens .scene-pane .scene-overlay .probe .point'))
    expect(Math.hypot(point.x - x, point.y - y)).toBeLessThan(2)
    for (const letter of ['ξ', 'η', 'ζ']) {
      await expect(page.locator('hex-lens .scene-pane .probe text', { hasText: letter })).toBeVisible()
    }
    await expect(page.locator('hex-lens .scene-scale .probe')).toBeVisible()

    const bar = await middleOf(page.locator('hex-lens .scene-scale .target'))
    await page.mouse.move(bar.x, bar.y)
    await lens.nextFrame()
    expect(await expectTrueReadout(lens)).not.toEqual(first)
    const mark = await page.locator('hex-lens .scene-scale .probe .line').boundingBox()
    // The bar is horizontal at this width.
    expect(Math.abs((mark?.x ?? 0) + (mark?.width ?? 0) / 2 - bar.x)).toBeLessThan(2)
    await page.mouse.move(x, y)
    await lens.nextFrame()

    await page.mouse.move(x + 30, y + 10)
    await lens.nextFrame()
    expect(await expectTrueReadout(lens)).not.toEqual(first)
    const stage = await lens.scene.boundingBox()
    await page.mouse.move((stage?.x ?? 0) + 20, (stage?.y ?? 0) + (stage?.height ?? 0) / 2)
    await expect(readoutOf(page)).toBeHidden()
    await page.mouse.move(x, y)
    await expect(readoutOf(page)).toBeVisible()
    await page.mouse.move(2, 2)
    await expect(readoutOf(page)).toBeHidden()
    expect(await pictures(page)).toBe(drawn)
  })

  await test.step('a point stays while the view is turned, not while a vertex is dragged', async () => {
    await lens.set(cube)
    const { x, y } = await middleOf(lens.scene)
    await page.mouse.move(x, y)
    const before = await expectTrueReadout(lens)
    await page.mouse.down()
    await page.mouse.move(x + 60, y, { steps: 3 })
    await lens.nextFrame()
    expect(await expectTrueReadout(lens)).toEqual(before)
    await page.mouse.up()

    const handle = await middleOf(page.locator('hex-lens .scene-pane .handle', { hasText: /^6$/ }).locator('.dot'))
    await page.mouse.move(handle.x, handle.y)
    await expect.poll(async () => (await readout(page)).reference).toEqual([1, 1, 1])
    await page.mouse.down()
    await page.mouse.move(handle.x + 10, handle.y - 10, { steps: 2 })
    await expect(readoutOf(page)).toBeHidden()
    await page.mouse.up()
  })
})

test('the reference cube marks the same point, and turns on its own or along', async ({ lens, page }) => {
  await lens.open()

  await test.step('the reference cube marks the same point, in one picture and one context', async () => {
    await lens.set(wedge)
    await lens.scene.focus()
    await page.keyboard.press('r')
    await expect(referenceOf(page)).toBeVisible()
    await expect(toggleOf(lens)).toHaveAttribute('aria-pressed', 'true')
    await expect(page.locator('hex-lens canvas')).toHaveCount(1)
    await lens.nextFrame()
    const drawn = await pictures(page)

    const { x, y } = await middleOf(referenceOf(page))
    await page.mouse.move(x, y)
    await expect(readoutOf(page)).toBeVisible()
    const there = await expectTrueReadout(lens)
    await expect(page.locator('hex-lens .reference .probe .point')).toBeVisible()
    const own = await middleOf(page.locator('hex-lens .scene-pane .scene-overlay .probe .point'))
    expect(await pictures(page)).toBe(drawn)
    await page.mouse.move(own.x, own.y)
    await lens.nextFrame()
    const here = await expectTrueReadout(lens)
    here.forEach((coordinate, axis) => {
      expect(Math.abs(coordinate - (there[axis] as number))).toBeLessThan(0.03)
    })

    await lens.scene.focus()
    await page.keyboard.press('ArrowUp')
    await lens.nextFrame()
    expect(await pictures(page)).toBe(drawn + 1)
    await toggleOf(lens).click()
    await expect(referenceOf(page)).toBeHidden()
  })

  await test.step('each turns on its own, or both together; nothing in the cube moves a vertex', async () => {
    await lens.set(cube)
    await toggleOf(lens).click()
    await expect(referenceOf(page)).toBeVisible()
    await lens.nextFrame()
    const axes = async (part: string) => {
      await lens.nextFrame()
      return page
        .locator(`hex-lens ${part} .triad .axis`)
        .evaluateAll(lines => lines.map(line => line.getAttribute('d')))
    }
    const own = await axes('.scene-pane')
    const fixed = await axes('.reference')
    await referenceOf(page).focus()
    await page.keyboard.press('ArrowRight')
    expect(await axes('.scene-pane')).toEqual(own)
    expect(await axes('.reference')).not.toEqual(fixed)

    await page.getByRole('checkbox', { name: 'Link views' }).check()
    expect(await axes('.reference')).toEqual(await axes('.scene-pane'))
    const { x, y } = await middleOf(referenceOf(page))
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x + 50, y + 20, { steps: 3 })
    await page.mouse.up()
    expect(await axes('.scene-pane')).not.toEqual(own)
    expect(await axes('.reference')).toEqual(await axes('.scene-pane'))
    expect(await lens.vertices()).toEqual(cube)

    await referenceOf(page).focus()
    await page.keyboard.press('p')
    await expect(readoutOf(page)).toBeVisible()
    await page.keyboard.press('r')
    await expect(lens.scene).toBeFocused()
  })
})

test('axe finds nothing beside the reference cube, which fits', async ({ lens, page }) => {
  await lens.open()
  await toggleOf(lens).click()
  await lens.scene.focus()
  await page.keyboard.press('p')
  await inSchemesAndWidths(lens, async () => {
    await expect(readoutOf(page)).toBeVisible()
    await expectAxeFindsNothing(page, '.stage')
    await expect(lens.button('Help')).toBeInViewport({ ratio: 1 })
  })
})
