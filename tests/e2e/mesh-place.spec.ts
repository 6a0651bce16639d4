/** The best place of a vertex on the page Mesh: for all cells around it, with its proof, taken and taken back. */
import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { checked } from '../unit/certificate-checker'
import { expect, expectAxeFindsNothing, expectLargeTargets, expectNoSidewaysOverflow, test } from './lens'

const headline = (page: Page) => page.locator('.overview .headline')
const place = (page: Page) => page.locator('.one > .place')

test('the best place of a vertex of a mesh is found, shown, proved, taken and taken back', async ({ page }) => {
  const wasm: string[] = []
  page.on('request', request => /repair.*\.wasm/.test(request.url()) && wasm.push(request.url()))
  await page.goto('mesh.html')
  await expect(headline(page)).toHaveText(/^12 of 7,168 hexahedra are invalid/)
  const panel = place(page)
  const marks = page.locator('hex-lens .scene-pane .place-marks')
  const vertex = (v: number) => panel.getByRole('button', { name: `Vertex ${v}, ` })
  const moveThere = panel.getByRole('button', { name: 'Move there' })

  await test.step('what answers comes when it is opened; the vertex that gains most is chosen', async () => {
    expect(wasm).toEqual([])
    await panel.getByText('Best place of a vertex').click()
    await expect(panel).toContainText(
      'Best place of vertex 4: the least relative minimum of its 8 cells goes from −2.2606 to 0.85165.',
    )
    await expect(panel).toContainText('Now cell 2951 limits it, there cells 3207, 2919 and 3175.')
    expect(wasm).toHaveLength(1)
    await expect(panel.getByRole('row')).toHaveCount(5)
    await expect(marks.locator('.place')).toBeVisible()
    await expect(marks.locator('.hold')).toHaveCount(4)
  })

  await test.step('axe finds nothing, in both schemes and on a phone', async () => {
    for (const [colorScheme, width] of [
      ['light', 1240],
      ['dark', 390],
    ] as const) {
      await page.emulateMedia({ colorScheme })
      await page.setViewportSize({ width, height: 800 })
      await expectNoSidewaysOverflow(page)
      await expectAxeFindsNothing(page)
    }
    await expectLargeTargets(panel.locator('button, summary'))
    await page.setViewportSize({ width: 1240, height: 800 })
  })

  await test.step('the proof as a file holds', async () => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      panel.getByRole('button', { name: 'Download' }).click(),
    ])
    const text = readFileSync(await download.path(), 'utf8')
    expect(checked(text)).toMatchObject({ status: 0 })
    expect(JSON.parse(text)[0].cells.map((cell: { name: string }) => cell.name)).toEqual(['2919', '3175', '3207'])
  })

  await test.step('another vertex repairs nothing: what forbids it', async () => {
    await vertex(0).click()
    await expect(panel).toContainText(
      'No place of vertex 0 makes cells 2918 and 2951 valid together: these four points forbid it.',
    )
    await expect(panel).toContainText('Proved exactly')
    await vertex(1).click()
    await expect(panel).toContainText(/No place of vertex 1 repairs cell \d+: th/)
    await vertex(4).click()
  })

  await test.step('moved there the cells are repaired, in one step to undo', async () => {
    await moveThere.click()
    await expect(panel).toContainText('Vertex 4 has been moved. Undo takes it back.')
    await expect(panel).toContainText('Vertex 4 is at its best place')
    await expect(panel.locator('.answer')).toBeFocused()
    await expect(headline(page)).toHaveText(/^10 of 7,168/)
    await page.getByRole('button', { name: 'Undo', exact: true }).click()
    await expect(headline(page)).toHaveText(/^12 of 7,168/)
    await expect(panel).toContainText('from −2.2606 to 0.85165')
  })

  await test.step('a vertex on the boundary stays until it is freed', async () => {
    await page.getByRole('textbox', { name: 'Go to index' }).fill('0')
    await page.getByRole('textbox', { name: 'Go to index' }).press('Enter')
    await expect(page.locator('.one .which')).toHaveText(/^Cell 0\./)
    await panel
      .getByRole('button', { name: /, fixed$/ })
      .first()
      .click()
    await expect(panel).toContainText(/Vertex \d stays: it is on the boundary of the hexahedra\./)
    await expect(moveThere).toBeDisabled()
    await page.getByRole('checkbox', { name: 'Free the boundary' }).check()
    await expect(moveThere).toBeEnabled()
  })

  await test.step('closed it takes its marks along', async () => {
    await panel.getByText('Best place of a vertex').click()
    await expect(marks).toBeHidden()
  })
})
