/** The page Mesh in one window: what is seen without scrolling, what stands in the lens, and what the controls on top leave open. */
import { fileURLToPath } from 'node:url'
import type { Page } from '@playwright/test'
import { expect, expectAxeFindsNothing, type Lens, test } from './lens'

const shared = (name: string) => fileURLToPath(new URL(`../../../shared/meshes/${name}`, import.meta.url))
const rows = (page: Page) => page.locator('.list .row:not(.head)')

const WINDOW = { width: 1440, height: 900 }
test.use({ viewport: WINDOW })

/** True if all of it is in the window. */
async function isInWindow(page: Page, selector: string): Promise<boolean> {
  const box = await page.locator(selector).boundingBox()
  return box !== null && box.y >= 0 && box.y + box.height <= WINDOW.height
}

/** Vertices of the chosen cell that are not in the lens's scene. */
async function verticesOutside(lens: Lens): Promise<string[]> {
  const scene = await lens.scene.boundingBox()
  if (!scene) throw new Error('There is no scene.')
  const outside: string[] = []
  for (const handle of await lens.element.locator('.scene-pane .handle').all()) {
    const box = await handle.boundingBox()
    const isInside =
      box !== null &&
      box.x + box.width / 2 > scene.x &&
      box.x + box.width / 2 < scene.x + scene.width &&
      box.y + box.height / 2 > scene.y &&
      box.y + box.height / 2 < scene.y + scene.height
    if (!isInside) outside.push((await handle.textContent()) ?? '')
  }
  expect(await lens.element.locator('.scene-pane .handle').count()).toBe(8)
  return outside
}

test('picture, list, lens and verdict are in the first window; menus, lists and chosen cells begin anew', async ({
  lens,
  page,
}) => {
  await page.goto('mesh.html')
  await expect(page.locator('.overview .headline')).toHaveText(/^12 of 7,168 hexahedra are invalid/)
  await expect(page.locator('.picture .bar')).toBeVisible()
  await expect(lens.verdict).toHaveText(/^INVALID/)

  await test.step('nothing of them is below the window', async () => {
    for (const part of ['.picture .bar', '.list .row:nth-child(1)', '.one hex-lens'])
      await expect.poll(() => isInWindow(page, `${part} >> nth=0`), part).toBe(true)
  })

  await test.step('the chosen cell says who accepts it', async () => {
    await page.getByLabel('Usual conditions').selectOption({ label: 'Invalid, yet the corners accept' })
    await expect(page.locator('.go .count')).toHaveText(/^\s*4 of 7,168 cells\s*$/)
    await expect(rows(page).first()).toContainText('Eight corners')
    await rows(page).first().click()
    await expect(page.locator('.one .accepted')).toHaveText(/^Accepted by eight corners, /)
    await page.getByLabel('Usual conditions').selectOption({ label: 'All cells' })
    await expect(rows(page).first()).toContainText('2951')
  })

  await test.step('another list is seen from its first row', async () => {
    await page.locator('.list .rows').press('End')
    await expect(rows(page).first()).not.toContainText('2951')
    await page.getByLabel('Sorted by').selectOption({ label: 'By volume' })
    await expect(page.locator('.list .row.active')).toHaveAttribute('aria-rowindex', '2')
    await page.getByLabel('Sorted by').selectOption({ label: 'Worst first' })
    await expect(rows(page).first()).toContainText('2951')
  })

  await test.step('one menu is open at a time, and Escape closes it from its button, too', async () => {
    const [files, untangle] = ['Take away', 'Untangle'].map(name => page.getByRole('button', { name, exact: true }))
    if (!files || !untangle) throw new Error('There are no buttons.')
    await files.press('Enter')
    await untangle.first().press('Enter')
    await expect(files).toHaveAttribute('aria-expanded', 'false')
    await expect(untangle.first()).toHaveAttribute('aria-expanded', 'true')
    await page.keyboard.press('Escape')
    await expect(untangle.first()).toHaveAttribute('aria-expanded', 'false')
  })

  await test.step('a cell is drawn with a ring of its neighbours', async () => {
    await page.getByLabel('Cells in the picture').selectOption({ label: 'Around the chosen cell' })
    await expect(page.locator('.picture').getByLabel('Rings around')).toHaveValue('1')
    await page.getByLabel('Cells in the picture').selectOption({ label: 'All cells' })
  })

  await test.step('time steps: short times, the zero at its line, no buttons to move vertices, the whole cell', async () => {
    await page.locator('.overview input[type=file]').setInputFiles(shared('real/8-block.g'))
    await expect(page.locator('.steps')).toContainText('step 9 (t = 0.08), cell 45')
    await expect(page.locator('.overview .notes')).toContainText('The slider shows the others')
    await expect(page.locator('.moving')).toHaveText(/^A mesh of several time steps is only shown/)
    const [zero, line] = await Promise.all(
      ['.steps .zero-mark', '.steps path.zero'].map(part => page.locator(part).boundingBox()),
    )
    if (!zero || !line) throw new Error('There is no line.')
    expect(Math.abs(zero.y + zero.height / 2 - (line.y + line.height / 2))).toBeLessThan(2)
    await expect.poll(() => isInWindow(page, '.picture .bar')).toBe(true)
    for (const row of [0, 6]) {
      await rows(page).nth(row).click()
      await expect(rows(page).nth(row)).toHaveAttribute('aria-selected', 'true')
      await expect.poll(() => verticesOutside(lens)).toEqual([])
    }
    await expectAxeFindsNothing(page)
  })
})
