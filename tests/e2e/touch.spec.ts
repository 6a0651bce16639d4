import type { Locator, Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, expectLargeTargets, handleOf, type Lens, type Point, test } from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

test.use({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } })

/** Puts fingers down, moves them step by step and lifts them. */
async function move(page: Page, from: readonly Point[], to: readonly Point[], look = async () => {}): Promise<void> {
  const touch = await page.context().newCDPSession(page)
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: readonly Point[]) =>
    touch.send('Input.dispatchTouchEvent', { type, touchPoints: touchPoints.map((point, id) => ({ ...point, id })) })
  const STEPS = 10
  await send('touchStart', from)
  for (let step = 1; step <= STEPS; step++) {
    const along = (a: number, b: number) => a + ((b - a) * step) / STEPS
    const points = from.map(({ x, y }, i) => ({ x: along(x, to[i]?.x ?? x), y: along(y, to[i]?.y ?? y) }))
    await send('touchMove', points)
  }
  await look()
  await send('touchEnd', [])
  await touch.detach()
}

function stateOf(lens: Lens) {
  return lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).state)
}

async function boxOf(locator: Locator) {
  const box = await locator.boundingBox()
  if (box === null) throw new Error('Not on the page.')
  return box
}

test('a handle is dragged, in one step to undo', async ({ lens, page }) => {
  await lens.open()
  await lens.set(cube)
  const { x, y } = await handleOf(lens, 6)
  await move(page, [{ x: x + 8, y: y + 6 }], [{ x: x + 40, y: y - 34 }])
  await lens.nextFrame()
  const moved = await lens.vertices()
  expect(moved.slice(18, 21)).not.toEqual([1, 1, 1])
  expect(moved.slice(0, 18)).toEqual(cube.slice(0, 18))
  expect(await page.evaluate(() => scrollY)).toBe(0)
  await lens.button('Undo').click()
  await expect.poll(() => lens.vertices()).toEqual(cube)
})

test('a swipe up scrolls and leaves the view as it was; one sideways turns it; two fingers zoom', async ({
  lens,
  page,
}) => {
  for (const address of ['./', 'lessons.html#what-the-jacobian-determinant-is/2', 'challenges.html'])
    await test.step(`on ${address}`, async () => {
      await lens.open(address)
      await lens.nextFrame()
      const scrolled = () => page.evaluate(() => scrollY)
      const stage = await boxOf(lens.scene)
      const start = { x: stage.x + 30, y: stage.y + stage.height - 70 }
      const [before, top] = [(await stateOf(lens)).camera, await scrolled()]
      await move(page, [start], [{ x: start.x + 6, y: start.y - 120 }])
      await expect.poll(scrolled).not.toBe(top)
      await lens.nextFrame()
      expect((await stateOf(lens)).camera).toEqual(before)
    })

  await test.step('sideways', async () => {
    await lens.open()
    const stage = await boxOf(lens.scene)
    const start = { x: stage.x + 40, y: stage.y + stage.height - 130 }
    const before = await handleOf(lens, 6)
    await move(page, [start], [{ x: start.x + 12, y: start.y + 1 }])
    await lens.nextFrame()
    const after = await handleOf(lens, 6)
    const first = Math.hypot(after.x - before.x, after.y - before.y)
    await move(page, [start], [{ x: start.x + 120, y: start.y + 40 }])
    await lens.nextFrame()
    const later = await handleOf(lens, 6)
    expect(Math.hypot(later.x - after.x, later.y - after.y)).toBeGreaterThan(20)
    // The turn starts where the finger's way was decided: the view does not jump.
    expect(first).toBeLessThan(8)
    expect(await page.evaluate(() => scrollY)).toBe(0)
  })

  await test.step('two fingers', async () => {
    const stage = await boxOf(lens.scene)
    const [y, left] = [stage.y + stage.height - 130, stage.x + 20]
    const zoom = async () => (await stateOf(lens)).camera?.zoom ?? 1
    const before = await zoom()
    const apart = [
      { x: left, y },
      { x: left + 240, y },
    ]
    const near = [
      { x: left + 80, y },
      { x: left + 160, y },
    ]
    await move(page, near, apart)
    await lens.nextFrame()
    expect(await zoom()).toBeGreaterThan(1.5 * before)
  })
})

