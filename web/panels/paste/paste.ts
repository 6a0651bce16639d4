/** Takes eight points out of whatever is pasted, dropped or typed; what it finds becomes the element, as one step to undo. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import { formatPoint } from '../../model/decimal'
import { vertexOf } from '../../model/hexahedron'
import type { FoundElement } from '../../model/import/format'
import { formats, type ImportResult } from '../../model/import/import'
import type { CreateView, Frame, Offer, View, ViewHost } from '../../views/view'
import css from './paste.css?inline'
import { readOffer } from './read-offer'

export const styles = css

const KNOWN = `${formats.map(({ name }) => name).join(', ')}, a PNG taken away from here`

class PasteView implements View {
  readonly root = document.createElement('div')
  readonly #host: ViewHost
  #offer: Offer | null = null
  #reading: AbortController | null = null
  #result: ImportResult | null = null
  /** Of the listed elements, the one shown last. */
  #taken: FoundElement | null = null

  constructor(host: ViewHost) {
    this.#host = host
    this.root.className = 'paste'
    this.#render()
  }

  update({ offer }: Frame): void {
    if (offer === null || offer === this.#offer) return
    this.#offer = offer
    void this.#read(offer.content)
  }

  dispose(): void {
    this.#reading?.abort()
  }

  async #read(content: string | File): Promise<void> {
    this.#reading?.abort()
    const reading = new AbortController()
    this.#reading = reading
    this.#result = null
    this.#taken = null
    this.#render()
    const result = await readOffer(content, reading.signal)
    if (reading.signal.aborted) return
    this.#reading = null
    this.#result = result
    if (result.ok && result.reading.count === 1) this.#take(result.reading.elements[0] as FoundElement)
    this.#render()
    if (result.ok && result.reading.count > 1) this.root.querySelector('select')?.focus()
    else if (!result.ok) this.root.querySelector('.outcome')?.scrollIntoView({ block: 'nearest' })
  }

  #take(element: FoundElement): void {
    this.#taken = element
    this.#host.dispatch({ type: 'set-vertices', vertices: element.vertices, preset: null })
  }

  #render(): void {
    render(
      html`<p>
          Press Ctrl+V (⌘V), drop a text or a file anywhere on Hexlens, or use the box. All that has eight points in it will do,
          in the vertex order of VTK.
        </p>
        <label for="paste-text">Text with eight points</label>
        <textarea id="paste-text" rows="5" spellcheck="false" autocomplete="off" autocapitalize="off"></textarea>
        <p class="actions">
          <button type="button" @click=${this.#onRead}>Read it</button>
          <button type="button" @click=${() => this.root.querySelector('input')?.click()}>Open a file</button>
          <input type="file" hidden @change=${this.#onFile} />
        </p>
        <p class="outcome" aria-live="polite">${this.#outcome()}</p>
        ${this.#choice()}
        <p class="private">Nothing that is pasted, dropped or typed here leaves the browser.</p>`,
      this.root,
    )
  }

  #outcome(): TemplateResult | string {
    if (this.#reading) return 'Reading …'
    if (this.#result === null) return ''
    if (!this.#result.ok) {
      return html`${this.#result.message} The element is as it was. <span class="known">Looked for: ${KNOWN}.</span>`
    }
    const { format, reading } = this.#result
    const note = reading.note === undefined ? '' : ` ${reading.note}`
    if (reading.count === 1) return `Read as ${format}.${note}`
    const listed = reading.elements.length < reading.count ? ` The first ${reading.elements.length} are listed.` : ''
    const shown = this.#taken ? ` Shown: ${this.#taken.name}.` : ' Which one?'
    return `${reading.count} elements were found, read as ${format}.${listed}${note}${shown}`
  }

  #choice(): TemplateResult | typeof nothing {
    if (!this.#result?.ok || this.#result.reading.count === 1) return nothing
    const { elements } = this.#result.reading
    return html`<label for="paste-choice">Elements, each with its first two vertices</label>
      <select id="paste-choice" size=${Math.min(elements.length, 6)} @keydown=${this.#onChoiceKey} @dblclick=${this.#onChosen}>
        ${elements.map((element, i) => html`<option value=${i} ?selected=${i === 0}>${optionText(element)}</option>`)}
      </select>
      <p class="actions"><button type="button" @click=${this.#onChosen}>Show this element</button></p>`
  }

  readonly #onRead = (): void => {
    void this.#read(this.root.querySelector('textarea')?.value ?? '')
  }

  readonly #onFile = (event: Event): void => {
    const input = event.target as HTMLInputElement
    const file = input.files?.[0]
    if (file) void this.#read(file)
    input.value = ''
  }

  readonly #onChoiceKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter') return
    event.preventDefault()
    this.#onChosen()
  }

  readonly #onChosen = (): void => {
    const index = this.root.querySelector('select')?.selectedIndex ?? -1
    const element = this.#result?.ok ? this.#result.reading.elements[index] : undefined
    if (element === undefined) return
    this.#take(element)
    this.#render()
  }
}

function optionText({ name, vertices }: FoundElement): string {
  return `${name}: ${formatPoint(vertexOf(vertices, 0))}, ${formatPoint(vertexOf(vertices, 1))}, …`
}

export const create: CreateView = host => new PasteView(host)
