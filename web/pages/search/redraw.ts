/** One redraw of the page at a time, at the earliest moment that was asked for. */
export class Redraw {
  readonly #draw: () => void
  #timer: ReturnType<typeof setTimeout> | undefined
  #due = Infinity

  constructor(draw: () => void) {
    this.#draw = draw
  }

  /** In so many milliseconds, or before. */
  within(delay: number): void {
    const due = performance.now() + delay
    if (due >= this.#due) return
    this.cancel()
    this.#due = due
    this.#timer = setTimeout(this.#draw, delay)
  }

  cancel(): void {
    clearTimeout(this.#timer)
    this.#due = Infinity
  }
}
