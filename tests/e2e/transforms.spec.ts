/** The element under transforms and zoom of its host: what a pointer does at a place of it is the same under all of them. */
import type { Locator, Page } from '@playwright/test'
import { expect, handleOf, type Point, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

const hosts: Readonly<Record<string, string>> = {
  none: '',
  'half the size': 'transform: scale(0.5)',
  'twice the size, as slides are': 'transform: scale(2)',
  turned: 'transform: rotate(-30deg)',
  'sheared and in a corner': 'transform: skew(15deg, 5deg) scale(0.9)',
  zoomed: 'zoom: 1.5',
  'in perspective': 'transform: perspective(900px) rotateY(35deg)',
}

/** Where shares of a box's width and height are on the page. */
function seenAt(box: Locator, x: number, y: number): Promise<Point> {
  return box.evaluate(
    (element, [left, top]) => {
      const mark = document.createElement('span')
      mark.style.cssText = `position: absolute; left: ${100 * left}%; top: ${100 * top}%`
      element.append(mark)
      const { x, y } = mark.getBoundingClientRect()
      mark.remove()
      return { x, y }
    },
    [x, y] as const,
  )
}

async function settled(page: Page): Promise<void> {
  const lens = page.locator('hex-lens')
  await expect.poll(() => lens.evaluate(element => (element as Element).complete)).toBe(true)
}

test('a pointer does the same under any transform, perspective or zoom, and while it changes', async ({
  lens,
  page,
}) => {
  await page.setViewportSize({ width: 1800, height: 1000 })
  await page.goto('./')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await page.evaluate(() => {
    for (const sheet of document.querySelectorAll('link[rel=stylesheet]')) sheet.remove()
    const fresh = Object.assign(document.createElement('hex-lens'), { views: 'scene face-maps inside' })
    fresh.style.cssText = '--hl-aspect-ratio: auto; --hl-stage-height: 420px'
    const host = Object.assign(document.createElement('div'), { id: 'host' })
    host.append(fresh)
    document.body.replaceChildren(host)
  })
  const host = page.locator('#host')
  const dress = async (style: string) => {
    await host.evaluate((element, css) => {
      element.style.cssText = `position: absolute; left: 1000px; top: 200px; width: 640px; transform-origin: top; ${css}`
    }, style)
    await lens.element.evaluate(element => {
      ;(element as Element).preset = 'cube'
      ;(element as Element).preset = 'looks-fine'
    })
    await page.mouse.move(1, 1)
    await lens.scene.evaluate(scene => scene.scrollIntoView({ block: 'center', inline: 'center' }))
    await settled(page)
  }
  const state = () => lens.element.evaluate(element => (element as Element).state)
  await dress('')
  for (const name of ['Face maps', 'Inside']) await lens.button(name).click()
  await settled(page)

  /** All that pointing leads to, in numbers. */
  const pointed = async (): Promise<number[]> => {
    const probed = async (box: Locator, x: number, y: number) => {
      // What was pointed at before has more words.
      await page.mouse.move(1, 1)
      await settled(page)
      await box.evaluate(element => element.scrollIntoView({ block: 'center', inline: 'center' }))
      const at = await seenAt(box, x, y)
      await page.mouse.move(at.x, at.y)
      await lens.nextFrame()
      await expect(page.locator('hex-lens .scene-pane .readout')).toBeVisible()
      const readout = await page.locator('hex-lens .scene-pane .readout').textContent()
      const texts = (readout?.match(/\(ξ, η, ζ\) = \(([^)]*)\)/)?.[1] ?? '').split(', ')
      return texts.map(text =>
        text
          .split('/')
          .map(Number)
          .reduce((numerator, denominator) => numerator / denominator),
      )
    }
    const places = [
      ...(await probed(lens.scene, 0.45, 0.4)),
      ...(await probed(page.locator('hex-lens .scene-scale .bar'), 0.93, 0.4)),
      ...(await probed(page.locator('hex-lens .face-map').first(), 0.2, 0.7)),
      ...(await probed(page.locator('hex-lens .plot').nth(2), 0.7, 0.4)),
      ...(await probed(page.locator('hex-lens .section-map'), 0.2, 0.7)),
    ]
    expect(places).toHaveLength(15)
    await lens.scene.evaluate(scene => scene.scrollIntoView({ block: 'center', inline: 'center' }))
    const hand = async (x: number, y: number) => {
      const at = await seenAt(lens.scene, x, y)
      await page.mouse.move(at.x, at.y)
    }
    await hand(0.05, 0.5)
    await page.mouse.down()
    await hand(0.12, 0.55)
    await hand(0.15, 0.45)
    await page.mouse.up()
    await hand(0.3, 0.6)
    await page.keyboard.down('Control')
    await page.mouse.wheel(0, -240)
    await page.keyboard.up('Control')
    await lens.nextFrame()
    const { camera } = await state()
    return [...places, ...(camera?.direction ?? []), camera?.zoom ?? 1, ...(camera?.pan ?? [])]
  }

  let expected: number[] = []
  for (const [name, style] of Object.entries(hosts))
    await test.step(name, async () => {
      await dress(style)
      const from = await handleOf(lens, 6)
      const before = await lens.vertices()
      await page.mouse.move(from.x, from.y)
      await page.mouse.down()
      await page.mouse.move(from.x + 12, from.y - 9, { steps: 3 })
      await page.mouse.move(from.x + 28, from.y - 21)
      await page.mouse.up()
      await settled(page)
      expect(await lens.vertices()).not.toEqual(before)
      const to = await handleOf(lens, 6)
      expect(Math.hypot(to.x - from.x - 28, to.y - from.y + 21)).toBeLessThan(2)
      await lens.element.evaluate(element => (element as Element).undo())
      await settled(page)
      const numbers = await pointed()
      if (name === 'none') expected = numbers
      expect(numbers.map((number, i) => Math.abs(number - (expected[i] as number)) < 0.03)).toEqual(
        numbers.map(() => true),
      )
      // Sharp where it is seen larger.
      const sharpness = await page
        .locator('hex-lens canvas')
        .first()
        .evaluate(canvas => {
          const { width, clientWidth } = canvas as HTMLCanvasElement
          return width / clientWidth / devicePixelRatio
        })
      expect(sharpness).toBeCloseTo(name.startsWith('twice') ? 2 : name === 'zoomed' ? 1.5 : Math.max(1, sharpness), 1)
    })

  await test.step('in an animation', async () => {
    await dress('')
    const animation = await host.evaluateHandle(element => {
      const animation = element.animate(
        [{ transform: 'none' }, { transform: 'translate(80px, 60px) rotate(20deg) scale(0.8)' }],
        1000,
      )
      animation.pause()
      return animation
    })
    const from = await handleOf(lens, 6)
    await page.mouse.move(from.x, from.y)
    await page.mouse.down()
    await page.mouse.move(from.x + 20, from.y)
    await animation.evaluate(running => {
      running.currentTime = 700
    })
    await page.mouse.move(from.x + 50, from.y + 40)
    await page.mouse.up()
    await settled(page)
    const to = await handleOf(lens, 6)
    expect(Math.hypot(to.x - from.x - 50, to.y - from.y - 40)).toBeLessThan(2)
  })
})
