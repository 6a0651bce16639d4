import { presets, presetVertices } from '../../web/model/presets'
import { expect, expectAxeFindsNothing, expectLargeTargets, inSchemesAndWidths, test } from './lens'

const cube = presetVertices(presets.find(({ id }) => id === 'cube') ?? presets[0])

test('the nearest element of the other verdict is found, looked at, applied and taken back', async ({ lens, page }) => {
  await lens.open()
  const panel = page.getByRole('region', { name: 'Nearest invalid, nearest valid' })
  const ghost = page.locator('hex-lens .scene-overlay path.ghost')
  const preview = lens.button('Preview the move of all eight')
  await lens.preset.selectOption('cube')
  await lens.button('Nearest invalid, nearest valid').click()

  await test.step('of the cube, where arithmetic says, and shown as a ghost', async () => {
    await expect(panel).toContainText('What is the smallest move that makes this element invalid?')
    await expect(panel).toContainText('Vertex 0 by 0.57735')
    await expect(panel).toContainText('Together by 0.5, the farthest by 0.43301')
    await expect(panel).toContainText('As short as any such move can be')
    await preview.click()
    await expect(preview).toHaveAttribute('aria-pressed', 'true')
    await expect(ghost).toBeVisible()
    expect(await lens.vertices()).toEqual(cube)
    await lens.button('Preview the move of vertex 0').click()
    await expect(preview).toHaveAttribute('aria-pressed', 'false')
    expect((await ghost.getAttribute('d'))?.match(/M/g)).toHaveLength(3)
  })

  await test.step('applied it is one step to undo, and the way back is looked for', async () => {
    await lens.button('Apply the move of vertex 0').click()
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await expect(panel.locator('.answer')).toBeFocused()
    await expect(panel).toContainText(
      'The move is applied. Undo takes it back. What is the smallest move that makes this element valid?',
    )
    await expect(ghost).toBeHidden()
    const moved = await lens.vertices()
    expect(moved.slice(3)).toEqual(cube.slice(3))
    for (const x of moved.slice(0, 3)) expect(x).toBeCloseTo(1 / 3, 12)
    await lens.button('Undo').click()
    await expect(lens.verdict).toHaveText(/^VALID/)
    expect(await lens.vertices()).toEqual(cube)
    await expect(panel).toContainText('Vertex 0 by 0.57735')
  })

  await test.step('while the element is being changed it waits, and looks at the new one', async () => {
    await lens.field(6, 'z').fill('-1')
    await expect(panel).toContainText('The search starts when this change is done.')
    await lens.field(6, 'z').press('Enter')
    await lens.field(6, 'z').blur()
    await expect(panel).toContainText('that makes this element valid?')
    await expect(panel).toContainText(/Vertex \d by \d/)
    await expect(panel).toContainText(/Together by \d/)
  })

  await test.step('a relative minimum is asked for, in any way to write a number, and what is none is refused', async () => {
    const field = page.getByRole('textbox', { name: 'Relative minimum' })
    for (const text of ['1,234', '1', '−1/8', 'much']) {
      await field.fill(text)
      await field.press('Enter')
      await expect(field).toHaveAccessibleDescription(/^Relative minimum: “.*” .* 0 is kept\.$/)
      await expect(field).toHaveValue(text)
    }
    await field.fill('1/5')
    await field.press('Enter')
    await expect(field).not.toHaveAttribute('aria-invalid')
    await expect(panel).toContainText('makes this element valid with a relative minimum of 0.2?')
    await expect(panel).toContainText(/Together by \d/)
    await lens.button('Apply the move of all eight').click()
    await expect(lens.minimum).toContainText(/Relative minimum\s*(0\.2|0\.20000)\s*no dimension/)
    await expect(panel).toContainText('makes this element invalid?')
    await lens.button('Undo').click()
    await field.fill('0')
    await field.press('Enter')
    await expect(panel).toContainText('makes this element valid?')
    await expect(panel).toContainText(/Together by \d/)
  })

  await test.step('closed it takes its ghost along', async () => {
    await preview.click()
    await expect(ghost).toBeVisible()
    await lens.button('Nearest invalid, nearest valid').click()
    await expect(ghost).toBeHidden()
    await lens.button('Nearest invalid, nearest valid').click()
  })

  await test.step('axe finds nothing, and it fits', async () => {
    await lens.element.evaluate(element => element.setAttribute('views', 'nearest')) // without the scene
    await panel.getByText('Each vertex alone').click()
    await expect(panel.getByRole('listitem')).toHaveCount(8)
    await expect(panel.getByRole('listitem').first()).toContainText('cannot')
    await inSchemesAndWidths(lens, () => expectAxeFindsNothing(page, '#panel-nearest'))
    await expectLargeTargets(panel.locator('button, summary'))
  })
})
