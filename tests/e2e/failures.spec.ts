import type { Page, Route } from '@playwright/test'
import { expect, type Lens, test, watchContexts } from './lens'

const answers: Record<string, (route: Route) => Promise<void>> = {
  'does not arrive': route => route.abort(),
  'is something else': route => route.fulfill({ contentType: 'application/wasm', body: '<!doctype html>' }),
}

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

const coreMissing = (page: Page) => page.getByRole('alert').filter({ hasText: 'core did not start' })

test.describe('without wasm', () => {
  test.use({ expectedErrors: /Failed to load resource|violates the following|policy: script-src forbids wasm-eval/ })

  for (const [what, answer] of Object.entries(answers)) {
    test(`when it ${what}, its twin in JavaScript decides`, async ({ lens, page }) => {
      await page.route('**/*.wasm*', answer)
      await expectTwinDecides(lens, page)
    })
  }

  test('where the page’s policy forbids it, its twin in JavaScript decides', async ({ lens, page }) => {
    await page.route('./', async route => {
      const response = await route.fetch()
      const policy = "script-src 'self'; style-src 'self'"
      await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': policy } })
    })
    await expectTwinDecides(lens, page)
    expect(
      await page.evaluate(() => WebAssembly.compile(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0)).then(String, String)),
    ).toContain('CompileError')
  })

  test('in a browser without WebAssembly, its twin in JavaScript decides', async ({ lens, page }) => {
    await page.addInitScript(() => {
      Reflect.deleteProperty(globalThis, 'WebAssembly')
    })
    await expectTwinDecides(lens, page)
  })

  test('and without its twin a sentence says so, and the numbers, undo and the link still work', async ({
    lens,
    page,
  }) => {
    await page.route('**/*.wasm*', route => route.fulfill({ status: 404, body: 'no' }))
    await page.route('**/*twin*', route => route.abort())
    await page.goto('./')
    await expect(coreMissing(page)).toContainText('404')
    await expect(lens.verdict).toHaveText(/^NO VERDICT/)
    const before = await lens.vertices()
    await lens.field(6, 'z').fill('0.5')
    await lens.field(6, 'z').press('Enter')
    await expect.poll(async () => (await lens.vertices())[20]).toBe(0.5)
    await expect.poll(() => page.url()).toContain('#')
    await lens.button('Undo').click()
    await expect.poll(() => lens.vertices()).toEqual(before)
    expect(await lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).report)).toBeNull()
  })
})

async function expectTwinDecides(lens: Lens, page: Page): Promise<void> {
  const twin = page.waitForResponse(/twin/)
  await lens.open()
  expect((await twin).ok()).toBe(true)
  await expect(coreMissing(page)).toBeHidden()
  await lens.set(cube.with(20, -3))
  await expect(lens.verdict).toHaveText(/^INVALID/)
  const minimum = () =>
    lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).report?.boundaryMinimum)
  expect(await minimum()).toBe(-3)
  await lens.set(cube)
  await expect(lens.verdict).toHaveText(/^VALID/)
  expect(await minimum()).toBe(1)
}

test.describe('without WebGL', () => {
  test.use({ expectedErrors: /WebGL/ })

  test('a sentence says so, a flat drawing has the colours and signs, and the verdict follows what is typed', async ({
    lens,
    page,
  }) => {
    await page.addInitScript(() => {
      for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
        const getContext = prototype.getContext as (kind: string, ...rest: unknown[]) => unknown
        Object.assign(prototype, {
          getContext(this: unknown, kind: string, ...rest: unknown[]) {
            return kind.startsWith('webgl') ? null : getContext.call(this, kind, ...rest)
          },
        })
      }
    })
    await lens.open()
    await expect(page.getByText(/WebGL/).first()).toBeVisible()
    await lens.set([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1])
    await expect(lens.verdict).toHaveText(/^VALID/)
    const tiles = page.locator('hex-lens .scene-flat > path:not([display])')
    const hatched = page.locator('hex-lens .scene-flat > path[fill^=url]:not([display])')
    await expect(tiles).toHaveCount(600)
    await expect(hatched).toHaveCount(0)
    await lens.field(6, 'z').fill('-3')
    await expect(lens.verdict).toHaveText(/^INVALID/)
    await expect(hatched).not.toHaveCount(0)
    const picture = await lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).toSVG())
    expect(picture.match(/<path [^>]*fill="url\(#scene-flat/g)?.length).toBe(await hatched.count())
    expect(picture).not.toContain('<image')
  })
})

test('a lost context is said, the numbers go on, and the picture comes back', async ({ lens, page }) => {
  await watchContexts(page)
  await lens.open()
  const context = await page.evaluateHandle(() => {
    const gl = (globalThis as unknown as { contexts: WebGL2RenderingContext[] }).contexts[0] as WebGL2RenderingContext
    return { gl, loss: gl.getExtension('WEBGL_lose_context') as WEBGL_lose_context }
  })
  await context.evaluate(({ loss }) => loss.loseContext())
  const sentence = page.getByRole('alert').filter({ hasText: /WebGL|context|picture|graphics/i })
  await expect(sentence).toBeVisible()
  await lens.field(6, 'z').fill('-3')
  await expect(lens.verdict).toHaveText(/^INVALID/)
  await context.evaluate(({ loss }) => loss.restoreContext())
  await expect(sentence).toBeHidden()
  await lens.field(6, 'z').fill('0.9')
  await lens.nextFrame()
  expect(await context.evaluate(({ gl }) => gl.isContextLost())).toBe(false)
})

test.describe('without scripts', () => {
  test.use({ javaScriptEnabled: false })

  test('the page says what it needs', async ({ page }) => {
    await page.goto('./')
    await expect(page.locator('noscript')).toBeVisible()
  })
})

test.describe('when its script does not arrive', () => {
  test.use({ expectedErrors: /Failed to load resource/ })

  test('the page says so after a while', async ({ lens, page }) => {
    await page.route('**/*.js', route => route.abort())
    await page.goto('./')
    await expect(lens.element.getByText('Hexlens could not start')).toBeVisible()
  })
})
