/**
 * The cells of a checked mesh, worst first, one of which can be chosen: a listbox of which only the
 * rows that are seen exist, however many there are. `onChoose` gets the index of the cell that is
 * pressed, tapped, or chosen with Enter.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { CheckedCells, ListedCell } from '../../mesh/checked-cells'
import { formatJacdet } from '../../model/decimal'
import { say } from '../../words/say'

/**
 * Browsers lay out no box much higher than this, in pixels: longer lists scroll in larger steps.
 */
const HIGHEST = 8_000_000
/** CSS pixels, until the first row is measured. */
const ROW_HEIGHT = 28

export class CellList {
  readonly root = document.createElement('div')
  readonly cells: CheckedCells
  readonly #onChoose: (cell: number) => void
  readonly #size = new ResizeObserver(() => this.#measure())
  #box: HTMLElement | null = null
  #rowHeight = ROW_HEIGHT
  #active = 0
  #shown: number | null = null
  #message = ''
  #isRefused = false

  constructor(cells: CheckedCells, onChoose: (cell: number) => void) {
    this.cells = cells
    this.#onChoose = onChoose
    this.root.className = 'cell-list'
    this.#render()
    this.#box = this.root.querySelector('.rows')
    this.#size.observe(this.root)
  }

  whenDrawn(): Promise<this> {
    return new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(() => resolve(this))))
  }

  focus(): void {
    this.#box?.focus({ preventScroll: true })
    this.root.scrollIntoView({ block: 'nearest' })
  }

  /** The cell that the element is now, or null. */
  setShown(cell: number | null): void {
    if (cell === this.#shown) return
    this.#shown = cell
    this.#render()
  }

  dispose(): void {
    this.#size.disconnect()
  }

  #measure(): void {
    const height = this.root.querySelector<HTMLElement>('[role=option]')?.offsetHeight ?? 0
    if (height > 0) this.#rowHeight = height
    this.#render()
  }

  /** The list's scroll position in rows; it need not be a whole number. */
  get #offset(): number {
    const { range, rows } = this.#extent
    return range > 0 ? ((this.#box?.scrollTop ?? 0) / range) * rows : 0
  }

  /** The pixels, and with them the rows, by which the list can be scrolled. */
  get #extent() {
    const view = this.#box?.clientHeight ?? 0
    const rows = Math.max(0, this.cells.count - view / this.#rowHeight)
    return { view, range: Math.max(0, this.#height - view), rows }
  }

  get #height(): number {
    return Math.min(HIGHEST, this.cells.count * this.#rowHeight)
  }

  #render(): void {
    const { view } = this.#extent
    const offset = this.#offset
    const first = Math.floor(offset)
    const seen = Math.min(this.cells.count - first, Math.ceil(view / this.#rowHeight) + 1)
    const top = (this.#box?.scrollTop ?? 0) - (offset - first) * this.#rowHeight
    const ranks = Array.from({ length: Math.max(seen, 1) }, (_, i) => first + i)
    const isActiveSeen = ranks.includes(this.#active)
    const columns = this.cells.hasBlocks ? 'columns with-blocks' : 'columns'
    const { hasIds } = this.cells
    render(
      html`<form @submit=${this.#onGoTo}>
          <label>${hasIds ? say('Go to cell') : say('Go to index')} <input autocomplete="off" spellcheck="false" inputmode=${this.cells.hasIds ? 'text' : 'numeric'} aria-invalid=${this.#isRefused ? 'true' : nothing} aria-describedby="cell-message" /></label>
          <button type="submit">${say('Go')}</button>
        </form>
        <div class=${columns} aria-hidden="true">
          <span>${hasIds ? say('Cell') : say('Index')}</span><span>${say('Verdict')}</span><span>${say('Relative min.')}</span>${this.cells.hasBlocks ? html`<span>${say('Block')}</span>` : nothing}
        </div>
        <div
          class="rows"
          role="listbox"
          tabindex="0"
          aria-label=${say('Cells, worst first')}
          aria-activedescendant=${isActiveSeen ? `cell-at-${this.#active}` : nothing}
          @scroll=${() => this.#render()}
          @keydown=${this.#onKey}
        >
          <div class="extent" role="presentation" .style=${`height: ${this.#height}px`}>
            <div role="presentation" .style=${`transform: translateY(${top}px)`}>
              ${ranks.map(rank => this.#row(rank, columns))}
            </div>
          </div>
        </div>
        <p class="message" id="cell-message" role="status">${this.#message}</p>`,
      this.root,
    )
  }

  #row(rank: number, columns: string): TemplateResult {
    const listed = this.cells.at(rank)
    const { cell, id, block, standing, why } = listed
    const isShown = cell === this.#shown
    return html`<div
      role="option"
      id=${`cell-at-${rank}`}
      class=${`${columns} ${rank === this.#active ? 'active' : ''}`}
      aria-selected=${isShown}
      aria-setsize=${this.cells.count}
      aria-posinset=${rank + 1}
      aria-label=${spoken(listed)}
      @click=${() => this.#choose(rank)}
    >
      <span>${id}</span><span class=${standing === 'invalid' ? 'negative' : ''}>${standing === 'invalid' ? say('INVALID') : say(standing)}</span
      ><span class=${why === null ? '' : 'why'}><span lang=${why === null ? nothing : 'en'}>${why ?? relative(listed)}</span></span>${
        this.cells.hasBlocks ? html`<span>${block ?? '–'}</span>` : nothing
      }
    </div>`
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    const page = Math.max(1, Math.floor(this.#extent.view / this.#rowHeight) - 1)
    const moves: Record<string, number> = {
      ArrowDown: this.#active + 1,
      ArrowUp: this.#active - 1,
      PageDown: this.#active + page,
      PageUp: this.#active - page,
      Home: 0,
      End: this.cells.count - 1,
    }
    if (event.altKey || event.ctrlKey || event.metaKey) return
    const to = moves[event.key]
    if (to !== undefined) this.#goTo(to)
    else if (event.key === 'Enter' || event.key === ' ') this.#choose(this.#active)
    else return
    event.preventDefault()
  }

  readonly #onGoTo = (event: SubmitEvent): void => {
    event.preventDefault()
    const wanted = this.root.querySelector('input')?.value.trim() ?? ''
    if (wanted === '') return
    const cell = this.cells.find(wanted, this.cells.at(this.#active).cell)
    this.#message = cell === null ? say('There is no cell {cell}.', { cell: wanted }) : ''
    this.#isRefused = cell === null
    if (cell === null) this.#render()
    else {
      this.#goTo(this.cells.rankOf(cell))
      this.#box?.focus()
    }
  }

  /** Makes a row the active one, and scrolls to it. */
  #goTo(rank: number): void {
    this.#active = Math.min(Math.max(rank, 0), this.cells.count - 1)
    const { view, range, rows } = this.#extent
    const offset = this.#offset
    const least = this.#active + 1 - view / this.#rowHeight
    const wanted = this.#active < offset ? this.#active : Math.max(offset, least)
    if (this.#box && wanted !== offset && rows > 0) this.#box.scrollTop = (wanted / rows) * range
    this.#render()
  }

  #choose(rank: number): void {
    this.#active = rank
    this.#isRefused = false
    const { cell, id, why } = this.cells.at(rank)
    const canBeShown = this.cells.verticesOf(cell) !== null
    this.#message = canBeShown ? '' : say('Cell {cell} cannot be shown: {why}.', { cell: id, why: why ?? '' })
    this.#render()
    if (canBeShown) this.#onChoose(cell)
  }
}

function relative({ standing, relativeMinimum }: ListedCell): string {
  if (standing === 'unanswered') return '–'
  return Number.isNaN(relativeMinimum) ? say('volume 0') : formatJacdet(relativeMinimum, 0, 'unit')
}

function spoken(listed: ListedCell): string {
  const { id, block, standing, why } = listed
  const answer = why ?? say('relative minimum {minimum}', { minimum: relative(listed) })
  const cell = { cell: id, verdict: say(standing), answer }
  return block === null
    ? say('Cell {cell}, {verdict}, {answer}', cell)
    : say('Cell {cell}, {verdict}, {answer}, block {block}', { ...cell, block })
}
