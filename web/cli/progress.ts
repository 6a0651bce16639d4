/** One line on a terminal that says how far the work is, and goes when it is done. */

/** Milliseconds. */
const INTERVAL = 100
const ERASE = '\r\u001b[K'

export class ProgressLine {
  readonly #terminal: { write(text: string): unknown } | null
  #shown = 0
  #isVisible = false

  /** Shows nothing where there is no terminal. */
  constructor(terminal: { write(text: string): unknown } | null) {
    this.#terminal = terminal
  }

  show(what: string, fraction: number): void {
    const now = performance.now()
    if (this.#terminal === null || now - this.#shown < INTERVAL) return
    this.#shown = now
    this.#isVisible = true
    this.#terminal.write(`${ERASE}${what}: ${Math.floor(100 * Math.min(Math.max(fraction, 0), 1))} %`)
  }

  clear(): void {
    if (this.#isVisible) this.#terminal?.write(ERASE)
    this.#isVisible = false
  }
}
