/** The host's colours, read from the custom properties that style it. */
import type { Rgb, Theme } from './colour-map'

const PROPERTIES: Readonly<Record<keyof Theme, { readonly name: string; readonly fallback: Rgb }>> = {
  paper: { name: '--hl-paper', fallback: [0.988, 0.988, 0.984] },
  ink: { name: '--hl-ink', fallback: [0.11, 0.118, 0.129] },
  negative: { name: '--hl-negative', fallback: [0.698, 0.094, 0.169] },
  positive: { name: '--hl-positive', fallback: [0.129, 0.4, 0.675] },
  neutral: { name: '--hl-neutral', fallback: [0.965, 0.965, 0.957] },
}

/** Reads the theme and, through `key`, tells cheaply whether it is another one than before. */
export class ThemeReader {
  readonly #element: HTMLElement
  #key = ''
  #theme: Theme | null = null

  constructor(element: HTMLElement) {
    this.#element = element
  }

  /** The same object as before while no colour has changed. */
  read(): Theme {
    const style = getComputedStyle(this.#element)
    const texts = Object.values(PROPERTIES).map(({ name }) => style.getPropertyValue(name))
    const key = texts.join()
    if (this.#theme !== null && key === this.#key) return this.#theme
    this.#key = key
    const entries = Object.entries(PROPERTIES).map(([property, { fallback }], i) => [
      property,
      parseColour(texts[i] as string) ?? fallback,
    ])
    this.#theme = Object.fromEntries(entries) as unknown as Theme
    return this.#theme
  }
}

let pixel: CanvasRenderingContext2D | null | undefined

/** Any CSS colour as a browser understands it; null for none. */
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
