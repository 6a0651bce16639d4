/** The page as a user has it: by roles and names. Every test also watches for what must never happen on the page. */
import AxeBuilder from '@axe-core/playwright'
import { test as base, type CDPSession, expect, type Locator, type Page } from '@playwright/test'

export class Lens {
  readonly page: Page
  readonly element: Locator
  readonly verdict: Locator
  /** The numbers behind the verdict. */
  readonly minimum: Locator
  readonly scene: Locator
  readonly preset: Locator

  constructor(page: Page) {
    this.page = page
    this.element = page.locator('hex-lens')
    this.verdict = page.getByRole('status', { name: 'Verdict' })
    this.minimum = page.getByRole('group', { name: 'Minimum' })
    this.scene = page.getByRole('application', { name: /^The hexahedron/ })
    this.preset = page.getByRole('combobox', { name: 'Preset' })
  }

  async open(address = './'): Promise<void> {
    await this.page.goto(address)
    await expect(this.verdict).toHaveText(/^(VALID|INVALID)/)
    await expect(this.scene).toBeVisible()
  }

  field(vertex: number, axis: 'x' | 'y' | 'z'): Locator {
    return this.page.getByRole('textbox', { name: `Vertex ${vertex} ${axis}` })
  }

  button(name: string): Locator {
    return this.page.getByRole('button', { name, exact: true })
  }

  vertices(): Promise<number[]> {
    return this.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).vertices)
  }

  /** Exactly, signs of zero included: JSON has no -0. */
  bits(): Promise<string[]> {
    return this.element.evaluate(element =>
      Array.from(
        new BigUint64Array(Float64Array.from((element as HTMLElementTagNameMap['hex-lens']).vertices).buffer),
        String,
      ),
    )
  }

  async set(vertices: readonly number[]): Promise<void> {
    const texts = vertices.map(value => (Object.is(value, -0) ? '-0' : String(value)))
    await this.element.evaluate((element, given) => {
      ;(element as HTMLElementTagNameMap['hex-lens']).vertices = given.map(Number)
    }, texts)
    await this.nextFrame()
  }

  /** Resolves when the views of an element that is seen show what it is, at the size it has: they follow its box a frame later. */
  async settled(): Promise<void> {
    await this.nextFrame()
    await expect
      .poll(() => this.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).complete))
      .toBe(true)
  }

  /** Resolves after the element's own frame, if one was due. */
  nextFrame(): Promise<void> {
    return this.page.evaluate(
      () => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(() => resolve()))),
    )
  }
}

export interface Point {
  readonly x: number
  readonly y: number
}

/** The position of a vertex's handle on the page. */
export async function handleOf(lens: Lens, vertex: number): Promise<Point> {
  const circle = lens.page
    .locator('hex-lens .scene-pane .handle', { hasText: new RegExp(`^${vertex}$`) })
    .locator('circle')
    .last()
  const box = await circle.boundingBox()
  if (box === null) throw new Error(`Vertex ${vertex} has no handle.`)
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}

/** Keeps every WebGL context that the page makes, in `globalThis.contexts`. */
export async function watchContexts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const contexts: unknown[] = []
    Object.assign(globalThis, { contexts })
    for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
      const getContext = prototype.getContext as (kind: string, ...rest: unknown[]) => unknown
      Object.assign(prototype, {
        getContext(this: unknown, kind: string, ...rest: unknown[]) {
          const context = getContext.call(this, kind, ...rest)
          if (kind.startsWith('webgl') && context && !contexts.includes(context)) contexts.push(context)
          return context
        },
      })
    }
  })
}

/** Objects and functions that a page holds. Bytes of its heap would count code, which comes whenever an engine compiles. */
export async function heldObjects(session: CDPSession): Promise<number> {
  const pieces: string[] = []
  const collect = ({ chunk }: { readonly chunk: string }) => pieces.push(chunk)
  session.on('HeapProfiler.addHeapSnapshotChunk', collect)
  await session.send('HeapProfiler.takeHeapSnapshot') // collects the garbage first
  session.off('HeapProfiler.addHeapSnapshotChunk', collect)
  const { snapshot, nodes } = JSON.parse(pieces.join('')) as {
    readonly snapshot: { readonly meta: { readonly node_fields: string[]; readonly node_types: [string[]] } }
    readonly nodes: number[]
  }
  const { node_fields: fields, node_types: types } = snapshot.meta
  const counted = ['object', 'closure'].map(name => types[0].indexOf(name))
  const ofType = fields.indexOf('type')
  return nodes.filter((value, i) => i % fields.length === ofType && counted.includes(value)).length
}

