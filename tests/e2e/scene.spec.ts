import type { Page } from '@playwright/test'
import { colourScaleOf, type Rgb, rampColour, rampOf, rampPosition } from '../../web/scene/paint/colour-map'
import { shaded } from '../../web/scene/paint/shading'
import { expect, handleOf, type Lens, type Point, test } from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

const hex = (text: string): Rgb =>
  [1, 3, 5].map(at => Number.parseInt(text.slice(at, at + 2), 16) / 255) as unknown as Rgb
const light = rampOf({
  paper: hex('#fcfcfb'),
  ink: hex('#1c1e21'),
  negative: hex('#b2182b'),
  positive: hex('#2166ac'),
  neutral: hex('#eeeeeb'),
})

/** The page at the end of one frame's callback, before the browser showed it. */
test.use({ pictureRatio: 1 })

interface Seen {
  readonly frame: number
  readonly vertices: readonly number[]
  readonly verdict: string
  readonly minimum: number
  readonly maximum: number
  readonly minimizer: Point
  readonly width: number
  readonly height: number
  readonly ratio: number
  /** RGBA, rows from the bottom, in base64. */
  readonly pixels: string
}

interface Watched {
  moveFrames: number[]
  seen: Seen[]
  afterFrame: ((time: number) => void) | null
}

/** Looks at the page right after every frame callback, in the very frame that a pointer's move belongs to. */
async function watchFrames(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const watched: Watched = { moveFrames: [], seen: [], afterFrame: null }
    Object.assign(globalThis, { watched })
    const request = requestAnimationFrame
    globalThis.requestAnimationFrame = callback =>
      request.call(globalThis, time => {
        callback(time)
        watched.afterFrame?.(time)
      })
    addEventListener('pointermove', () => request.call(globalThis, time => watched.moveFrames.push(time)), {
      capture: true,
    })
  })
}

async function lookAfterFrames(lens: Lens): Promise<void> {
  await lens.element.evaluate(element => {
    const lens = element as HTMLElementTagNameMap['hex-lens']
    const root = element.shadowRoot as ShadowRoot
    const canvas = root.querySelector('canvas') as HTMLCanvasElement
    const { watched } = globalThis as unknown as { watched: Watched }
    let last = ''
    watched.afterFrame = time => {
      const verdict = (root.querySelector('[role=status]') as HTMLElement).innerText
      const ring = root.querySelector('.minimizer .ring') as SVGCircleElement
      if (lens.vertices.join() === last || lens.report === null) return
      last = lens.vertices.join()
      const { width, height } = canvas
      const copy = Object.assign(document.createElement('canvas'), { width, height })
      const context = copy.getContext('2d') as CanvasRenderingContext2D
      context.drawImage(canvas, 0, 0)
      const pixels = context.getImageData(0, 0, width, height).data
      watched.seen.push({
        frame: time,
        vertices: lens.vertices,
        verdict,
        minimum: lens.report.boundaryMinimum,
        maximum: lens.report.boundaryMaximum,
        minimizer: { x: Number(ring.getAttribute('cx')), y: Number(ring.getAttribute('cy')) },
        width,
        height,
        ratio: width / canvas.clientWidth,
        pixels: btoa(pixels.reduce((text, byte) => text + String.fromCharCode(byte), '')),
      })
    }
  })
}

async function lastSeen(page: Page): Promise<{ seen: Seen; moveFrames: number[] }> {
  const { seen, moveFrames } = await page.evaluate(() => {
    const { watched } = globalThis as unknown as { watched: Watched }
    return { seen: watched.seen.splice(0).at(-1), moveFrames: watched.moveFrames.splice(0) }
  })
  if (seen === undefined) throw new Error('No frame changed anything.')
  return { seen, moveFrames }
}

function distance(a: Rgb, b: Rgb): number {
  return Math.max(...a.map((value, i) => Math.abs(value - (b[i] as number))))
}

