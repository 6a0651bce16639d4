import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { readHexahedron } from '../../web/cli/read-hexahedra'
import { readNumber } from '../../web/model/number-text'
import { gallery } from '../../web/pages/gallery/gallery'
import { elementVertices } from '../../web/pages/gallery/gallery-vertices'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, type Lens, test } from './lens'

/** The numbers of elements searched, and of elements found. */
async function counts(page: Page): Promise<[number, number]> {
  const text = (await page.locator('.counts').textContent()) ?? ''
  const [, elements, found] = /^([\d,]+) elements, [\d,]+ a second; ([\d,]+) found$/.exec(text) ?? []
  return [elements, found].map(digits => Number(digits?.replaceAll(',', '') ?? 0)) as [number, number]
}

async function foundMoreThan(page: Page, count: number): Promise<void> {
  await expect.poll(async () => (await counts(page))[1]).toBeGreaterThan(count)
}

test('a search finds, stops, goes on; finds are shown, kept, polished and exported', async ({ lens, page }) => {
  await page.goto('./search.html?find=edges&seed=11')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  const finds = page.getByRole('list', { name: 'Found' }).getByRole('button')
  const kept = page.getByRole('list', { name: 'Kept' })
  const news = page.getByRole('status').and(page.locator('.news'))

  await test.step('the form is one key away, and the address stays', async () => {
    const address = page.url()
    await page.getByRole('link', { name: 'Skip to the search' }).press('Enter')
    await expect(page.locator('#column')).toBeFocused()
    expect(page.url()).toBe(address)
  })

  await test.step('what a property cannot be is said with its place, and is not searched for', async () => {
    const property = page.getByLabel('Property')
    await property.fill('corner_min > 0 and')
    await expect(page.getByText('The condition breaks off')).toBeVisible()
    await expect(page.getByText('At character 19:')).toBeAttached()
    await expect(property).toHaveAttribute('aria-invalid', 'true')
    await expect(page.getByLabel('Find')).toHaveValue('own')
    await expect(lens.button('Start')).toBeDisabled()
    await page.getByLabel('Find').selectOption({ label: 'Edges positive, yet invalid' })
    await expect(property).toHaveValue('edge_min > 0 > boundary_min')
    await page.getByLabel('Sigma').fill('0')
    await expect(page.getByText('Sigma needs a number above 0')).toBeVisible()
    await page.getByLabel('Sigma').fill('0.5')
  })

  await test.step('workers search until they are told to stop, and go on from there', async () => {
    await lens.button('Start').click()
    await foundMoreThan(page, 0)
    await expect(news).toHaveText(/^[\d,]+ found among [\d,]+ elements\.$/)
    await lens.button('Stop').click()
    await expect(news).toHaveText(/^Stopped\. /)
    const stopped = await counts(page)
    await expect(finds.first()).toBeVisible()
    await lens.button('Continue').click()
    await foundMoreThan(page, stopped[1])
    await lens.button('Stop').click()
    await expect(lens.button('Start over')).toBeVisible()
    const [elements] = await counts(page)
    expect(elements % 1024).toBe(0)
    expect(elements).toBeGreaterThan(stopped[0])
  })

  await test.step('a find is one click away from the lens', async () => {
    await page.getByLabel('most extreme first').check()
    await expect(finds.first().getByRole('img')).toHaveAttribute('alt', /^Invalid, minimum −.* on face/)
    await expect(finds.first()).toHaveText(/^\s*0\.\d+\s*$/)
    const before = await lens.bits()
    await finds.first().click()
    await expect.poll(() => lens.bits()).not.toEqual(before)
    await expect(lens.verdict).toContainText('J > 0 at all vertices and on all edges')
    await expect(finds.first()).toHaveAttribute('aria-current', 'true')
    await expect(page.getByText('The element in the lens has the property;')).toBeVisible()
    await page.getByLabel('simplest first').check()
  })

  const found = await lens.bits()
  await test.step('the address has form and element, and a reload what was kept', async () => {
    await lens.button('Keep').click()
    await expect(kept.getByRole('button', { name: /Remove edges-11-\d+/ })).toBeVisible()
    await page.reload()
    await expect(page.getByLabel('Seed')).toHaveValue('11')
    await expect.poll(() => lens.bits()).toEqual(found)
    await expect(lens.verdict).toContainText('J > 0 at all vertices and on all edges')
    await expect(kept.getByRole('img')).toHaveCount(1)
  })

  await test.step('it is polished to something simpler with the same property', async () => {
    await lens.button('Polish').click()
    await expect(kept.getByRole('img')).toHaveCount(2)
    await expect(lens.verdict).toContainText('J > 0 at all vertices and on all edges')
    const simple = await lens.vertices()
    expect(simple.filter(x => x === 0 || x === 1).length).toBeGreaterThan(12)
    expect(simple.every(x => Number.isInteger(Math.round(1e6 * x) / 1e4))).toBe(true)
  })

  await test.step('what is kept goes into a file that the command line reads', async () => {
    const download = page.waitForEvent('download')
    await lens.button('Export what is kept').click()
    const entries: unknown[] = JSON.parse(await readFile(await (await download).path(), 'utf8'))
    const hexahedra = entries.map(readHexahedron)
    expect(hexahedra.map(({ name }) => name)).toEqual([
      expect.stringMatching(/^edges-11-\d+-polished$/),
      expect.stringMatching(/^edges-11-\d+$/),
    ])
    expect(hexahedra[0]?.vertices).toEqual(await lens.vertices())
    const words = new BigUint64Array(Float64Array.from(hexahedra[1]?.vertices ?? []).buffer)
    expect(Array.from(words, String)).toEqual(found)
  })

  await test.step('axe finds nothing, and targets are large enough, in each scheme and width', async () => {
    await page.getByText('What a property can say').click()
    await page.getByText('How sure is that?').click()
    await lens.button('Continue').click()
    await foundMoreThan(page, 0)
    await lens.button('Stop').click()
    await expect(finds.first().getByRole('img')).toHaveAttribute('alt', /Invalid/)
    await inSchemesAndWidths(lens, async () => {
      await expectAxeFindsNothing(page)
      await expectLargeTargets(
        page.locator('.column :is(button, select, input:not([type="radio"]), .law label, summary)'),
      )
    })
  })

  await test.step('where the browser stores nothing, it is said', async () => {
    await page.evaluate(() => {
      Object.defineProperty(globalThis, 'localStorage', {
        get() {
          throw new DOMException('refused', 'SecurityError')
        },
      })
    })
    await kept.getByRole('button', { name: /Remove edges-\d+-\d+$/ }).click()
    await expect(kept.getByRole('img')).toHaveCount(1)
    await expect(page.getByText('This browser stores nothing for this page')).toBeVisible()
  })
})

