/** The element as a guest on somebody else's page. */
import AxeBuilder from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { expect, heldObjects, test, watchContexts } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

/** A page of text with elements in it, none of whose styles suits them; the app's own element and style are gone. */
async function visit(page: Page, widgets: readonly Readonly<Record<string, string>>[]): Promise<void> {
  await page.goto('./')
  await expect(page.getByRole('status', { name: 'Verdict' })).toHaveText(/^(VALID|INVALID)/)
  await page.evaluate(async widgets => {
    const style = new CSSStyleSheet()
    style.replaceSync(
      'html { font: italic 40px serif; letter-spacing: 9px; text-transform: uppercase; text-align: right } button { display: none }',
    )
    document.adoptedStyleSheets = [style]
    for (const link of document.querySelectorAll('link[rel=stylesheet]')) link.remove()
    const shifts: number[] = []
    Object.assign(globalThis, { shifts })
    document.body.replaceChildren()
    await new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)))
    const paragraph = () => Object.assign(document.createElement('p'), { textContent: 'Words of the page.' })
    for (const attributes of widgets) {
      const lens = document.createElement('hex-lens')
      for (const [name, text] of Object.entries(attributes)) lens.setAttribute(name, text)
      lens.style.width = '360px'
      document.body.append(paragraph(), lens)
    }
    document.body.append(paragraph())
    await new Promise(resolve => requestAnimationFrame(resolve))
    new PerformanceObserver(list => {
      for (const entry of list.getEntries()) shifts.push((entry as unknown as { value: number }).value)
    }).observe({ type: 'layout-shift' })
  }, widgets)
}

const elements = (page: Page) => page.locator('hex-lens')

async function expectAllComplete(page: Page, count: number): Promise<void> {
  await expect
    .poll(() => elements(page).evaluateAll(lenses => lenses.filter(lens => (lens as Element).complete).length), {
      timeout: 30_000,
    })
    .toBe(count)
}

/** Pictures that each element has drawn; -1 for one that has no scene. */
const drawn = (page: Page) =>
  elements(page).evaluateAll(lenses =>
    lenses.map(lens => Number((lens.shadowRoot?.querySelector('.scene') as HTMLElement | null)?.dataset.frames ?? -1)),
  )

/** Shares of opaque pixels. */
const painted = (page: Page) =>
  elements(page).evaluateAll(lenses =>
    lenses.map(lens => {
      const canvas = lens.shadowRoot?.querySelector('canvas') as HTMLCanvasElement
      const copy = Object.assign(document.createElement('canvas'), { width: 40, height: 30 })
      const context = copy.getContext('2d') as CanvasRenderingContext2D
      if (getComputedStyle(canvas).visibility === 'hidden') return 0
      context.drawImage(canvas, 0, 0, 40, 30)
      const { data } = context.getImageData(0, 0, 40, 30)
      return data.filter((value, i) => i % 4 === 3 && value > 200).length / 1200
    }),
  )

