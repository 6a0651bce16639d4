import { expect, Lens, test } from './lens'

const awkward = [
  0.1 + 0.2,
  -0,
  5e-324,
  1.7976931348623157e308,
  -1.7976931348623157e308,
  1e-300,
  2 ** -1074,
  1 / 3,
  -1e-17,
  4.35,
  0,
  123456789.98765433,
  2 ** 53 + 2,
  -2.2250738585072014e-308,
  1e21,
  1e-7,
  0.30000000000000004,
  9.5367431640625e-7,
  -0.1,
  7,
  1e22,
  -3.5e-310,
  2.5,
  1e100,
]
const tiny = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1].map(x => x * 1e-300)

test.use({ permissions: ['clipboard-read', 'clipboard-write'] })

test('a copied link opens the doubles again, bit for bit', async ({ lens, page, context }) => {
  await lens.open()
  for (const [name, vertices] of Object.entries({ awkward, tiny }))
    await test.step(name, async () => {
      await lens.set(vertices)
      const bits = await lens.bits()
      await lens.button('Copy link').click()
      await expect(page.getByText('Link copied')).toBeVisible()
      const link = await page.evaluate(() => navigator.clipboard.readText())

      const other = new Lens(await context.newPage())
      await other.open(link)
      expect(await other.bits()).toEqual(bits)
      await other.page.close()
    })
})

test('the address is the element: as it changes, when another is pasted, after a reload', async ({ lens, page }) => {
  await lens.open()

  await test.step('a link pasted into the address bar of the open page is opened, and undone', async () => {
    const first = await lens.bits()
    await lens.set(tiny)
    const link = await page.evaluate(() => location.href)
    await lens.button('Undo').click()
    await expect.poll(() => lens.bits()).toEqual(first)
    await expect.poll(() => page.url()).not.toBe(link)
    await page.evaluate(hash => {
      location.hash = hash
    }, new URL(link).hash)
    await expect.poll(() => lens.vertices()).toEqual(tiny)
    await expect(lens.verdict).toHaveText(/^VALID/)
    await lens.button('Undo').click()
    await expect.poll(() => lens.bits()).toEqual(first)
  })

  await test.step('a broken link pasted into an open page keeps the element shown', async () => {
    await lens.set(tiny)
    await page.evaluate(() => {
      location.hash = '#v1:broken'
    })
    await expect(page.getByRole('alert').filter({ hasText: /link/i })).toBeVisible()
    expect(await lens.vertices()).toEqual(tiny)
    await page.evaluate(() => {
      location.hash = ''
    })
    await expect(page.getByRole('alert').filter({ hasText: /link/i })).toBeHidden()
    await page.evaluate(() => {
      location.hash = '#v1:broken'
    })
    await page.getByRole('button', { name: 'Dismiss' }).click()
    await expect(page.getByRole('button', { name: 'Dismiss' })).toBeHidden()
  })

  await test.step('the address follows what is committed, and a reload shows it again', async () => {
    const address = page.url()
    await lens.field(6, 'z').fill('0.75')
    await lens.field(6, 'z').press('Enter')
    await expect.poll(() => page.url()).not.toBe(address)
    const bits = await lens.bits()
    await page.reload()
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    expect(await lens.bits()).toEqual(bits)
  })

  await test.step('where the clipboard is closed the link is shown to be copied by hand', async () => {
    await page.evaluate(() => {
      Object.defineProperty(navigator, 'clipboard', { value: undefined })
    })
    await lens.set(tiny)
    await lens.button('Copy link').click()
    await expect(page.getByRole('textbox', { name: 'The browser did not let' })).toHaveValue(page.url())
  })
})

test('a broken link says so, keeps a working page, and is not overwritten before something changes', async ({
  lens,
  page,
}) => {
  await lens.open('./#v1:broken')
  const sentence = page.getByRole('alert').filter({ hasText: /link/i })
  await expect(sentence).toBeVisible()
  expect(page.url()).toContain('#v1:broken')
  const before = await lens.vertices()
  await lens.field(0, 'x').fill('0.125')
  await lens.field(0, 'x').press('Enter')
  await expect.poll(() => lens.vertices()).not.toEqual(before)
  await expect(sentence).toBeHidden()
  expect(page.url()).not.toContain('broken')
})

test('Back and Forward step through the presets, and a reload stays', async ({ lens, page }) => {
  await lens.open()
  await lens.preset.selectOption('cube')
  await expect(lens.verdict).toHaveText(/^VALID/)
  await lens.preset.selectOption('wrong-order')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await page.goBack()
  await expect(lens.preset).toHaveValue('cube')
  await expect(lens.verdict).toHaveText(/^VALID/)
  await page.reload()
  await expect(lens.preset).toHaveValue('cube')
  await page.goForward()
  await expect(lens.preset).toHaveValue('wrong-order')
  await page.goBack()
  await page.goBack()
  await expect(lens.preset).toHaveValue('looks-fine')
})