/** The numbers in the counts, the picture of the first find, and what the form asks for. */
async function searchState(page: Page) {
  return {
    counts: await counts(page),
    first: await page.getByRole('list', { name: 'Found' }).getByRole('img').first().getAttribute('alt'),
    number: await page.getByRole('list', { name: 'Found' }).getByRole('img').count(),
    property: await page.getByLabel('Property').inputValue(),
    seed: await page.getByLabel('Seed').inputValue(),
  }
}

async function searchUntilFound(lens: Lens, page: Page): Promise<void> {
  await lens.button('Start').click()
  await foundMoreThan(page, 12)
  await lens.button('Stop').click()
  await expect(lens.button('Continue')).toBeVisible()
  await expect(page.getByRole('list', { name: 'Found' }).getByRole('img').first()).toHaveAttribute('alt', /nvalid/)
}

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [390, 844],
] as const)
  test(`the first find is seen at once, above the form, at ${width}x${height}`, async ({ lens, page }) => {
    await page.setViewportSize({ width, height })
    await lens.open('./search.html?find=corners&seed=3')
    const first = page.getByRole('list', { name: 'Found' }).getByRole('img').first()
    // Enter in the form starts it, too, from below.
    await page.getByLabel('Property').press('Enter')
    await expect(first).toHaveAttribute('alt', /nvalid/)
    await expect(first).toBeInViewport({ ratio: 1 })
    await expect(lens.button('Stop')).toBeInViewport({ ratio: 1 })
    await lens.button('Stop').click()
    const [find, property] = [await first.boundingBox(), await page.getByLabel('Property').boundingBox()]
    expect(find?.y).toBeLessThan(property?.y ?? 0)
    const covering = await page.locator('hex-lens').boundingBox()
    if (width < 800) expect(find?.y).toBeGreaterThan((covering?.y ?? 0) + (covering?.height ?? 0))
    const isAbove = await first.evaluate(image => {
      const field = document.querySelector('[name="property"]') as Element
      return (image.compareDocumentPosition(field) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0
    })
    expect(isAbove).toBe(true)
  })

for (const address of ['search.html', 'gallery.html'])
  test(`handles do not cover the element on a phone, on ${address}`, async ({ lens, page }) => {
    await page.setViewportSize({ width: 390, height: 844 })
    await lens.open(address)
    const boxes = await page
      .locator('hex-lens .scene-pane .handle .dot, hex-lens .scene-pane .minimizer .ring')
      .evaluateAll(circles => circles.map(circle => circle.getBoundingClientRect().toJSON() as DOMRect))
    expect(boxes.length).toBe(9)
    const width = Math.max(...boxes.map(({ right }) => right)) - Math.min(...boxes.map(({ left }) => left))
    const height = Math.max(...boxes.map(({ bottom }) => bottom)) - Math.min(...boxes.map(({ top }) => top))
    const covered = boxes.reduce((sum, box) => sum + (Math.PI / 4) * box.width * box.height, 0)
    expect(covered / (width * height)).toBeLessThan(0.05)
  })

for (const [walk, width, height] of [
  ['Back, reload and in a second tab', 1440, 900],
  ['Back and reload', 390, 844],
] as const)
  test(`finds, form and scroll are there after ${walk}, at ${width}x${height}`, async ({ lens, page, context }) => {
    await page.setViewportSize({ width, height })
    await lens.open('./search.html?find=corners&seed=4')
    await searchUntilFound(lens, page)
    await page.getByLabel('most extreme first').check()
    await page.getByRole('list', { name: 'Found' }).getByRole('img').nth(1).click()
    await page.getByRole('link', { name: 'Open on the page Lens' }).scrollIntoViewIfNeeded()
    const before = await searchState(page)
    const bits = await lens.bits()
    const scrolled = () => page.evaluate(() => Math.round(scrollY))
    const scroll = await scrolled()
    expect(before.counts[1]).toBeGreaterThan(12)
    const unchanged = async (page: Page) => {
      await expect(page.getByRole('list', { name: 'Found' }).getByRole('img').first()).toHaveAttribute('alt', /nvalid/)
      expect(await searchState(page)).toEqual(before)
      await expect(page.getByLabel('most extreme first')).toBeChecked()
    }

    await page.getByRole('link', { name: 'Open on the page Lens' }).click()
    await expect(lens.preset).toBeVisible()
    await page.goBack()
    await unchanged(page)
    await expect.poll(scrolled).toBe(scroll)
    expect(await lens.bits()).toEqual(bits)
    await page.reload()
    await unchanged(page)
    await expect.poll(scrolled).toBe(scroll)
    if (walk === 'Back and reload') return

    const second = await context.newPage()
    await second.goto('./search.html')
    await unchanged(second)
    await second.getByLabel('Seed').fill('5')
    await expect(second.getByText('These are of the search for')).toBeVisible()
    await second.getByRole('button', { name: 'Start', exact: true }).click()
    await foundMoreThan(second, 0)
    await second.close()
    await page.goto('./gallery.html')
    await page.goto('./search.html')
    await unchanged(page)
    // It goes on where it ended.
    await lens.button('Continue').click()
    await foundMoreThan(page, before.counts[1])
    await page.reload()
    expect((await counts(page))[1]).toBeGreaterThan(before.counts[1])
  })

test('it is said how sure nothing makes one, and that nothing can be kept', async ({ lens, page }) => {
  await lens.open(`./search.html?find=own&property=${encodeURIComponent('valid and centre < 0')}`)
  await page.evaluate(() => {
    sessionStorage.clear()
    Storage.prototype.setItem = () => {
      throw new DOMException('full', 'QuotaExceededError')
    }
  })
  await lens.button('Start').click()
  await expect.poll(async () => (await counts(page))[0]).toBeGreaterThan(20_000)
  await lens.button('Stop').click()
  await expect(page.getByText('This browser has no room left for this page.')).toBeVisible()
  const [elements, found] = await counts(page)
  expect(found).toBe(0)
  const text = (await page.locator('.share').textContent()) ?? ''
  const [, one = ''] = /^At most 1 in ([\d,]+) of the elements of this distribution have the property/.exec(text) ?? []
  const bound = 1 / Number(one.replaceAll(',', ''))
  expect((1 - bound) ** elements).toBeLessThan(0.05)
  expect((1 - bound) ** elements).toBeGreaterThan(0.048)
})

test('a find leads to more extreme ones, until it is stopped', async ({ lens, page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await lens.open('./search.html?find=depth-guard&seed=2')
  await lens.button('Start').click()
  await foundMoreThan(page, 0)
  await lens.button('Stop').click()
  await page.getByLabel('most extreme first').check()
  const find = page.getByRole('list', { name: 'Found' }).getByRole('listitem').first()
  // The first find may be a small one: 9.5×10⁻⁵.
  const numberIn = (text: string | null | undefined) => {
    const read = readNumber(text ?? '')
    if (!read.ok) throw new Error(read.error.message)
    return read.value
  }
  const low = numberIn(await find.locator('.picture').textContent())
  await find.getByRole('button', { name: 'More extreme' }).click()
  await expect(find.getByText(/^[\d.]+(×10\S+)?, [\d,]+ steps?, [\d,]+ tried$/)).toBeVisible()
  const stop = lens.button('Stop climbing').first()
  await expect(stop).toBeFocused()
  await stop.click()
  const sentence = page.getByText(/^Climbed to .* in [\d,]+ steps?, and kept as depth-guard-2-\d+-climbed\.$/)
  await expect(sentence.first()).toBeVisible()
  const [, high] = /to (\S+) in/.exec((await sentence.first().textContent()) ?? '') ?? []
  expect(numberIn(high)).toBeGreaterThan(low)
  await expect(find.getByText(/^[\d.]+(×10\S+)?, [\d,]+ steps?, [\d,]+ tried, kept$/)).toBeVisible()
  await expect(page.getByRole('list', { name: 'Kept' }).getByRole('img')).toHaveCount(1)
  await expect(lens.verdict).toHaveText(/^VALID/)
  await expectAxeFindsNothing(page)
})

test('the gallery shows each element, in the lens too, and leads on', async ({ lens, page }) => {
  const elements = gallery.flatMap(room => room.elements)
  await page.goto('./gallery.html#face-negative-quarter')
  await expect(page.getByText('There is no “face-negative-quarter” in the gallery.')).toBeVisible()
  await page.goto('./gallery.html#face-negative-half')
  await expect(lens.verdict).toContainText('J > 0 at all vertices and on all edges')
  const pictures = page.locator('.gallery [aria-current="true"]')
  await expect(pictures).toHaveText('The same family, further')

  await test.step('every element has a picture in words and colours', async () => {
    const images = page.locator('.gallery img')
    await expect(images).toHaveCount(elements.length)
    await expect(page.locator('.gallery img[src^="data:image/png;base64,"]')).toHaveCount(elements.length)
    const texts = await images.evaluateAll(list => list.map(image => (image as HTMLImageElement).alt))
    expect(texts.every(text => /^(Valid|Invalid), minimum .* on (vertex|edge|face) .*\.$/.test(text))).toBe(true)
    const widths = await images.evaluateAll(list => list.map(image => (image as HTMLImageElement).naturalWidth))
    expect(widths.every(width => width > 0)).toBe(true)
  })

  await test.step('the one that is chosen is in the lens and in the address', async () => {
    for (const id of ['twisted-160', 'beyond-doubles', 'wedge']) {
      const element = elements.find(element => element.id === id)
      if (!element) throw new Error(`There is no ${id}.`)
      await page.getByRole('button', { name: element.title }).click()
      await expect.poll(() => lens.vertices()).toEqual(elementVertices(element))
      await expect(lens.verdict).toHaveText(element.claims[0].startsWith('valid') ? /^VALID/ : /^INVALID/)
      expect(new URL(page.url()).hash).toBe(`#${id}`)
    }
  })

  await test.step('on a phone the element is seen between its handles', async () => {
    const size = page.viewportSize()
    await page.setViewportSize({ width: 390, height: 844 })
    const sizes = () =>
      page.locator('hex-lens .scene-pane .handle .dot').evaluateAll(dots => {
        const boxes = dots.map(dot => (dot as SVGCircleElement).getBBox())
        const tops = dots.map(dot => dot.getBoundingClientRect().top)
        return { widest: Math.max(...boxes.map(({ width }) => width)), height: Math.max(...tops) - Math.min(...tops) }
      })
    await expect.poll(async () => (await sizes()).widest).toBeLessThanOrEqual(8.5)
    await expect.poll(async () => (await sizes()).height).toBeGreaterThan(125)
    if (size) await page.setViewportSize(size)
  })

  await test.step('one that is changed is none of them any more', async () => {
    await lens.set((await lens.vertices()).with(0, 0.125))
    await expect(pictures).toHaveCount(0)
  })

  await test.step('axe finds nothing, and targets are large enough, in each scheme and width', async () => {
    await inSchemesAndWidths(lens, async () => {
      await expectAxeFindsNothing(page)
      await expectLargeTargets(page.locator('.gallery :is(button, a)'))
    })
  })

  await test.step('it opens on the page of the lens', async () => {
    await page.getByRole('link', { name: 'Touches zero on a face on the page Lens' }).click()
    await expect(lens.verdict).toContainText('exactly zero')
    await expect(lens.preset).toBeVisible()
  })
})
