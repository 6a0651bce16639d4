import { presets } from '../../web/content/presets'
import { expect, test } from './lens'

test('the first screen shows an element that looks fine and is not', async ({ lens }) => {
  await lens.open()
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await expect(lens.verdict).toContainText(/All eight vertices .* positive, yet (edge|face)/)
  await expect(lens.preset).toHaveValue(/.+/)
})

test('every preset gets the verdict it claims, and an edited one is called by no preset’s name', async ({ lens }) => {
  await lens.open()
  for (const preset of presets) {
    await lens.preset.selectOption({ label: preset.title })
    await lens.nextFrame()
    expect(await lens.vertices()).toEqual([...preset.vertices])
    await expect(lens.verdict).toHaveText(preset.valid ? /^VALID/ : /^INVALID/)
  }
  await lens.field(0, 'x').fill('0.123')
  await expect(lens.preset.locator('option:checked')).toHaveText('Custom')
})
