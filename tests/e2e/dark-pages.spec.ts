/** The element goes by the colour scheme of the page where it stands, unless it has a theme of its own. */
import { expect, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

const DARK = 'rgb(23, 24, 26)'
const LIGHT = 'rgb(252, 252, 251)'

test('a dark page has dark elements whatever the system prefers, at once, and nested the nearest counts', async ({
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'light' })
  await page.setViewportSize({ width: 500, height: 900 })
  await page.goto('./')
  await page.evaluate(() => {
    for (const link of document.querySelectorAll('link[rel=stylesheet]')) link.remove()
    const box = (id: string, scheme: string, ...inside: Node[]) => {
      const div = Object.assign(document.createElement('div'), { id })
      div.style.colorScheme = scheme
      div.append(...inside)
      return div
    }
    const lens = (id: string, theme?: string) => {
      const element = Object.assign(document.createElement('hex-lens'), { id })
      element.style.cssText = 'width: 200px; height: 120px'
      if (theme) element.setAttribute('theme', theme)
      return element
    }
    document.body.replaceChildren(
      lens('own-dark', 'dark'),
      box('outer', 'dark', lens('inherits'), box('inner', 'light', lens('nested'), lens('own-dark-in-light', 'dark'))),
      lens('says-nothing'),
      lens('own-light', 'light'),
    )
  })
  const looks = () =>
    page.locator('hex-lens').evaluateAll(elements =>
      elements.map(element => {
        const root = element.shadowRoot as ShadowRoot
        const paper = getComputedStyle(root.querySelector('.lens') as HTMLElement)
        const canvas = root.querySelector<HTMLCanvasElement>('canvas')
        const isComplete = (element as Element).complete
        return [element.id, { paper: paper.backgroundColor, isComplete, picture: canvas?.toDataURL() }] as const
      }),
    )
  const expectLooks = (dark: readonly string[], light: readonly string[]) =>
    expect(async () => {
      const all = Object.fromEntries(await looks())
      expect(Object.values(all).every(({ isComplete }) => isComplete)).toBe(true)
      for (const id of dark) expect([id, all[id]?.paper]).toEqual([id, DARK])
      for (const id of light) expect([id, all[id]?.paper]).toEqual([id, LIGHT])
      expect(new Set(dark.map(id => all[id]?.picture)).size).toBe(1)
      expect(new Set(light.map(id => all[id]?.picture)).size).toBe(1)
      expect(all[dark[0] as string]?.picture).not.toBe(all[light[0] as string]?.picture)
    }).toPass({ timeout: 60_000 })
  await expectLooks(['own-dark', 'inherits', 'own-dark-in-light'], ['own-light', 'nested', 'says-nothing'])

  await page.evaluate(() => {
    document.documentElement.style.colorScheme = 'dark'
    ;(document.getElementById('outer') as HTMLElement).style.colorScheme = 'light'
    ;(document.getElementById('inner') as HTMLElement).style.colorScheme = 'dark'
  })
  await expectLooks(['own-dark', 'says-nothing', 'nested', 'own-dark-in-light'], ['own-light', 'inherits'])

  // What happens while it is not displayed shows when it is again, and then nothing moves any more.
  await page.evaluate(() => {
    document.body.style.display = 'none'
    document.documentElement.style.colorScheme = 'light'
  })
  await page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))))
  await page.evaluate(() => document.body.style.removeProperty('display'))
  await expectLooks(['own-dark', 'nested', 'own-dark-in-light'], ['own-light', 'inherits', 'says-nothing'])
  const frames = await page.evaluate(async () => {
    const request = window.requestAnimationFrame
    let asked = 0
    window.requestAnimationFrame = callback => {
      asked++
      return request(callback)
    }
    for (let i = 0; i < 10; i++) await new Promise(resolve => request(resolve))
    return asked
  })
  expect(frames).toBe(0)

  await page.emulateMedia({ colorScheme: 'dark' })
  await expectLooks(['own-dark', 'nested', 'own-dark-in-light'], ['own-light', 'inherits', 'says-nothing'])
  await page.evaluate(() => {
    document.documentElement.style.colorScheme = 'light dark'
  })
  await expectLooks(['own-dark', 'nested', 'own-dark-in-light', 'says-nothing'], ['own-light', 'inherits'])
})
