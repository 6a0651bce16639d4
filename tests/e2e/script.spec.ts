/** The element as a page's script has it: highlights, hidden faces, cameras, morphs, and elements of one group. */
import AxeBuilder from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { snippetsOf } from '../package/documentation'
import { expect, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

/** Two elements side by side, alone on the page, and what they tell: whose, what, and in which frame. */
async function visit(page: Page, ...attributes: readonly Readonly<Record<string, string>>[]): Promise<void> {
  await page.goto('./')
  await expect(page.getByRole('status', { name: 'Verdict' })).toHaveText(/^(VALID|INVALID)/)
  await page.evaluate(attributes => {
    const told: unknown[] = []
    const lenses = attributes.map((each, i) => {
      const lens = document.createElement('hex-lens')
      for (const [name, text] of Object.entries({ id: 'ab'[i] ?? '', ...each })) lens.setAttribute(name, text)
      lens.style.cssText = 'display: inline-block; width: 420px; height: 330px'
      for (const name of ['hex-input', 'hex-change', 'hex-camera', 'hex-probe', 'hex-error'] as const)
        lens.addEventListener(name, ({ type, detail }) =>
          told.push({ id: lens.id, type, frame: document.timeline.currentTime, detail }),
        )
      return lens
    })
    const [main, heading] = [document.createElement('main'), document.createElement('h1')]
    heading.textContent = 'Elements'
    heading.style.cssText = 'margin: 0; font-size: 16px'
    main.append(heading, ...lenses)
    document.body.replaceChildren(main)
    document.body.style.cssText = 'margin: 0'
    const settled = async () => {
      do await new Promise(requestAnimationFrame)
      while (!lenses.every(lens => lens.complete || !lens.isConnected))
    }
    Object.assign(globalThis, { told, settled })
  }, attributes)
  await allSettled(page)
}

declare global {
  var told: { id: string; type: string; frame: number; detail: unknown }[]
  var settled: () => Promise<void>
}

const allSettled = (page: Page) => page.evaluate(() => globalThis.settled())
const allTold = (page: Page) => page.evaluate(() => globalThis.told.splice(0))

test('highlights, hidden faces, a camera that moves and a morph, and sentences for what is wrong', async ({ page }) => {
  await visit(page, { preset: 'cube' })
  const marked = await page.evaluate(async () => {
    const lens = document.querySelector('hex-lens') as Element
    const parts = () =>
      [...(lens.shadowRoot?.querySelectorAll<SVGElement>('.highlight:not([display])') ?? [])].map(
        ({ dataset }) => dataset.part,
      )
    const pixels = () => {
      const canvas = lens.shadowRoot?.querySelector('canvas') as HTMLCanvasElement
      const copy = Object.assign(document.createElement('canvas'), { width: 64, height: 48 })
      const context = copy.getContext('2d') as CanvasRenderingContext2D
      context.drawImage(canvas, 0, 0, 64, 48)
      return context.getImageData(0, 0, 64, 48).data.join()
    }
    const history = lens.history
    lens.highlight({ vertices: [6], edges: 0, faces: [5], point: [0.5, 0, 0.5] })
    await settled()
    const shown = parts()
    lens.highlight({ faces: 6 })
    ;(lens as { hiddenFaces: unknown }).hiddenFaces = [9]
    ;(lens as { camera: unknown }).camera = { zoom: 2 }
    await settled()
    const kept = [parts().length, lens.hiddenFaces.length]
    const codes = told.splice(0).map(({ detail }) => (detail as { code: string }).code)
    const refused = await Promise.all(
      [lens.moveCamera({} as never), lens.playMorph([1]), lens.playMorph(lens.vertices, Number.NaN)].map(promise =>
        promise.catch(({ code }) => code),
      ),
    )
    const before = pixels()
    lens.hiddenFaces = [1, 2, 5]
    await settled()
    const some = pixels()
    lens.hiddenFaces = [0, 1, 2, 3, 4, 5]
    await settled()
    const none = pixels()
    lens.setAttribute('hidden-faces', '2 5')
    return {
      shown,
      kept,
      codes,
      refused,
      hides: some !== before && some !== none && /^[0,]*$/.test(none),
      isHistorySame: JSON.stringify(history) === JSON.stringify(lens.history),
    }
  })
  expect(marked).toEqual({
    shown: ['face-5', 'edge-0', 'vertex-6', 'point'],
    kept: [4, 0],
    codes: ['bad-highlight', 'bad-hidden-faces', 'bad-camera'],
    refused: ['bad-argument', 'wrong-count', 'bad-argument'],
    hides: true,
    isHistorySame: true,
  })
  await allSettled(page)
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([])

  const moved = await page.evaluate(async () => {
    const lens = document.querySelector('hex-lens') as Element
    lens.highlight()
    lens.camera = { direction: [0, -1, 0], zoom: 2 }
    await settled()
    const given = lens.camera
    lens.camera = given
    await settled()
    const once = told.splice(0).map(({ type, detail }) => [type, JSON.stringify(detail) === JSON.stringify(given)])
    const arrived = await lens.moveCamera({ direction: [1, 0, 0] }, 0.2)
    await settled()
    const frames = told.splice(0).map(({ frame }) => frame)
    const stop = new AbortController()
    const stopped = lens.moveCamera({ direction: [0, 1, 0] }, 3000, { signal: stop.signal })
    requestAnimationFrame(() => requestAnimationFrame(() => stop.abort()))
    const isThere = await stopped
    lens.camera = { direction: [1, 1, 0], zoom: 3 }
    await settled()
    lens.fit()
    await settled()
    const { zoom } = lens.camera
    const to = lens.vertices.with(20, 2)
    told.length = 0
    const played = await lens.playMorph(to, 0.2)
    await settled()
    const steps = lens.history.elements.length
    const hasEnded = lens.vertices.join() === to.join() && told.every(({ type }) => type === 'hex-input')
    lens.reset()
    await settled()
    return {
      once,
      arrived,
      isOncePerFrame: frames.length > 1 && new Set(frames).size === frames.length,
      isThere,
      zoom,
      played,
      steps,
      hasEnded,
      isBack: lens.vertices[20] === 1,
    }
  })
  expect(moved).toEqual({
    once: [['hex-camera', true]],
    arrived: true,
    isOncePerFrame: true,
    isThere: false,
    zoom: 1,
    played: true,
    steps: 2,
    hasEnded: true,
    isBack: true,
  })

  // The reader's hand ends a motion; who wants no motion sees its end at once.
  const held = page.evaluate(() => (document.querySelector('hex-lens') as Element).playMorph('0 '.repeat(24), 3000))
  await page.locator('hex-lens .scene-stage').press('Shift')
  expect(await held).toBe(false)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.evaluate(async () => {
    const lens = document.querySelector('hex-lens') as Element
    await lens.moveCamera({ direction: [0, 0, 1], zoom: 2 }, 3000)
    await lens.playMorph(lens.vertices.with(0, -1), 3000)
  })
  await allSettled(page)
  await allTold(page)
  const [html = '', script = ''] = snippetsOf('From script')
  await page.evaluate(html => {
    document.body.innerHTML = html
    for (const lens of document.querySelectorAll('hex-lens'))
      lens.style.cssText = 'display: inline-block; width: 420px; height: 330px'
    document.addEventListener('hex-error', event => told.push((event as CustomEvent).detail))
  }, html)
  await page.evaluate(script => Object.getPrototypeOf(async () => {}).constructor(script)(), script)
  expect(await page.evaluate(() => [document.querySelectorAll('hex-lens').length, told])).toEqual([2, []])
})

test('two of a group: a drag, a turn and a point in one are seen in the other in the same frame', async ({ page }) => {
  await visit(page, { preset: 'looks-fine', group: 'pair' }, { preset: 'cube', group: 'pair' })
  const both = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('hex-lens')].map(({ vertices, camera, history }) =>
        JSON.stringify([vertices, camera, history]),
      ),
    )
  const expectSame = async () => {
    await allSettled(page)
    const [a, b] = await both()
    expect(a).toBe(b)
  }
  /** Each told as often as the other, once a frame, in the same frames. */
  const expectTogether = async (type: string, least: number) => {
    const all = (await allTold(page)).filter(each => each.type === type)
    const framesOf = (id: string) => all.filter(each => each.id === id).map(({ frame }) => frame)
    expect(framesOf('a').length).toBeGreaterThanOrEqual(least)
    expect(new Set(framesOf('a')).size).toBe(framesOf('a').length)
    expect(framesOf('a')).toEqual(framesOf('b'))
  }
  await expectSame()
  expect(await allTold(page)).toEqual([])

  const { mouse } = page
  const box = await page.locator('#a .handle .dot').nth(6).boundingBox()
  const [x, y] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2]
  await mouse.move(x, y)
  await mouse.down()
  for (const step of [10, 20, 30]) {
    await mouse.move(x - step, y - step)
    await allSettled(page)
  }
  const [a, b] = (await both()).map(text => JSON.parse(text)[0])
  expect(a).toEqual(b)
  await mouse.up()
  await expectSame()
  await expectTogether('hex-input', 3)
  await page.evaluate(() => (document.querySelector('#b') as Element).undo())
  await expectSame()
  await allTold(page)

  await mouse.move(30, 170)
  await mouse.down()
  for (const step of [10, 20]) {
    await mouse.move(30 + step, 170)
    await allSettled(page)
  }
  await mouse.up()
  await expectSame()
  await expectTogether('hex-camera', 2)
  await mouse.move(210, 180)
  await allSettled(page)
  await expectTogether('hex-probe', 1)
  await expect(page.locator('#b .scene-stage .probe').first()).toBeVisible()

  // One that goes in its own drag leaves the other as it was before, with nothing pointed at.
  const handle = await page.locator('#a .handle .dot').nth(6).boundingBox()
  await mouse.move((handle?.x ?? 0) + 3, (handle?.y ?? 0) + 3)
  await mouse.down()
  await mouse.move((handle?.x ?? 0) - 20, (handle?.y ?? 0) - 20)
  await allSettled(page)
  const left = await page.evaluate(async () => {
    const [a, b] = [...document.querySelectorAll('hex-lens')] as [Element, Element]
    const isFollowing =
      b.vertices.join() !== JSON.parse(JSON.stringify(b.history.elements[b.history.present])).vertices.join()
    a.remove()
    await settled()
    a.vertices = a.vertices.with(0, 9)
    await settled()
    const { elements, present } = b.history
    return [isFollowing, b.vertices.join() === elements[present]?.vertices.join(), b.vertices[0] === 9]
  })
  expect(left).toEqual([true, true, false])
  expect((await allTold(page)).at(-1)).toMatchObject({ id: 'b' })
})
