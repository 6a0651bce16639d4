/**
 * Lays the element out for paper: it gets the attribute `data-printing`, which its styles go by,
 * and is drawn at once, before the browser makes the pages. Two signals start it, since not every
 * way to print or to preview gives both.
 */
export class Printing {
  readonly #host: HTMLElement
  readonly #draw: () => void
  readonly #listening = new AbortController()

  constructor(host: HTMLElement, draw: () => void) {
    this.#host = host
    this.#draw = draw
    const { signal } = this.#listening
    addEventListener('beforeprint', () => this.#print(true), { signal })
    addEventListener('afterprint', () => this.#print(false), { signal })
    matchMedia('print').addEventListener('change', ({ matches }) => this.#print(matches), { signal })
  }

  get isOn(): boolean {
    return this.#host.hasAttribute('data-printing')
  }

  dispose(): void {
    this.#listening.abort()
    this.#host.removeAttribute('data-printing')
  }

  #print(isOn: boolean): void {
    if (isOn === this.isOn) return
    this.#host.toggleAttribute('data-printing', isOn)
    this.#draw()
  }
}
