/**
 * What stands below the picture where there is no room beside it: the verdict in a line or two, and a button that opens all else, so
 * that the picture has most of the element's box. The box grows by what is opened. A page that says `--hl-stage-height` has a
 * layout of its own, with everything open.
 */
import { say } from '../words/say'

/** The width, in CSS pixels, from which panels stand beside the picture; the style sheet says the same. */
const BESIDE = 896

export class BelowPicture {
  readonly #lens: HTMLElement
  readonly #stage: HTMLElement
  readonly #button = document.createElement('button')
  readonly #resizes = new ResizeObserver(entries => {
    this.#isNarrow = (entries.at(-1)?.contentRect.width ?? 0) < BESIDE
    this.#update()
  })
  /** True if anything besides the verdict is shown. */
  #hasMore = false
  #isLine = false
  #isNarrow = false
  #isOpen = false

  constructor(lens: HTMLElement, stage: HTMLElement, root: HTMLElement) {
    this.#lens = lens
    this.#stage = stage
    this.#button.type = 'button'
    this.#button.addEventListener('click', () => this.#toggle())
    const heading = document.createElement('h2')
    heading.append(this.#button)
    root.append(heading)
  }

  /** `isLine`: nothing but the verdict is shown. */
  begin(hasStage: boolean, hasPanels: boolean, isLine: boolean): void {
    this.#isLine = isLine
    const isLaidOut = getComputedStyle(this.#lens).getPropertyValue('--hl-stage-height') !== ''
    this.#hasMore = hasStage && hasPanels && !isLine && !isLaidOut
    if (this.#hasMore) this.#resizes.observe(this.#lens)
    this.#update()
  }

  end(): void {
    this.#resizes.disconnect()
  }

  /** In a frame, which has the element's language. */
  draw(): void {
    const words = say('Details')
    if (this.#button.textContent !== words) this.#button.textContent = words
  }

  #toggle(): void {
    this.#isOpen = !this.#isOpen
    // The picture keeps its height under the reader's eyes.
    const { style } = this.#lens
    if (this.#isOpen) style.setProperty('--_kept-height', `${this.#stage.clientHeight}px`)
    else style.removeProperty('--_kept-height')
    this.#update()
  }

  #update(): void {
    const isFoldable = this.#hasMore && this.#isNarrow
    const { classList } = this.#lens
    classList.toggle('is-foldable', isFoldable)
    classList.toggle('has-line', this.#isLine || (isFoldable && !this.#isOpen))
    this.#button.setAttribute('aria-expanded', String(this.#isOpen))
  }
}
