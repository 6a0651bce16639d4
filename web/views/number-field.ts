/**
 * A field for one number. What is typed stays as it is typed; what is refused stays, too, with a
 * sentence, while the number is still the last good one. Enter or leaving the field makes a number
 * final, Escape takes it back, and the arrow keys go up and down by a step.
 */
import { isWithin, type Limits, numberText, readNumber } from '../model/number-text'
import { say } from '../words/say'

/** Characters that surely fit a field; a longer text may hide its exponent. */
const WIDTH = 11

export interface NumberFieldOptions {
  /** The field's name, for screen readers and at the beginning of its sentences. */
  readonly name: string
  /** The id of the element with the sentences. */
  readonly refusalId: string
  /** Says `refusal` in that element: it is another one. */
  readonly onRefusal: () => void
  readonly limits?: Limits
  readonly step?: number
  /** Without it the number is taken when it is final. */
  readonly live?: {
    /** Called before the first number that is typed. */
    begin(): void
    type(value: number): void
    cancel(): void
  }
  /** The number that is final; live ones have been typed before. */
  readonly commit: (value: number) => void
}

export class NumberField {
  readonly input = document.createElement('input')
  /** One sentence or two; empty if the text is a number that is taken. */
  refusal = ''
  readonly #options: NumberFieldOptions
  /** The number of the last frame, or as typed since. */
  #value = Number.NaN
  /** The number before what was typed. */
  #before: number | null = null

  constructor(options: NumberFieldOptions) {
    this.#options = options
    const { name, limits } = options
    this.input.autocomplete = 'off'
    this.input.spellcheck = false
    // The keyboards for numbers of some phones have no minus and no slash.
    if (limits?.least !== undefined) this.input.inputMode = limits.isWhole ? 'numeric' : 'decimal'
    this.input.setAttribute('aria-label', name)
    for (const type of ['input', 'change', 'focusout', 'keydown']) this.input.addEventListener(type, this)
  }

  /** The number is this one. A text that is being typed stays while it means the same. */
  show(value: number): void {
    if (Object.is(value, this.#value)) return
    this.#value = value
    const read = this.#isFocused ? this.#read() : null
    if (!read?.ok || !Object.is(read.value, value)) this.#write()
    this.#refuse('')
  }

  /** Makes final what was typed. */
  commit(): void {
    if (this.#before === null) return
    this.#before = null
    this.#options.commit(this.#value)
  }

  handleEvent(event: Event): void {
    if (event.type === 'input') this.#onInput()
    else if (event.type === 'keydown') this.#onKey(event as KeyboardEvent)
    else {
      this.#finish()
      if (event.type === 'focusout' && this.refusal === '') this.#write()
    }
  }

  #onInput(): void {
    if (this.#options.live) this.#take()
    else if (this.#read().ok) this.#refuse('')
  }

  #finish(): void {
    if (!this.#options.live) this.#take()
    this.commit()
  }

  /** The text as it is now becomes the number, or is refused. */
  #take(): void {
    const read = this.#read()
    if (!read.ok) {
      this.#cancel()
      this.#refuse(
        say('{field}: {why} {number} is kept.', {
          field: this.#options.name,
          why: read.error.message,
          number: numberText(this.#value),
        }),
      )
      return
    }
    this.#refuse('')
    if (Object.is(read.value, this.#value)) return
    const { live } = this.#options
    if (this.#before === null) {
      this.#before = this.#value
      live?.begin()
    }
    this.#value = read.value
    live?.type(read.value)
  }

  #cancel(): void {
    if (this.#before === null) return
    this.#value = this.#before
    this.#before = null
    this.#options.live?.cancel()
  }

  #onKey(event: KeyboardEvent): void {
    const { step = 1, limits = {} } = this.#options
    const { key, altKey, ctrlKey, metaKey } = event
    const way = key === 'ArrowUp' ? 1 : key === 'ArrowDown' ? -1 : 0
    if (key === 'Escape') {
      if (this.#before === null && this.input.value === numberText(this.#value)) return
      event.preventDefault()
      this.#cancel()
      this.#write()
      this.#refuse('')
    } else if (key === 'Enter') this.#finish()
    else if (way !== 0 && !(altKey || ctrlKey || metaKey || this.input.readOnly)) {
      event.preventDefault()
      const read = this.#read()
      const value = (read.ok ? read.value : this.#value) + way * step
      if (!Number.isFinite(value) || !isWithin(value, limits)) return
      this.input.value = numberText(value)
      this.#take()
      if (!this.#options.live) this.commit()
    }
  }

  get #isFocused(): boolean {
    return this.input.matches(':focus')
  }

  #read() {
    return readNumber(this.input.value, this.#options.limits)
  }

  #write(): void {
    const text = numberText(this.#value)
    this.input.value = text
    this.input.title = text.length > WIDTH ? text : ''
  }

  #refuse(sentence: string): void {
    if (sentence === this.refusal) return
    this.refusal = sentence
    const { refusalId, onRefusal } = this.#options
    for (const name of ['aria-errormessage', 'aria-describedby'])
      if (sentence === '') this.input.removeAttribute(name)
      else this.input.setAttribute(name, refusalId)
    if (sentence === '') this.input.removeAttribute('aria-invalid')
    else this.input.setAttribute('aria-invalid', 'true')
    onRefusal()
  }
}
