import { expect, test } from './lens'

test('the minimum comes with the bound of its error, on the boundary and inside', async ({ lens, page, context }) => {
  await lens.open()

  await test.step('the minimum comes with the bound of its error, on either reference cube', async () => {
    await expect(lens.minimum).toContainText(/min J = −0\.010653 ±\u00a0[\d.]+×10⁻¹[²³⁴⁵]/)
    await expect(lens.minimum).toContainText('a witness: J ≤ −0.010653 there')
    await expect(lens.minimum).toContainText(/nowhere lower, to within [\d.]+×10⁻¹[¹²³⁴]/)
    await page.getByRole('button', { name: /\[0,1\]/ }).click()
    await expect(lens.minimum).toContainText(/min J = −0\.0013317 ±/)
    await expect(lens.minimum).toContainText('J ≤ −0.0013316 there')
    await page.getByRole('button', { name: /\[−1,1\]/ }).click()
  })

  await test.step('a valid element says from where on it is positive, and nothing of its inside', async () => {
    await lens.preset.selectOption({ label: 'Valid, though subdivision gives up' })
    await expect(lens.verdict).toContainText(/^VALID.*min J = 0\.062755/s)
    await expect(lens.minimum).toContainText(/min J = 0\.062755 ±/)
    await expect(lens.minimum).toContainText('error bounds: all J ≥ 0.062754')
    await expect(lens.minimum).not.toContainText(/inside/i)
  })

  await test.step('the paper’s counterexample reads 0 on the boundary and −1/4 inside', async () => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    await lens.preset.selectOption({ label: 'Zero on the faces, negative inside' })
    await expect(lens.minimum).toContainText(/min J = 0\s+on the boundary/)
    await expect(lens.minimum).toContainText(/min J = −1\/4 ±\u00a0[\d.]+×10⁻¹[¹²³⁴⁵]\s+inside/)
    await expect(lens.minimum).toContainText('at (ξ, η, ζ) = (1/2, 1/2, 1/2)')
    await expect(lens.minimum).toContainText('exact arithmetic')
    await lens.minimum.getByRole('button', { name: '(1/2, 1/2, 1/2)' }).click()
    await expect(page.getByText('Copied 0.5, 0.5, 0.5')).toBeVisible()
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('0.5, 0.5, 0.5')
  })
})

test('what is degenerate, inverted or collapsed is said', async ({ lens, page, context }) => {
  await lens.open()
  await lens.preset.selectOption({ label: 'Unit cube' })
  await expect(lens.verdict).toHaveText(/^VALID/)
  const cube = await lens.vertices()
  const vertexAt = (places: string) => [...places].flatMap(v => cube.slice(3 * Number(v), 3 * Number(v) + 3))
  const kind = lens.verdict.locator('.kind')

  await test.step('an ordinary element has a volume and a relative minimum, and nothing more is said of it', async () => {
    await expect(lens.verdict).toContainText(/^VALID.*min J = 1/s)
    await expect(lens.minimum).toContainText(/Volume\s*1\s*length³/)
    await expect(lens.minimum).toContainText(/Relative minimum\s*1\s*no dimension/)
    await expect(kind).toHaveCount(0)
  })

  await test.step('a wedge is called one, and heard to be one', async () => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    await lens.set(vertexAt('01234466'))
    await expect(kind).toHaveText('a wedge stored as a hexahedron')
    await expect(lens.verdict).toContainText('Vertices 4 and 5 coincide, and so do 6 and 7: jacdet is 0 there.')
    await expect(page.locator('.announcer')).toContainText('Invalid: a wedge stored as a hexahedron. Vertices 4 and 5')
    await page.getByRole('button', { name: /\[0,1\]/ }).click()
    await lens.minimum.getByRole('button', { name: '1/2' }).click()
    await expect(page.getByText('Copied 0.5')).toBeVisible()
  })

  await test.step('classes', async () => {
    await lens.set(vertexAt('45670123'))
    await expect(kind).toHaveText('inverted')
    await expect(lens.verdict).toContainText('The usual cause is a mirrored node order.')
    await expect(lens.minimum).toContainText(/Relative minimum\s*−1\s*no dimension/)
    await lens.set(vertexAt('01230123'))
    await expect(kind).toHaveText('collapsed')
    await expect(lens.minimum).toContainText('none, as the volume is 0')
  })
})

test('the important comes first: verdict, sentence, checks, then bounds and coordinates', async ({ lens, page }) => {
  await lens.open()
  const places = [
    lens.verdict.getByText('INVALID', { exact: true }),
    lens.verdict.locator('.why'),
    page.getByRole('heading', { name: 'Who would notice?' }),
    page.getByText('±').first(),
    page.getByText('(ξ, η, ζ) =').first(),
    page.getByRole('heading', { name: 'Vertices' }),
  ]
  for (const [width, height] of [
    [1440, 900],
    [1024, 768],
    [390, 844],
  ] as const) {
    await page.setViewportSize({ width, height })
    await lens.settled()
    const tops = await Promise.all(places.map(async place => (await place.boundingBox())?.y ?? Number.NaN))
    expect(tops, `at ${width} pixels`).toEqual(tops.toSorted((a, b) => a - b))
    // NaN is in order with any number.
    expect(tops.every(Number.isFinite)).toBe(true)
  }
})
