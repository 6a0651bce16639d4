/** The list of cells: a grid of which only the rows that are seen exist. Rows come from the worker; until then they are blank. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import { formatJacdet, formatNumber } from '../model/decimal'
import type { Arrangement, Column, Row } from '../survey/survey-jobs'
import { checkNamesOfMeshes } from '../views/check-names'
import { type PlainWord, say } from '../words/say'

/** Browsers lay out no box much higher than this, in pixels: longer lists scroll in larger steps. */
const HIGHEST = 8_000_000
/** CSS pixels, until the first row is measured. */
const ROW_HEIGHT = 28
/** Rows that are asked for at once. */
const BLOCK = 64
/** Characters for which there is room; that of the chosen cell is bold, and so much wider. */
const LONGEST_ID = 12
const BOLD = 1.1

export interface TableHost {
  /** What is said from now on is in the host's language; without it English, or whatever was spoken last. */
  speak?(): void
  rows(from: number, to: number): Promise<readonly Row[]>
  arrange(order: Arrangement): void
  choose(cell: number, rank: number): void
}

interface ColumnWords {
  readonly column: Column
  readonly name: PlainWord
  readonly title: PlainWord
}

const COLUMNS: readonly ColumnWords[] = [
  { column: 'id', name: 'Cell', title: 'The id in the file' },
  { column: 'worst', name: 'Relative min.', title: 'The least jacdet over the volume: at most 1' },
  { column: 'minimum', name: 'Minimum', title: 'The least jacdet' },
  { column: 'volume', name: 'Volume', title: 'The mean of jacdet' },
  { column: 'class', name: 'Class', title: 'Valid, invalid, inverted or collapsed' },
  { column: 'accepted-by', name: 'Accepted by', title: 'Checks that accept the cell' },
  { column: 'block', name: 'Block', title: 'The first block that the cell is in' },
]

interface ShownList {
  readonly hasBlocks: boolean
  readonly order: Arrangement
  readonly isGrown?: boolean
}

export class CellTable {
  readonly #root: HTMLElement
  readonly #host: TableHost
  readonly #size = new ResizeObserver(() => this.#measure())
  #box: HTMLElement | null = null
  #rowHeight = ROW_HEIGHT
  /** Pixels, as they were looked at last: to ask a page that has just been changed for them takes a layout. */
  #view = 0
  #scrollTop = 0
  #count = 0
  #hasBlocks = false
  #order: Arrangement = { column: 'worst', isDescending: false }
  #active = 0
  #chosen: number | null = null
  /** Blocks of rows as they are in the present order; a promise is under way. */
  #blocks = new Map<number, readonly Row[] | null>()
  /** As they were before the list has grown. */
  readonly #before = new Map<number, readonly Row[]>()
  #version = 0
  /** Characters of the longest id that has been seen. */
  #idLength = 0

  constructor(root: HTMLElement, host: TableHost) {
    this.#root = root
    this.#host = host
    this.#size.observe(root)
  }

  /**
   * Another list, or the same in another order, or grown, whose rows stay in sight until others have come; its first rows, if they are there
   * already.
   */
  show(count: number, { hasBlocks, order, isGrown = false }: ShownList, first: readonly Row[] = []): void {
    this.#count = count
    this.#hasBlocks = hasBlocks
    this.#order = order
    this.#idLength = 0
    if (!isGrown) this.#before.clear()
    else for (const [block, rows] of this.#blocks) if (rows) this.#before.set(block, rows)
    this.#blocks = new Map(first.length >= Math.min(BLOCK, count) ? [[0, first]] : [])
    this.#version++
    this.#active = Math.min(this.#active, Math.max(0, count - 1))
    this.#render()
  }

  /** Other numbers of some cells, which keep their places. */
  patch(rows: readonly Row[]): void {
    const own = new Map(rows.map(row => [row.cell, row]))
    for (const [block, before] of this.#blocks)
      if (before?.some(({ cell }) => own.has(cell)))
        this.#blocks.set(
          block,
          before.map(row => own.get(row.cell) ?? row),
        )
    this.#render()
  }

  /** Marks the chosen cell; with its rank, scrolls there. */
  choose(cell: number | null, rank: number | null): void {
    this.#chosen = cell
    if (rank === null) this.#render()
    else this.#goTo(rank)
  }

  /** Back to the first row, for another list. */
  toStart(): void {
    this.#goTo(0)
  }

  dispose(): void {
    this.#size.disconnect()
  }

  focus(): void {
    this.#box?.focus({ preventScroll: true })
  }

  #measure(): void {
    this.#rowHeight = this.#root.querySelector<HTMLElement>('.row')?.offsetHeight || ROW_HEIGHT
    this.#look()
    this.#render()
  }

