import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { checks } from '../../web/content/checks'
import { presets, presetVertices } from '../../web/content/presets'
import type { CheckId } from '../../web/core/report'
import { expect, test } from './lens'

/** Valid elements, proved by exact subdivision, that a subdivision which gives up past depth 4 rejects. */
const depthGuardCases: readonly { readonly vertices: readonly (readonly number[])[] }[] = JSON.parse(
  readFileSync(new URL('../vectors/depth_guard_false_negatives.json', import.meta.url), 'utf8'),
)

const rowOf = (page: Page, id: CheckId) =>
  page.getByRole('table', { name: 'Who would notice?' }).getByRole('row', { name: checks[id].name })

/** What a screen reader says of the row. */
const answer = (page: Page, id: CheckId) => rowOf(page, id).getByRole('cell').last()

test('every answer agrees with the verdict or is called wrong, and says what it looks at', async ({ lens, page }) => {
  await lens.open()

  await test.step('the first screen shows who passes an invalid element and who notices', async () => {
    for (const id of ['corners', 'corners-and-centre', 'gauss-2', 'gauss-3'] as const)
      await expect(answer(page, id)).toHaveText(/passes it, wrong\s+✗/)
    for (const id of ['edges', 'bernstein', 'subdivision'] as const)
      await expect(answer(page, id)).toHaveText(/rejects it, agrees\s+✓/)
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
      await expect(answer(page, 'subdivision')).toHaveText(/rejects it, wrong\s+✗/)
    }
  })

  await test.step('every answer agrees with the verdict or is called wrong', async () => {
    for (const preset of presets.filter(({ valid }) => valid !== null)) {
      await lens.set(presetVertices(preset))
      for (const id of Object.keys(checks) as CheckId[]) {
        const text = await answer(page, id).innerText()
        const agrees = text.startsWith('passes it') === preset.valid
        expect(text, `${preset.id}: ${id}`).toContain(agrees ? ', agrees' : ', wrong')
      }
    }
  })
})
