/** The source of the element, its node order, and the list of cells to choose from. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { ReadCells, Reading, ShownCell } from '../../input/reading'
import type { Vertices } from '../../model/hexahedron'
import { isNew } from '../../views/is-new'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import type { CellList } from './cell-list'
import listCss from './cell-list.css?inline'
import css from './reading.css?inline'
import { notesOf, statusSentence } from './reading-words'

export const readingStyles = css + listCss

class ReadingView implements View {
  readonly root = document.createElement('section')
  isLoading = false
  readonly #context: ViewContext
  #list: CellList | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'reading'
    this.#render(null, null, null)
  }

  update({ reading, state, report }: Frame): void {
    // The words stay those of before while a gesture runs.
    const vertices = state.gestureStart ?? state.vertices
    const cell = reading?.state === 'read' ? reading.cellOf(vertices) : null
    const isValid = state.gestureStart === null ? (report?.valid ?? null) : null
    if (!isNew(this.root, reading, cell, isValid, this.#list)) return
    this.#render(reading, cell, isValid)
    if (reading?.state !== 'read' || reading.cells.count === 1) this.#list = null
    else if (this.#list?.cells === reading.cells) this.#list.setShown(cell?.cell ?? null)
    else void this.#makeList(reading, vertices)
  }

  dispose(): void {
    this.#list?.dispose()
  }

  async #makeList(reading: ReadCells, vertices: Vertices): Promise<void> {
    if (this.isLoading) return
    this.isLoading = true
    const { CellList } = await import('./cell-list')
    this.isLoading = false
    this.#list = new CellList(reading.cells, cell => this.#context.input.show(cell))
    this.#list.setShown(reading.cellOf(vertices)?.cell ?? null)
    this.#context.requestFrame()
    if (!reading.isQuiet) this.#list.whenDrawn().then(list => list.focus())
  }

  /** The section is a region of the page only if there is something in it. */
  #render(reading: Reading | null, cell: ShownCell | null, isValid: boolean | null): void {
    if (reading && isSaid(reading, cell)) this.root.setAttribute('aria-label', say('What was read'))
    else this.root.removeAttribute('aria-label')
    render(
      html`<p class="said" aria-live="polite">${reading && isSaid(reading, cell) ? heard(reading) : ''}</p>
        ${reading && this.#content(reading, cell, isValid)}`,
      this.root,
    )
  }

  #content(reading: Reading, cell: ShownCell | null, isValid: boolean | null): TemplateResult | typeof nothing {
    if (reading.state === 'refused' || !isSaid(reading, cell)) return nothing
    if (reading.state === 'under-way')
      return html`<p class="status">
        <span>${statusSentence(reading)}</span>
        <button type="button" @click=${() => this.#context.input.close()}>${say('Cancel')}</button>
      </p>`
    const isList = reading.cells.count > 1
    return html`<p class="status">
        <span>${statusSentence(reading)}${isList && cell === null ? ` ${say('Choose one to look at it.')}` : ''}</span>
        ${isList ? html`<button type="button" @click=${() => this.#context.input.close()}>${say('Close the list')}</button>` : nothing}
      </p>
      ${isList ? html`<slot name="list"></slot>${this.#list?.root}` : nothing} ${notes(reading, cell)}
      ${cell && this.#order(reading, cell, isValid)}`
  }

  #order(reading: ReadCells, { cell, id, order }: ShownCell, isValid: boolean | null): TemplateResult | typeof nothing {
    const whose = reading.cells.count > 1 ? say('Cell {cell}:', { cell: id }) : ''
    if (order)
      return html`<p class="order" tabindex="-1">${whose} ${say('Taken in the order “{order}”; Undo takes this back.', { order: say(order.name) })}</p>`
    const open = isValid === false ? reading.cells.openOrderOf(cell) : null
    if (open === null) return nothing
    return html`<p class="order">
      <span>${whose} ${say('In the order “{order}” it is valid.', { order: say(open.name) })}</span>
      <button type="button" @click=${() => this.#use(cell, open)}>${say('Use it')}</button>
    </p>`
  }

  /** The button goes, so the focus moves to the sentence that says what happened. */
  #use(cell: number, order: NonNullable<ShownCell['order']>): void {
    this.#context.input.show(cell, order)
    const focus = () => this.root.querySelector<HTMLElement>('.order')?.focus({ preventScroll: true })
    requestAnimationFrame(() => requestAnimationFrame(focus))
  }
}

/** The panel `problems` says refusals; one element is named only as long as it is the one read. */
function isSaid(reading: Reading, cell: ShownCell | null): boolean {
  return reading.state === 'under-way' || (reading.state === 'read' && (reading.cells.count > 1 || cell !== null))
}

/** The sentence without percentages, which would be read out one after the other. */
function heard(reading: Reading): string {
  return statusSentence(reading.state === 'under-way' ? { ...reading, fraction: 0 } : reading)
}

function notes(reading: ReadCells, cell: ShownCell | null): TemplateResult | typeof nothing {
  const sentences = notesOf(reading, cell?.order ?? null)
  return sentences.length === 0 ? nothing : html`<p class="notes" lang="en">${sentences.join(' ')}</p>`
}

export const createReading: CreateView = context => new ReadingView(context)
