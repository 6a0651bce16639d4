/** The room that the scene has, in units: how it is split, how large its parts are, and what goes where in the element's own. */
import { type Layout, layoutOf } from './layout'
import { unitOf } from './unit'

interface Size {
  readonly width: number
  readonly height: number
}

/** From this width on, in units, the reference cube stands beside the element, else below it. */
const BESIDE = 560
/** In a box lower than this it is beside it, too: below it one would have to scroll to see it. */
const TOO_LOW = 340

export class Room {
  readonly #root: HTMLElement
  readonly #pane: HTMLElement
  #unit = 1
  #whole: Size = { width: 0, height: 0 }
  #own: Size = { width: 0, height: 0 }
  #layout: Layout = layoutOf(0, 0)

  /** `pane` is the element's own part of `root`. */
  constructor(root: HTMLElement, pane: HTMLElement) {
    this.#root = root
    this.#pane = pane
  }

  /** CSS pixels of one unit. */
  get unit(): number {
    return this.#unit
  }

  get whole(): Size {
    return this.#whole
  }

  get own(): Size {
    return this.#own
  }

  get layout(): Layout {
    return this.#layout
  }

  get isEmpty(): boolean {
    return this.#own.width === 0 || this.#own.height === 0
  }

  /** Where it is below the element the box is higher for it, and stays so. */
  #split(): 'beside' | 'below' {
    const isLow = this.#whole.height < TOO_LOW && this.#root.dataset.split !== 'below'
    return this.#whole.width >= BESIDE || isLow ? 'beside' : 'below'
  }

  /** Lays out the parts; whether the element's own has another size than before. */
  measure(isSplit: boolean): boolean {
    const unit = unitOf(this.#root)
    this.#unit = unit
    this.#whole = { width: this.#root.clientWidth / unit, height: this.#root.clientHeight / unit }
    this.#root.dataset.split = isSplit ? this.#split() : 'none'
    this.#root.classList.toggle('tight', this.#root.dataset.split === 'beside' && this.#whole.width < BESIDE)
    const [width, height] = [this.#pane.offsetWidth / unit, this.#pane.offsetHeight / unit]
    if (width === this.#own.width && height === this.#own.height) return false
    this.#own = { width, height }
    this.#layout = layoutOf(width, height)
    this.#root.classList.toggle('narrow', this.#layout.isNarrow)
    this.#root.classList.toggle('low', this.#layout.isLow)
    return true
  }
}
