/** Small still pictures of elements on a page, in the colours of its scheme: each analysed once, drawn when it is first shown. */
import type { Report } from '../core/report'
import type { Vertices } from '../model/hexahedron'
import { rampOf } from '../scene/paint/colour-map'
import { paletteOf } from '../scene/paint/face-raster'
import { ThemeReader } from '../scene/paint/theme'
import { type Colours, THUMBNAIL_SIDE, thumbnailPixels, thumbnailText } from '../scene/paint/thumbnail'

type Lens = HTMLElementTagNameMap['hex-lens']

export interface Picture {
  /** For the `src` of an image. */
  readonly address: string
  /** The picture in words. */
  readonly text: string
}

/** The image until there is a picture. */
export const BLANK = `data:image/svg+xml,${encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg"/>')}`

/** A picture takes some tens of milliseconds to draw: the frames between them belong to the reader. */
const AT_ONCE = 1

export class Pictures {
  readonly #lens: Lens
  readonly #onChange: () => void
  readonly #theme: ThemeReader
  readonly #reports = new Map<string, Report>()
  readonly #pictures = new Map<string, Picture>()
  readonly #awaited = new Set<string>()
  readonly #canvas = document.createElement('canvas')
  #colours: Colours | null = null
  /** Pictures that may still be drawn before the page has to be drawn again. */
  #left = AT_ONCE

  /** `onChange` is called when there are more, or others; `root` has the colours. */
  constructor(lens: Lens, root: HTMLElement, onChange: () => void) {
    this.#lens = lens
    this.#onChange = onChange
    this.#theme = new ThemeReader(root, onChange)
  }

  /** Null until there is one: `onChange` says when. */
  of(vertices: Vertices): Picture | null {
    const colours = this.#current()
    const key = vertices.join()
    const known = this.#pictures.get(key)
    if (known) return known
    const report = this.#reports.get(key)
    if (!report) {
      void this.#analyze(key, vertices)
      return null
    }
    if (this.#left === 0) return null
    this.#left -= 1
    const picture = { address: this.#address(thumbnailPixels(report, colours)), text: thumbnailText(report) }
    this.#pictures.set(key, picture)
    return picture
  }

  /** Forgets all others than these, and may draw some more. */
  begin(shown: readonly Vertices[]): void {
    this.#left = AT_ONCE
    const keys = new Set(shown.map(vertices => vertices.join()))
    for (const known of [this.#reports, this.#pictures])
      for (const key of known.keys()) if (!keys.has(key)) known.delete(key)
  }

  #address(pixels: Uint8ClampedArray<ArrayBuffer>): string {
    this.#canvas.width = THUMBNAIL_SIDE
    this.#canvas.height = THUMBNAIL_SIDE
    this.#canvas.getContext('2d')?.putImageData(new ImageData(pixels, THUMBNAIL_SIDE), 0, 0)
    return this.#canvas.toDataURL()
  }

  #current(): Colours {
    const theme = this.#theme.read()
    if (this.#colours?.theme !== theme) {
      this.#colours = { theme, palette: paletteOf(rampOf(theme), theme) }
      this.#pictures.clear()
    }
    return this.#colours
  }

  /** True if one was asked for that has not been drawn. */
  get isBehind(): boolean {
    return this.#left === 0
  }

  async #analyze(key: string, vertices: Vertices): Promise<void> {
    if (this.#awaited.has(key)) return
    this.#awaited.add(key)
    // There are no pictures without the core; the element says that it did not start.
    const report = await this.#lens.analyze(vertices).catch(() => null)
    this.#awaited.delete(key)
    if (!report) return
    this.#reports.set(key, report)
    this.#onChange()
  }
}
