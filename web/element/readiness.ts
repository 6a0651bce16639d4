/**
 * That the element is drawn, and its verdict, for pages that wait and for their style sheets:
 * `:state(ready)`, `:state(valid)`, `:state(invalid)`. Focus that is asked for earlier comes then.
 */
const FOCUSABLE = 'button:enabled, input:enabled, select:enabled, a[href], summary, [tabindex="0"]'

export class Readiness {
  /** Resolved when the element is first drawn. */
  readonly first: Promise<void>
  readonly #host: HTMLElement
  readonly #internals: ElementInternals | undefined
  readonly #tell: () => void
  #resolve = (): void => {}
  #isReady = false
  #isFirst = true
  /** `before` had the focus when it was asked for; a reader who has gone on since keeps it. */
  #asked: { readonly options: FocusOptions | undefined; readonly before: Element | null } | null = null

  constructor(host: HTMLElement, tell: () => void) {
    this.#host = host
    this.#tell = tell
    // Older browsers have no internals, no states, or states with other names.
    this.#internals = host.attachInternals?.()
    this.first = new Promise(resolve => {
      this.#resolve = resolve
    })
  }

  /** Called when everything in sight is drawn. */
  drawn(): void {
    if (this.#asked?.before === document.activeElement) this.focus(this.#asked.options)
    if (this.#isReady) return
    this.#isReady = true
    this.#set('ready', true)
    this.#resolve()
    if (this.#isFirst && this.#host.autofocus && document.activeElement === document.body) this.focus()
    this.#isFirst = false
    this.#tell()
  }

  /** The element has left the page. */
  end(): void {
    this.#isReady = false
    this.#asked = null
    this.#set('ready', false)
  }

  judged(valid: boolean | null): void {
    this.#set('valid', valid === true)
    this.#set('invalid', valid === false)
  }

  /** To the scene, or to the first that can have it. */
  focus(options?: FocusOptions): void {
    const { shadowRoot } = this.#host
    const target = shadowRoot?.querySelector('.scene-stage') ?? shadowRoot?.querySelector(`.lens :is(${FOCUSABLE})`)
    const before = document.activeElement
    ;(target as HTMLElement | null | undefined)?.focus(options)
    this.#asked = shadowRoot?.activeElement ? null : { options, before }
  }

  #set(state: string, isOn: boolean): void {
    try {
      this.#internals?.states?.[isOn ? 'add' : 'delete'](state)
    } catch {}
  }
}
