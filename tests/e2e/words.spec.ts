/** Every word of the element is in the list, and the language is that of the page. */
import type { Locator, Page } from '@playwright/test'
import { formatNames } from '../../web/mesh/format-names'
import { german } from '../../web/words/de'
import { chinese } from '../../web/words/zh'
import { expect, test } from './lens'

type Element = HTMLElementTagNameMap['hex-lens']

/** Names, and what stands for itself in every language. */
const NAMES =
  /\b(Hexlens|jacdet|min|max|[a-cstx-zABCDJLMPRX-Z]|px|4ac|2a|tau|xi|eta|zeta|Roots\+B|Cubit|Verdict|Zhang|iframe|Sphinx|MyST in Sphinx|MkDocs|Quarto|Jupyter|BibTeX|Python|(?:[-\w]+)\.(?:png|pvtu)|points in text|camera|theme|vertices|round|pink|auto, light, dark|many|[A-Z-]{2,}|Gmsh|Roots)\b|\de[-+]?\d/g

/** A language in which every letter of a sentence is a dot, but those of its holes; so a letter on the page is untranslated. */
async function speakPseudo(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const dots = (sentence: string) => sentence.replace(/\{\w+\}|\p{L}/gu, part => (part.length > 1 ? part : '·'))
    const pseudo = new Proxy({}, { get: (_, sentence) => dots(String(sentence)) })
    Object.assign(globalThis, { hexlensWords: { tlh: pseudo } })
  })
}

/** Texts, names and tooltips in the element that have letters, but those marked as English, code, and the panel that only pages of Hexlens have. */
function lettersIn(lens: Locator): Promise<string[]> {
  return lens.evaluate(element => {
    const found = new Set<string>()
    const walk = (node: Node) => {
      if (node instanceof globalThis.Element) {
        if (node.matches('code, pre, math, style, hex-lens, [lang=en], [part~=nearest]')) return
        for (const name of ['aria-label', 'aria-valuetext', 'aria-description', 'title', 'placeholder', 'alt'])
          if (node.hasAttribute(name)) found.add(node.getAttribute(name) as string)
        if (node instanceof HTMLInputElement && node.type === 'text') found.add('')
      }
      if (node instanceof Text) found.add((node.textContent ?? '').trim().replace(/\s+/g, ' '))
      for (const child of node.childNodes) walk(child)
    }
    walk((element.shadowRoot as ShadowRoot).querySelector('.lens') as Node)
    return [...found]
  })
}

test('every word goes through the list: none is left where a language has dots for letters', async ({ lens, page }) => {
  test.setTimeout(600_000)
  await speakPseudo(page)
  await page.setViewportSize({ width: 1440, height: 900 })
  await lens.open()
  await page.evaluate(() => {
    document.documentElement.lang = 'tlh'
    const lens = document.querySelector('hex-lens') as Element
    lens.views = 'all'
  })
  const inside = page.locator('hex-lens').first()
  const texts = new Set<string>()
  const look = async () => {
    await expect.poll(() => inside.evaluate(element => (element as Element).complete)).toBe(true)
    for (const text of await lettersIn(inside)) texts.add(text)
  }
  const press = (selector: string) =>
    inside.evaluate((element, selector) => {
      for (const button of (element.shadowRoot as ShadowRoot).querySelectorAll<HTMLElement>(selector)) button.click()
    }, selector)
  await look()
  // Everything that opens: panels, the proof, lists of what is looked at, the reference cube, help, turning.
  await press('[aria-expanded=false]:not(.reading *)')
  await press('summary')
  await press('.scene-controls [aria-pressed=false]')
  await look()
  await press(
    '.copied, .take-away button, .embed .snippet button, .certificate .actions button, .toolbar .actions button',
  )
  await look()
  // Of each kind one: invalid on edges, valid, lower inside, zero, inverted, mended by another order, coincident.
  const presets = ['looks-fine', 'cube', 'non-strict', 'touching', 'inverted', 'wrong-order', 'wedge']
  for (const preset of presets) {
    await inside.evaluate((element, preset) => {
      ;(element as Element).preset = preset
    }, preset)
    await look()
    // Steps of the algorithm, probes, and the node orders of this element.
    for (let step = 0; step < 2; step++) {
      await press('.algorithm li:nth-child(7n) button, .node-order [aria-expanded=false]')
      await inside.evaluate(element => {
        const scene = (element.shadowRoot as ShadowRoot).querySelector('.scene-stage') as HTMLElement
        for (const key of ['p', 'c'])
          scene.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, composed: true }))
      })
      await look()
    }
    if (preset === 'looks-fine')
      for (let i = 0; i < 9; i++) {
        await inside.evaluate((element, i) => {
          const root = element.shadowRoot as ShadowRoot
          const choice = root.querySelector('.embed select') as HTMLSelectElement
          choice.selectedIndex = i % choice.options.length
          choice.dispatchEvent(new Event('change'))
          const faces = root.querySelectorAll<HTMLElement>('.face-map')
          faces[i % faces.length]?.click()
          for (const select of root.querySelectorAll<HTMLSelectElement>('.algorithm select')) {
            select.selectedIndex = i % 2
            select.dispatchEvent(new Event('change'))
          }
        }, i)
        await look()
      }
  }
  // What is refused, and what is read.
  await inside.evaluate(element => {
    const lens = element as Element
    lens.setAttribute('vertices', '1 2 3')
    lens.setAttribute('camera', 'round')
    lens.setAttribute('theme', 'pink')
    const field = (lens.shadowRoot as ShadowRoot).querySelector('.vertices input') as HTMLInputElement
    field.value = 'many'
    field.dispatchEvent(new Event('input', { bubbles: true }))
    lens.offer('0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1', true)
  })
  await expect(page.locator('hex-lens .reading .status')).toBeVisible()
  await look()
  await page.evaluate(() => {
    const root = (document.querySelector('hex-lens') as Element).shadowRoot as ShadowRoot
    root.querySelector('.scene')?.dispatchEvent(new PointerEvent('pointerdown', { pointerType: 'touch', pointerId: 9 }))
  })
  await look()
  const left = [...texts].filter(text =>
    /\p{Script=Latin}/u.test(text.replace(formatNames.join(', '), '').replace(NAMES, '')),
  )
  expect(left).toEqual([])
})

