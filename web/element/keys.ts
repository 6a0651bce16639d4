/**
 * A key that the element uses goes no further: slides, notebooks and search boxes do not act on it,
 * too. Any other key is the page's, untouched. Whoever uses a key prevents its default; what the
 * browser does with keys in fields and on buttons is known here.
 */
import { historyStep } from './shortcuts'

const TEXT_FIELD = 'textarea, input:not([type=checkbox], [type=radio], [type=range])'
const EDITS = /^(.|Enter|Backspace|Delete|Insert|Home|End|PageUp|PageDown|Arrow.*)$/u
/** With Ctrl or Cmd. */
const EDIT_COMMANDS = /^([acvxyz]|Backspace|Delete|Insert|Home|End|Arrow.*)$/i
const CHOICE = 'select, input[type=range], input[type=radio]'
const CHOICES = /^(.|Enter|Home|End|PageUp|PageDown|Arrow.*)$/u
const SCROLLS = /^( |Home|End|PageUp|PageDown|Arrow.*)$/

/**
 * JupyterLab hears keys before every element, and passes over those of elements that have this
 * attribute (Lumino's CommandRegistry).
 */
const NOT_THE_NOTEBOOKS = 'data-lm-suppress-shortcuts'

/** True if the browser does something with the key in the field or on the button that has the focus. */
export function isControls(target: Element, event: KeyboardEvent): boolean {
  const { key, altKey } = event
  // AltGr types characters; on Windows it is Ctrl and Alt.
  const isTyping = event.isComposing || event.getModifierState('AltGraph')
  const isCommand = !isTyping && (event.ctrlKey || event.metaKey)
  if (target.matches(TEXT_FIELD)) return isTyping || (!altKey && (isCommand ? EDIT_COMMANDS : EDITS).test(key))
  if (isCommand || altKey) return false
  if (target.matches(CHOICE)) return CHOICES.test(key)
  if (target.matches('button, summary, a, input')) return key === 'Enter' || (key === ' ' && !target.matches('a'))
  return SCROLLS.test(key) && /auto|scroll/.test(getComputedStyle(target).overflowY)
}

export class Keys {
  readonly #host: HTMLElement
  readonly #shadow: ShadowRoot
  /** Codes of the keys that are held and were used when they went down. */
  readonly #used = new Set<string>()
  /** While the focus is within, and the attribute is not the page's own. */
  #within: AbortController | null = null

  /** Listens after all others in the shadow root: it is made last. */
  constructor(host: HTMLElement, shadow: ShadowRoot) {
    this.#host = host
    this.#shadow = shadow
    for (const type of ['keydown', 'keypress', 'keyup'] as const)
      shadow.addEventListener(type, event => this.#onKey(event as KeyboardEvent))
    shadow.addEventListener('focusin', () => this.#enter())
    shadow.addEventListener('focusout', event => {
      if (!shadow.contains((event as FocusEvent).relatedTarget as Node | null)) this.leave()
    })
  }

  /** The focus is elsewhere. */
  leave(): void {
    this.#used.clear()
    this.#within?.abort()
    if (this.#within) this.#host.removeAttribute(NOT_THE_NOTEBOOKS)
    this.#within = null
  }

  #onKey(event: KeyboardEvent): void {
    const { type, code, target } = event
    // The page's own content between the tags has its keys.
    if (!this.#shadow.contains(target as Node)) return
    if (type === 'keydown') {
      if (event.defaultPrevented || isControls(target as Element, event)) this.#used.add(code)
      else this.#used.delete(code)
    }
    if (this.#used.has(code)) event.stopPropagation()
    if (type === 'keyup') this.#used.delete(code)
  }

  #enter(): void {
    if (this.#within || this.#host.hasAttribute(NOT_THE_NOTEBOOKS)) return
    this.#within = new AbortController()
    this.#host.setAttribute(NOT_THE_NOTEBOOKS, '')
    addEventListener('keydown', event => this.#onAnyKey(event), { capture: true, signal: this.#within.signal })
  }

  /** Saving and the like, by keys with Ctrl or Cmd that the element does not use, stay the notebook's. */
  #onAnyKey(event: KeyboardEvent): void {
    const isOurs =
      !(event.ctrlKey || event.metaKey) ||
      event.key.startsWith('Arrow') ||
      historyStep(event) !== null ||
      isControls(event.composedPath()[0] as Element, event)
    this.#host.toggleAttribute(NOT_THE_NOTEBOOKS, isOurs)
  }
}