test('thirty on a page share one context, are drawn when they are seen, and leave the page alone', async ({ page }) => {
  await watchContexts(page)
  await visit(
    page,
    Array.from({ length: 30 }, (_, i) => ({ preset: i % 2 ? 'cube' : 'looks-fine', views: 'scene verdict' })),
  )
  await expect.poll(async () => (await drawn(page))[0]).toBeGreaterThan(0)
  const first = await drawn(page)
  expect(first.slice(6)).toEqual(Array(24).fill(-1))
  // An element out of view is analysed all the same.
  expect(
    await elements(page)
      .last()
      .evaluate(lens => (lens as Element).report?.valid),
  ).toBe(true)

  for (let i = 0; i < 30; i++) {
    await elements(page).nth(i).scrollIntoViewIfNeeded()
    await expect.poll(async () => (await drawn(page))[i], { timeout: 30_000 }).toBeGreaterThan(0)
  }
  expect(Math.min(...(await painted(page)))).toBeGreaterThan(0.02)
  expect(await page.evaluate(() => (globalThis as unknown as { contexts: unknown[] }).contexts.length)).toBe(1)
  expect(await page.evaluate(() => (globalThis as unknown as { shifts: number[] }).shifts)).toEqual([])

  // One changes, only that one is drawn.
  const before = await drawn(page)
  await elements(page)
    .nth(29)
    .evaluate((lens, given) => {
      ;(lens as Element).vertices = given.map(x => 2 * x + (x === 1 ? 0.25 : 0))
    }, cube)
  await expect.poll(async () => (await drawn(page))[29]).toBe((before[29] as number) + 1)
  expect((await drawn(page)).slice(0, 29)).toEqual(before.slice(0, 29))

  // The context is lost and comes back: for all.
  await page.evaluate(() => {
    const [gl] = (globalThis as unknown as { contexts: [WebGL2RenderingContext] }).contexts
    const loss = gl.getExtension('WEBGL_lose_context') as WEBGL_lose_context
    Object.assign(globalThis, { loss })
    loss.loseContext()
  })
  await expect.poll(async () => Math.max(...(await painted(page)))).toBe(0)
  await page.evaluate(() => (globalThis as unknown as { loss: WEBGL_lose_context }).loss.restoreContext())
  await expect.poll(async () => (await painted(page))[29]).toBeGreaterThan(0.02)
  await elements(page).first().scrollIntoViewIfNeeded()
  await expect.poll(async () => (await painted(page))[0]).toBeGreaterThan(0.02)

  // Neither side's style reaches the other.
  const styles = await elements(page)
    .first()
    .evaluate(lens => {
      const read = (element: Element | HTMLElement) => {
        const { fontSize, fontStyle, letterSpacing, textTransform, textAlign } = getComputedStyle(element)
        return [fontSize, fontStyle, letterSpacing, textTransform, textAlign]
      }
      const word = lens.shadowRoot?.querySelector('.verdict .word') as HTMLElement
      const button = lens.shadowRoot?.querySelector('.scene-controls > button:last-child') as HTMLElement
      return [read(word), read(document.querySelector('p') as HTMLElement), getComputedStyle(button).display !== 'none']
    })
  expect(styles).toEqual([
    ['18px', 'normal', '-0.18px', 'none', 'start'],
    ['40px', 'italic', '9px', 'uppercase', 'right'],
    true,
  ])
})

test('put in and taken out a hundred times, nothing is left behind', async ({ page }) => {
  await watchContexts(page)
  await visit(page, [{ views: 'scene verdict inside' }])
  await elements(page).evaluate(lens => {
    lens.style.width = '160px'
  })
  for (const name of ['Details', 'Inside'])
    await elements(page).getByRole('button', { name, exact: true }).dispatchEvent('click')
  await expectAllComplete(page, 1)
  const client = await page.context().newCDPSession(page)
  await client.send('Performance.enable')
  const inAndOut = (times: number) =>
    page.evaluate(async times => {
      const old = document.querySelector('hex-lens') as Element
      const put = async (lens: Element) => {
        document.body.prepend(lens)
        while (!lens.complete) await new Promise(requestAnimationFrame)
      }
      for (let i = 0; i < times; i++) {
        old.remove()
        if (i % 10 === 0) {
          const fresh = document.createElement('hex-lens')
          fresh.style.width = '120px'
          await put(fresh)
          fresh.remove()
        }
        await put(old)
      }
    }, times)
  const measure = async () => {
    const objects = await heldObjects(client)
    const { metrics } = await client.send('Performance.getMetrics')
    const value = (name: string) => metrics.find(metric => metric.name === name)?.value as number
    return { objects, nodes: value('Nodes'), listeners: value('JSEventListeners') }
  }
  await inAndOut(20)
  const early = await measure()
  await inAndOut(80)
  const late = await measure()
  expect(late.listeners - early.listeners).toBeLessThanOrEqual(10)
  expect(late.nodes - early.nodes).toBeLessThanOrEqual(100)
  expect(late.objects - early.objects).toBeLessThan(80)
  expect(await page.evaluate(() => (globalThis as unknown as { contexts: unknown[] }).contexts.length)).toBe(1)
  const sheets = await elements(page).evaluate(lens => lens.shadowRoot?.adoptedStyleSheets.length)
  await inAndOut(1)
  expect(await elements(page).evaluate(lens => lens.shadowRoot?.adoptedStyleSheets.length)).toBe(sheets)
})

