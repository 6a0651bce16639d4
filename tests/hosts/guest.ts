/** What a good guest does, looked at in each host: a test for each fault that authors may meet. */
import { join } from 'node:path'
import AxeBuilder from '@axe-core/playwright'
import type { Locator, Page } from '@playwright/test'
import { handleOf, type Lens } from '../e2e/lens'
import { documented } from '../unit/embed-fixture'
import { expect, hosts, nameHost, onceInRun, test } from './host'

export interface Guest {
  readonly name: string
  readonly version: () => string
  /** Makes the site, once in a run. */
  readonly build: () => void | Promise<void>
  readonly address: string
  /** Uses the host's own switch between light and dark, if it has one; a switch that goes through several takes several calls. */
  readonly turn?: (page: Page, scheme: 'light' | 'dark') => Promise<void>
  /** What the host itself says in the console. */
  readonly says?: RegExp
}

/** Widths of columns, as sites have them on phones and on screens. */
const COLUMNS = [320, 480, 640, 760, 900]

/** Keys that the element uses; in one host or another each of them does something else. */
const KEYS = ['m', 'f', 's', 'p', '7', 'ArrowRight', 'ArrowLeft', 'ArrowUp', 'ArrowDown', 'PageDown', 'PageUp']

export function testGuest(guest: Guest): void {
  const { name, version, build, address, turn, says } = guest
  test.describe(name, () => {
    nameHost(name, version)
    test.use({ viewport: { width: 1280, height: 900 }, ...(says ? { expectedErrors: says } : {}) })

    test.beforeAll(async () => {
      test.setTimeout(900_000)
      await onceInRun(name, build)
    })

    const open = async (lens: Lens) => {
      await lens.open(address)
      await lens.scene.evaluate(scene => scene.scrollIntoView({ block: 'center' }))
      await lens.nextFrame()
    }

    test('starts, is right, and axe finds nothing in it', async ({ lens, page }) => {
      await open(lens)
      await expectDocumented(lens)
      await expectComplete(lens)
      await page.screenshot({ path: join(hosts, 'pictures', `${name}.png`) })
      await expectAxeFindsNothingInElement(page)
    })

    test('the picture has half of the box in columns of all widths', async ({ lens }) => {
      await open(lens)
      await expectRoom(lens)
    })

    test('a vertex is dragged', async ({ lens }) => {
      await open(lens)
      await expectDrag(lens)
    })

    test('keys that it uses are its own, and others are not', async ({ lens }) => {
      await open(lens)
      await expectKeysToStay(lens)
    })

    if (turn)
      test('its colours go with the switch of the host', async ({ lens, page }) => {
        for (const system of ['light', 'dark'] as const) {
          await page.emulateMedia({ colorScheme: system })
          await open(lens)
          for (const wanted of system === 'light' ? [true, false] : [false, true]) {
            await switchTo(page, turn, wanted)
            await expect.poll(() => isDark(lens.element.locator('.lens'))).toBe(wanted)
            if (wanted) await page.screenshot({ path: join(hosts, 'pictures', `${name}-dark.png`) })
          }
          await expectAxeFindsNothingInElement(page)
        }
      })
  })
}

export async function expectDocumented(lens: Lens): Promise<void> {
  await expect(lens.verdict).toHaveText(/^INVALID/)
  expect(await lens.vertices()).toEqual(documented.vertices)
  await expect(lens.page.getByRole('group', { name: documented.label })).toBeVisible()
}

/** Everything of it that is in sight is drawn. */
export async function expectComplete(lens: Lens): Promise<void> {
  await expect
    .poll(() => lens.element.evaluate(element => (element as HTMLElementTagNameMap['hex-lens']).complete))
    .toBe(true)
}

