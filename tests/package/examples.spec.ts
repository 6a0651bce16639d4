/** The pages of docs/examples, as they lie beside the built files; every number in them is the core's. */
import { copyFileSync, cpSync, mkdirSync } from 'node:fs'
import { join } from 'node:path'
import AxeBuilder from '@axe-core/playwright'
import { elsewhere, expect, root, test } from './elsewhere'

const pages = [
  { name: 'negative-jacobian', verdicts: [false, false], decimals: 12 },
  { name: 'corners', verdicts: [false], decimals: 12 },
  { name: 'theorem', verdicts: [true, false], decimals: 10 },
]

test.beforeAll(() => {
  cpSync(join(root, 'docs/examples'), join(elsewhere, 'docs/examples'), { recursive: true })
  mkdirSync(join(elsewhere, 'dist'), { recursive: true })
  copyFileSync(join(elsewhere, 'node_modules/hexlens/dist/hexlens.iife.js'), join(elsewhere, 'dist/hexlens.iife.js'))
})

for (const { name, verdicts, decimals } of pages) {
  test(`${name}: the elements are what the text says`, async ({ lens, page }) => {
    await page.goto(`docs/examples/${name}.html`)
    const elements = await lens.element.all()
    expect(elements.length).toBe(verdicts.length)
    for (const [i, element] of elements.entries()) {
      await element.scrollIntoViewIfNeeded()
      await expect(element.getByRole('status', { name: 'Verdict' })).toHaveText(verdicts[i] ? /^VALID/ : /^INVALID/)
    }
    const claims = await page.locator('data[data-of]').evaluateAll(list =>
      list.map(claim => {
        const element = claim.closest('section')?.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
        const path = claim.getAttribute('data-of') as string
        const computed = path
          .split('.')
          .reduce<unknown>((found, key) => Reflect.get(found as object, key), element.report)
        return { path, computed, claimed: Number(claim.getAttribute('value')) }
      }),
    )
    expect(claims.length).toBeGreaterThan(0)
    for (const { path, computed, claimed } of claims) expect(computed, path).toBeCloseTo(claimed, decimals)
    const { violations } = await new AxeBuilder({ page }).exclude('hex-lens').analyze()
    expect(violations.map(({ id }) => id)).toEqual([])
  })
}