test('chips hold the drags of the chosen vertex', async ({ lens, page }) => {
  await lens.open()
  await lens.set(cube)
  const chips = page.getByRole('group', { name: 'Drags are held to' })
  const chip = (name: string) => chips.getByRole('button', { name, exact: true })
  const tapHandle = async (vertex: number) => {
    const { x, y } = await handleOf(lens, vertex)
    await page.touchscreen.tap(x, y)
  }
  const dragged = async (vertex: number) => {
    await lens.set(cube)
    const { x, y } = await handleOf(lens, vertex)
    await move(page, [{ x, y }], [{ x: x + 23, y: y - 31 }])
    await lens.nextFrame()
    const after = (await lens.vertices()).slice(3 * vertex, 3 * vertex + 3)
    return after.map((value, axis) => value - (cube[3 * vertex + axis] as number))
  }

  await test.step('they are there while a vertex is chosen, and large', async () => {
    await expect(chips).toBeHidden()
    await tapHandle(6)
    await expect(chips.getByRole('button')).toHaveText(['X', 'Y', 'Z', 'Depth', 'Grid'])
    await expectLargeTargets(chips.getByRole('button'))
    expect((await boxOf(chip('X'))).height).toBeGreaterThanOrEqual(44)
    await expectAxeFindsNothing(page)
  })

  await test.step('an axis', async () => {
    await chip('Z').tap()
    await expect(chip('Z')).toHaveAttribute('aria-pressed', 'true')
    const [x, y, z] = await dragged(6)
    expect([x, y]).toEqual([0, 0])
    expect(z).not.toBe(0)
  })

  await test.step('depth in its place, and the grid with it', async () => {
    await chip('Depth').tap()
    await expect(chip('Z')).toHaveAttribute('aria-pressed', 'false')
    await chip('Grid').tap()
    await expect(chip('Depth')).toHaveAttribute('aria-pressed', 'true')
    const by = await dragged(6)
    expect(by).not.toEqual([0, 0, 0])
    // The grid of an element of size 1.
    for (const value of by) expect(value * 20).toBeCloseTo(Math.round(value * 20), 9)
  })

  await test.step('by keyboard, too', async () => {
    await chip('X').focus()
    await page.keyboard.press('Space')
    await expect(chip('X')).toHaveAttribute('aria-pressed', 'true')
    await expect(chip('Depth')).toHaveAttribute('aria-pressed', 'false')
  })

  await test.step('a tap beside the handles lets go of the vertex, and of what was held', async () => {
    const stage = await boxOf(lens.scene)
    await page.touchscreen.tap(stage.x + 20, stage.y + stage.height / 2)
    await expect(chips).toBeHidden()
    await expect(page.locator('hex-lens .handle.selected')).toHaveCount(0)
    const by = await dragged(6)
    expect(by.filter(value => value !== 0).length).toBeGreaterThan(1)
    await expect(chip('X')).toHaveAttribute('aria-pressed', 'false')
  })

  await test.step('they stand with the reference cube and its link', async () => {
    await lens.button('Reference cube').tap()
    const link = await boxOf(page.locator('hex-lens .reference-link'))
    const last = await boxOf(chip('Grid'))
    expect(link.y + link.height).toBeLessThanOrEqual(last.y)
    await page.getByRole('checkbox', { name: 'Link views' }).tap()
    await lens.button('Reference cube').tap()
  })

  await test.step('a mouse, which comes with keys, needs none', async () => {
    await expect(chips).toBeVisible()
    const { x, y } = await handleOf(lens, 2)
    await page.mouse.click(x, y)
    await expect(chips).toBeHidden()
  })
})

test('the help is about fingers where there are some, and about keys where there is a mouse', async ({
  lens,
  page,
}) => {
  await lens.open()
  await lens.button('Help').tap()
  const help = page.locator('hex-lens .scene-help')
  await expect(help).toContainText('Two fingers zoom')
  await expect(help).not.toContainText('Shift')
  await expect(help).toBeInViewport({ ratio: 1 })
  await expectAxeFindsNothing(page)
  const { x, y } = await boxOf(lens.scene)
  await page.mouse.click(x + 20, y + 100)
  await expect(help).toContainText('Shift')
  await expect(help).not.toContainText('Two fingers zoom')
})

test('on a phone the scene stays in sight above what is said of it', async ({ lens, page }) => {
  await test.step('on the page of the lens', async () => {
    for (const [width, height] of [
      [390, 844],
      [390, 664],
      [844, 390],
    ] as const) {
      await page.setViewportSize({ width, height })
      await lens.open()
      const last = page.locator('hex-lens .folds').getByRole('button').last()
      await last.scrollIntoViewIfNeeded()
      await expect(lens.scene).toBeInViewport({ ratio: 0.98 })
      const [stage, said] = [await boxOf(lens.scene), await boxOf(last)]
      const isBeside = said.x >= stage.x + stage.width
      expect(isBeside || said.y >= stage.y + stage.height).toBe(true)
      expect(isBeside).toBe(width > height)
    }
  })

  const hashes: string[] = []
  for (const lesson of ['corners-are-not-enough', 'edges-are-not-enough', 'faces-are-enough', 'finding-the-minimum']) {
    await page.goto(`lessons.html#${lesson}/1`)
    await expect(page.locator('.step[data-active]')).toBeVisible()
    const steps = await page.locator('.step').count()
    for (let step = 1; step <= steps; step++) hashes.push(`${lesson}/${step}`)
  }
  for (const [width, height, least] of [
    [390, 844, 250],
    [844, 390, 170],
  ] as const)
    await test.step(`in the lessons at ${width} pixels`, async () => {
      await page.setViewportSize({ width, height })
      let looked = 0
      for (const hash of hashes) {
        await page.goto(`lessons.html#${hash}`)
        await expect(page.locator('.step[data-active] .number')).toHaveText(hash.split('/')[1] as string)
        const views = await lens.element.getAttribute('views')
        if (views === 'scene' || views === 'scene verdict') continue
        looked++
        await expect(lens.scene).toBeVisible()
        const panels = page.locator('hex-lens .side')
        await panels.evaluate(side => side.scrollTo(0, side.scrollHeight))
        const [stage, side] = [await boxOf(lens.scene), await boxOf(panels)]
        const step = await boxOf(page.locator('.step[data-active] h2'))
        expect(stage.height, hash).toBeGreaterThan(180)
        expect(side.y, hash).toBeGreaterThanOrEqual(stage.y + stage.height)
        expect(side.height, hash).toBeGreaterThan(least)
        await expect(lens.scene).toBeInViewport({ ratio: 0.98 })
        // The step's text begins under the panels, or beside them.
        if (width < height) expect(step.y, hash).toBeGreaterThanOrEqual(side.y + side.height)
        await expect(page.locator('.step[data-active] h2')).toBeInViewport({ ratio: 1 })
      }
      expect(looked).toBeGreaterThan(8)
    })
})