interface Options {
  /** Sentences in the console that a test provokes on purpose. */
  expectedErrors: RegExp | null
  /**
   * Pixels of the faces' picture for each of the screen's, each way: software would take more than a third of the time of all
   * tests for it. A test of the picture itself says 1.
   */
  pictureRatio: number
}

export const test = base.extend<{ lens: Lens } & Options>({
  expectedErrors: [null, { option: true }],
  pictureRatio: [0.25, { option: true }],
  context: async ({ context, pictureRatio }, use) => {
    await context.addInitScript(ratio => {
      Object.defineProperty(globalThis, 'devicePixelRatio', { value: ratio * devicePixelRatio })
    }, pictureRatio)
    await use(context)
  },
  lens: async ({ page, baseURL, expectedErrors }, use) => {
    const complaints: string[] = []
    page.on('pageerror', error => complaints.push(`exception: ${error.message}`))
    page.on('console', message => {
      if (message.type() === 'error' && !expectedErrors?.test(message.text()))
        complaints.push(`console: ${message.text()}`)
    })
    page.on('request', request => {
      const { protocol, origin } = new URL(request.url())
      const own = origin === new URL(baseURL as string).origin
      if (!own && protocol !== 'data:' && protocol !== 'blob:') complaints.push(`asks elsewhere: ${request.url()}`)
    })
    await page.addInitScript(() => {
      addEventListener('securitypolicyviolation', event => {
        console.error(`policy: ${event.violatedDirective} forbids ${event.blockedURI}`)
      })
    })
    await use(new Lens(page))
    expect(complaints).toEqual([])
  },
})

export { expect }

/** Each scheme and each width once: contrast is the schemes', room the widths'. */
export const SCHEMES_AND_WIDTHS = [
  ['light', 1280, 800],
  ['dark', 360, 740],
] as const

/** The page cannot be scrolled sideways, as soon as its views have followed its width. */
export async function expectNoSidewaysOverflow(page: Page): Promise<void> {
  await expect
    .poll(() => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth))
    .toBe(0)
}

/** Looks at one open page in each scheme and width, where nothing may be wider than the page. */
export async function inSchemesAndWidths(lens: Lens, look: () => Promise<void>): Promise<void> {
  for (const [colorScheme, width, height] of SCHEMES_AND_WIDTHS)
    await test.step(`in the ${colorScheme} scheme at ${width} pixels`, async () => {
      await lens.page.emulateMedia({ colorScheme })
      await lens.page.setViewportSize({ width, height })
      await lens.nextFrame()
      await expectNoSidewaysOverflow(lens.page)
      await look()
      await expectNoSidewaysOverflow(lens.page)
    })
}

/**
 * Every visible one of the targets, and there is one, is at least 24 pixels each way. Numbers to copy stand in lines of text, which WCAG
 * exempts; that they have room around them is axe's to see.
 */
export async function expectLargeTargets(targets: Locator): Promise<void> {
  const small = () =>
    targets.evaluateAll(elements => {
      const sizes = elements
        .filter(element => element.checkVisibility() && !element.matches('data'))
        .map(element => {
          const { width, height } = element.getBoundingClientRect()
          return { element: element.outerHTML.slice(0, 200), size: Math.min(width, height) }
        })
      return sizes.length === 0 ? 'None is visible.' : sizes.filter(({ size }) => size < 24)
    })
  await expect.poll(small).toEqual([])
}

/** No violation of WCAG 2.2 AA on the page, or in a part of the element. */
export async function expectAxeFindsNothing(page: Page, part?: string): Promise<void> {
  // One frame is enough: the mode for many opens a page for each run. Rules of WCAG 2.2 alone have
  // to be asked for.
  // Only violations are described: the rest would take a quarter of the time.
  const isThere = await page.evaluate(() => 'axe' in globalThis)
  const builder = new AxeBuilder(isThere ? { page, axeSource: 'void 0' } : { page })
    .setLegacyMode()
    .options({ rules: { 'target-size': { enabled: true } }, resultTypes: ['violations'] })
  if (part !== undefined) builder.include({ fromShadowDom: ['hex-lens', part] })
  const { violations } = await builder.analyze()
  expect(
    violations.map(({ id, nodes }) => `${id}: ${nodes.map(node => `${node.html} ${node.failureSummary}`).join('; ')}`),
  ).toEqual([])
}
