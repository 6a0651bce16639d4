import type { Page } from '@playwright/test'
import { reordered } from '../../web/model/node-order'
import { nodeOrders } from '../../web/model/node-orders'
import { presets, presetVertices } from '../../web/model/presets'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, type Lens, test } from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const wrongOrder = presetVertices(presets.find(({ id }) => id === 'wrong-order') ?? presets[0])
const lexicographic = nodeOrders.find(({ id }) => id === 'lexicographic')?.permutation ?? []

async function openPanel({ page }: Lens): Promise<ReturnType<typeof panelOf>> {
  await page.getByRole('button', { name: 'Node order', exact: true }).click()
  const panel = panelOf(page)
  await expect(panel.locator('.answer')).not.toBeEmpty()
  return panel
}

function panelOf(page: Page) {
  return page.getByRole('region', { name: 'Node order' })
}

test('an order that makes the element valid is named and used; where there is none it says so', async ({ lens }) => {
  await lens.open()

  await test.step('an order that makes the element valid is named, looked at, used and taken back', async () => {
    await lens.preset.selectOption({ label: 'Wrong node order' })
    await expect(lens.verdict).toHaveText(/^INVALID/)
    const panel = await openPanel(lens)
    await expect(panel).toContainText('Of 21 other orders of the same eight points, one makes it valid:')
    await expect(panel.getByRole('listitem')).toHaveText(/Lexicographic\s+deal\.II.*min J = 15\/16/s)
    const preview = lens.button('Preview Lexicographic')
    await preview.click()
    await expect(preview).toHaveAttribute('aria-expanded', 'true')
    const ghost = lens.page.locator('hex-lens .scene-overlay path.ghost')
    await expect(ghost).toBeVisible()
    expect((await ghost.getAttribute('d'))?.match(/M/g)).toHaveLength(12)
    const numbers = lens.page.locator('hex-lens .handle .number')
    // The selected vertex's comes last, over its neighbours.
    await expect(numbers).toHaveText(['1', '2 → 3', '3 → 2', '4', '5', '6 → 7', '7 → 6', '0'])
    await lens.button('Node order').click()
    await expect(ghost).toBeHidden()
    await lens.button('Node order').click()
    await preview.click()
    await expect(ghost).toBeVisible()
    await expect(panel.getByRole('img', { name: 'The element in the order Lexicographic: valid' })).toBeVisible()
    expect(await lens.vertices()).toEqual(wrongOrder)
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await lens.button('Use this order: Lexicographic').click()
    await expect(lens.verdict).toHaveText(/^VALID/)
    expect(await lens.vertices()).toEqual(reordered(wrongOrder, lexicographic))
    await expect(panel.locator('.answer')).toBeFocused()
    await expect(ghost).toBeHidden()
    await expect(panel).toContainText('The points were taken in the order “Lexicographic”. Undo takes this back.')
    await lens.button('Undo').click()
    await expect(lens.verdict).toHaveText(/^INVALID/)
    expect(await lens.vertices()).toEqual(wrongOrder)
    await expect(preview).toBeVisible()
  })

  await test.step('while the element is being changed it waits', async () => {
    await lens.set(wrongOrder)
    const panel = panelOf(lens.page)
    await expect(panel.getByRole('listitem')).toHaveCount(1)
    await lens.field(6, 'z').fill('1.125')
    await expect(panel).toContainText('The orders are tried when this change is done.')
    await lens.field(6, 'z').press('Enter')
    await lens.field(6, 'z').blur()
    await expect(panel.getByRole('listitem')).toHaveCount(1)
  })

  await test.step('two orders that differ by a rotation are one answer with two names', async () => {
    await lens.preset.selectOption({ label: 'Cube inside out' })
    const panel = panelOf(lens.page)
    await expect(panel.getByRole('listitem').first()).toContainText(/Salome’s MED files\s*Top first\s+AVS UCD/)
    await expect(panel.getByRole('listitem').first()).toContainText('min J = 1')
  })

  await test.step('of a valid element nothing is tried, and where no order helps it says so', async () => {
    await lens.set(cube)
    const panel = panelOf(lens.page)
    await expect(panel).toContainText('The element is valid as its points are ordered')
    await expect(panel.getByRole('listitem')).toHaveCount(0)
    await lens.set(cube.map((x, i) => (i % 3 === 2 ? 0 : x)))
    await expect(panel).toContainText('None of the 21 orders tried makes it valid.')
    await panel.getByText('The 21 orders tried', { exact: true }).click()
    await expect(panel.getByRole('term')).toHaveCount(nodeOrders.length)
  })
})

test('axe finds nothing in the open panel, which fits', async ({ lens, page }) => {
  await lens.open()
  await lens.set(wrongOrder)
  const panel = await openPanel(lens)
  await lens.button('Preview Lexicographic').click()
  await panel.getByText('The 21 orders tried', { exact: true }).click()
  await inSchemesAndWidths(lens, async () => {
    await expectAxeFindsNothing(page, '#panel-node-order')
    await expectLargeTargets(panel.getByRole('button'))
  })
})
