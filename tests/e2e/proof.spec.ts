import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { certificateJson, certify } from '../../web/core/exact/certificate'
import { presets, presetVertices } from '../../web/model/presets'
import { runsOf } from '../../web/panels/proof/runs'
import {
  expect,
  expectAxeFindsNothing,
  expectLargeTargets,
  expectNoSidewaysOverflow,
  inSchemesAndWidths,
  test,
} from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const depthGuard = presetVertices(presets.find(({ id }) => id === 'depth-guard') ?? presets[0])

const proofOf = (page: Page) => page.getByRole('group', { name: 'Proof' })

test('the proof opens, follows the element, and names intervals and reasons', async ({ lens, page }) => {
  await lens.open()

  await test.step('the proof is closed at first, and opening it is no step to undo', async () => {
    const proof = proofOf(page)
    const show = lens.button('Show the proof')
    await expect(show).toHaveAttribute('aria-expanded', 'false')
    await expect(proof).not.toContainText('exactly')
    await show.focus()
    await page.keyboard.press('Enter')
    await expect(lens.button('Hide the proof')).toBeFocused()
    await expect(lens.button('Hide the proof')).toHaveAttribute('aria-expanded', 'true')
    await expect(proof).toContainText(
      /one point with J < 0\. At \(ξ, η, ζ\) =\s+\(1\/2, 1, 1\) jacdet is exactly −1\/128\./,
    )
    await expect(lens.button('Undo')).toBeDisabled()
    await page.keyboard.press('Space')
    await expect(proof.getByRole('button', { name: 'Download' })).toBeHidden()
  })

  await test.step('it follows the element, and during a gesture waits for its end', async () => {
    await lens.set(cube)
    await lens.button('Show the proof').click()
    const proof = proofOf(page)
    await expect(proof).toContainText('Knupp’s conjecture')
    await lens.field(6, 'z').fill('-3')
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await expect(proof).toContainText('The proof follows when this change is done.')
    await expect(proof).toContainText('Knupp’s conjecture')
    await lens.field(6, 'z').press('Enter')
    await lens.field(6, 'z').blur()
    await expect(proof).toContainText('one point with J < 0')
    await expect(proof).not.toContainText('The proof follows when this change is done.')
    await lens.button('Undo').click()
    await expect(proof).toContainText('Knupp’s conjecture')
  })

  await test.step('of a valid element it names intervals and reasons of all six faces, and the theorem', async () => {
    await lens.set(depthGuard)
    const table = page.getByRole('table', { name: 'Intervals of each face' })
    await expect(table.getByRole('rowheader')).toHaveText(['−ξ', '+ξ', '−η', '+η', '−ζ', '+ζ'])
    const certificate = certify(depthGuard)
    const runs = certificate.valid ? certificate.faces.flatMap(runsOf) : []
    expect(runs.length).toBeGreaterThan(6)
    const rows = runs.map(
      ({ count }) => new RegExp(` to [\\d/]+\\s*${count}\\s*(b ≥ 0|2a \\+ b ≤ 0|c \\+ b/2 > 0|4ac > b²)`),
    )
    await expect(table.locator('tbody tr')).toHaveText(rows)
    await expect(proofOf(page)).toContainText('Knupp’s conjecture, now a theorem')
    await lens.set(cube)
    await expect(table.locator('tbody tr').filter({ hasText: '0 to 1' })).toHaveCount(6)
  })
})

test('what is copied or downloaded is what the checker takes', async ({ lens, page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  await lens.open()

  await test.step('what is copied or downloaded is what the checker takes, a list of this element', async () => {
    await lens.button('Show the proof').click()
    const saved = async () => {
      const download = page.waitForEvent('download')
      await lens.button('Download').click()
      const file = await download
      return { name: file.suggestedFilename(), text: await readFile(await file.path(), 'utf8') }
    }
    for (const [name, vertices] of [
      ['looks-fine', presetVertices(presets[0])],
      ['hexahedron', depthGuard.with(0, 2)],
    ] as const) {
      await lens.set(vertices)
      await lens.button('Copy JSON').click()
      await expect(lens.button('Copied')).toBeVisible()
      const copied = await page.evaluate(() => navigator.clipboard.readText())
      expect(JSON.parse(copied)).toEqual([certificateJson(name, vertices, certify(vertices))])
      expect(await saved()).toEqual({ name: `${name}-certificate.json`, text: copied })
    }
  })

  await test.step('the value follows the reference cube, the file does not', async () => {
    await lens.set(presetVertices(presets[0]))
    await page.getByRole('button', { name: /\[0,1\]/ }).click()
    const proof = proofOf(page)
    await expect(proof).toContainText('exactly −1/1024')
    await expect(proof).toContainText('eight times this')
    await lens.button('Copy point and value').click()
    await expect(lens.button('Copied')).toBeVisible()
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('(1/2, 1, 1), -1/128')
  })
})

test('axe finds nothing in an open proof, also in one that waits', async ({ lens, page }) => {
  await lens.open()
  await lens.button('Show the proof').click()
  await page.getByText('What each looks at').click()
  await inSchemesAndWidths(lens, async () => {
    for (const vertices of [presetVertices(presets[0]), depthGuard]) {
      await lens.set(vertices)
      await lens.field(0, 'x').fill('0.1')
      await expect(proofOf(page)).toContainText('The proof follows when this change is done.')
      await expectAxeFindsNothing(page, '.certificate')
      await lens.field(0, 'x').blur()
      await expect(proofOf(page)).not.toContainText('The proof follows when this change is done.')
      await expectAxeFindsNothing(page, '.certificate')
      await expectNoSidewaysOverflow(page)
    }
    await expectAxeFindsNothing(page, '.checks')
    await expectLargeTargets(proofOf(page).getByRole('button'))
  })
})
