/** The best place of a vertex of the chosen cell: for all cells around it, before and after, and which points forbid a better one. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { RepairCore } from '../../core/repair/best-place'
import { formatNumber, formatPoint } from '../../model/decimal'
import type { Vec3 } from '../../model/hexahedron'
import { nearestDouble } from '../../model/rational'
import type { Around } from '../../survey/survey-jobs'
import { copyText } from '../../views/copy-text'
import { LETTERS, type PlaceMarks, shortWeight } from '../../views/place-marks'
import { saveFile } from '../../views/save-file'
import {
  bestPlaces,
  certificateOf,
  type HeldStar,
  limitingCells,
  proved,
  type StarHold,
  type StarPlace,
} from './vertex-star'

export interface PlaceHost {
  /** Moves a point of the mesh: one step to undo. Resolves when its cells are answered. */
  move(point: number, to: Vec3): Promise<void>
  /** Why a vertex of the chosen cell stays where it is, as a sentence; null if it may move. */
  whyFixed(vertex: number): string | null
  /** What the lens shows of it. */
  mark(place: PlaceMarks | null): void
}

/** The chosen cell with the cells around it; `around` is null until it is known which cells share a face. */
export interface PlaceOf {
  readonly id: string
  readonly cell: number
  readonly around: Around | null
}

export class PlaceView {
  readonly #root: HTMLElement
  readonly #host: PlaceHost
  readonly #core: RepairCore
  #of: PlaceOf | null = null
  #vertex: number | null = null
  #places: readonly (StarPlace | null)[] = []
  #held: HeldStar | null = null
  /** What has become of the last press of a button. */
  #news = ''

  constructor(root: HTMLElement, host: PlaceHost, core: RepairCore) {
    this.#root = root
    this.#host = host
    this.#core = core
  }

  /** Another cell, or the same after its mesh has moved; null takes the marks away. */
  show(of: PlaceOf | null): void {
    if (of?.cell !== this.#of?.cell) {
      this.#vertex = null
      this.#news = ''
    }
    this.#of = of
    this.#places = of?.around ? bestPlaces(this.#core, of.around) : []
    this.#answer()
  }

  /** A vertex of the chosen cell. */
  choose(vertex: number): void {
    this.#vertex = vertex
    this.#news = ''
    this.#answer()
  }

  /** Without a choice the vertex that gains most is the chosen one. */
  #answer(): void {
    if (this.#places.length > 0) this.#vertex ??= mostGaining(this.#places, v => this.#host.whyFixed(v) === null)
    const own = this.#vertex === null ? null : (this.#places[this.#vertex] ?? null)
    this.#held = own && proved(own)
    this.#host.mark(this.#held && this.#of ? marksOf(this.#held, this.#vertex as number, this.#of) : null)
    this.#render()
  }

  #render(): void {
    render(this.#of ? this.#template(this.#of) : nothing, this.#root)
  }

