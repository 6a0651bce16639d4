/** The fold with the best place of a vertex of the chosen cell. What answers it comes when it is opened. */
import { wordsOf } from '../../core/workers'
import type { PlaceHost, PlaceOf, PlaceView } from './place-view'

export class PlaceFold {
  readonly #details = document.createElement('details')
  readonly #content = document.createElement('div')
  readonly #root: HTMLElement
  readonly #host: PlaceHost
  #view: PlaceView | null = null
  #isLoading = false
  #of: PlaceOf | null = null

  constructor(root: HTMLElement, host: PlaceHost) {
    this.#root = root
    this.#host = host
    const summary = document.createElement('summary')
    summary.textContent = 'Best place of a vertex'
    this.#content.className = 'content'
    this.#details.append(summary, this.#content)
    this.#details.addEventListener('toggle', () => this.#toggled())
    root.append(this.#details)
  }

  /** Another cell, or the same after its mesh has moved; null if none is chosen. */
  show(of: PlaceOf | null): void {
    this.#of = of
    this.#root.hidden = of === null
    this.refresh()
  }

  /** After vertices have become fixed or free. */
  refresh(): void {
    this.#view?.show(this.#details.open ? this.#of : null)
  }

  #toggled(): void {
    if (this.#view) this.refresh()
    else if (this.#details.open && !this.#isLoading) void this.#load()
  }

  async #load(): Promise<void> {
    this.#isLoading = true
    this.#say('Loading…')
    try {
      const [{ PlaceView }, { repairFiles }] = await Promise.all([
        import('./place-view'),
        import('../../core/repair/repair-files'),
      ])
      const core = await repairFiles()
      this.#content.replaceChildren()
      this.#view = new PlaceView(this.#content, this.#host, core)
      this.refresh()
    } catch (reason) {
      this.#say(`Best places could not be loaded (${wordsOf(reason)}). Close and open this to try again.`)
    }
    this.#isLoading = false
  }

  #say(words: string): void {
    const line = document.createElement('p')
    line.setAttribute('role', 'status')
    line.textContent = words
    this.#content.replaceChildren(line)
  }
}
