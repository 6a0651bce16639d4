/** Lesson 0 in the plane, questions that are asked first, the overview and the glossary, as a reader has them. */
import type { Locator, Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, test } from './lens'

const phone = { width: 390, height: 844 }
const elementOf = (page: Page) => page.getByRole('application', { name: /^The quadrilateral/ })
const squareOf = (page: Page) => page.getByRole('application', { name: /^The reference square/ })
const verdictOf = (page: Page) => page.locator('.plane .verdict')
const readoutOf = (page: Page) => page.locator('.plane .readout')
const stepOf = (page: Page) => page.getByRole('article').filter({ has: page.locator('[aria-current=step]') })
const claimsOf = (page: Page) => stepOf(page).getByRole('list', { name: 'Computed' }).getByRole('listitem')

/** The middle of a corner's handle in the window, when the plane is drawn anew: the column's link is there a frame before it. */
async function middleOf(page: Page, corner: number): Promise<{ x: number; y: number }> {
  await page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))))
  const box = await elementOf(page).locator('.corner .dot').nth(corner).boundingBox()
  if (!box) throw new Error(`Corner ${corner} is not drawn.`)
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}

async function drag(page: Page, corner: number, by: readonly [number, number], release = true): Promise<void> {
  const { x, y } = await middleOf(page, corner)
  await page.mouse.move(x, y)
  await page.mouse.down()
  for (const part of [0.5, 1]) await page.mouse.move(x + part * by[0], y + part * by[1])
  if (release) await page.mouse.up()
}

/** Corners as the link to the lens has them: exactly. */
const linkOf = (page: Page) => stepOf(page).getByRole('link', { name: 'Open in the lens' }).getAttribute('href')

