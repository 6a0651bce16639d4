/** The host's colours, read from the custom properties that style it, and news of when they may have changed. */
import type { Rgb, Theme } from './colour-map'

const PROPERTIES: Readonly<Record<keyof Theme, { readonly name: string; readonly fallback: Rgb }>> = {
  paper: { name: '--hl-paper', fallback: [0.988, 0.988, 0.984] },
  ink: { name: '--hl-ink', fallback: [0.11, 0.118, 0.129] },
  negative: { name: '--hl-negative', fallback: [0.698, 0.094, 0.169] },
  positive: { name: '--hl-positive', fallback: [0.129, 0.4, 0.675] },
  neutral: { name: '--hl-neutral', fallback: [0.933, 0.933, 0.922] },
}

/**
 * Holds the theme of an element in a shadow root. Reading styles makes the browser settle them, too dear for every frame of
 * a drag, so it happens after a change of colour scheme, or of an attribute of the host or the document's root.
 */
export class ThemeReader {
  readonly #element: HTMLElement
  readonly #onChange: () => void
  readonly #darkness = matchMedia('(prefers-color-scheme: dark)')
  readonly #attributes = new MutationObserver(() => this.#expire())
  #theme: Theme | null = null
  #isExpired = true

  constructor(element: HTMLElement, onChange: () => void) {
    this.#element = element
    this.#onChange = onChange
    this.#darkness.addEventListener('change', this.#expire)
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
    this.#darkness.removeEventListener('change', this.#expire)
    this.#attributes.disconnect()
  }

  readonly #expire = (): void => {
    this.#isExpired = true
    this.#onChange()
  }

  #compute(): Theme {
    const root = this.#element.getRootNode()
    this.#attributes.observe(document.documentElement, { attributes: true })
    if (root instanceof ShadowRoot) this.#attributes.observe(root.host, { attributes: true })
    const style = getComputedStyle(this.#element)
    const entries = Object.entries(PROPERTIES).map(([property, { name, fallback }]) => [
      property,
      parseColour(style.getPropertyValue(name)) ?? fallback,
    ])
    return Object.fromEntries(entries) as unknown as Theme
  }
}

function sameTheme(a: Theme, b: Theme | null): boolean {
  const colours = Object.keys(a) as (keyof Theme)[]
  return b !== null && colours.every(colour => a[colour].every((value, i) => value === b[colour][i]))
}

let pixel: CanvasRenderingContext2D | null | undefined

/** Any CSS colour as a browser understands it; null if it is none. */
function parseColour(text: string): Rgb | null {
  const hex = /^\s*#([\da-f]{2})([\da-f]{2})([\da-f]{2})\s*$/i.exec(text)
  if (hex) return hex.slice(1, 4).map(pair => Number.parseInt(pair, 16) / 255) as unknown as Rgb
  if (!CSS.supports('color', text.trim())) return null
  pixel ??= Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d', {
    willReadFrequently: true,
  })
  if (!pixel) return null
  pixel.fillStyle = text.trim()
  pixel.fillRect(0, 0, 1, 1)
  const [r, g, b] = pixel.getImageData(0, 0, 1, 1).data
  return [(r as number) / 255, (g as number) / 255, (b as number) / 255]
}
