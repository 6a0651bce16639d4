/** The language in which an element speaks, and news of its changes: an attribute `lang` around it, or words that arrive. */
import { ARRIVAL, languageOf, speak } from '../words/say'

/** Events whose handlers say something. */
const SAYING = ['click', 'input', 'change', 'keydown', 'submit', 'scroll', 'focusin', 'focusout'] as const

export class OwnLanguage {
  readonly #element: HTMLElement
  readonly #lens: HTMLElement
  readonly #onChange: () => void
  readonly #attributes = new MutationObserver(() => this.#check())
  #tag = 'en'

  /** `lens` holds all that the element says. */
  constructor(element: HTMLElement, lens: HTMLElement, onChange: () => void) {
    this.#element = element
    this.#lens = lens
    this.#onChange = onChange
    for (const type of SAYING) lens.addEventListener(type, () => this.speak(), { capture: true, passive: true })
  }

  start(): void {
    let root = this.#element.getRootNode()
    this.#attributes.observe(root, { subtree: true, attributeFilter: ['lang'] })
    while (root instanceof ShadowRoot) {
      root = root.host.getRootNode()
      this.#attributes.observe(root, { subtree: true, attributeFilter: ['lang'] })
    }
    addEventListener(ARRIVAL, this.#check)
    this.#take()
  }

  stop(): void {
    this.#attributes.disconnect()
    removeEventListener(ARRIVAL, this.#check)
  }

  /** What is said from now on is in this language. */
  speak(): void {
    speak(this.#tag)
  }

  /** Likewise while the work is done, which may be a part of another element's. */
  during(work: () => void): void {
    const before = speak(this.#tag)
    work()
    speak(before)
  }

  #take(): void {
    this.#tag = languageOf(this.#element)
    this.#lens.lang = this.#tag
    this.#lens.dir = 'ltr'
  }

  readonly #check = (): void => {
    if (languageOf(this.#element) === this.#tag) return
    this.#take()
    this.#onChange()
  }
}