/** Shares of the painted pixels whose colour is the map's for a negative or a positive jacdet, and of clearly red ones. */
function coloursOf(seen: Seen): { negative: number; positive: number; red: number } {
  const pixels = Buffer.from(seen.pixels, 'base64')
  const stops = Array.from({ length: 129 }, (_, i) => i / 64 - 1).flatMap(position =>
    [0, 0.5, 1].map(lit => ({ position, colour: shaded(rampColour(light, position), lit) })),
  )
  const counts = { negative: 0, positive: 0, red: 0, painted: 0 }
  for (let i = 0; i < pixels.length; i += 4 * 29) {
    if (pixels[i + 3] !== 255) continue
    counts.painted++
    const colour = [0, 1, 2].map(c => (pixels[i + c] as number) / 255) as unknown as Rgb
    if (colour[0] - colour[2] > 0.15) counts.red++
    const nearest = stops.reduce((a, b) => (distance(b.colour, colour) < distance(a.colour, colour) ? b : a))
    if (distance(nearest.colour, colour) > 0.02) continue
    if (nearest.position < -0.05) counts.negative++
    if (nearest.position > 0.05) counts.positive++
  }
  const share = (count: number) => count / counts.painted
  return { negative: share(counts.negative), positive: share(counts.positive), red: share(counts.red) }
}

/** The least difference between the map's colour for a value and the picture within a few pixels of a place. */
function differenceAt(seen: Seen, { x, y }: Point, colour: Rgb): number {
  const { width, ratio } = seen
  const pixels = Buffer.from(seen.pixels, 'base64')
  let least = Number.POSITIVE_INFINITY
  for (let dy = -6; dy <= 6; dy++) {
    for (let dx = -6; dx <= 6; dx++) {
      const i = 4 * ((Math.round(y * ratio) + dy) * width + Math.round(x * ratio) + dx)
      if (pixels[i + 3] !== 255) continue
      least = Math.min(least, distance([0, 1, 2].map(c => (pixels[i + c] as number) / 255) as unknown as Rgb, colour))
    }
  }
  return least
}

test('one frame moves the vertex, the colours, the minimizer and the verdict, on both sides of zero', async ({
  lens,
  page,
}) => {
  await page.setViewportSize({ width: 900, height: 480 })
  await watchFrames(page)
  await lens.open()
  await lens.set(cube)
  const handle = await handleOf(lens, 6)
  const far = await handleOf(lens, 0)
  await page.mouse.move(handle.x, handle.y)
  await page.mouse.down()
  await page.mouse.move(handle.x + 4, handle.y + 4)
  await lens.nextFrame()
  await lookAfterFrames(lens)

  await page.mouse.move(handle.x + 1.3 * (far.x - handle.x), handle.y + 1.3 * (far.y - handle.y))
  await lens.nextFrame()
  const bad = await lastSeen(page)
  expect(bad.moveFrames).toContain(bad.seen.frame)
  expect(bad.seen.vertices.slice(0, 18)).toEqual(cube.slice(0, 18))
  expect(bad.seen.vertices.slice(18, 21)).not.toEqual([1, 1, 1])
  expect(bad.seen.verdict).toMatch(/^INVALID/)
  expect(bad.seen.minimum).toBeLessThan(0)
  const invalid = coloursOf(bad.seen)
  expect(invalid.negative).toBeGreaterThan(0.01)
  expect(invalid.positive).toBeGreaterThan(0.01)

  await page.mouse.move(handle.x - 6, handle.y + 6)
  await lens.nextFrame()
  const good = await lastSeen(page)
  expect(good.moveFrames).toContain(good.seen.frame)
  expect(good.seen.verdict).toMatch(/^VALID/)
  expect(good.seen.minimum).toBeGreaterThan(0)
  const valid = coloursOf(good.seen)
  expect(valid.red).toBe(0)
  expect(valid.positive).toBeGreaterThan(0.5)
  const scale = colourScaleOf(good.seen.minimum, good.seen.maximum)
  const colour = rampColour(light, rampPosition(scale, good.seen.minimum))
  const differences = [0, 0.5, 1].map(lit => differenceAt(good.seen, good.seen.minimizer, shaded(colour, lit)))
  expect(Math.min(...differences)).toBeLessThan(0.05)
  await page.mouse.up()
})

