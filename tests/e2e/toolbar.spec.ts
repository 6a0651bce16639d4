import { expect, test } from './lens'

const cube = '0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1'

test.describe('Paste in the toolbar', () => {
  test('reads the clipboard', async ({ lens, page, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    await lens.open()
    await page.evaluate(text => navigator.clipboard.writeText(text), cube)
    await lens.button('Paste').click()
    await expect(lens.verdict).toHaveText(/^VALID/)
    expect(await lens.vertices()).toEqual(cube.split(' ').map(Number))
  })

  test('opens the box and says so where the browser does not allow that', async ({ lens, page }) => {
    await page.addInitScript(() => {
      Object.defineProperty(navigator.clipboard, 'readText', { value: () => Promise.reject(new Error('No.')) })
    })
    await lens.open()
    await lens.button('Paste').click()
    await expect(page.getByText('Press Ctrl+V (⌘V), or use the box.')).toBeVisible()
    await expect(page.getByRole('textbox', { name: /^Text with eight points/ })).toBeVisible()
  })

  test('is not there where nothing is read', async ({ lens }) => {
    await lens.open()
    await lens.element.evaluate(element => element.setAttribute('views', 'scene verdict toolbar'))
    await expect(lens.button('Copy link')).toBeVisible()
    await expect(lens.button('Paste')).toHaveCount(0)
  })
})

test('the panels are in the order in which they are wanted', async ({ lens, page }) => {
  await lens.open()
  const names = await page.locator('hex-lens .folds .fold > h2').allInnerTexts()
  expect(names).toEqual([
    'Face maps',
    'Algorithm 1, step by step',
    'Inside',
    'Nearest invalid, nearest valid',
    'Best place of a vertex',
    'Morph',
    'Node order',
    'Paste or drop',
    'Take away',
    'Copy embed',
  ])
})
