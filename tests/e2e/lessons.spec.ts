/** The lessons as a reader has them: step by step, played with, left and come back to. */
import type { Page } from '@playwright/test'
import {
  expect,
  expectAxeFindsNothing,
  expectLargeTargets,
  expectNoSidewaysOverflow,
  inSchemesAndWidths,
  test,
} from './lens'

/** The step that is read. */
const stepOf = (page: Page) => page.getByRole('article').filter({ has: page.locator('[aria-current=step]') })
const titleOf = (page: Page) => stepOf(page).getByRole('heading')
const claimsOf = (page: Page) => stepOf(page).getByRole('list', { name: 'Computed' }).getByRole('listitem')
const barOf = (page: Page) => page.getByRole('group', { name: 'Steps of the lesson' })

test('every step of every lesson, and what each claims holds on the screen', async ({ lens: _, page }) => {
  await page.goto('lessons.html#quadrilaterals-first')
  const titles: string[] = []
  const walked: string[] = []
  let claims = 0
  for (let isLast = false; !isLast; ) {
    const [, step, count] = /Step (\d+) of (\d+)/.exec(await barOf(page).innerText()) as RegExpExecArray
    if (step === '1') titles.push(await page.getByRole('heading', { level: 1 }).innerText())
    await expect(titleOf(page)).toHaveText(new RegExp(`^\\s*${step} `))
    const showIt = stepOf(page).getByRole('button', { name: 'Show it' })
    if (await showIt.isVisible()) await showIt.click()
    const says = await claimsOf(page).count()
    await expect(claimsOf(page).filter({ hasText: /: holds/ })).toHaveCount(says)
    await expect(stepOf(page).locator('math').first().or(stepOf(page).locator('.task'))).not.toHaveCount(0)
    claims += says
    walked.push(`${titles.length}/${step}`)
    isLast = await page.getByRole('button', { name: 'Next', exact: true }).and(page.locator(':disabled')).isVisible()
    if (isLast) expect(step).toBe(count)
    else await page.keyboard.press('ArrowRight')
    // The next one is told before it is shown.
    if (!isLast) await expect(barOf(page)).not.toContainText(`Step ${step} of ${count}`)
  }
  expect(titles).toEqual([
    'Quadrilaterals first',
    'What the Jacobian determinant is',
    'Corners are not enough',
    'Edges are not enough',
    'Faces are enough',
    'Strictly!',
    'Finding the minimum',
  ])
  expect(new Set(walked).size).toBe(walked.length)
  expect(claims).toBeGreaterThan(60)
  await expect(page.getByRole('link', { name: 'challenges', exact: true })).toHaveAttribute('href', './challenges.html')
})

