import { presets, presetVertices } from '../../web/model/presets'
import { expect, test } from './lens'

test('every preset gets the verdict it claims, and the first looks fine and is not', async ({ lens }) => {
  await lens.open()

  await test.step('the first screen shows an element that looks fine and is not', async () => {
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await expect(lens.verdict).toContainText(/J > 0 at all .*, yet J ≤ 0 on (edge|face)/)
    await expect(lens.preset).toHaveValue(/.+/)
  })

  await test.step('a random element is another one each time, each a step to undo', async () => {
    await lens.preset.selectOption({ label: 'Random' })
    await expect(lens.button('Another')).toBeVisible()
    const one = await lens.vertices()
    await lens.button('Another').click()
    await expect.poll(() => lens.vertices()).not.toEqual(one)
    await lens.button('Undo').click()
    await expect.poll(() => lens.vertices()).toEqual(one)
  })

  await test.step('every preset gets the verdict it claims, and an edited one is called by no preset’s name', async () => {
    for (const preset of presets) {
      await lens.preset.selectOption({ label: preset.title })
      await lens.nextFrame()
      if (preset.valid !== null) expect(await lens.vertices()).toEqual(presetVertices(preset))
      await expect(lens.verdict).toHaveText(
        preset.valid === null ? /^(VALID|INVALID)/ : preset.valid ? /^VALID/ : /^INVALID/,
      )
    }
    await lens.field(0, 'x').fill('0.123')
    await expect(lens.preset.locator('option:checked')).toHaveText('Custom')
  })
})