test.describe('on a page that scrolls', () => {
  test.use({ hasTouch: true })

  test('wheel and finger scroll the page across an element, a handle is dragged, and Tab comes out again', async ({
    page,
  }) => {
    await visit(page, [{ preset: 'cube' }, { preset: 'looks-fine' }, { preset: 'cube' }, { preset: 'cube' }])
    await expect.poll(async () => (await drawn(page))[0]).toBeGreaterThan(0)
    const top = () => page.evaluate(() => document.scrollingElement?.scrollTop as number)
    const zoom = () =>
      elements(page)
        .first()
        .evaluate(lens => (lens as Element).state.camera?.zoom ?? 1)
    const box = async () => (await elements(page).first().boundingBox()) as { x: number; y: number }

    const { x, y } = await box()
    await page.mouse.move(x + 180, y + 70)
    await page.mouse.wheel(0, 60)
    await expect.poll(top).toBe(60)
    expect(await zoom()).toBe(1)
    await page.keyboard.down('Control')
    await page.mouse.wheel(0, -120)
    await page.keyboard.up('Control')
    await expect.poll(zoom).toBeGreaterThan(1)
    expect(await top()).toBe(60)
    const scene = elements(page).first().getByRole('application')
    await scene.focus()
    const zoomed = await zoom()
    await page.mouse.wheel(0, -120)
    await expect.poll(zoom).toBeGreaterThan(zoomed)
    expect(await top()).toBe(60)

    // Tab leaves the element in as many steps as there are things to use.
    const inside = () => page.evaluate(() => document.activeElement === document.querySelector('hex-lens'))
    let steps = 0
    for (; (await inside()) && steps < 20; steps++) await page.keyboard.press('Tab')
    expect(steps).toBeLessThan(20)
    await elements(page)
      .nth(1)
      .evaluate(lens => lens.scrollIntoView({ block: 'center' }))
    await expect.poll(async () => (await drawn(page))[1]).toBeGreaterThan(0)
    const start = await top()

    const client = await page.context().newCDPSession(page)
    const touch = async (type: 'touchStart' | 'touchMove' | 'touchEnd', points: { x: number; y: number }[]) => {
      await client.send('Input.dispatchTouchEvent', { type, touchPoints: points })
    }
    const swipe = async (from: { x: number; y: number }) => {
      await touch('touchStart', [from])
      for (let i = 1; i <= 10; i++) await touch('touchMove', [{ x: from.x, y: from.y - 8 * i }])
      await touch('touchEnd', [])
    }
    const second = (await elements(page).nth(1).boundingBox()) as { x: number; y: number }
    await swipe({ x: second.x + 20, y: second.y + 60 })
    await expect.poll(top).toBeGreaterThan(start + 30)
    // A page goes on a little after the finger has left it.
    const goesOn = async () => {
      const at = await top()
      await page.waitForTimeout(150)
      return (await top()) - at
    }
    await expect.poll(goesOn).toBe(0)
    // It may have gone far.
    await elements(page)
      .nth(1)
      .evaluate(lens => lens.scrollIntoView({ block: 'center' }))
    await expect.poll(goesOn).toBe(0)
    const before = await top()
    // The lowest of them: nothing else is near it.
    const at = await elements(page)
      .nth(1)
      .locator('.scene-pane .handle .dot')
      .evaluateAll(dots => {
        const boxes = dots.map(dot => dot.getBoundingClientRect())
        const { x, y, width } = boxes.reduce((a, b) => (b.y > a.y ? b : a))
        return { x: x + width / 2, y: y + width / 2 }
      })
    const vertices = await elements(page)
      .nth(1)
      .evaluate(lens => (lens as Element).vertices)
    await swipe(at)
    await expect
      .poll(() =>
        elements(page)
          .nth(1)
          .evaluate(lens => (lens as Element).vertices),
      )
      .not.toEqual(vertices)
    expect(await top()).toBe(before)
  })
})