type Words = Readonly<Record<string, string>>

/** Elements on an empty page, in German, in the language around, in English, and in a shadow root. */
async function visit(page: Page): Promise<void> {
  await page.goto('./')
  await page.evaluate(() => {
    for (const link of document.querySelectorAll('link[rel=stylesheet]')) link.remove()
    document.documentElement.lang = 'de-AT'
    const lens = (lang?: string) => {
      const element = document.createElement('hex-lens')
      element.style.cssText = 'width: 280px; height: 260px'
      if (lang) element.lang = lang
      return element
    }
    const host = document.createElement('div')
    host.lang = 'zh-Hant-TW'
    host.attachShadow({ mode: 'open' }).append(lens())
    document.body.replaceChildren(lens(), lens('en'), host, lens('fr'))
  })
}

test('an element speaks the language around it, as soon as that is there or another', async ({ lens: _, page }) => {
  await page.setViewportSize({ width: 320, height: 1200 })
  await visit(page)
  const said = () =>
    page.evaluate(() => {
      const [first, english, french] = document.querySelectorAll('hex-lens')
      const inShadow = document.querySelector('div')?.shadowRoot?.querySelector('hex-lens')
      return [first, english, inShadow, french].map(lens => {
        const root = lens?.shadowRoot
        const parts = [root?.querySelector<HTMLElement>('.lens')?.lang, root?.querySelector('.word')?.textContent]
        return [...parts, root?.querySelector('.problems span')?.textContent ?? ''].join(' ').trim()
      })
    })
  await expect.poll(said).toEqual(['en INVALID', 'en INVALID', 'en INVALID', 'en INVALID'])
  await page.evaluate(() => document.querySelector('hex-lens')?.setAttribute('camera', 'round'))
  const refusal = 'The attribute camera is not understood'
  await expect.poll(said).toEqual([expect.stringContaining(refusal), 'en INVALID', 'en INVALID', 'en INVALID'])
  // Languages arrive.
  await page.evaluate(
    words => {
      Object.assign(globalThis, { hexlensWords: words })
      dispatchEvent(new Event('hexlens-words'))
    },
    { de: german as Words, zh: chinese as Words },
  )
  const german1 = expect.stringContaining('de UNGÜLTIG Das Attribut camera wird nicht verstanden: „round“')
  await expect.poll(said).toEqual([german1, 'en INVALID', 'zh 无效', 'en INVALID'])
  // The page changes its language, and an element its own.
  await page.evaluate(() => {
    document.querySelector('hex-lens')?.removeAttribute('camera')
    document.documentElement.lang = 'en'
    for (const lens of document.querySelectorAll<HTMLElement>('hex-lens[lang]')) lens.lang = 'zh'
    ;(document.querySelector('div') as HTMLElement).lang = 'de'
  })
  await expect.poll(said).toEqual(['en INVALID', 'zh 无效', 'de UNGÜLTIG', 'zh 无效'])
})

test('German fits into a phone', async ({ lens, page }) => {
  test.setTimeout(600_000)
  await page.addInitScript(de => {
    Object.assign(globalThis, { hexlensWords: { de } })
    addEventListener('DOMContentLoaded', () => {
      document.documentElement.lang = 'de'
    })
  }, german as Words)
  await page.setViewportSize({ width: 390, height: 844 })
  await page.goto('./')
  const inside = page.locator('hex-lens').first()
  await expect(lens.element.locator('.word')).toHaveText('UNGÜLTIG')
  await inside.evaluate(element => {
    const root = element.shadowRoot as ShadowRoot
    for (const button of root.querySelectorAll<HTMLElement>('[aria-expanded=false], summary')) button.click()
  })
  for (const width of [390, 320]) {
    await page.setViewportSize({ width, height: 844 })
    await expect.poll(() => inside.evaluate(element => (element as Element).complete)).toBe(true)
    // The views follow the box one frame after it has changed.
    const over = () =>
      inside.evaluate(element => {
        const root = element.shadowRoot as ShadowRoot
        const { right } = (root.querySelector('.lens') as HTMLElement).getBoundingClientRect()
        return [...root.querySelectorAll<HTMLElement>('.lens :not(svg *)')]
          .filter(each => !each.closest('.said, pre, math, .rows, hex-lens'))
          .filter(each => each.getBoundingClientRect().width > 1 && each.getBoundingClientRect().right > right + 1)
          .map(each => `${each.localName}.${each.className} ${each.textContent?.trim().slice(0, 40)}`)
      })
    await expect.poll(over, `at ${width} CSS pixels`).toEqual([])
    await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
  }
})