  #template({ around, id }: PlaceOf): TemplateResult {
    if (around === null) return html`<p class="soft" role="status">Finding which cells share a face…</p>`
    return html`${this.#chooser()}
      ${
        this.#held
          ? this.#answerTemplate(this.#held, this.#vertex as number, id)
          : html`<p>A coordinate of the cells around this vertex is not a finite number.</p>`
      }`
  }

  #chooser(): TemplateResult {
    return html`<p class="soft" id="place-reach">
        The best that each vertex of the cell can do, moved alone: the least relative minimum of all cells around it.
      </p>
      <div class="reach" role="group" aria-labelledby="place-reach">
        ${this.#places.map((own, v) => {
          const value = reachOf(own)
          const isFixed = this.#host.whyFixed(v) !== null
          return html`<button
            type="button"
            class=${isFixed ? 'is-fixed' : ''}
            aria-pressed=${v === this.#vertex}
            aria-label=${`Vertex ${v}, ${value === null ? 'no valid place' : `at best ${value}`}${isFixed ? ', fixed' : ''}`}
            @click=${() => this.choose(v)}
          >
            <b>${v}</b> <span>${value ?? '–'}</span>
          </button>`
        })}
      </div>`
  }

  #answerTemplate(held: HeldStar, vertex: number, id: string): TemplateResult {
    const fixed = this.#host.whyFixed(vertex)
    const { place, cells } = held
    return html`<p class="answer" tabindex="-1">${answerWords(held, vertex)}</p>
      ${
        place.isMoved
          ? html`<p class="go">
              <button type="button" ?disabled=${fixed !== null} @click=${() => this.#move(held, vertex)}>Move there</button>
              <span class="soft">
                to ${formatPoint(place.position)}, ${formatNumber(distanceOf(held))} away${place.measure === 'scale' ? LEAST_BAD : ''}.
                ${fixed ?? ''}
              </span>
            </p>`
          : nothing
      }
      <p>${whyWords(held)}</p>
      ${held.holds.length === 0 ? nothing : holdsTable(held)}
      ${this.#certificate(held, `vertex ${vertex} of cell ${id}`)}
      <p role="status">${this.#news}</p>
      <p class="soft">
        ${upper(counted(cells.length))} around the vertex: all their other vertices stay. Derivation and limits are in docs/repair.md.
      </p>`
  }

  #certificate(held: HeldStar, name: string): TemplateResult | typeof nothing {
    const text = certificateOf(held, name)
    if (text === null) return nothing
    return html`<p class="go">
      <button type="button" @click=${() => this.#copy(text)}>Copy the proof</button>
      <button type="button" @click=${() => saveFile('place-certificate.json', text, 'application/json')}>Download</button>
      <span class="soft">To check it: <code>python3 tests/certificates/check_certificates.py FILE.json</code></span>
    </p>`
  }

  async #copy(text: string): Promise<void> {
    this.#news = (await copyText(text))
      ? 'The proof is copied.'
      : 'Copying is not allowed here. Download gives the same.'
    this.#render()
  }

  async #move(held: HeldStar, vertex: number): Promise<void> {
    const point = this.#of?.around?.points[vertex]
    if (point === undefined) return
    await this.#host.move(point, held.place.position)
    this.#news = `Vertex ${vertex} has been moved. Undo takes it back.`
    this.#render()
    this.#root.querySelector<HTMLElement>('.answer')?.focus({ preventScroll: true })
  }
}

function answerWords(held: HeldStar, vertex: number): TemplateResult {
  const { place, cells } = held
  const { isMoved, relativeMinimum, presentRelativeMinimum: present, measure } = place
  if (measure === 'scale') return html`<b>${forbiddenWords(held, vertex)}</b>`
  const number = (value: number | null) =>
    value === null ? '–' : html`<b class=${value < 0 ? 'negative' : ''}>${formatNumber(value)}</b>`
  return isMoved
    ? html`Best place of vertex ${vertex}: the least relative minimum of ${around(cells.length)} goes from
        ${number(present)} to ${number(relativeMinimum)}. ${limitWords(held)}`
    : html`Vertex ${vertex} is at its best place: the least relative minimum of ${around(cells.length)} is
        ${number(relativeMinimum)}. ${limitWords(held)}`
}

/** Which cells have the least relative minimum, now and at the best place. */
function limitWords(held: HeldStar): string {
  const there = heldIds(held)
  const words = (ids: readonly string[]) => `${ids.length === 1 ? 'cell' : 'cells'} ${listed(ids)}`
  const limits = (ids: readonly string[]) => (ids.length === 1 ? 'limits' : 'limit')
  if (there.length === 0) return ''
  if (!held.place.isMoved) return `${upper(words(there))} ${limits(there)} it.`
  const now = limitingCells(held).map(({ row }) => row.id)
  return `Now ${words(now)} ${limits(now)} it, there ${words(there)}.`
}

function forbiddenWords(held: HeldStar, vertex: number): string {
  const { proof, holds } = held
  const isImpossible = proof.isProved && proof.isImpossible
  if (!isImpossible) return `No valid place of vertex ${vertex} was found, and none is ruled out.`
  const ids = heldIds(held)
  const points = POINTS[holds.length - 1]
  const forbid = holds.length === 1 ? 'forbids' : 'forbid'
  return ids.length === 1
    ? `No place of vertex ${vertex} repairs cell ${ids[0]}: ${points} ${forbid} it.`
    : `No place of vertex ${vertex} makes cells ${listed(ids)} valid together: ${points} ${forbid} it.`
}

const LEAST_BAD = ', where the least J over the size of its cell is greatest, though not positive'

const POINTS = ['this point', 'these two points', 'these three points', 'these four points']