test('a step is linked to, played with, restored, left and come back to', async ({ lens, page }) => {
  await lens.open('lessons.html#corners-are-not-enough/2')
  await expect(titleOf(page)).toHaveText(/Between two corners/)
  await expect(stepOf(page).getByRole('img')).toHaveAccessibleName(
    /edge 1–2: 7\/8 at vertex 1.* lowest −0\.030711 at 0\.70/,
  )

  await test.step('what is done to the element shows in the claims, and one button takes it back', async () => {
    const own = await lens.vertices()
    await lens.scene.focus()
    await page.keyboard.press('2')
    for (let i = 0; i < 3; ++i) await page.keyboard.press('Shift+ArrowRight')
    await expect.poll(() => lens.vertices()).not.toEqual(own)
    await expect(claimsOf(page).filter({ hasText: /: does not hold/ })).not.toHaveCount(0)
    await expect(stepOf(page)).toContainText('You have changed the element.')
    const played = await lens.vertices()

    await page.reload()
    await expect(titleOf(page)).toHaveText(/Between two corners/)
    expect(await lens.vertices()).toEqual(played)
    await page.getByRole('button', { name: 'Restore this step' }).click()
    await expect(claimsOf(page).filter({ hasText: /: holds/ })).toHaveCount(2)
    expect(await lens.vertices()).toEqual(own)
  })

  await test.step('Next, an arrow and scrolling move on; Back goes back', async () => {
    await page.getByRole('button', { name: 'Next', exact: true }).click()
    await expect(titleOf(page)).toHaveText(/The centre as well/)
    await expect(page).toHaveURL(/#corners-are-not-enough\/3$/)
    await expect(page.getByRole('table', { name: /Who would notice/ })).toBeVisible()
    await page.keyboard.press('ArrowLeft')
    await expect(titleOf(page)).toHaveText(/Between two corners/)
    await page.goBack()
    await expect(titleOf(page)).toHaveText(/The centre as well/)
    await page.mouse.move(850, 300)
    await page.mouse.wheel(0, (await stepOf(page).boundingBox())?.height ?? 0)
    await expect(page).toHaveURL(/#corners-are-not-enough\/4$/)
    await expect(titleOf(page)).toHaveText(/The points of a solver/)
    await page.goBack()
    await expect(titleOf(page)).toHaveText(/Between two corners/)
  })

  await test.step('arrows in the picture are the picture’s', async () => {
    await lens.scene.focus()
    await page.keyboard.press('ArrowRight')
    await expect(titleOf(page)).toHaveText(/Between two corners/)
  })

  await test.step('the list of lessons leads to each, a link of no lesson to all of them', async () => {
    await page.getByText('Lesson 2 of 6').click()
    await page.getByRole('link', { name: 'Faces are enough' }).click()
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('Faces are enough')
    await expect(page).toHaveTitle(/^Faces are enough/)
    await expect(page.locator('.column')).toBeFocused()
    await expect(page.locator('.contents')).not.toHaveAttribute('open')
    await page.evaluate(() => {
      location.hash = '#nothing/7'
    })
    await expect(page.getByText('There is no lesson “nothing”. These are the lessons that there are.')).toBeVisible()
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('Lessons')
  })

  await test.step('on top the pages are linked, and the column is one key away', async () => {
    const pages = page.getByRole('navigation', { name: 'Hexlens' })
    await expect(pages.getByRole('link')).toHaveText(['Lens', 'Mesh', 'Lessons', 'Challenges', 'Search', 'Gallery'])
    await expect(pages.locator('[aria-current=page]')).toHaveText('Lessons')
    const skip = page.getByRole('link', { name: 'Skip to the lesson' })
    await skip.focus()
    await skip.press('Enter')
    await expect(page.locator('.column')).toBeFocused()
    expect(page.url()).toContain('#nothing/7')
  })
})

test('a link leads to its step, though drawings of steps before it and the font come late', async ({ lens, page }) => {
  await page.setViewportSize({ width: 390, height: 844 })
  await lens.open('lessons.html#faces-are-enough/6')
  await expect(page.locator('.column .drawing')).toHaveCount(2)
  const below = async () =>
    (await titleOf(page).evaluate(title => title.getBoundingClientRect().top)) -
    (await lens.element.evaluate(element => element.getBoundingClientRect().bottom))
  await expect.poll(async () => Math.abs((await below()) - 16)).toBeLessThan(2)
  await expect(titleOf(page)).toHaveText(/Both have the same sign/)

  await test.step('a step begins with its picture, wherever the one before was scrolled to', async () => {
    const inLens = (top: number | null) =>
      lens.element.evaluate((element, to) => {
        const scroller = element.shadowRoot?.querySelector('.lens') as HTMLElement
        if (to !== null) scroller.scrollTop = to
        return scroller.scrollTop
      }, top)
    const isFullySeen = () =>
      lens.element.evaluate(element => {
        const box = element.shadowRoot?.querySelector('.reference')?.getBoundingClientRect()
        return box !== undefined && box.height > 0 && box.bottom <= element.getBoundingClientRect().bottom
      })
    expect(await isFullySeen()).toBe(true)
    const before = await page.evaluate(() => scrollY)
    for (const name of ['Reference cube', 'Fit', 'Help']) await lens.button(name).focus()
    await lens.button('Fit').click()
    expect(await page.evaluate(() => scrollY)).toBe(before)
    await page.setViewportSize({ width: 390, height: 600 })
    await expect.poll(isFullySeen).toBe(true)
    expect(await inLens(40)).toBe(40)
    await page.evaluate(() => {
      location.hash = '#faces-are-enough/5'
    })
    await expect.poll(() => inLens(null)).toBe(0)
    await page.goBack()
    await page.setViewportSize({ width: 390, height: 844 })
    await expect(titleOf(page)).toHaveText(/Both have the same sign/)
  })

  await test.step('it stays when a phone is turned', async () => {
    await page.setViewportSize({ width: 844, height: 390 })
    await expect.poll(() => titleOf(page).evaluate(title => title.getBoundingClientRect().top)).toBeLessThan(90)
    await page.setViewportSize({ width: 390, height: 844 })
    await expect.poll(async () => Math.abs((await below()) - 16)).toBeLessThan(2)
    await expect(titleOf(page)).toHaveText(/Both have the same sign/)
  })

  await test.step('a reload, too, and the two drawings of a lesson are apart', async () => {
    await page.evaluate(() => scrollBy(0, 40))
    await page.reload()
    await expect(page.locator('.column .drawing')).toHaveCount(2)
    await expect.poll(async () => Math.abs((await below()) + 24)).toBeLessThan(2)
    await page.evaluate(() => {
      location.hash = '#corners-are-not-enough/6'
    })
    await expect(page.locator('.column .drawing')).toHaveCount(2)
    const reds = page.locator('.column .drawing').evaluateAll(drawings =>
      drawings.map(drawing => {
        const clip = drawing.querySelector('svg svg')
        return [
          clip?.getAttribute('y'),
          drawing.querySelector('.zero')?.getAttribute('d')?.slice('M0 '.length).split('H')[0],
        ]
      }),
    )
    for (const [top, zero] of await reds) expect(top).toBe(zero)
  })
})

test('axe finds nothing beside the lens or under it, and nothing is too small or too wide', async ({ lens, page }) => {
  await lens.open('lessons.html#faces-are-enough/5')
  await expect(claimsOf(page).filter({ hasText: /: holds/ })).toHaveCount(1)
  await inSchemesAndWidths(lens, async () => {
    await expectAxeFindsNothing(page)
    await expectLargeTargets(page.locator('.pages a, .column a, .column button:not(.term), .column summary'))
    const covered = await lens.element.evaluate(({ clientHeight }) => clientHeight / innerHeight)
    if ((await page.evaluate(() => innerWidth)) < 500) expect(covered).toBeLessThan(0.5)
  })
  // 1280 × 1024 enlarged to 400 %.
  await page.setViewportSize({ width: 320, height: 256 })
  await expectNoSidewaysOverflow(page)
})
