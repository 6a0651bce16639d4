import { expect, test } from './lens'

test('the minimum comes with the bound of its error, on the boundary and inside', async ({ lens, page, context }) => {
  await lens.open()

  await test.step('the minimum comes with the bound of its error, on either reference cube', async () => {
    await expect(lens.verdict).toContainText(/min J = −0\.010653 ±\u00a0[\d.]+×10⁻¹[²³⁴⁵]/)
    await expect(lens.verdict).toContainText('a witness: J ≤ −0.010653 there')
    await expect(lens.verdict).toContainText(/nowhere lower, to within [\d.]+×10⁻¹[¹²³⁴]/)
    await page.getByRole('button', { name: /\[0,1\]/ }).click()
    await expect(lens.verdict).toContainText(/min J = −0\.0013317 ±/)
    await expect(lens.verdict).toContainText('J ≤ −0.0013316 there')
    await page.getByRole('button', { name: /\[−1,1\]/ }).click()
  })

  await test.step('a valid element says from where on it is positive, and nothing of its inside', async () => {
    await lens.preset.selectOption({ label: 'Valid, though subdivision gives up' })
    await expect(lens.verdict).toContainText(/^VALID\s+min J = 0\.062755 ±/)
    await expect(lens.verdict).toContainText('error bounds: all J ≥ 0.062754')
    await expect(lens.verdict).not.toContainText(/inside/i)
  })

  await test.step('the paper’s counterexample reads 0 on the boundary and −1/4 inside', async () => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    await lens.preset.selectOption({ label: 'Zero on the faces, negative inside' })
    await expect(lens.verdict).toContainText(/min J = 0\s+on the boundary/)
    await expect(lens.verdict).toContainText(/min J = −1\/4 ±\u00a0[\d.]+×10⁻¹[¹²³⁴⁵]\s+inside/)
    await expect(lens.verdict).toContainText('at (ξ, η, ζ) = (1/2, 1/2, 1/2)')
    await expect(lens.verdict).toContainText('exact arithmetic')
    await lens.verdict.getByRole('button', { name: '(1/2, 1/2, 1/2)' }).click()
    await expect(page.getByText('Copied 0.5, 0.5, 0.5')).toBeVisible()
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('0.5, 0.5, 0.5')
  })
})
