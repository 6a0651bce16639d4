/** The host's colours, as the custom properties that style it come out in its colour scheme, and news of their changes. */
import type { Rgb, Theme } from './colour-map'

const PROPERTIES: Readonly<Record<keyof Theme, { readonly style: keyof CSSStyleDeclaration; readonly fallback: Rgb }>> =
  {
    paper: { style: 'backgroundColor', fallback: [0.988, 0.988, 0.984] },
    ink: { style: 'color', fallback: [0.11, 0.118, 0.129] },
    negative: { style: 'borderTopColor', fallback: [0.698, 0.094, 0.169] },
    positive: { style: 'borderLeftColor', fallback: [0.129, 0.4, 0.675] },
    neutral: { style: 'outlineColor', fallback: [0.933, 0.933, 0.922] },
  }

/** A swatch wears every colour where nobody sees it. */
const SWATCH =
  'position:absolute;visibility:hidden;width:1px;height:1px;background:var(--hl-paper);color:var(--hl-ink);border-top-color:var(--hl-negative);border-left-color:var(--hl-positive);outline-color:var(--hl-neutral)'

/**
 * Holds the theme of an element. Reading styles makes the browser settle them, too dear for every frame of a drag, so it
 * happens after a change. Of that the swatch tells: its colours change by a transition, whatever the cause, and one that
 * happens while it is not displayed shows by its size when it is again. For paper the host's attributes tell, at once.
 */
export class ThemeReader {
  readonly #element: HTMLElement
  readonly #swatch = document.createElement('i')
  readonly #onChange: () => void
  readonly #sizes = new ResizeObserver(() => this.#expire())
  readonly #attributes = new MutationObserver(() => this.#expire())
  #theme: Theme | null = null
  #isExpired = true

  constructor(element: HTMLElement, onChange: () => void) {
    this.#element = element
    this.#onChange = onChange
    this.#swatch.style.cssText = SWATCH
    this.#swatch.addEventListener('transitionend', this.#expire)
    this.#sizes.observe(this.#swatch)
  }

  /** The same object as before while no colour has changed. */
  read(): Theme {
    if (this.#isExpired || this.#attributes.takeRecords().length > 0) {
      this.#isExpired = false
      const theme = this.#compute()
      if (!sameTheme(theme, this.#theme)) this.#theme = theme
    }
    return this.#theme as Theme
  }

  dispose(): void {
    this.#sizes.disconnect()
    this.#attributes.disconnect()
    this.#swatch.remove()
  }

  readonly #expire = (): void => {
    this.#isExpired = true
    this.#onChange()
  }

  #compute(): Theme {
    const root = this.#element.getRootNode()
    if (root instanceof ShadowRoot) this.#attributes.observe(root.host, { attributes: true })
    if (!this.#swatch.isConnected) this.#element.append(this.#swatch)
    const style = getComputedStyle(this.#swatch)
    this.#swatch.style.transition = 'none' // or the colours from before a change would still be read
    const entries = Object.entries(PROPERTIES).map(([property, { style: name, fallback }]) => [
      property,
      parseColour(String(style[name])) ?? fallback,
    ])
    this.#swatch.style.transition = '1ms'
    return Object.fromEntries(entries) as unknown as Theme
  }
}

function sameTheme(a: Theme, b: Theme | null): boolean {
  const colours = Object.keys(a) as (keyof Theme)[]
  return b !== null && colours.every(colour => a[colour].every((value, i) => value === b[colour][i]))
}

let pixel: CanvasRenderingContext2D | null | undefined

/** A computed colour; null if it is that of no background at all. */
function parseColour(text: string): Rgb | null {
  const rgb = /^rgb\((\d+), (\d+), (\d+)\)$/.exec(text)
  if (rgb) return rgb.slice(1).map(value => Number(value) / 255) as unknown as Rgb
  pixel ??= Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d', {
    willReadFrequently: true,
  })
  if (!pixel || text === 'rgba(0, 0, 0, 0)') return null
  pixel.fillStyle = text
  pixel.fillRect(0, 0, 1, 1)
  const [r, g, b] = pixel.getImageData(0, 0, 1, 1).data
  return [(r as number) / 255, (g as number) / 255, (b as number) / 255]
}
