import AxeBuilder from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { challengeFragment } from '../../web/pages/challenges/challenge-link'
import { challenges } from '../../web/pages/challenges/challenges'
import { expect, expectLargeTargets, inSchemesAndWidths, type Lens, test } from './lens'

const column = (page: Page) => page.locator('#column')
const outcome = (page: Page) => page.locator('#column .outcome')
/** The numbers stand beside the scene. */
const ROOMY = { width: 1350, height: 480 }
const condition = (page: Page, n: number) => column(page).getByRole('combobox', { name: `Condition ${n}`, exact: true })
const CUBE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const marks = (page: Page) => page.locator('#column .goal li')

async function openChallenges(lens: Lens, fragment: string): Promise<void> {
  await lens.page.goto('about:blank')
  await lens.open(`./challenges.html${fragment}`)
}

/** The scene, which axe looks at elsewhere, is left out: it would be drawn for nothing. */
async function expectAxeFindsNothingInColumn({ element, page }: Lens): Promise<void> {
  await element.evaluate(lens => lens.setAttribute('views', 'verdict'))
  const { violations } = await new AxeBuilder({ page })
    .setLegacyMode()
    .options({ rules: { 'target-size': { enabled: true } } })
    .include('#column')
    .analyze()
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map(node => node.html).join('; ')}`)).toEqual([])
}

test('a challenge is solved by keyboard, kept, shared, explained and forgotten', async ({ lens, page }) => {
  await openChallenges(lens, '')

  await test.step('the list says what there is and what is solved; axe finds nothing', async () => {
    await expect(column(page).getByRole('listitem')).toHaveText(
      challenges.map(({ title }) => new RegExp(`^\\s*${title}\\s*$`)),
    )
    await expect(column(page)).toContainText(`0 of ${challenges.length} solved. It is kept in this browser alone.`)
    await expectAxeFindsNothingInColumn(lens)
    await page.setViewportSize(ROOMY)
  })

  await test.step('one is judged live, and solved by keyboard', async () => {
    await column(page).getByRole('link', { name: 'Break it with one vertex' }).click()
    await expect(column(page).getByRole('heading', { name: 'Break it with one vertex' })).toBeFocused()
    await expect(marks(page)).toHaveText([
      /Not met:\s*Invalid\s*, now it is valid/,
      /Met:\s*Moved vertices ≤ 1\s*, now 0/,
    ])
    await page.getByRole('link', { name: 'Skip to the challenges' }).press('Enter')
    await expect(page.locator('#column')).toBeFocused()
    expect(page.url()).toContain('#challenge=one-vertex')
    await lens.scene.focus()
    await page.keyboard.press('6')
    for (let n = 0; n < 10; n++) await page.keyboard.press('Shift+ArrowDown')
    await expect(lens.field(6, 'z')).toHaveValue('0')
    await expect(outcome(page)).toHaveText('Solved: every condition holds.')
    await expect(marks(page).first()).toHaveText(/Met:\s*Invalid\s*, now it is invalid/)
    await expect(column(page).getByRole('link', { name: 'Next: Touch zero exactly' })).toBeVisible()
    expect(new URL(page.url()).hash).toBe(
      `#${challengeFragment({ kind: 'challenge', id: 'one-vertex', vertices: await lens.vertices() })}`,
    )
  })

  await test.step('undo takes it back, start again begins anew', async () => {
    await column(page).getByRole('button', { name: 'Undo' }).click()
    await expect(outcome(page)).toBeEmpty()
    await expect(lens.verdict).toHaveText(/^VALID/)
    await lens.field(6, 'z').fill('-0.125')
    await lens.field(6, 'z').press('Enter')
    await expect(outcome(page)).toHaveText('Solved: every condition holds.')
    await lens.field(0, 'x').fill('-0.5')
    await lens.field(0, 'x').press('Enter')
    await expect(marks(page).nth(1)).toHaveText(/Not met:\s*Moved vertices ≤ 1\s*, now 2/)
    await column(page).getByRole('button', { name: 'Start again' }).click()
    await expect(marks(page).nth(1)).toHaveText(/, now 0/)
    expect(await lens.vertices()).toEqual(challenges[0]?.start)
  })

  await test.step('hint and solution come on request; a solution that is shown is not one that is solved', async () => {
    await column(page).getByRole('link', { name: 'All challenges' }).click()
    await expect(column(page)).toContainText(`1 of ${challenges.length} solved.`)
    await column(page).getByRole('link', { name: 'Touch zero exactly' }).click()
    const hint = column(page).getByText('Put a vertex into the plane of its three neighbours')
    await expect(hint).toBeHidden()
    await column(page).getByRole('button', { name: 'Hint' }).click()
    await expect(hint).toBeVisible()
    await column(page).getByRole('button', { name: 'Show a solution' }).click()
    await expect(outcome(page)).toHaveText('This is the stored solution.')
    await expect(marks(page)).toHaveText(/Met:\s*Boundary minimum = 0\s*, now 0/)
    await inSchemesAndWidths(lens, () => expectAxeFindsNothingInColumn(lens))
    await expectLargeTargets(column(page).locator('button, summary'))
  })

  await test.step('a link shares a solution bit for bit; progress survives, and can be forgotten', async () => {
    const vertices = [...(challenges[0]?.solution ?? [])]
      .map(Number)
      .with(0, -0)
      .with(18, 0.1 + 0.2)
    await openChallenges(lens, `#${challengeFragment({ kind: 'challenge', id: 'one-vertex', vertices })}`)
    await expect(outcome(page)).toHaveText('Solved: every condition holds.')
    expect(await lens.bits()).toEqual(Array.from(new BigUint64Array(Float64Array.from(vertices).buffer), String))
    await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }))
    await column(page).getByRole('button', { name: 'Copy link to this element' }).click()
    await expect(column(page).getByRole('textbox', { name: 'Link to this element' })).toHaveValue(page.url())
    await column(page).getByRole('link', { name: 'All challenges' }).click()
    await expect(column(page).getByRole('listitem').first()).toHaveText(/solved/)
    await column(page).getByRole('button', { name: 'Forget what I have solved' }).click()
    await expect(column(page)).toContainText('0 of')
    await expect(column(page).getByRole('button', { name: 'Forget what I have solved' })).toBeHidden()
  })

  await test.step('all that is kept can be forgotten, elements and undo, too', async () => {
    const kept = () => page.evaluate(() => [localStorage, sessionStorage].flatMap(storage => Object.keys(storage)))
    expect(await kept()).toContain('hexlens-challenge-one-vertex-1')
    await page.evaluate(() => localStorage.setItem('others', 'stay'))
    await column(page).getByRole('button', { name: 'Forget what is kept here' }).click()
    await expect(column(page).getByRole('button', { name: 'Keep it' })).toBeFocused()
    await expectAxeFindsNothingInColumn(lens)
    await column(page).getByRole('button', { name: 'Forget it all' }).click()
    await expect(column(page)).toContainText('Nothing is kept any more.')
    expect(await kept()).toEqual(['others'])
    await column(page).getByRole('link', { name: 'Break it with one vertex' }).click()
    await expect(marks(page).nth(1)).toHaveText(/, now 0/)
  })
})

