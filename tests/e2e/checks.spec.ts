import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import type { CheckId } from '../../web/core/report'
import { presets, presetVertices } from '../../web/model/presets'
import { checks } from '../../web/panels/checks/check-words'
import { expect, test } from './lens'

/** Valid elements, proved by exact subdivision, that a subdivision which gives up past depth 4 rejects. */
const depthGuardCases: readonly { readonly vertices: readonly (readonly number[])[] }[] = JSON.parse(
  readFileSync(new URL('../vectors/depth_guard_false_negatives.json', import.meta.url), 'utf8'),
)

const rowOf = (page: Page, id: CheckId) =>
  page.getByRole('table', { name: 'Who would notice?' }).getByRole('row', { name: checks[id].name })

/** The row's answer, as a screen reader says it. */
const answer = (page: Page, id: CheckId) => rowOf(page, id).getByRole('cell').last()

test('every answer agrees with the verdict or is called wrong, and says what it looks at', async ({ lens, page }) => {
  await lens.open()

  await test.step('the first screen shows who accepts an invalid element and who notices', async () => {
    for (const id of ['corners', 'corners-and-centre', 'gauss-2', 'gauss-3'] as const)
      await expect(answer(page, id)).toHaveText(/accepts: wrong\s+✗/)
    for (const id of ['edges', 'bernstein', 'subdivision'] as const)
      await expect(answer(page, id)).toHaveText(/rejects: agrees\s+✓/)
    await expect(answer(page, 'tangents')).toHaveText(/cannot tell: agrees\s+✓/)
    await expect(rowOf(page, 'corners')).toContainText('3/64')
    await expect(rowOf(page, 'corners')).toContainText('deal.II')
    await expect(rowOf(page, 'corners-and-centre')).toContainText('0.28868')
  })

  await test.step('what each looks at is one press away', async () => {
    const sentence = page.getByText(checks.subdivision.looksAt)
    await expect(sentence).toBeHidden()
    await page.getByText('What each looks at').press('Enter')
    await expect(sentence).toBeVisible()
  })

  await test.step('the valid elements that a guarded subdivision rejects are shown as wrongly rejected', async () => {
    for (const { vertices } of depthGuardCases) {
      await lens.set(vertices.flat())
      await expect(lens.verdict).toHaveText(/^VALID/)
      await expect(answer(page, 'subdivision')).toHaveText(/rejects: wrong\s+✗/)
    }
  })

  await test.step('every answer agrees with the verdict or is called wrong', async () => {
    for (const preset of presets.filter(({ valid }) => valid !== null)) {
      await lens.set(presetVertices(preset))
      for (const id of Object.keys(checks) as CheckId[]) {
        const text = (await answer(page, id).textContent())?.trim() ?? ''
        const agrees = /^(accepts|certifies):/.test(text) === preset.valid
        const wrong = text.startsWith('cannot tell:') ? ': leaves it open' : ': wrong'
        expect(text, `${preset.id}: ${id}`).toContain(agrees ? ': agrees' : wrong)
      }
    }
  })
})

test('a wedge as a hexahedron has Verdict’s number, and what it means', async ({ lens, page }) => {
  await lens.open()
  await lens.set([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1, 1])
  const row = rowOf(page, 'corners-and-centre')
  await expect(row.locator('data')).toHaveAttribute('value', '1e+30')
  await expect(row).toContainText('to Verdict an edge or axis has no length')
  await expect(answer(page, 'corners-and-centre')).toHaveText(/accepts: wrong\s+✗/)
})

test('a row that is pointed at has its points marked in the scene and in the reference cube', async ({
  lens,
  page,
}) => {
  await lens.open()
  const marks = page.locator('.scene-overlay .samples')
  const dots = async (scene: number) => {
    const lines = await marks.nth(scene).locator('.line').all()
    const paths = await Promise.all(lines.map(line => line.getAttribute('d')))
    return paths.join('').match(/h0/g)?.length ?? 0
  }

  await test.step('by the mouse, and no longer', async () => {
    await rowOf(page, 'gauss-2').hover()
    await expect(marks.first()).toBeVisible()
    expect(await dots(0)).toBe(8)
    await rowOf(page, 'gauss-3').hover()
    await expect.poll(() => dots(0)).toBe(27)
    await rowOf(page, 'edges').hover()
    await expect.poll(() => dots(0)).toBe(0)
    await expect(marks.first()).toBeVisible()
    await page.mouse.move(5, 5)
    await expect(marks.first()).toBeHidden()
  })

  await test.step('by the keys that go from number to number', async () => {
    await rowOf(page, 'corners').getByRole('button').focus()
    await expect(marks.first()).toBeVisible()
    await expect.poll(() => dots(0)).toBe(8)
    await page.keyboard.press('ArrowDown')
    await expect.poll(() => dots(0)).toBe(9)
    await page.getByText('What each looks at').focus()
    await expect(marks.first()).toBeHidden()
  })

  await test.step('in the reference cube at the same points', async () => {
    await page.getByRole('button', { name: 'Reference cube' }).click()
    await rowOf(page, 'bernstein').hover()
    await expect(marks).toHaveCount(2)
    await expect.poll(() => dots(1)).toBe(20)
    await page.mouse.move(5, 5)
  })
})

test.describe('by touch', () => {
  test.use({ hasTouch: true })

  test('a tap on a row marks it until one elsewhere', async ({ lens, page }) => {
    await lens.open()
    const mark = page.locator('.scene-overlay .samples').first()
    await rowOf(page, 'gauss-2').getByRole('rowheader').tap()
    await expect(mark).toBeVisible()
    await lens.verdict.tap()
    await expect(mark).toBeHidden()
  })
})
