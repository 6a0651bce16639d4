/** Announces the progress of a search for screen readers, politely and rarely. */
import type { Search } from './engine/search'

/** Milliseconds between announcements while the search runs. */
const PAUSE = 20_000

export class LiveRegion {
  readonly #region: HTMLElement
  #saidAt = 0
  #saidFound = 0

  constructor(region: HTMLElement) {
    this.#region = region
  }

  begin(): void {
    this.#saidAt = performance.now()
    this.#saidFound = 0
    this.say('Searching.')
  }

  /** The first find at once, then what is new now and then, and the end. */
  report({ elements, found, isRunning }: Pick<Search, 'elements' | 'found' | 'isRunning'>): void {
    const now = performance.now()
    const isFirst = found > 0 && this.#saidFound === 0
    const isDue = now - this.#saidAt >= PAUSE && found > this.#saidFound
    if (isRunning && !isFirst && !isDue) return
    this.#saidAt = now
    this.#saidFound = found
    this.say(
      `${isRunning ? '' : 'Stopped. '}${found.toLocaleString('en')} found among ${elements.toLocaleString('en')} elements.`,
    )
  }

  say(sentence: string): void {
    this.#region.textContent = sentence
  }
}