  #look(): void {
    this.#view = this.#box?.clientHeight ?? 0
    this.#scrollTop = this.#box?.scrollTop ?? 0
  }

  get #extent(): { readonly view: number; readonly range: number; readonly rows: number } {
    const view = this.#view
    return {
      view,
      range: Math.max(0, this.#height - view),
      rows: Math.max(0, this.#count - view / this.#rowHeight),
    }
  }

  get #height(): number {
    return Math.min(HIGHEST, this.#count * this.#rowHeight)
  }

  /** The scroll position in rows. */
  get #offset(): number {
    const { range, rows } = this.#extent
    return range > 0 ? (this.#scrollTop / range) * rows : 0
  }

  #rowAt(rank: number): Row | null {
    const block = Math.floor(rank / BLOCK)
    const rows = this.#blocks.get(block)
    if (rows === undefined) void this.#fetch(block)
    return (rows ?? this.#before.get(block))?.[rank - block * BLOCK] ?? null
  }

  async #fetch(block: number): Promise<void> {
    const version = this.#version
    this.#blocks.set(block, null)
    const rows = await this.#host.rows(block * BLOCK, Math.min(this.#count, (block + 1) * BLOCK)).catch(() => null)
    if (version !== this.#version || rows === null) return
    this.#blocks.set(block, rows)
    this.#render()
  }

  #render(): void {
    this.#host.speak?.()
    const { view } = this.#extent
    const offset = this.#offset
    const first = Math.floor(offset)
    const seen = Math.max(0, Math.min(this.#count - first, Math.ceil(view / this.#rowHeight) + 1))
    const top = this.#scrollTop - (offset - first) * this.#rowHeight
    const ranks = Array.from({ length: Math.max(seen, Math.min(1, this.#count)) }, (_, i) => first + i)
    const columns = COLUMNS.filter(({ column }) => column !== 'block' || this.#hasBlocks)
    const isActiveSeen = ranks.includes(this.#active)
    const lengths = ranks.map(rank => this.#rowAt(rank)?.id.length ?? 0)
    this.#idLength = Math.min(LONGEST_ID, Math.max(this.#idLength, ...lengths))
    render(
      html`<div
        class=${`rows by-${this.#order.column} ${this.#hasBlocks ? 'with-blocks' : ''}`}
        .style=${`--_id: ${BOLD * this.#idLength}ch`}
        role="grid"
        tabindex="0"
        aria-label=${say('Cells')}
        aria-rowcount=${this.#count + 1}
        aria-colcount=${columns.length}
        aria-activedescendant=${isActiveSeen ? `row-${this.#active}` : nothing}
        @scroll=${this.#onScroll}
        @keydown=${this.#onKey}
      >
        <div class="row head" role="row" aria-rowindex="1">${columns.map((words, i) => this.#heading(words, i + 1))}</div>
        <div class="extent" role="presentation" .style=${`height: ${this.#height}px`}>
          <div role="presentation" .style=${`transform: translateY(${top}px)`}>${ranks.map(rank => this.#row(rank))}</div>
        </div>
      </div>`,
      this.#root,
    )
    const isNew = this.#box === null
    this.#box = this.#root.querySelector('.rows')
    if (isNew) this.#measure()
  }

  readonly #onScroll = (): void => {
    this.#look()
    this.#render()
  }

  /** Narrow lists leave out columns, so each says which it is. */
  #heading({ column, name, title }: ColumnWords, index: number): TemplateResult {
    const isSorted = column === this.#order.column
    const sort = isSorted ? (this.#order.isDescending ? 'descending' : 'ascending') : 'none'
    const next = { column, isDescending: isSorted && !this.#order.isDescending }
    return html`<span role="columnheader" class=${column} aria-colindex=${index} aria-sort=${sort}
      ><button type="button" title=${say(title)} @click=${() => this.#host.arrange(next)}>
        ${say(name)}<span class="sort" aria-hidden="true">${isSorted ? (this.#order.isDescending ? ' ▾' : ' ▴') : ''}</span>
      </button></span
    >`
  }

  #row(rank: number): TemplateResult {
    const row = this.#rowAt(rank)
    const isChosen = row !== null && row.cell === this.#chosen
    return html`<div
      class=${`row ${rank === this.#active ? 'active' : ''} ${isChosen ? 'chosen' : ''}`}
      role="row"
      id=${`row-${rank}`}
      aria-rowindex=${rank + 2}
      aria-selected=${isChosen}
      @click=${() => row && this.#choose(rank, row)}
    >
      ${row === null ? html`<span role="gridcell" aria-colindex="1" class="id"></span>` : this.#cells(row)}
    </div>`
  }

  #cells(row: Row): TemplateResult {
    const { id, standing, relativeMinimum, minimum, volume, acceptedBy, block, why } = row
    const isInvalid = standing === 'invalid'
    if (why !== null)
      return html`<span role="gridcell" aria-colindex="1" class="id">${id}</span><span role="gridcell" class="why" aria-colindex="2" aria-colspan=${this.#hasBlocks ? 6 : 5}>${say('unanswered')}: <span lang="en">${why}</span></span>`
    return html`<span role="gridcell" aria-colindex="1" class="id">${id}</span>
      <span role="gridcell" aria-colindex="2" class=${`worst ${isInvalid ? 'negative' : ''}`}
        >${Number.isNaN(relativeMinimum) ? say('volume 0') : formatNumber(relativeMinimum)}</span
      >
      <span role="gridcell" aria-colindex="3" class=${`minimum ${isInvalid ? 'negative' : ''}`}>${formatJacdet(minimum.value, minimum.exponent, 'unit')}</span>
      <span role="gridcell" aria-colindex="4" class="volume">${formatJacdet(volume.value, volume.exponent, 'unit')}</span>
      <span role="gridcell" aria-colindex="5" class=${`class ${isInvalid ? 'negative' : ''}`}>${row.class === 'invalid' ? say('INVALID') : row.class === null ? '' : say(row.class)}</span>
      <span role="gridcell" aria-colindex="6" class="accepted-by" title=${acceptedBy.map(check => say(checkNamesOfMeshes[check])).join(', ')}
        >${isInvalid ? acceptedWords(acceptedBy) : ''}</span
      >
      ${this.#hasBlocks ? html`<span role="gridcell" aria-colindex="7" class="block">${block ?? '–'}</span>` : nothing}`
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    // A heading's button is pressed by its own keys.
    const isOnButton = event.target !== event.currentTarget
    if (event.altKey || event.ctrlKey || event.metaKey || isOnButton) return
    const page = Math.max(1, Math.floor(this.#extent.view / this.#rowHeight) - 2)
    const moves: Record<string, number> = {
      ArrowDown: this.#active + 1,
      ArrowUp: this.#active - 1,
      PageDown: this.#active + page,
      PageUp: this.#active - page,
      Home: 0,
      End: this.#count - 1,
    }
    const to = moves[event.key]
    if (to !== undefined) this.#goTo(to)
    else if (event.key === 'Enter' || event.key === ' ') {
      const row = this.#rowAt(this.#active)
      if (row) this.#choose(this.#active, row)
    } else return
    event.preventDefault()
  }

  #choose(rank: number, { cell }: Row): void {
    this.#active = rank
    this.#host.choose(cell, rank)
  }

  /** Makes a row the active one, and scrolls to it. */
  #goTo(rank: number): void {
    this.#active = Math.min(Math.max(rank, 0), Math.max(0, this.#count - 1))
    this.#look()
    const { view, range, rows } = this.#extent
    const offset = this.#offset
    const least = this.#active + 2 - view / this.#rowHeight
    const wanted = this.#active < offset ? this.#active : Math.max(offset, least)
    if (this.#box && wanted !== offset && rows > 0) {
      this.#box.scrollTop = (Math.min(wanted, rows) / rows) * range
      this.#look()
    }
    this.#render()
  }
}

function acceptedWords(acceptedBy: Row['acceptedBy']): string {
  if (acceptedBy.length === 0) return say('none')
  return acceptedBy.map(check => say(checkNamesOfMeshes[check])).join(', ')
}