test('corners are dragged, taken back and moved by keys', async ({ lens, page }) => {
  await page.setViewportSize({ width: 1440, height: 900 })
  await page.goto('lessons.html#quadrilaterals-first/5')
  await expect(verdictOf(page)).toHaveText(/INVALID\s+Least J: −3\/4, at corner 2/)
  await expect(claimsOf(page).filter({ hasText: /: holds/ })).toHaveCount(2)
  const own = await linkOf(page)
  const undo = page.getByRole('button', { name: 'Undo' })
  const redo = page.getByRole('button', { name: 'Redo' })
  await expect(undo).toBeDisabled()

  await test.step('a drag is one step to undo, and the verdict follows', async () => {
    await drag(page, 2, [160, -160])
    await expect(verdictOf(page)).toHaveText(/^\s*VALID/)
    await expect(claimsOf(page).filter({ hasText: /: does not hold/ })).toHaveCount(1)
    await expect(stepOf(page)).toContainText('You have changed the quadrilateral.')
    await undo.click()
    await expect(verdictOf(page)).toHaveText(/INVALID/)
    await expect.poll(() => linkOf(page)).toBe(own)
    await redo.click()
    await expect(verdictOf(page)).toHaveText(/^\s*VALID/)
    await elementOf(page).press('Control+z')
    await expect.poll(() => linkOf(page)).toBe(own)
  })

  await test.step('Escape ends a drag where it began', async () => {
    await drag(page, 2, [160, -160], false)
    await expect(verdictOf(page)).toHaveText(/^\s*VALID/)
    await expect(elementOf(page).locator('.ghost')).toHaveCount(1)
    await expect(readoutOf(page)).toHaveText(/^Corner 2: \([\d.]+, [\d.]+\)$/)
    await page.keyboard.press('Escape')
    await page.mouse.up()
    await expect.poll(() => linkOf(page)).toBe(own)
    await expect(undo).toBeDisabled()
  })

  await test.step('a corner that was dragged out of sight is brought back into it', async () => {
    await drag(page, 1, [700, 0])
    const box = await elementOf(page).boundingBox()
    const { x } = await middleOf(page, 1)
    expect(x).toBeLessThan((box?.x ?? 0) + (box?.width ?? 0))
    await undo.click()
  })

  await test.step('keys choose and move, arrows do not change the step, and it is said', async () => {
    await elementOf(page).focus()
    await page.keyboard.press('1')
    await expect(elementOf(page)).toHaveAccessibleName(/Corner 1 is chosen, at 2, 0\./)
    await page.keyboard.press('ArrowRight')
    await expect(elementOf(page)).toHaveAccessibleName(/Corner 1 is chosen, at 2\.1, 0\./)
    await page.keyboard.press('Control+ArrowUp')
    await expect(elementOf(page)).toHaveAccessibleName(/Corner 1 is chosen, at 2\.1, 0\.01\./)
    await expect(page.getByRole('status').filter({ hasText: /^Corner 1: 2\.1, 0\.01\. Least jacdet -/ })).toHaveCount(1)
    await expect(page).toHaveURL(/#quadrilaterals-first\/5$/)
    const moved = await linkOf(page)
    await page.reload()
    await expect.poll(() => linkOf(page)).toBe(moved)
    await page.getByRole('button', { name: 'Restore this step' }).click()
    await expect.poll(() => linkOf(page)).toBe(own)
  })

  await inSchemesAndWidths(lens, async () => {
    await page.mouse.move(
      ...(await squareOf(page)
        .boundingBox()
        .then(box => [(box?.x ?? 0) + 40, (box?.y ?? 0) + 90] as const)),
    )
    await expect(page.locator('.plane .little')).toHaveCount(2)
    await expectAxeFindsNothing(page)
    await expectLargeTargets(page.locator('.plane button, .plane svg'))
  })
})

test.describe('without the core', () => {
  test.use({ expectedErrors: /Failed to load resource/ })

  test('the plane is drawn and dragged, and says that there is no verdict', async ({ lens: _, page }) => {
    for (const part of ['**/*.wasm*', '**/*twin*']) await page.route(part, route => route.abort())
    await page.setViewportSize({ width: 1440, height: 900 })
    await page.goto('lessons.html#quadrilaterals-first/3')
    await expect(stepOf(page).getByRole('button', { name: 'I expect it here' })).toBeDisabled()
    await stepOf(page).getByRole('button', { name: 'Show it' }).click()
    await expect(verdictOf(page)).toHaveText(/NO VERDICT\s*The core could not start\./)
    const own = await linkOf(page)
    await drag(page, 2, [60, 40])
    await expect.poll(() => linkOf(page)).not.toBe(own)
    await expect(elementOf(page).locator('[fill^=rgb]').first()).toBeAttached()
  })
})

test('pointing at one picture marks the same point in the other, mirrored where it is red', async ({
  lens: _,
  page,
}) => {
  await page.setViewportSize({ width: 1440, height: 900 })
  await page.goto('lessons.html#quadrilaterals-first/5')
  await expect(verdictOf(page)).toHaveText(/INVALID/)
  const rim = async (of: Locator) => {
    const box = await of.locator('.edges').boundingBox()
    if (!box) throw new Error('There is no outline.')
    return box
  }
  const square = await rim(squareOf(page))
  const at = (xi: number, eta: number) =>
    page.mouse.move(square.x + xi * square.width, square.y + (1 - eta) * square.height)

  await at(0.25, 0.25)
  await expect(readoutOf(page)).toHaveText(/\(0\.25\d*, 0\.25\d*\)|\(0\.2[45]\d*, 0\.2[45]\d*\)/)
  await expect(elementOf(page).locator('.little')).toHaveCount(1)
  await expect(elementOf(page).locator('.little.negative')).toHaveCount(0)
  await at(0.95, 0.95)
  await expect(readoutOf(page)).toHaveText(/J = −0\.\d+\. Areas: 0\.04 and −0\.0\d+, inside out\./)
  await expect(elementOf(page).locator('.little.negative')).toHaveCount(1)

  const middle = async (of: Locator) => {
    const box = await of.locator('.little .point').boundingBox()
    return [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2] as const
  }
  await at(0.4, 0.3)
  await expect(readoutOf(page)).toHaveText(/\((0\.4|0\.39\d*|0\.40\d*), (0\.3|0\.29\d*|0\.30\d*)\)/)
  const [before, inElement] = [await middle(squareOf(page)), await middle(elementOf(page))]
  await page.mouse.move(square.x + square.width + 40, square.y - 60)
  await page.mouse.move(...inElement)
  await expect.poll(async () => Math.abs((await middle(squareOf(page)))[0] - before[0])).toBeLessThan(2)
  expect(Math.abs((await middle(squareOf(page)))[1] - before[1])).toBeLessThan(2)

  await squareOf(page).focus()
  await page.keyboard.press('Escape')
  await expect(page.locator('.plane .little')).toHaveCount(0)
  await page.keyboard.press('ArrowRight')
  await expect(readoutOf(page)).toHaveText(/\(0\.55, 0\.5\)/)
})

test.describe('on a phone', () => {
  test.use({ hasTouch: true, viewport: phone })

  test('a finger drags a corner, a tap marks a point, and the page scrolls beside them', async ({ lens: _, page }) => {
    await page.goto('lessons.html#quadrilaterals-first/5')
    await expect(verdictOf(page)).toHaveText(/INVALID/)
    const own = await linkOf(page)
    const client = await page.context().newCDPSession(page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', x: number, y: number) =>
      client.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y }] })
    const swipe = async (from: { x: number; y: number }, by: readonly [number, number]) => {
      await touch('touchStart', from.x, from.y)
      for (const part of [0.2, 0.4, 0.6, 0.8, 1]) await touch('touchMove', from.x + part * by[0], from.y + part * by[1])
      await touch('touchEnd', 0, 0)
    }
    const scrolled = () => page.evaluate(() => scrollY)

    const before = await scrolled()
    await swipe(await middleOf(page, 2), [60, -60])
    await expect(verdictOf(page)).toHaveText(/^\s*VALID/)
    expect(await scrolled()).toBe(before)
    expect(await linkOf(page)).not.toBe(own)

    await page.touchscreen.tap(330, 150)
    await expect(page.locator('.plane .little')).toHaveCount(2)
    const { x, y } = await page
      .locator('.plane .square .edges')
      .boundingBox()
      .then(box => box as { x: number; y: number })
    await swipe({ x: x + 20, y: y + 80 }, [0, -70])
    await expect.poll(scrolled).toBeGreaterThan(before)
  })
})

