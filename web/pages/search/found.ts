/** The finds of a search as small pictures, with what they say of all elements of its distribution. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { formatNumber } from '../../model/decimal'
import type { Vertices } from '../../model/hexahedron'
import { KEEPING_NOTES, type Keeping } from '../keep'
import { startOf } from './engine/distribution'
import type { Find, Order } from './engine/ranking'
import type { Tally } from './engine/tally'
import type { SearchRecord } from './kept-searches'
import type { Choice } from './results'
import { shareInWords } from './share'

/** Finds that are shown first; while the search runs, they change from moment to moment. */
export const SHOWN_FIRST = 12

export interface FoundProps {
  readonly record: SearchRecord
  /** False if the form has been changed since. */
  readonly isOfForm: boolean
  readonly isRunning: boolean
  readonly order: Order
  readonly showsAll: boolean
  readonly keeping: Keeping
  readonly choicesTemplate: (choices: readonly Choice[]) => TemplateResult
  onSort(order: Order): void
  onShowAll(): void
  onExport(): void
}

/** The finds that are to be seen. */
export function shownFinds({
  record,
  order,
  showsAll,
  isRunning,
}: Pick<FoundProps, 'record' | 'order' | 'showsAll' | 'isRunning'>): readonly Find[] {
  const finds = record.tally.finds(order)
  return showsAll && !isRunning ? finds : finds.slice(0, SHOWN_FIRST)
}

export function foundTemplate(props: FoundProps): TemplateResult {
  const { record, isOfForm, isRunning, order, showsAll, keeping, choicesTemplate, onSort, onShowAll, onExport } = props
  const { tally } = record
  const sorted = (value: Order, label: string) =>
    html`<label><input type="radio" name="order" .checked=${order === value} @change=${() => onSort(value)} /> ${label}</label>`
  const choices = shownFinds(props).map(find => choiceOf(record, find, order))
  const count = tally.finds(order).length
  return html`<section aria-labelledby="found">
    <div class="head">
      <h2 id="found">Found</h2>
      <div class="order" role="radiogroup" aria-label="Order">
        ${sorted('simplicity', 'simplest first')} ${sorted('extremeness', 'most extreme first')}
      </div>
    </div>
    ${
      isOfForm
        ? nothing
        : html`<p class="quiet">These are of the search for <code>${tally.query.property}</code> with seed ${tally.query.seed}.</p>`
    }
    ${KEEPING_NOTES[keeping] === '' ? nothing : html`<p class="complaint">${KEEPING_NOTES[keeping]}</p>`}
    ${
      count === 0
        ? html`<p class="quiet">${isRunning ? 'Nothing yet.' : 'Nothing so far.'}</p>`
        : html`${choicesTemplate(choices)}
            <div class="actions">
              ${
                count > SHOWN_FIRST && !isRunning
                  ? html`<button type="button" @click=${onShowAll}>${showsAll ? `Show ${SHOWN_FIRST}` : `Show all ${count}`}</button>`
                  : nothing
              }
              <button type="button" @click=${onExport}>Export what is found</button>
            </div>`
    }
    ${tally.elements === 0 ? nothing : shareTemplate(tally)}
  </section>`
}

function shareTemplate({ found, elements }: Tally): TemplateResult {
  return html`<p class="share">${shareInWords(found, elements)}</p>
    <details class="vocabulary">
      <summary>How sure is that?</summary>
      <p>
        Elements are drawn independently. If a share p of the distribution has the property, n elements all miss it with
        probability (1 − p)<sup>n</sup>. That is less than 5 % where p is above 1 − 0.05<sup>1/n</sup>, about 3/n: the
        <a href="https://en.wikipedia.org/wiki/Rule_of_three_(statistics)">rule of three</a>. Where some were found, the
        bounds are those of <a href="https://doi.org/10.1093/biomet/26.4.404">Clopper and Pearson</a>. They hold for
        this distribution alone: with another sigma, grid or symmetry the share is another one.
      </p>
    </details>`
}

/** "1,948,672 elements, 591,000 a second; 19,506 found". */
export function countsText({ elements, found }: Tally, milliseconds: number): string {
  const rate = thousands(Math.round(elements / milliseconds) * 1000)
  return `${thousands(elements)} elements, ${rate} a second; ${thousands(found)} found`
}

export function thousands(count: number): string {
  return count.toLocaleString('en')
}

export function choiceOf({ find, tally }: SearchRecord, { vertices, index, extremeness }: Find, order: Order): Choice {
  const caption = order === 'simplicity' ? movedText(tally, vertices) : formatNumber(extremeness)
  return { vertices, name: `${find}-${tally.query.seed}-${index}`, caption }
}

function movedText({ query }: Tally, vertices: Vertices): string {
  const start = startOf(query.distribution)
  const moved = [0, 1, 2, 3, 4, 5, 6, 7].filter(v =>
    [0, 1, 2].some(r => vertices[3 * v + r] !== start[3 * v + r]),
  ).length
  return `${moved} moved`
}
