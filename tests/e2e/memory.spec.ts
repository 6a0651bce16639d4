import type { CDPSession } from '@playwright/test'
import { expect, heldObjects, test } from './lens'

const PANELS = [
  'Face maps',
  'Algorithm 1, step by step',
  'Inside',
  'Morph',
  'Nearest invalid, nearest valid',
  'Best place of a vertex',
  'Node order',
]
const WARM_UP = { moves: 1000, aFrame: 50 }
const MEASURED = { moves: 10_000, aFrame: 500 }

interface Counts {
  readonly objects: number
  readonly nodes: number
  readonly listeners: number
}

async function countsOf(session: CDPSession): Promise<Counts> {
  const objects = await heldObjects(session)
  const { nodes, jsEventListeners } = await session.send('Memory.getDOMCounters')
  return { objects, nodes, listeners: jsEventListeners }
}

test.use({ viewport: { width: 640, height: 480 } })

test('10,000 moves of a drag leave nothing behind, with panels open', async ({ lens, page }) => {
  test.setTimeout(180_000) // many frames, and machines may be busy
  await lens.open()
  await lens.button('Reference cube').click()
  for (const panel of PANELS) await lens.button(panel).click()
  await expect(page.getByRole('img', { name: /^Map of jacdet on the section/ })).toBeVisible()
  await lens.scene.scrollIntoViewIfNeeded()
  const handle = page.locator('hex-lens .scene-pane .handle').nth(6)
  const { x, y, width, height } = (await handle.boundingBox()) as {
    x: number
    y: number
    width: number
    height: number
  }
  const [fromX, fromY] = [x + width / 2, y + height / 2]
  await page.mouse.move(fromX, fromY)
  await page.mouse.down()
  await page.mouse.move(fromX + 8, fromY)
  const drag = ({ moves, aFrame }: typeof MEASURED) =>
    page.evaluate(
      async ([fromX, fromY, count, aFrame]) => {
        const stage = document.querySelector('hex-lens')?.shadowRoot?.querySelector('.scene-pane .scene-stage')
        for (let n = 0; n < count; n++) {
          const clientX = fromX + 30 * Math.sin(n / 70)
          const clientY = fromY + 20 * Math.sin(n / 110)
          stage?.dispatchEvent(new PointerEvent('pointermove', { pointerId: 1, clientX, clientY, bubbles: true }))
          if (n % aFrame === 0) await new Promise(requestAnimationFrame)
        }
      },
      [fromX, fromY, moves, aFrame] as const,
    )
  const session = await page.context().newCDPSession(page)
  const start = await lens.vertices()
  await drag(WARM_UP)
  expect(await lens.vertices()).not.toEqual(start)
  const before = await countsOf(session)
  await drag(MEASURED)
  const after = await countsOf(session)
  // A report and a frame are released with the next.
  expect(after.objects - before.objects).toBeLessThan(MEASURED.moves / 10)
  expect(after.nodes - before.nodes).toBeLessThan(50)
  expect(after.listeners - before.listeners).toBeLessThan(10)
  await page.mouse.up()
  await lens.button('Undo').click()
  await expect(lens.button('Undo')).toBeDisabled()
})