test('a question is asked before the step is shown: choosing, pressing, dragging, giving up', async ({
  lens,
  page,
}) => {
  await page.setViewportSize({ width: 1440, height: 900 })
  await page.goto('lessons.html#quadrilaterals-first/4')
  const question = stepOf(page).getByRole('group', { name: 'Question' })

  await test.step('until then neither colours nor verdict nor claims are there', async () => {
    await expect(question.getByRole('button')).toHaveText(['Corner 0', 'Corner 1', 'Corner 2', 'Corner 3', 'Show it'])
    await expect(page.locator('.plane .least, .plane .verdict, .plane [fill^=rgb]')).toHaveCount(0)
    await expect(claimsOf(page)).toHaveCount(0)
    await expect(stepOf(page).locator('.task')).toHaveCount(0)
    await expectAxeFindsNothing(page)
  })

  await test.step('a wrong answer is told so, and the right one with its numbers', async () => {
    await question.getByRole('button', { name: 'Corner 0' }).click()
    const judged = question.locator('.judged')
    await expect(judged).toBeFocused()
    await expect(judged).toContainText('Not quite. It is: Corner 2.')
    await expect(question.getByRole('listitem').filter({ hasText: 'right' })).toHaveText(/Corner 2.*11\/16/s)
    await expect(question.getByRole('listitem').filter({ hasText: 'your answer' })).toHaveText(/Corner 0/)
    await expect(verdictOf(page)).toHaveText(/VALID\s+Least J: 11\/16, at corner 2/)
    await expect(claimsOf(page).filter({ hasText: /: holds/ })).toHaveCount(2)
  })

  await test.step('it is still answered after a reload, and can be asked again: by pressing the corner', async () => {
    await page.reload()
    await expect(question.locator('.judged')).toContainText('Not quite.')
    await question.getByRole('button', { name: 'Ask me again' }).click()
    await expect(question.getByRole('button', { name: 'Corner 0' })).toBeFocused()
    await expect(page.locator('.plane .least')).toHaveCount(0)
    const own = await linkOf(page)
    await drag(page, 2, [80, 80])
    expect(await linkOf(page)).toBe(own)
    await expect(question.locator('.judged')).toContainText('Right.')
  })

  await test.step('by dragging: the core judges what is handed in', async () => {
    await page.getByRole('button', { name: 'Previous' }).click()
    const look = question.getByRole('button', { name: 'I expect it here' })
    await expect(look).toBeVisible()
    await look.click()
    await expect(question.locator('.judged')).toContainText('Not quite.')
    await question.getByRole('button', { name: 'Ask me again' }).click()
    // On to the middle between corners 1 and 3.
    const [corner, one, three] = [await middleOf(page, 2), await middleOf(page, 1), await middleOf(page, 3)]
    await drag(page, 2, [(one.x + three.x) / 2 - corner.x, (one.y + three.y) / 2 - corner.y])
    await expect(page.locator('.plane .verdict')).toHaveCount(0)
    const dragged = await linkOf(page)
    await look.click()
    await expect(question.locator('.judged')).toContainText('Right.')
    await expect(verdictOf(page)).toBeVisible()
    expect(await linkOf(page)).toBe(dragged)
  })

  await test.step('in the lens the element before the answer is another one; Show it shows the step’s own', async () => {
    await lens.open('lessons.html#what-the-jacobian-determinant-is/7')
    await expect(lens.verdict).toHaveText(/^VALID/)
    await expect(stepOf(page)).not.toContainText('You have changed')
    await question.getByRole('button', { name: 'Show it' }).press('Enter')
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await expect(question.locator('.judged')).toContainText('It is: The volume is still positive.')
    await expect(claimsOf(page).filter({ hasText: /: holds/ })).toHaveCount(4)
    await expect(stepOf(page)).not.toContainText('You have changed')
  })
})

