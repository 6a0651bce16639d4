import type { Page } from '@playwright/test'
import type { Report } from '../../web/core/report'
import { expect, type Lens, test } from './lens'

test.beforeEach(({ context }) => context.grantPermissions(['clipboard-read', 'clipboard-write']))

const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText())
const said = (lens: Lens) => lens.element.locator('.copied')
const reportOf = (lens: Lens): Promise<Report> =>
  lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).report as Report)

test('any number is copied with all its digits, by pressing it or by keys', async ({ lens, page }) => {
  await lens.open()
  const { boundaryMinimum, minimizer, checks } = await reportOf(lens)
  const minimum = lens.verdict.getByRole('button', { name: '−0.010653', exact: true })
  await minimum.click()
  await expect(said(lens)).toHaveText(`Copied ${boundaryMinimum}`)
  expect(await clipboard(page)).toBe(String(boundaryMinimum))
  await lens.minimum.getByRole('button', { name: '(0, 0.59091, 1)' }).press('Enter')
  expect(await clipboard(page)).toBe(minimizer.point.join(', '))

  const table = page.getByRole('table', { name: 'Who would notice?' })
  await table.getByRole('button', { name: '3/64' }).focus()
  await expect(said(lens)).toBeEmpty()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press(' ')
  await expect(said(lens)).toHaveText(`Copied ${checks[2]?.value}`)
  expect(await clipboard(page)).toBe(String(checks[2]?.value))
  // The table is one stop of the Tab key.
  await page.keyboard.press('Tab')
  await expect(page.getByRole('link', { name: 'Cubit' })).toBeFocused()

  await page.getByRole('button', { name: /\[0,1\]/ }).click()
  await lens.verdict.getByRole('button', { name: '−0.0013317', exact: true }).click()
  expect(await clipboard(page)).toBe(String(boundaryMinimum / 8))
})

test('C copies the point that is pointed at, a tap on its words too', async ({ lens, page }) => {
  await lens.open()
  const { minimizer } = await reportOf(lens)
  const rest = `, (xi, eta, zeta) = (${minimizer.point.join(', ')}), (x, y, z) = (${minimizer.position.join(', ')})`
  await lens.scene.press('c')
  await expect(said(lens)).toBeEmpty()
  await lens.scene.press('p')
  await lens.scene.press('c')
  await expect(said(lens)).toContainText(rest)
  expect(await clipboard(page)).toMatch(/^jacdet = -0\.0106534090909\d+, /)
  await page.evaluate(() => navigator.clipboard.writeText(''))
  await page.locator('hex-lens .scene .readout .jacdet').click()
  await expect.poll(() => clipboard(page)).toContain(rest)
})

test('where the clipboard is closed the digits stand there selected', async ({ lens, page }) => {
  await lens.open()
  await page.evaluate(() => {
    Object.defineProperty(navigator, 'clipboard', { value: undefined })
  })
  await lens.verdict.getByRole('button', { name: '−0.010653', exact: true }).click()
  const { boundaryMinimum } = await reportOf(lens)
  await expect(said(lens)).toHaveText(`Copying is not allowed here: ${boundaryMinimum}`)
  expect(await page.evaluate(() => getSelection()?.toString())).toBe(String(boundaryMinimum))
})