test('a drag moves a vertex as typing does, in one step; Escape takes it back', async ({ lens, page }) => {
  await lens.open()

  await test.step('Escape in the middle of a drag puts the vertex back and leaves nothing to undo', async () => {
    const before = await lens.vertices()
    const handle = await handleOf(lens, 5)
    await page.mouse.move(handle.x, handle.y)
    await page.mouse.down()
    await page.mouse.move(handle.x + 40, handle.y + 30, { steps: 3 })
    await lens.nextFrame()
    expect(await lens.vertices()).not.toEqual(before)
    await page.keyboard.press('Escape')
    await page.mouse.move(handle.x + 80, handle.y + 60)
    await page.mouse.up()
    await lens.nextFrame()
    expect(await lens.vertices()).toEqual(before)
    await expect(lens.button('Undo')).toBeDisabled()
  })

  await test.step('a drag is one step to undo and to redo', async () => {
    await lens.set(cube)
    const handle = await handleOf(lens, 6)
    await page.mouse.move(handle.x, handle.y)
    await page.mouse.down()
    for (let step = 1; step <= 5; step++) {
      await page.mouse.move(handle.x + 10 * step, handle.y - 4 * step)
      await lens.nextFrame()
    }
    await page.mouse.up()
    await lens.nextFrame()
    const moved = await lens.vertices()
    expect(moved).not.toEqual(cube)
    await lens.button('Undo').click()
    await expect.poll(() => lens.vertices()).toEqual(cube)
    await lens.button('Redo').click()
    await expect.poll(() => lens.vertices()).toEqual(moved)
  })

  await test.step('dragging and typing are the same thing', async () => {
    await lens.set(cube)
    const handle = await handleOf(lens, 6)
    await page.mouse.move(handle.x, handle.y)
    await page.mouse.down()
    await page.mouse.move(handle.x + 30, handle.y - 20, { steps: 2 })
    await page.mouse.up()
    await lens.nextFrame()
    const dragged = (await lens.vertices()).slice(18, 21)
    const verdict = await lens.verdict.innerText()
    expect(dragged).not.toEqual([1, 1, 1])
    await expect(lens.field(6, 'z')).toHaveValue(String(dragged[2]))
    await lens.set(cube)
    for (const [axis, value] of (['x', 'y', 'z'] as const).map((axis, i) => [axis, dragged[i]] as const)) {
      await lens.field(6, axis).fill(String(value))
    }
    await expect.poll(async () => (await lens.vertices()).slice(18, 21)).toEqual(dragged)
    await expect.poll(() => lens.verdict.innerText()).toBe(verdict)
  })

  await test.step('what is typed out of the picture brings the picture along once it is committed', async () => {
    for (const text of ['40', '1e308']) {
      const before = await handleOf(lens, 0)
      await lens.field(6, 'z').fill(text)
      await lens.nextFrame()
      expect(await handleOf(lens, 0)).toEqual(before)
      await lens.field(6, 'z').press('Enter')
      await lens.nextFrame()
      const stage = await lens.scene.boundingBox()
      const { x, y } = await handleOf(lens, 6)
      expect(x).toBeGreaterThan(stage?.x as number)
      expect(y).toBeGreaterThan(stage?.y as number)
      await page.keyboard.press('Control+z')
      await lens.button('Fit').click()
      await lens.nextFrame()
    }
  })

  await test.step('vertices in one place share a label, and the chosen one of them is dragged', async () => {
    await lens.preset.selectOption({ label: 'Zero on the faces, negative inside' })
    await lens.nextFrame()
    const shared = page.locator('hex-lens .handle', { hasText: '0, 2, 5, 7' }).locator('circle').last()
    await expect(shared).toBeVisible()
    await lens.scene.focus()
    await page.keyboard.press('5')
    const before = await lens.vertices()
    const box = await shared.boundingBox()
    const { x, y } = { x: (box?.x ?? 0) + (box?.width ?? 0) / 2, y: (box?.y ?? 0) + (box?.height ?? 0) / 2 }
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x - 20, y + 30, { steps: 3 })
    await page.mouse.up()
    await lens.nextFrame()
    const moved = (await lens.vertices()).flatMap((value, i) => (value === before[i] ? [] : [Math.floor(i / 3)]))
    expect([...new Set(moved)]).toEqual([5])
  })
})