test('the overview: times, progress that is kept and can be forgotten, and the way back', async ({ lens, page }) => {
  await page.goto('lessons.html')
  const rows = page.locator('.overview li')
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Lessons')
  await expect(rows).toHaveCount(7)
  for (const row of await rows.all()) await expect(row).toContainText(/\d+ min/)
  await expect(page.getByText(/The times are estimates/)).toBeVisible()
  await expect(page.locator('hex-lens')).toBeHidden()
  await inSchemesAndWidths(lens, async () => {
    await expectAxeFindsNothing(page)
    await expectLargeTargets(page.locator('.column a, .column button'))
  })

  await page.getByRole('link', { name: 'Begin' }).click()
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Quadrilaterals first')
  await page.goBack()
  await expect(rows.nth(0)).toContainText('1 of 6 steps seen')
  await rows.nth(2).getByRole('link').click()
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await page.getByText('Lesson 2 of 6').click()
  await page.getByRole('link', { name: 'All lessons' }).click()
  await expect(rows.nth(2)).toContainText('1 of 6 steps seen')
  await expect(page).toHaveTitle(/Hexlens: lessons/)

  await rows.nth(2).getByRole('link').click()
  await page.getByRole('button', { name: 'Next', exact: true }).click()
  await expect(page).toHaveURL(/#corners-are-not-enough\/2$/)
  await page.goto('./')
  await page.getByRole('navigation').getByRole('link', { name: 'Lessons' }).click()
  await expect(rows.nth(2)).toContainText('2 of 6 steps seen')
  await expect(page.getByText('Lesson 2, step 2: Between two corners')).toBeVisible()
  await expectAxeFindsNothing(page)
  await page.getByRole('link', { name: 'Continue' }).click()
  await expect(page).toHaveURL(/#corners-are-not-enough\/2$/)
  await page.goBack()
  await page.getByRole('button', { name: 'Forget it' }).click()
  await expect(page.locator('.column')).toBeFocused()
  await expect(rows.nth(2)).toContainText('6 steps')
  await page.reload()
  await expect(page.getByRole('link', { name: 'Begin' })).toBeVisible()
  expect(await page.evaluate(() => localStorage.getItem('hexlens-lessons'))).toBeNull()
})

test('words of the glossary say what they mean: pointed at, focused or tapped, until Escape', async ({
  lens,
  page,
}) => {
  await lens.open('lessons.html#what-the-jacobian-determinant-is/3')
  const word = stepOf(page).getByRole('button', { name: 'Jacobian determinant' })
  const box = page.locator('.meaning')
  await expect(word).toHaveAccessibleDescription(/the factor by which the map changes the volume/)
  await expect(box).toBeHidden()

  await word.hover()
  await expect(box).toContainText('jacdet The Jacobian determinant')
  await box.hover()
  await expect(box).toBeVisible()
  await page.mouse.move(5, 300)
  await expect(box).toBeHidden()

  await word.focus()
  await expect(box).toBeVisible()
  await expectAxeFindsNothing(page)
  await page.keyboard.press('Escape')
  await expect(box).toBeHidden()
  await expect(word).toBeFocused()

  await inSchemesAndWidths(lens, async () => {
    await word.scrollIntoViewIfNeeded()
    await word.click()
    await expect(box).toBeInViewport({ ratio: 1 })
    await page.keyboard.press('Escape')
    await expect(box).toBeHidden()
  })
})

test('formulas have their own font, which the page’s policy allows and others’ do not', async ({ lens: _, page }) => {
  await page.goto('lessons.html#finding-the-minimum/4')
  await expect
    .poll(() => page.evaluate(() => [...document.fonts].map(({ family, status }) => `${family} ${status}`)))
    .toEqual([expect.stringMatching(/^"?Lesson Math"? loaded$/)])
  const policyOf = () => page.locator('meta[http-equiv=Content-Security-Policy]').getAttribute('content')
  expect(await policyOf()).toContain("font-src 'self'")
  // A prime stands at its letter.
  const [letter, prime] = await stepOf(page)
    .locator('math[display=block] mrow:has(> mo)')
    .first()
    .evaluate(row =>
      [...row.children].map(part => part.getBoundingClientRect()).map(({ left, right }) => ({ left, right })),
    )
  expect(Math.abs((prime?.left ?? 0) - (letter?.right ?? 99))).toBeLessThan(1)
  await page.goto('gallery.html')
  expect(await policyOf()).toContain("font-src 'none'")
})
