/** Small still pictures of elements on a page, in the colours of its scheme: each analysed once, drawn when it is first shown. */
import type { Report } from '../core/report'
import type { Vertices } from '../model/hexahedron'
import { rampOf } from '../scene/paint/colour-map'
import { ThemeReader } from '../scene/paint/theme'
import { type Colours, thumbnailAddress, thumbnailText } from '../scene/paint/thumbnail'

type Lens = HTMLElementTagNameMap['hex-lens']

export interface Picture {
  readonly address: string
  /** The picture in words. */
  readonly text: string
}

/** The image until there is a picture. */
export const BLANK = `data:image/svg+xml,${encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg"/>')}`

/** A picture takes a few milliseconds to draw and to show. */
const AT_ONCE = 8

export class Pictures {
  readonly #lens: Lens
  readonly #onChange: () => void
  readonly #theme: ThemeReader
  readonly #reports = new Map<string, Report>()
  readonly #pictures = new Map<string, Picture>()
  readonly #awaited = new Set<string>()
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
    const picture = { address: thumbnailAddress(report, colours), text: thumbnailText(report) }
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

  #current(): Colours {
    const theme = this.#theme.read()
    if (this.#colours?.theme !== theme) {
      this.#colours = { theme, ramp: rampOf(theme) }
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