test('a teacher writes a challenge in a link; what cannot be read is said', async ({ lens, page }) => {
  await openChallenges(lens, '#write')
  await page.setViewportSize(ROOMY)
  const make = column(page).getByRole('button', { name: 'Make the link' })
  const complaint = column(page).getByRole('alert')

  await test.step('with a form that says what is wrong', async () => {
    await lens.set(CUBE)
    await make.click()
    await expect(complaint).toHaveText('The title is empty.')
    await column(page).getByRole('textbox', { name: 'Title' }).fill('Squeeze it')
    await column(page).getByLabel('What it is about').fill('Keep it valid,\nwith J < 1/8 somewhere.')
    await column(page).getByText('The conditions as text').click()
    const text = column(page).getByRole('textbox', { name: 'The conditions as text, one a line' })
    await expect(text).toHaveValue('not valid\ncorner_min > 0')
    await text.fill('valid\nsmoothness > 3')
    await make.click()
    await expect(complaint).toContainText('Condition 2, “smoothness > 3”, is not understood at character 1')
    await expect(condition(page, 2)).toHaveValue('text')
    await expect(column(page).getByRole('textbox', { name: 'Condition 2 as text' })).toHaveAccessibleDescription(
      /^At character 1: “smoothness” is not a name/,
    )
    await text.fill('valid\nboundary_min < 1/8')
    await text.blur()
    await expect(condition(page, 2)).toHaveValue('boundary_min')
    await column(page).getByRole('button', { name: 'Take the element as the start' }).click()
    await make.click()
    await expect(complaint).toBeEmpty()
    await inSchemesAndWidths(lens, () => expectAxeFindsNothingInColumn(lens))
    await expectLargeTargets(column(page).locator('button, input, textarea, summary, select'))
    await page.setViewportSize(ROOMY)
  })

  await test.step('the link opens it, to be solved as any other', async () => {
    const link = await column(page).getByRole('textbox', { name: 'Link to the challenge' }).inputValue()
    await column(page).getByRole('link', { name: 'Open it' }).click()
    expect(page.url()).toBe(link)
    await expect(column(page).getByRole('heading', { name: 'Squeeze it' })).toBeVisible()
    await expect(column(page)).toContainText('with J < 1/8 somewhere.')
    await lens.field(6, 'z').fill('0.0625')
    await lens.field(6, 'z').press('Enter')
    await expect(outcome(page)).toHaveText('Solved: every condition holds.')
    expect(page.url()).toMatch(/^[^#]*#own=%7B%22version%22.*&v=1&vertices=/)
    await page.reload()
    await expect(outcome(page)).toHaveText('Solved: every condition holds.')
  })

  await test.step('and links that hold no challenge say why', async () => {
    const own = (text: string) =>
      `#own=${encodeURIComponent(JSON.stringify({ version: 1, title: 'T', text, start: challenges[0]?.start, goal: ['valid'] }))}`
    for (const [fragment, sentence] of [
      [own('<img src=x>'), 'challenge.text is plain text, but it holds “<i”, which looks like HTML.'],
      ['#own=%7B', 'The challenge is not JSON'],
      ['#challenge=none', 'There is no challenge “none”.'],
      ['#challenge=one-vertex&v=1&vertices=1', 'The link holds 1 number where 24 are needed.'],
    ] as const) {
      await page.evaluate(hash => {
        location.hash = hash
      }, fragment)
      await expect(complaint).toContainText(sentence)
    }
    await expect(page.locator('#column img')).toHaveCount(0)
  })
})