export async function expectAxeFindsNothingInElement(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page })
    .setLegacyMode()
    // The host's style sheets are not fetched a second time: not all of them may be.
    .options({ rules: { 'target-size': { enabled: true } }, resultTypes: ['violations'], preload: false })
    .include('hex-lens')
    .analyze()
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join('; ')}`)).toEqual([])
}

const ROOM = { picture: true, covered: 0, scrolls: 0 }

export async function expectRoom(lens: Lens): Promise<void> {
  for (const width of COLUMNS) expect(await roomIn(lens, width), `${width} pixels`).toMatchObject(ROOM)
}

/** The element's room in a column: its picture has half of its box, no handle is under a button, and nothing scrolls. */
async function roomIn(lens: Lens, width: number): Promise<typeof ROOM & { readonly share: number }> {
  await lens.element.evaluate((element, width) => {
    const column = element.parentElement as HTMLElement
    column.style.cssText = `box-sizing: content-box; width: ${width}px; min-width: 0; max-width: none; padding: 0`
  }, width)
  await lens.element.evaluate(element => element.scrollIntoView({ block: 'start' }))
  await lens.nextFrame()
  await expectComplete(lens)
  return await lens.element.evaluate(element => {
    const root = element.shadowRoot as ShadowRoot
    const part = (name: string) => root.querySelector(`[part~=${name}]`) as HTMLElement
    const handles = [...root.querySelectorAll('.scene-pane .handle circle')].map(circle =>
      circle.getBoundingClientRect(),
    )
    const covered = handles.filter(({ x, y, width, height }) =>
      root.elementFromPoint(x + width / 2, y + height / 2)?.closest('button, select'),
    )
    const boxes = [element, part('lens'), part('panels'), ...root.querySelectorAll('.panel')]
    const scrolls = boxes.filter(
      box => box.scrollHeight > box.clientHeight + 1 || box.scrollWidth > box.clientWidth + 1,
    )
    const area = (box: HTMLElement) => box.offsetWidth * box.offsetHeight
    const share = area(part('stage')) / area(element as HTMLElement)
    return { picture: share >= 0.5, covered: covered.length, scrolls: scrolls.length, share }
  })
}

/** Drags a vertex in steps. It alone moves, and its handle stays under the pointer. */
export async function expectDrag(lens: Lens, vertex = 6): Promise<void> {
  const { mouse } = lens.page
  const before = await lens.vertices()
  const from = await handleOf(lens, vertex)
  await mouse.move(from.x, from.y)
  await mouse.down()
  for (const [dx, dy] of [
    [8, -4],
    [16, -8],
    [24, -12],
  ] as const) {
    await mouse.move(from.x + dx, from.y + dy)
    await lens.nextFrame()
    const { x, y } = await handleOf(lens, vertex)
    // Half a pixel for each of two roundings, in a scene that may be shown at twice its size.
    expect(Math.abs(x - from.x - dx)).toBeLessThan(2)
    expect(Math.abs(y - from.y - dy)).toBeLessThan(2)
  }
  await mouse.up()
  await lens.nextFrame()
  const after = await lens.vertices()
  const moved = after.flatMap((value, i) => (Object.is(value, before[i]) ? [] : [Math.floor(i / 3)]))
  expect(new Set(moved)).toEqual(new Set([vertex]))
}

/** Escape first: it has nothing to take back, so the host has it. */
export async function expectKeysToStay(lens: Lens): Promise<void> {
  const { page } = lens
  await page.evaluate(() => {
    const heard: string[] = []
    Object.assign(globalThis, { heard })
    addEventListener('keydown', event => heard.push(`${event.key}${event.defaultPrevented ? ' prevented' : ''}`))
  })
  const address = page.url()
  await lens.scene.focus()
  for (const key of ['Escape', ...KEYS]) await page.keyboard.press(key)
  await expect(lens.scene).toBeFocused()
  expect(page.url()).toBe(address)
  const heard = await page.evaluate(() => (globalThis as unknown as { heard: string[] }).heard)
  expect(heard.filter(key => !/^Escape/.test(key))).toEqual([])
  expect(heard[0]?.split(' ')[0]).toBe('Escape')
}

async function switchTo(page: Page, turn: NonNullable<Guest['turn']>, dark: boolean): Promise<void> {
  await expect(async () => {
    if ((await isDark(page.locator('body'))) !== dark) await turn(page, dark ? 'dark' : 'light')
    await expect.poll(() => isDark(page.locator('body')), { timeout: 2_000 }).toBe(dark)
  }).toPass({ timeout: 60_000 })
}

/** A switch that is one button. */
export const click = (selector: string) => (page: Page) =>
  page.locator(selector).filter({ visible: true }).first().click()

/** By the first background, from there outwards, that is not see-through. */
export function isDark(place: Locator): Promise<boolean> {
  return place.first().evaluate(start => {
    const context = new OffscreenCanvas(1, 1).getContext('2d') as OffscreenCanvasRenderingContext2D
    for (let element: Element | null = start; element; element = element.parentElement) {
      context.clearRect(0, 0, 1, 1)
      context.fillStyle = getComputedStyle(element).backgroundColor
      context.fillRect(0, 0, 1, 1)
      const [red = 0, green = 0, blue = 0, alpha = 0] = context.getImageData(0, 0, 1, 1).data
      if (alpha > 127) return red + green + blue < 384
    }
    return false
  })
}
