import { expect, expectAxeFindsNothing, handleOf, test } from './lens'

test('after a first drag that makes the element invalid the page says where the red may be', async ({ lens, page }) => {
  await lens.open()
  await lens.preset.selectOption({ label: 'Unit cube' })
  await lens.nextFrame()
  const { x, y } = await handleOf(lens, 6)
  const { x: toX, y: toY } = await handleOf(lens, 3)
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(toX, toY, { steps: 3 })
  await page.mouse.up()
  await expect(lens.verdict).toHaveText(/^INVALID/)
  const note = page.getByText('The red may lie behind.')
  const camera = () => lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).state.camera)
  const before = await camera()
  await note.getByRole('button', { name: 'Show the minimum' }).click()
  await expect(note).toHaveCount(0)
  await expect.poll(camera).not.toEqual(before)
})

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [390, 844],
] as const)
  test(`at ${width} pixels the first screen says what to do, until it is done`, async ({ lens, page }) => {
    await page.setViewportSize({ width, height })
    await lens.open()
    const hint = page.locator('.hint')
    const legend = page.locator('hex-lens').getByText('edge candidate', { exact: true })
    const cue = page.locator('hex-lens .scene-pane .cue')

    await test.step('the important is in sight', async () => {
      await expect(hint).toBeInViewport({ ratio: 1 })
      await expect(hint).toContainText('Where J < 0 (red) the map folds over')
      await expect(lens.verdict.locator('.word')).toBeInViewport({ ratio: 1 })
      await expect(lens.verdict.locator('.why')).toBeInViewport({ ratio: 1 })
      await expect(legend).toBeHidden()
      await expectAxeFindsNothing(page)
    })

    await test.step('a handle shows that it can be dragged, and none looks chosen', async () => {
      await expect(cue).toBeVisible()
      // The figure is the same at each size, and drawing it takes seconds.
      if (width === 390) {
        const figure = await lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).toSVG())
        expect(figure).toContain('<circle')
        expect(figure).not.toContain('M-4-12')
      }
      await expect(page.locator('hex-lens .handle.selected, hex-lens tr.selected')).toHaveCount(0)
    })

    await test.step('with the focus of the keyboard the first one is', async () => {
      await lens.scene.focus()
      await expect(page.locator('hex-lens .scene-pane .handle.selected')).toHaveText('0')
    })

    await test.step('another preset is no drag', async () => {
      await lens.preset.selectOption({ label: 'Unit cube' })
      await lens.nextFrame()
      await expect(hint).toBeVisible()
    })

    await test.step('the first drag ends it for good', async () => {
      const { x, y } = await handleOf(lens, 6)
      await page.mouse.move(x, y)
      await page.mouse.down()
      await page.mouse.move(x + 20, y - 20, { steps: 2 })
      await expect(hint).toHaveCount(0)
      await page.mouse.up()
      await expect(cue).toBeHidden()
      await expect(page.getByText('The red may lie behind.')).toHaveCount(0)
      await page.getByRole('combobox', { name: 'Preset' }).selectOption({ label: 'Looks fine, is not' })
      await expect(legend).toBeVisible()
      await page.reload()
      await expect(legend).toBeVisible()
      await expect(hint).toHaveCount(0)
      await expect(cue).toBeHidden()
    })
  })
