/** A copy that stands in for the canvas while the page is printed: what was drawn on that may be gone when the pages are made. */
import { copyOf } from './figure'

export class PaperCopy {
  readonly #canvas: HTMLCanvasElement
  #copy: HTMLCanvasElement | null = null
  #drawn = 0

  constructor(canvas: HTMLCanvasElement) {
    this.#canvas = canvas
  }

  /** Right after something may have been drawn; `drawn` counts the pictures. */
  update(isForPaper: boolean, drawn: number): void {
    if (isForPaper && this.#copy && drawn === this.#drawn) return
    this.#copy?.remove()
    this.#copy = isForPaper ? copyOf(this.#canvas) : null
    this.#drawn = drawn
    if (this.#copy === null) return
    this.#copy.className = 'for-paper'
    this.#canvas.before(this.#copy)
  }
}
