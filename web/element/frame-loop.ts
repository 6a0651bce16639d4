/**
 * Draws an element once a frame of the page at most, and only if something is new and the element
 * is seen. It is seen if it is in view, printed, or a picture of it is asked for.
 */
import { Printing } from './printing'

export interface DueFrame {
  /** The page's time of the frame; NaN before a page is printed, which is no frame of the page. */
  readonly time: number
  /** False if only updates wait that the last frame had no time for. */
  readonly isNews: boolean
  readonly isSeen: boolean
  readonly isForPaper: boolean
}

/** `isWaiting`: updates are left for a later frame; `isUnmade`: views are still to be made. */
export type DrawFrame = (frame: DueFrame) => { readonly isWaiting: boolean; readonly isUnmade: boolean }

export class FrameLoop {
  readonly #element: HTMLElement
  readonly #draw: DrawFrame
  #request = 0
  #isNews = false
  #isInView = false
  #pictures = 0
  #visibility: IntersectionObserver | null = null
  #printing: Printing | null = null

  constructor(element: HTMLElement, draw: DrawFrame) {
    this.#element = element
    this.#draw = draw
  }

  start(): void {
    this.#printing = new Printing(this.#element, () => this.#drawForPaper())
    this.#visibility = new IntersectionObserver(entries => {
      this.#isInView = entries.at(-1)?.isIntersecting ?? false
      if (this.#isInView) this.schedule()
    })
    this.#visibility.observe(this.#element)
  }

  stop(): void {
    cancelAnimationFrame(this.#request)
    this.#request = 0
    this.#visibility?.disconnect()
    this.#printing?.dispose()
    this.#isInView = false
  }

  /** Something is new: it is drawn in the next frame. */
  schedule(): void {
    this.#isNews = true
    this.#ask()
  }

  /** Draws what is new in a frame of the page that is already there, not in the next one. */
  drawIn(time: number): void {
    cancelAnimationFrame(this.#request)
    if (this.#element.isConnected) this.#onFrame(time)
  }

  get isIdle(): boolean {
    return this.#request === 0
  }

  get isSeen(): boolean {
    return this.#isInView || this.#pictures > 0 || this.#isForPaper
  }

  /** The element is drawn while a picture of it is made, although nobody may see it. */
  async whileDrawn<T>(work: () => Promise<T>): Promise<T> {
    this.#pictures++
    this.schedule()
    try {
      return await work()
    } finally {
      this.#pictures--
    }
  }

  get #isForPaper(): boolean {
    return this.#printing?.isOn ?? false
  }

  #ask(): void {
    if (this.#element.isConnected && this.#request === 0) this.#request = requestAnimationFrame(this.#onFrame)
  }

  readonly #onFrame = (time: number): void => {
    this.#request = 0
    if (this.#drawNow(time).isWaiting) this.#ask()
  }

  #drawNow(time: number): ReturnType<DrawFrame> {
    const isNews = this.#isNews
    this.#isNews = false
    return this.#draw({ time, isNews, isSeen: this.isSeen, isForPaper: this.#isForPaper })
  }

  /** Draws every view before the browser makes the pages, in this very moment. */
  #drawForPaper(): void {
    cancelAnimationFrame(this.#request)
    this.#request = 0
    let drawn: ReturnType<DrawFrame>
    do {
      this.#isNews = true
      drawn = this.#drawNow(Number.NaN)
    } while (this.#isForPaper && drawn.isUnmade)
    if (drawn.isWaiting) this.#ask()
  }
}