test('keys show where the focus is, and the help', async ({ lens, page }) => {
  await lens.open()

  await test.step('a pointer draws no focus frame, a key does', async () => {
    const frame = () => lens.scene.evaluate(element => getComputedStyle(element).outlineStyle)
    const { x, y } = await handleOf(lens, 1)
    await page.mouse.click(x, y)
    await expect(lens.scene).toBeFocused()
    expect(await frame()).toBe('none')
    await page.keyboard.press('6')
    expect(await frame()).toBe('solid')
  })

  await test.step('the help is one key or one press away', async () => {
    const help = page.locator('hex-lens .scene-help')
    await expect(help).toBeHidden()
    await expect(lens.scene).toHaveAccessibleDescription(/Arrow keys move the chosen vertex/)
    await lens.scene.focus()
    await page.keyboard.press('?')
    await expect(help).toBeVisible()
    await expect(lens.button('Help')).toHaveAttribute('aria-expanded', 'true')
    await lens.button('Help').click()
    await expect(help).toBeHidden()
    await lens.button('Reset').press('?')
    await expect(help).toBeVisible()
  })

  await test.step('without dragging or pinching the view is turned and zoomed', async () => {
    await lens.button('Turn').click()
    let before = await handleOf(lens, 6)
    const moved = async () => {
      await lens.nextFrame()
      const now = await handleOf(lens, 6)
      const by = { x: now.x - before.x, y: now.y - before.y }
      before = now
      return by
    }
    const ways: { x: number; y: number }[] = []
    for (const name of ['Turn left', 'Turn right', 'Turn up', 'Turn down', 'Zoom in', 'Zoom out']) {
      await lens.button(name).click()
      ways.push(await moved())
    }
    for (const [there, back] of [ways.slice(0, 2), ways.slice(2, 4), ways.slice(4)]) {
      expect(Math.hypot(there?.x ?? 0, there?.y ?? 0)).toBeGreaterThan(3)
      expect(there?.x).toBeCloseTo(-(back?.x ?? 0), 0)
      expect(there?.y).toBeCloseTo(-(back?.y ?? 0), 0)
    }
    await lens.button('Turn').click()
    await expect(page.getByRole('group', { name: 'Turn and zoom' })).toBeHidden()
  })
})

test('with the keyboard alone vertices are chosen and moved', async ({ lens, page }) => {
  await lens.open()

  await test.step('with the keyboard alone every vertex is chosen and moved', async () => {
    let tabs = 0
    while (!(await lens.scene.evaluate(scene => scene.matches(':focus')))) {
      expect(++tabs).toBeLessThan(12)
      await page.keyboard.press('Tab')
    }
    for (let vertex = 0; vertex < 8; vertex++) {
      const before = await lens.vertices()
      await page.keyboard.press(String(vertex))
      for (const key of ['ArrowRight', 'ArrowUp', 'PageDown']) await page.keyboard.press(key)
      await lens.nextFrame()
      const after = await lens.vertices()
      const changed = after.flatMap((value, i) => (value === before[i] ? [] : [i]))
      expect(changed).toEqual([3 * vertex, 3 * vertex + 1, 3 * vertex + 2])
    }
  })

  await test.step('an arrow key in the very frame of an undo goes on from what the undo left', async () => {
    const first = await lens.vertices()
    await lens.scene.focus()
    await page.keyboard.press('6')
    await page.keyboard.press('ArrowRight')
    await lens.nextFrame()
    const moved = await lens.vertices()
    expect(moved).not.toEqual(first)
    await lens.element.evaluate(element => {
      ;(element as HTMLElementTagNameMap['hex-lens']).undo()
      const scene = (element.shadowRoot as ShadowRoot).activeElement as HTMLElement
      for (const type of ['keydown', 'keyup'])
        scene.dispatchEvent(new KeyboardEvent(type, { key: 'ArrowRight', bubbles: true, composed: true }))
    })
    await lens.nextFrame()
    expect(await lens.vertices()).toEqual(moved)
  })
})
