/** The column of the list: which cells are listed and in which order, the histogram, the count, a cell by its id. */
import { html, nothing, type TemplateResult } from 'lit-html'
import type { Arrangement, Column, Overview } from '../../survey/survey-jobs'
import { arrangingTemplate } from './arranging'
import type { Range } from './histogram-range'
import type { Shown } from './page-state'

export interface ListingActions {
  readonly listing: {
    arrange(order: Arrangement): void
    cancelArranging(): void
    select(condition: string, range: Range): void
    selectWholeRange(): void
  }
  readonly choosing: {
    goTo(id: string): void
  }
}

/** What others draw in it. */
export interface ListingParts {
  readonly histogram: HTMLElement | typeof nothing
  readonly table: HTMLElement
}

/** Conditions that are asked for most. */
const CONDITIONS: readonly { readonly name: string; readonly condition: string }[] = [
  { name: 'All cells', condition: '' },
  { name: 'Invalid', condition: 'not valid' },
  { name: 'Invalid, yet the corners accept', condition: 'not valid and corner_min > 0' },
  { name: 'Invalid, yet VTK’s scaled Jacobian accepts', condition: 'not valid and scaled_jacobian > 0' },
  { name: 'Invalid, yet 2×2×2 Gauss points accept', condition: 'not valid and gauss2_min > 0' },
  { name: 'Relative minimum below 0.2', condition: 'boundary_min / volume < 0.2' },
]

/** Also by columns for which the list has no room. */
const ORDERS: readonly { readonly column: Column; readonly name: string }[] = [
  { column: 'worst', name: 'Worst first' },
  { column: 'id', name: 'By cell' },
  { column: 'minimum', name: 'By minimum' },
  { column: 'volume', name: 'By volume' },
  { column: 'class', name: 'By class' },
  { column: 'accepted-by', name: 'By who accepts' },
  { column: 'block', name: 'By block' },
]

export function listingTemplate(
  shown: Shown,
  { listing, choosing }: ListingActions,
  parts: ListingParts,
): TemplateResult | typeof nothing {
  const { overview, range, selected, arranging, message } = shown
  if (!overview) return nothing
  const isDone = selected?.done === overview.hexahedra
  const isWhole = isDone && selected.listed === overview.hexahedra
  const count = countWords(shown, overview, isWhole)
  return html`${filterTemplate(shown, overview, listing)}
    ${parts.histogram}
    <form class="go" @submit=${(event: SubmitEvent) => onGo(event, choosing)}>
      <p class="count" title=${isDone ? nothing : 'So many per cent of the cells have been looked at'}>
        ${count}${isDone ? '' : `, ${Math.floor((100 * (selected?.done ?? 0)) / overview.hexahedra)} %`}
        ${range === null ? nothing : html`<button type="button" title="Whole range" aria-label="Whole range" @click=${() => listing.selectWholeRange()}>✕</button>`}
      </p>
      <label>Go to ${overview.hasIds ? 'id' : 'index'} <input name="id" autocomplete="off" spellcheck="false" /></label>
      <button type="submit">Go</button>
    </form>
    <p class="said" role="status">${isDone && !isWhole ? `${count} are listed.` : ''}</p>
    <p class="message" role="status">${message}</p>
    ${arranging ? arrangingTemplate(arranging, () => listing.cancelArranging()) : nothing}
    ${parts.table}`
}

function filterTemplate(
  { condition, complaint, range, order, arranging }: Shown,
  { blocks }: Overview,
  listing: ListingActions['listing'],
): TemplateResult {
  return html`<form class="filter" @submit=${(event: Event) => event.preventDefault()}>
      <select aria-label="Usual conditions" @change=${(event: Event) => listing.select((event.target as HTMLSelectElement).value, range)}>
        ${CONDITIONS.map(
          given =>
            html`<option value=${given.condition} .selected=${given.condition === condition}>${given.name}</option>`,
        )}
        <option hidden .selected=${!CONDITIONS.some(given => given.condition === condition)}>Own condition</option>
      </select>
      <select aria-label="Sorted by" @change=${(event: Event) => listing.arrange({ column: (event.target as HTMLSelectElement).value as Column, isDescending: false })}>
        ${ORDERS.filter(({ column }) => column !== 'block' || blocks.length > 0).map(
          given =>
            html`<option value=${given.column} .selected=${given.column === (arranging?.order ?? order).column}>${given.name}</option>`,
        )}
      </select>
      <label class="said" for="condition">Cells that are listed meet this condition</label>
      <input
        id="condition"
        .value=${condition}
        placeholder="not valid and corner_min > 0"
        spellcheck="false"
        autocomplete="off"
        autocapitalize="off"
        aria-invalid=${complaint === null ? nothing : 'true'}
        aria-describedby="condition-complaint"
        @change=${(event: Event) => listing.select((event.target as HTMLInputElement).value, range)}
      />
      <p id="condition-complaint" class="complaint" role="status">${complaint}</p>
    </form>`
}

function countWords({ selected }: Shown, { hexahedra }: Overview, isWhole: boolean): string {
  const all = hexahedra.toLocaleString('en')
  if (!isWhole) return `${(selected?.listed ?? 0).toLocaleString('en')} of ${all} cells`
  return all === '1' ? 'One cell' : `All ${all} cells`
}

function onGo(event: SubmitEvent, choosing: ListingActions['choosing']): void {
  event.preventDefault()
  const id = new FormData(event.target as HTMLFormElement).get('id')
  if (typeof id === 'string' && id.trim() !== '') choosing.goTo(id.trim())
}
