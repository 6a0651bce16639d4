/** Fields for numbers beside those of the vertices: the same texts are understood and refused. */
import { expect, test } from './lens'

test('the height of an embedded element is a whole number within its limits, however it is written', async ({
  lens,
  page,
}) => {
  await lens.open()
  await lens.button('Copy embed').click()
  const field = page.getByRole('textbox', { name: 'Height' })
  const lines = page.getByRole('region', { name: 'Copy embed' }).locator('pre').last()
  for (const text of ['12', '480,5', '1/3', '1.234,5', '480 px', '']) {
    await field.fill(text)
    await field.press('Enter')
    await expect(field).toHaveAttribute('aria-invalid', 'true')
    await expect(field).toHaveAccessibleDescription(/^Height: .* 480 is kept\.$/)
    await field.blur()
    await expect(field).toHaveValue(text)
    await expect(lines).toContainText('height: 480px')
  }
  await field.fill('1280/4')
  await field.press('Enter')
  await expect(lines).toContainText('height: 320px')
  await expect(field).not.toHaveAttribute('aria-invalid')
  await field.press('ArrowUp')
  await expect(lines).toContainText('height: 340px')
  await field.fill('7')
  await field.press('Escape')
  await expect(field).toHaveValue('340')
})

test('the numbers of a search are understood likewise, and say which of them is none', async ({ lens, page }) => {
  await lens.open('./search.html')
  const [sigma, seed] = [page.getByRole('textbox', { name: 'Sigma' }), page.getByRole('textbox', { name: 'Seed' })]
  const start = page.getByRole('button', { name: 'Start', exact: true })
  for (const text of ['1/3', '½', '0,5', '5e−1']) {
    await sigma.fill(text)
    await expect(sigma).not.toHaveAttribute('aria-invalid')
    await expect(start).toBeEnabled()
  }
  await sigma.fill('1,234')
  await expect(sigma).toHaveAccessibleDescription('Sigma: “1,234” can mean 1.234 or 1234: write one of them.')
  await expect(sigma).toHaveAttribute('aria-invalid', 'true')
  await expect(seed).not.toHaveAttribute('aria-invalid')
  await expect(start).toBeDisabled()
  await expect(sigma).toHaveValue('1,234')
  await sigma.fill('0')
  await expect(sigma).toHaveAccessibleDescription('Sigma needs a number above 0 and at most 100.')
  await sigma.fill('0.5')
  await seed.fill('one')
  await expect(seed).toHaveAccessibleDescription('Seed: “one” is not one number, such as −1.5, 1/3 or 2e-3.')
})