test('attributes, properties, methods and events', async ({ page }) => {
  await visit(page, [{ preset: 'cube', label: 'A cube', camera: '-30 40 1.5' }])
  await expectAllComplete(page, 1)
  await expect(page.getByRole('group', { name: 'A cube' })).toBeVisible()
  const told = await elements(page).evaluate(async (element, cube) => {
    const lens = element as Element
    const events: string[] = []
    for (const name of ['hex-input', 'hex-change', 'hex-verdict', 'hex-error']) {
      document.addEventListener(name, event => {
        const { detail } = event as CustomEvent
        events.push(`${name} ${detail.source ?? JSON.stringify(detail)} ${detail.valid ?? ''}`)
      })
    }
    const settled = async () => {
      do await new Promise(requestAnimationFrame)
      while (!lens.complete)
    }
    const camera = lens.state.camera
    lens.setAttribute('vertices', cube.with(20, -3).join(' '))
    await settled()
    const moved = [lens.preset, lens.getAttribute('preset'), lens.report?.valid, lens.vertices[20]]
    lens.setAttribute('vertices', '1 2 3')
    await settled()
    const sentence = lens.shadowRoot?.querySelector('.problems')?.textContent?.trim()
    const kept = lens.vertices[20]
    lens.undo()
    await settled()
    const undone = [
      lens.preset,
      lens.getAttribute('preset'),
      lens.getAttribute('vertices')?.slice(0, 12),
      lens.vertices,
    ]
    const problem = lens.shadowRoot?.querySelector('.problems')?.textContent?.trim()
    lens.redo()
    const redone = lens.vertices[20]
    lens.preset = 'looks-fine'
    lens.theme = 'dark'
    lens.views = 'scene verdict vertices'
    await settled()
    const dark = getComputedStyle(lens.shadowRoot?.querySelector('.lens') as HTMLElement).backgroundColor
    const parts = ['scene', 'verdict', 'vertices', 'toolbar', 'panels'].map(
      part => lens.shadowRoot?.querySelectorAll(`[part~="${part}"]`).length,
    )
    lens.readOnly = true
    await settled()
    const field = lens.shadowRoot?.querySelector('.vertices input') as HTMLInputElement
    const held = lens.vertices
    const scene = lens.shadowRoot?.querySelector('.scene-stage') as HTMLElement
    scene.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', bubbles: true, composed: true }))
    await settled()
    const readOnly = [field.readOnly, lens.vertices.join() === held.join(), scene.getAttribute('aria-label')]
    const { valid } = await lens.analyze(cube)
    const refused = await lens.analyze([1]).catch(error => error.code)
    const png = await lens.toPNG()
    const svg = await lens.toSVG()
    const magic = [...new Uint8Array(await png.arrayBuffer()).slice(1, 4)]
      .map(byte => String.fromCharCode(byte))
      .join('')
    const own = [lens.views, lens.theme, lens.getAttribute('readonly')]
    return {
      camera,
      moved,
      sentence,
      kept,
      undone,
      problem,
      redone,
      dark,
      parts,
      readOnly,
      valid,
      refused,
      magic,
      svg,
      own,
      events,
    }
  }, cube)
  expect(told.camera?.zoom).toBeCloseTo(1.5, 3)
  expect(told.camera?.direction[2]).toBeCloseTo(Math.sin((40 * Math.PI) / 180), 5)
  expect(told.moved).toEqual([null, null, false, -3])
  expect(told.sentence).toBe('A hexahedron has 24 coordinates; 3 were given.')
  expect(told.kept).toBe(-3)
  expect(told.undone).toEqual(['cube', 'cube', '0 0 0, 1 0 0', cube])
  expect(told.problem).toBe('')
  expect(told.redone).toBe(-3)
  expect(told.dark).toBe('rgb(23, 24, 26)')
  expect(told.parts).toEqual([1, 1, 1, 0, 1])
  expect(told.readOnly).toEqual([true, true, 'The hexahedron in space'])
  expect([told.valid, told.refused, told.magic]).toEqual([true, 'wrong-count', 'PNG'])
  expect(told.svg).toMatch(/^<svg .*<title>A cube<\/title>\n<desc>v=1&#38;vertices=/s)
  expect(told.own).toEqual(['scene verdict vertices', 'dark', ''])
  expect(told.events.slice(0, 4)).toEqual([
    'hex-input program false',
    'hex-verdict program false',
    'hex-error {"code":"bad-vertices","message":"A hexahedron has 24 coordinates; 3 were given."} ',
    'hex-input history true',
  ])
})

test('a second copy of the script does no harm', async ({ page }) => {
  const errors: string[] = []
  page.on('pageerror', error => errors.push(error.message))
  await page.goto('./')
  await expect(page.getByRole('status', { name: 'Verdict' })).toHaveText(/^INVALID/)
  await page.evaluate(async () => {
    const loaded = performance.getEntriesByType('resource').map(({ name }) => name)
    const script = loaded.find(name => /\/element-[^/]*\.js$/.test(name))
    const first = customElements.get('hex-lens')
    await import(`${script}?again`)
    if (customElements.get('hex-lens') !== first) throw new Error('defined anew')
    const lens = document.createElement('hex-lens')
    lens.preset = 'cube'
    document.querySelector('main')?.prepend(lens)
  })
  await expect(page.getByRole('status', { name: 'Verdict' })).toHaveText([/^VALID/, /^INVALID/])
  expect(errors).toEqual([])
})

test('axe finds nothing in elements of every kind, dark and light', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  await page.setViewportSize({ width: 1000, height: 2600 })
  await visit(page, [
    { preset: 'cube', label: 'A cube' },
    { theme: 'light', views: 'scene' },
    { readonly: '', views: 'scene toolbar vertices', controls: 'none' },
    { vertices: '1 2 3', views: 'verdict checks', theme: 'light' },
  ])
  await expectAllComplete(page, 4)
  const { violations } = await new AxeBuilder({ page }).include('hex-lens').analyze()
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join('; ')}`)).toEqual([])
})