function whyWords({ place, proof, holds }: HeldStar): string {
  const { measure } = place
  if (!proof.isProved)
    return 'Not proved: the weights do not cancel exactly. All that is certain is that no relative minimum is above 1.'
  if (holds.length === 0) return 'No place is better, proved: the least jacdet is never above its mean, the volume.'
  if (measure === 'volume')
    return `No place is better, proved exactly: with these weights J\u00a0−\u00a0r·volume adds up to the same number at every place, and it is not positive. So no place has more than r = ${formatNumber(nearestDouble(proof.bound))}.`
  if (!proof.isImpossible) return 'The weights cancel exactly, but their sum is positive: it forbids nothing.'
  return holds.length === 1
    ? 'Proved exactly: J at this point is the same wherever the vertex is, and it is not positive.'
    : 'Proved exactly: with these weights J adds up to the same number at every place, and it is not positive. So J is never positive at all of them.'
}

function holdsTable({ holds, place }: HeldStar): TemplateResult {
  const { isMoved } = place
  return html`<table aria-label="Points that forbid a better place">
    <thead>
      <tr>
        <th scope="col"><span class="said">Point</span></th>
        <th scope="col">cell</th>
        <th scope="col">weight</th>
        <th scope="col">(ξ, η, ζ)</th>
        <th scope="col">J/volume${isMoved ? ' now' : ''}</th>
        ${isMoved ? html`<th scope="col">there</th>` : nothing}
      </tr>
    </thead>
    <tbody>
      ${holds.map((hold, i) => holdRow(hold, LETTERS[i] as string, isMoved))}
    </tbody>
  </table>`
}

function holdRow({ cell, point, weight, now, there }: StarHold, letter: string, isMoved: boolean): TemplateResult {
  const share = weight === null ? '' : shortWeight(weight)
  if (cell === null)
    return html`<tr><th scope="row">${letter}</th><td colspan="5">a side of the box in which places are sought ${share}</td></tr>`
  return html`<tr>
    <th scope="row">${letter}</th>
    <td>${cell.row.id}</td>
    <td>${share}</td>
    <td>${formatPoint(point)}</td>
    <td class=${signClass(now)}>${relativeText(now)}</td>
    ${isMoved ? html`<td class=${signClass(there)}>${relativeText(there)}</td>` : nothing}
  </tr>`
}

function signClass(value: number | null): string {
  return value !== null && value < 0 ? 'negative' : ''
}

/** Null where the cell has no volume. */
function relativeText(value: number | null): string {
  return value === null ? '–' : formatNumber(value)
}

function marksOf({ place, holds }: HeldStar, vertex: number, { cell }: PlaceOf): PlaceMarks {
  const points = holds.flatMap((hold, i) =>
    hold.cell === null
      ? []
      : [
          {
            position: hold.position,
            point: hold.cell.row.cell === cell ? hold.point : null,
            label: LETTERS[i] as string,
            weight: hold.weight,
          },
        ],
  )
  return { vertex, position: place.isMoved ? place.position : null, points }
}

/** The free vertex with the greatest gain; the first where none may move or none has a valid place. */
function mostGaining(places: readonly (StarPlace | null)[], isFree: (vertex: number) => boolean): number {
  const gains = places.map((own, v) => {
    const after = isFree(v) ? bestValueOf(own) : null
    return after === null ? -1 : after - (own?.place.presentRelativeMinimum ?? 0)
  })
  return gains.indexOf(Math.max(...gains))
}

function bestValueOf(own: StarPlace | null): number | null {
  return own?.place.measure === 'volume' ? own.place.relativeMinimum : null
}

function reachOf(own: StarPlace | null): string | null {
  const value = bestValueOf(own)
  return value === null ? null : shortWeight(value)
}

function heldIds({ holds }: HeldStar): string[] {
  return [...new Set(holds.flatMap(({ cell }) => cell?.row.id ?? []))]
}

function distanceOf({ place, present }: HeldStar): number {
  return Math.hypot(...place.position.map((x, axis) => x - (present[axis] as number)))
}

/** "its 8 cells" */
function around(count: number): string {
  return count === 1 ? 'its one cell' : `its ${count} cells`
}

function counted(count: number): string {
  return count === 1 ? 'one cell' : `${count} cells`
}

function listed(names: readonly string[]): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`
}

function upper(words: string): string {
  return `${words[0]?.toUpperCase()}${words.slice(1)}`
}
