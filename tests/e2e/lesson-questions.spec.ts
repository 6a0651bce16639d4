/** Questions of the lessons beside the lens, derivations in foldouts, and the minimum computed without the theorem. */
import type { Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, test } from './lens'

const stepOf = (page: Page) => page.getByRole('article').filter({ has: page.locator('[aria-current=step]') })
const questionOf = (page: Page) => stepOf(page).getByRole('group', { name: 'Question' })
const claimsOf = (page: Page) => stepOf(page).getByRole('list', { name: 'Computed' }).getByRole('listitem')

interface Choice {
  readonly step: string
  readonly right: string
  readonly wrong: string
  /** The verdict that is on the screen before the answer; null if there is none. */
  readonly before: RegExp | null
}

const choices: readonly Choice[] = [
  {
    step: 'edges-are-not-enough/2',
    right: 'It is negative on some part of a face',
    wrong: 'It just touches zero on a face',
    before: /^VALID/,
  },
  {
    step: 'faces-are-enough/4',
    right: 'Negative: red goes through from bottom to top',
    wrong: 'Positive: the two red parts are apart',
    before: null,
  },
  { step: 'strictly/2', right: 'Less than zero', wrong: 'Exactly zero', before: null },
  {
    step: 'finding-the-minimum/7',
    right: 'No: all coefficients are at least 1',
    wrong: 'Yes: some coefficient is below 1',
    before: /^VALID/,
  },
]

for (const { step, right, wrong, before } of choices)
  test(`${step}: asks before it shows, and judges by the core`, async ({ lens, page }) => {
    await page.goto(`lessons.html#${step}`)
    const question = questionOf(page)
    await expect(question.getByRole('button', { name: right })).toBeVisible()
    await expect(claimsOf(page)).toHaveCount(0)
    await expect(stepOf(page).locator('.task')).toHaveCount(0)
    await expect(lens.scene).toBeVisible()
    if (before) await expect(lens.verdict).toHaveText(before)
    else await expect(lens.verdict).toHaveCount(0)
    await expect
      .poll(() => lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).complete))
      .toBe(true)
    await expectAxeFindsNothing(page)

    await question.getByRole('button', { name: wrong }).click()
    await expect(question.locator('.judged')).toBeFocused()
    await expect(question.locator('.judged')).toContainText(`Not quite. It is: ${right}.`)
    await expect(question.getByRole('listitem').filter({ hasText: ': right' })).toHaveCount(1)
    await expect(stepOf(page)).not.toContainText('You have changed')
    await expect(claimsOf(page).filter({ hasText: /: holds/ })).not.toHaveCount(0)

    await question.getByRole('button', { name: 'Ask me again' }).click()
    await question.getByRole('button', { name: right }).press('Enter')
    await expect(question.locator('.judged')).toContainText('Right.')
    await expectAxeFindsNothing(page)
  })

test('a vertex of the lens is dragged to the place that is asked for', async ({ lens, page }) => {
  await lens.open('lessons.html#corners-are-not-enough/5')
  const question = questionOf(page)
  const handIn = question.getByRole('button', { name: 'I expect it here' })
  const own = await lens.vertices()
  const at = (t: number) => own.map((x, i) => (Math.floor(i / 3) === 6 ? t : x))
  await expect(handIn).toBeEnabled()
  await expect(page.getByRole('table', { name: /Who would notice/ })).toHaveCount(0)

  await test.step('by keys, not far enough: the element stays as it was handed in', async () => {
    await lens.scene.focus()
    await page.keyboard.press('6')
    await page.keyboard.press('ArrowLeft')
    await expect.poll(() => lens.vertices()).not.toEqual(own)
    const moved = await lens.vertices()
    await handIn.click()
    await expect(question.locator('.judged')).toBeFocused()
    await expect(question.locator('.judged')).toContainText('Not quite.')
    await expect(page.getByRole('table', { name: /Who would notice/ })).toBeVisible()
    expect(await lens.vertices()).toEqual(moved)
    await expect(stepOf(page)).toContainText('You have changed the element.')
  })

  await test.step('asked again, it begins with the step’s own element', async () => {
    await question.getByRole('button', { name: 'Ask me again' }).click()
    await expect.poll(() => lens.vertices()).toEqual(own)
    await expect(page.getByRole('table', { name: /Who would notice/ })).toHaveCount(0)
  })

  await test.step('far enough, and not too far', async () => {
    for (const [t, judgement] of [
      [0.464, 'Right.'],
      [0.3, 'Not quite.'],
    ] as const) {
      await lens.set(at(t))
      await expect(lens.verdict).toHaveText(/^INVALID/)
      await handIn.click()
      await expect(question.locator('.judged')).toContainText(judgement)
      expect(await lens.vertices()).toEqual(at(t))
      await question.getByRole('button', { name: 'Ask me again' }).click()
    }
  })

  await inSchemesAndWidths(lens, async () => {
    await expectAxeFindsNothing(page)
    await expectLargeTargets(page.locator('.column button:not(.term), .column summary'))
  })
})

test('a derivation is opened by a key and stays open while the element changes', async ({ lens, page }) => {
  await lens.open('lessons.html#faces-are-enough/6')
  const foldout = stepOf(page).locator('.foldout')
  await expect(foldout).not.toHaveAttribute('open')
  await foldout.locator('summary').press('Enter')
  await expect(foldout.locator('math').last()).toBeVisible()
  await lens.scene.focus()
  await page.keyboard.press('2')
  await page.keyboard.press('ArrowRight')
  await expect(stepOf(page)).toContainText('You have changed the element.')
  await expect(foldout).toHaveAttribute('open')
  await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page))
})

test('the minimum of the whole element is computed apart, also while the element changes', async ({ lens, page }) => {
  await lens.open('lessons.html#faces-are-enough/7')
  const figure = stepOf(page).locator('figure')
  await expect(figure).toContainText(/Whole element, by \d+ boxes\s+15\/64/)
  await expect(figure).toContainText(/Boundary, by candidates\s+15\/64\s+The two agree/)
  await lens.open('lessons.html#faces-are-enough/5')
  const tube = await lens.vertices()
  await lens.open('lessons.html#faces-are-enough/7')
  await lens.set(tube)
  await expect(figure).toContainText(
    /boxes\s+−0\.10156.*Boundary, by candidates\s+−1\/16\s+The least jacdet is inside/s,
  )
})
