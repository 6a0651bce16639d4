/** The element's box in places of all kinds, and what has its room in it. */
import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { documented } from '../unit/embed-fixture'
import { expect, expectAxeFindsNothing, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

/** Puts an element into a place, with the styles of both, in the page's stead. */
async function put(page: Page, place: string, style: string, views = 'scene verdict'): Promise<void> {
  await page.evaluate(
    ([place, style, views, vertices]) => {
      for (const sheet of document.querySelectorAll('link[rel=stylesheet]')) sheet.remove()
      const lens = Object.assign(document.createElement('hex-lens'), { views, vertices })
      lens.style.cssText = style as string
      const box = document.createElement('div')
      box.style.cssText = place as string
      const words = document.createElement('p')
      words.textContent = 'Words of the page, which want their room as well. '.repeat(4)
      box.append(lens, words)
      document.body.replaceChildren(box)
    },
    [place, style, views, documented.vertices] as const,
  )
  await expect.poll(() => page.locator('hex-lens').evaluate(lens => (lens as Element).complete)).toBe(true)
}

const measured = (page: Page) =>
  page.locator('hex-lens').evaluate(lens => {
    const root = lens.shadowRoot as ShadowRoot
    const part = (name: string) => root.querySelector(`[part~=${name}]`) as HTMLElement
    const handles = [...root.querySelectorAll('.scene-pane .handle .dot')].map(dot => dot.getBoundingClientRect())
    const covered = handles.filter(({ x, y, width, height }) =>
      root.elementFromPoint(x + width / 2, y + height / 2)?.closest('button, select, .scene-scale'),
    )
    const span = (of: (box: DOMRect) => number) => Math.max(...handles.map(of)) - Math.min(...handles.map(of))
    return {
      width: lens.clientWidth,
      height: lens.clientHeight,
      place: (lens.parentElement as HTMLElement).clientWidth,
      picture: part('stage').clientHeight,
      element: Math.max(
        span(({ x }) => x),
        span(({ y }) => y),
      ),
      covered: covered.length,
      scrolls: [lens, part('lens'), part('panels'), ...root.querySelectorAll('.panel')].filter(
        ({ scrollHeight, clientHeight, scrollWidth, clientWidth }) =>
          scrollHeight > clientHeight + 1 || scrollWidth > clientWidth + 1,
      ).length,
    }
  })

test('what Copy embed writes has most of its box for the picture, and grows by what is opened', async ({
  lens,
  page,
}) => {
  await page.setViewportSize({ width: 1000, height: 1200 })
  await lens.open()
  const snippet = readFileSync('docs/embedding.md', 'utf8')
  const style = snippet.match(/^ {2}style="(.*)"$/m)?.[1] ?? ''
  expect(style).toContain(`${documented.height}px`)
  await put(page, 'margin: auto', style, documented.views.join(' '))
  const box = page.locator('hex-lens').locator('..')
  for (const width of [320, 480, 640, 760, 900]) {
    await box.evaluate((element, width) => {
      element.style.width = `${width}px`
    }, width)
    await expect.poll(async () => (await measured(page)).width).toBe(width)
    await lens.settled()
    const { height, picture, element, covered, scrolls } = await measured(page)
    expect(height).toBeGreaterThanOrEqual(documented.height)
    expect(picture).toBeGreaterThan(height / 2)
    expect(element).toBeGreaterThan(width > 600 ? 250 : 150)
    expect({ covered, scrolls }).toEqual({ covered: 0, scrolls: 0 })
    if (width > 800) continue
    const checks = page.getByText('Who would notice?')
    await expect(checks).toBeHidden()
    await lens.button('Details').click()
    await expect(checks).toBeVisible()
    await lens.settled()
    const open = await measured(page)
    expect(open.picture).toBe(picture)
    expect([open.height > height + 200, open.scrolls]).toEqual([true, 0])
    if (width === 320) await expectAxeFindsNothing(page, '.lens')
    await lens.button('Details').click()
    await expect.poll(async () => (await measured(page)).height).toBe(height)
  }
})

test('the box has a width and a height in any place', async ({ lens, page }) => {
  await page.setViewportSize({ width: 800, height: 900 })
  await lens.open()
  const places = [
    { place: 'display: block', style: '', width: 500, height: 375 },
    { place: 'display: flex', style: '', width: [280, 420] },
    { place: 'display: flex', style: 'height: 400px', width: [280, 420], height: 400 },
    { place: 'display: flex', style: 'flex: 1' },
    { place: 'display: flex; flex-direction: column; align-items: flex-start', style: '', width: 500, height: 375 },
    { place: 'display: flex; flex-direction: column; height: 700px', style: 'flex: 1', width: 500 },
    { place: 'display: grid', style: '', width: 500, height: 375 },
    { place: 'display: grid; grid-template-columns: auto 1fr', style: '', width: [280, 500] },
    { place: '', style: 'float: left', width: 500, height: 375 },
    { place: '', style: 'float: left; height: 420px', width: 500, height: 420 },
    { place: '', style: 'display: inline-block; height: 420px', width: 500, height: 420 },
    { place: '', style: 'display: table-cell', width: [280, 500] },
    { place: '', style: 'display: inline-block; max-width: 300px', width: 300, height: 352 },
    { place: 'position: relative', style: 'position: absolute', width: 500, height: 375 },
    { place: '', style: 'aspect-ratio: 1', width: 500, height: 500 },
    { place: '', style: '--hl-aspect-ratio: 5 / 4', width: 500, height: 400 },
    { place: 'writing-mode: vertical-rl; height: 500px', style: '', width: [280, 560] },
    { place: '', style: 'writing-mode: vertical-rl', width: 500, height: 375 },
  ] as const
  for (const { place, style, ...expected } of places)
    await test.step(`${place} | ${style}`, async () => {
      await put(page, `width: 500px; ${place}`, style)
      const { width, height, picture, covered, scrolls, ...rest } = await measured(page)
      const [least, most] = 'width' in expected ? [expected.width].flat() : [280]
      expect(width).toBeGreaterThanOrEqual(least as number)
      expect(width).toBeLessThanOrEqual(most ?? (least as number))
      if ('height' in expected) expect(height).toBe(expected.height)
      expect(picture).toBeGreaterThan(height / 2)
      expect({ covered, scrolls }).toEqual({ covered: 0, scrolls: 0 })
      expect(width).toBeLessThanOrEqual(Math.max(rest.place, 500))
    })
})
