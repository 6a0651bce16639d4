import { expect, test } from './lens'

test('nothing is rendered while nothing changes', async ({ lens, page }) => {
  await page.addInitScript(() => {
    const counts = { frames: 0, draws: 0 }
    Object.assign(globalThis, { counts })
    const request = requestAnimationFrame
    globalThis.requestAnimationFrame = callback => {
      counts.frames++
      return request.call(globalThis, callback)
    }
    for (const name of [
      'drawArrays',
      'drawElements',
      'drawArraysInstanced',
      'drawElementsInstanced',
      'clear',
    ] as const) {
      const draw = WebGL2RenderingContext.prototype[name] as (...args: unknown[]) => void
      Object.assign(WebGL2RenderingContext.prototype, {
        [name](this: unknown, ...args: unknown[]) {
          counts.draws++
          draw.apply(this, args)
        },
      })
    }
  })
  const counts = () =>
    page.evaluate(() => ({ ...(globalThis as unknown as { counts: { frames: number; draws: number } }).counts }))
  await lens.open()
  await page.mouse.move(300, 300)
  await page.waitForTimeout(1500)
  const before = await counts()
  expect(before.draws).toBeGreaterThan(0)
  await page.waitForTimeout(1500)
  expect(await counts()).toEqual(before)

  await lens.field(3, 'x').fill('0.4')
  await expect.poll(async () => (await counts()).draws).toBeGreaterThan(before.draws)
})

test('the element among others, heard by people and by the page, taken out and put back', async ({ lens, page }) => {
  await lens.open()

  await test.step('two elements on a page do not disturb each other', async () => {
    await page.evaluate(() => {
      const other = document.createElement('hex-lens')
      other.views = 'all'
      other.vertices = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
      document.querySelector('main')?.append(other)
    })
    const second = page.locator('hex-lens').nth(1)
    await second.scrollIntoViewIfNeeded()
    await expect(page.getByRole('status', { name: 'Verdict' })).toHaveText([/^INVALID/, /^VALID/])
    await second.getByRole('textbox', { name: 'Vertex 6 z' }).fill('-3')
    await expect(second.getByRole('status', { name: 'Verdict' })).toHaveText(/^INVALID/)
    await expect(page.locator('hex-lens').first().getByRole('button', { name: 'Undo' })).toBeDisabled()
    await second.evaluate(element => element.remove())
  })

  await test.step('a change is said once, politely, a moment later', async () => {
    const said = page.locator('hex-lens .announcer')
    await expect(said).toHaveText('')
    await lens.set([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1])
    await lens.field(6, 'z').fill('1.5')
    await expect(said).toHaveText(/^Vertex 6: 1, 1, 1\.5\. Minimum jacdet .* (at|on) (vertex|edge|face) \d+\. Valid\.$/)
    await expect(said).toHaveAttribute('aria-live', 'polite')
  })

  await test.step('the element speaks to the page that holds it', async () => {
    await lens.field(6, 'z').blur()
    await lens.preset.selectOption('looks-fine')
    await lens.nextFrame()
    const told = await page.evaluate(async () => {
      const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
      const events: string[] = []
      const refusals: string[] = []
      for (const name of ['hex-input', 'hex-change', 'hex-verdict'])
        document.addEventListener(name, event => events.push(`${name} by ${(event as CustomEvent).detail.source}`))
      document.addEventListener('hex-error', event => refusals.push((event as CustomEvent).detail.message))
      const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
      lens.vertices = new Float64Array(cube)
      const atOnce = lens.report
      for (const wrong of [[1, 2, 3], cube.with(5, Number.NaN), cube.with(5, Number.POSITIVE_INFINITY), null])
        lens.vertices = wrong as number[]
      await new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)))
      return { events, refusals, atOnce, kept: lens.vertices, cube }
    })
    expect(told.events).toEqual(['hex-input by program', 'hex-verdict by program'])
    expect(told.refusals).toEqual([
      'A hexahedron has 24 coordinates; 3 were given.',
      'Coordinate 5 is NaN, not a finite number.',
      'Coordinate 5 is Infinity, not a finite number.',
      'A hexahedron has 24 coordinates; none were given.',
    ])
    expect(told.atOnce?.valid).toBe(true)
    expect(told.atOnce?.boundaryMinimum).toBe(1)
    expect(told.kept).toEqual(told.cube)
  })

  await test.step('taken out of the page and put back, the element goes on as it was', async () => {
    await lens.field(0, 'x').fill('0.5')
    await lens.field(0, 'x').press('Enter')
    const before = await lens.vertices()
    await page.evaluate(async () => {
      const lens = document.querySelector('hex-lens') as HTMLElement
      const parent = lens.parentElement as HTMLElement
      lens.remove()
      await new Promise(resolve => requestAnimationFrame(resolve))
      parent.append(lens)
    })
    await expect(lens.verdict).toHaveCount(1)
    await expect(lens.verdict).toHaveText(/^(VALID|INVALID)/)
    expect(await lens.vertices()).toEqual(before)
    await lens.button('Undo').click()
    await expect.poll(() => lens.vertices()).not.toEqual(before)
  })

  await test.step('the built page carries a strict policy of its own', async () => {
    const policy = await page.locator('meta[http-equiv=Content-Security-Policy]').getAttribute('content')
    expect(policy).toContain("default-src 'none'")
    expect(policy).not.toContain('unsafe-inline')
    expect(policy).not.toContain("'unsafe-eval'")
    expect(policy).not.toMatch(/https?:|\*/)
  })
})
