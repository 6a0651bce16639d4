import { readFileSync } from 'node:fs'
import { presets, presetVertices } from '../../web/model/presets'
import { checked } from '../unit/certificate-checker'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, test } from './lens'

const first = presetVertices(presets[0])

test('the best place of a vertex is found, shown, proved, taken and taken back', async ({ lens, page }) => {
  const wasm: string[] = []
  page.on('request', request => /repair.*\.wasm/.test(request.url()) && wasm.push(request.url()))
  await lens.open()
  const title = 'Best place of a vertex'
  const panel = page.getByRole('region', { name: title })
  const marks = page.locator('hex-lens .scene-pane .place-marks')
  const place = marks.locator('.place')
  expect(wasm).toEqual([])
  await lens.button(title).click()

  await test.step('the core for it comes when the panel is opened; the vertex that gains most comes first', async () => {
    await expect(panel.getByRole('button', { name: 'Vertex 7, at best 0.61' })).toHaveAttribute('aria-pressed', 'true')
    expect(wasm).toHaveLength(1)
  })

  await test.step('one point that no place lifts forbids it', async () => {
    await panel.getByRole('button', { name: 'Vertex 0, no valid place' }).click()
    await expect(panel).toContainText('No place of vertex 0 makes this element valid: this point forbids it.')
    await expect(panel).toContainText('J at this point is the same wherever vertex 0 is')
    await expect(panel.getByRole('button', { name: 'Move there' })).toHaveCount(0)
    await expect(panel.getByRole('row')).toHaveCount(2)
    await expect(place).toBeHidden()
    await expect(marks.locator('.hold text:visible')).toHaveText(['A 1.00'])
  })

  await test.step('another vertex makes it valid: where, and which points forbid more, in view', async () => {
    await panel.getByRole('button', { name: 'Vertex 7, at best 0.61' }).click()
    await expect(panel).toContainText('Vertex 7 alone can bring the relative minimum from −0.073052 to 0.61291.')
    await expect(panel).toContainText('No place is better, proved exactly')
    await expect(panel.getByRole('row')).toHaveCount(5)
    await expect(place).toBeInViewport()
    await expect(marks.locator('.hold text:visible')).toHaveText(['A, C 0.14', 'B 0.72', 'D 0.14'])
  })

  await test.step('the proof as a file holds', async () => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      panel.getByRole('button', { name: 'Download' }).click(),
    ])
    const text = readFileSync(await download.path(), 'utf8')
    expect(checked(text)).toMatchObject({ status: 0 })
    expect(checked(text.replace(/"level":"\d+/, '"level":"1')).status).toBe(1)
  })

  await test.step('moved there it is valid, in one step to undo', async () => {
    await panel.getByRole('button', { name: 'Move there' }).click()
    await expect(lens.verdict).toHaveText(/^VALID/)
    await expect(panel.locator('.answer')).toBeFocused()
    await expect(panel).toContainText('The vertex has been moved. Undo takes it back.')
    await expect(panel).toContainText('Vertex 7 is at its best place: relative minimum 0.61291.')
    await expect(place).toBeHidden()
    const moved = await lens.vertices()
    expect(moved.slice(0, 21)).toEqual(first.slice(0, 21))
    await lens.button('Undo').click()
    expect(await lens.vertices()).toEqual(first)
    await expect(place).toBeVisible()
  })

  await test.step('a cube is as good as can be', async () => {
    await lens.preset.selectOption('cube')
    await expect(panel).toContainText('Vertex 7 is at its best place: relative minimum 1.')
    await expect(panel).toContainText('the least jacdet is never above its mean')
    await expect(panel.getByRole('table')).toHaveCount(0)
  })

  await test.step('four points can forbid it together', async () => {
    await lens.preset.selectOption('face-negative')
    await expect(panel).toContainText('No place of vertex 7 makes this element valid: these 4 points forbid it.')
    await expect(panel).toContainText('where min J is greatest, though not positive')
  })

  await test.step('axe finds nothing, and it fits', async () => {
    await panel.getByText('What is certain, and why').click()
    await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page, '#panel-best-place'))
    await expectLargeTargets(panel.locator('button, summary'))
  })

  await test.step('closed it takes its marks along', async () => {
    await lens.button(title).click()
    await expect(marks).toBeHidden()
  })
})
