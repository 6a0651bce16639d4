import type { Page } from '@playwright/test'
import { hosts } from '../../web/panels/embed/hosts'
import { expect, expectAxeFindsNothing, expectNoSidewaysOverflow, SCHEMES_AND_WIDTHS, test } from './lens'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

const panelOf = (page: Page) => page.getByRole('region', { name: 'Copy embed', exact: true })
const previewOf = (page: Page) => panelOf(page).locator('hex-lens')

test.beforeEach(({ context }) => context.grantPermissions(['clipboard-read', 'clipboard-write']))

test('the lines for each host follow the element and the choices, and so does the preview', async ({ lens, page }) => {
  await lens.open()
  await page.getByRole('button', { name: 'Copy embed', exact: true }).click()
  const panel = panelOf(page)
  const lines = () => panel.locator('pre').allInnerTexts()
  const preview = previewOf(page)
  await preview.scrollIntoViewIfNeeded()
  await expect(preview.getByRole('status', { name: 'Verdict' })).toHaveText(/^INVALID/)
  await expect(panel.getByRole('textbox', { name: 'Description' })).toHaveValue('An invalid hexahedron')

  const before = page.url()
  await lens.element.first().evaluate(
    (element, vertices) => {
      ;(element as HTMLElementTagNameMap['hex-lens']).vertices = vertices
    },
    cube.with(0, -0),
  )
  await expect(preview.getByRole('status', { name: 'Verdict' })).toHaveText(/^VALID/)
  await expect(panel.getByRole('textbox', { name: 'Description' })).toHaveValue('A valid hexahedron')
  await panel.getByRole('checkbox', { name: 'Who would notice' }).check()
  await panel.getByRole('checkbox', { name: 'Scene' }).uncheck()
  await panel.getByRole('textbox', { name: 'Height' }).fill('320')
  await panel.getByRole('textbox', { name: 'Height' }).press('Enter')
  await panel.getByRole('combobox', { name: 'Colours' }).selectOption('dark')
  await panel.getByRole('checkbox', { name: 'Cannot be changed by readers' }).check()
  const [head, body] = (await lines()) as [string, string]
  expect(head).toBe('<script defer src="hexlens.iife.js"></script>')
  expect(body).toContain('vertices="-0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 1, 1 0 1, 1 1 1, 0 1 1"')
  expect(body).toContain(
    'views="verdict checks"\n  theme="dark"\n  readonly\n  style="display: block; min-height: 320px; --hl-aspect-ratio: auto"',
  )
  expect(body).toContain(
    `<a href="${page.url().replaceAll('&', '&amp;')}"><img src="hexlens.png" alt="A valid hexahedron"`,
  )
  await expect(preview.getByRole('application')).toHaveCount(0)
  await panel.getByRole('checkbox', { name: 'Who would notice' }).uncheck()
  await expect.poll(async () => (await preview.boundingBox())?.height).toBe(320)
  expect(await preview.evaluate(element => [element.getAttribute('theme'), element.hasAttribute('readonly')])).toEqual([
    'dark',
    true,
  ])
  expect(page.url()).not.toBe(before)

  for (const { title, setup } of hosts) {
    await panel.getByRole('combobox', { name: 'For' }).selectOption(title)
    const shown = await lines()
    expect(shown.slice(0, -1)).toEqual(setup.map(({ text }) => text))
    await panel
      .getByRole('button', { name: /^Copy: / })
      .last()
      .click()
    await expect(panel.getByText(/^Copied: /)).toBeVisible()
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(shown.at(-1))
  }
})

test('the view of the preview is kept, and its picture saved', async ({ lens, page }) => {
  await lens.open()
  await page.getByRole('button', { name: 'Copy embed', exact: true }).click()
  const panel = panelOf(page)
  const scene = previewOf(page).getByRole('application')
  await previewOf(page).scrollIntoViewIfNeeded()
  await expect(scene).toBeVisible()
  const address = page.url()
  await previewOf(page).evaluate(element => {
    const preview = element as HTMLElementTagNameMap['hex-lens']
    preview.vertices = preview.vertices.with(0, 0.25)
  })
  await lens.nextFrame()
  expect(page.url()).toBe(address)
  await scene.focus()
  await page.keyboard.press('a')
  await lens.nextFrame()
  await panel.getByRole('button', { name: 'Keep this view' }).click()
  await expect(panel.locator('pre').last()).toContainText(/camera="-?[\d.]+ -?[\d.]+ [\d.]+"/)
  const download = page.waitForEvent('download')
  await panel.getByRole('button', { name: 'Download hexlens.png' }).click()
  expect((await download).suggestedFilename()).toBe('hexlens.png')
  await expect(panel.getByText('Saved as hexlens.png.')).toBeVisible()
})

for (const [colorScheme, width, height] of SCHEMES_AND_WIDTHS) {
  test.describe(`in the ${colorScheme} scheme`, () => {
    test.use({ colorScheme })

    test(`at ${width} pixels axe finds nothing, and all fits`, async ({ lens, page }) => {
      await page.setViewportSize({ width, height })
      await lens.open()
      await page.getByRole('button', { name: 'Copy embed', exact: true }).click()
      await previewOf(page).scrollIntoViewIfNeeded()
      await expect(previewOf(page).getByRole('application')).toBeVisible()
      await expectAxeFindsNothing(page, '#panel-embed')
      await expectNoSidewaysOverflow(page)
    })
  })
}
