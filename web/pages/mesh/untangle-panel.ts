/** Untangling on the page Mesh: what is asked for, how far it is, what would move, drawn as lines before it is taken as one step. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { UntangledCounts } from '../../core/repair/untangling'
import { wordsOf } from '../../core/workers'
import { readNumber } from '../../model/number-text'
import type { OpenSurvey } from '../../survey/open-survey'
import { startCertifying, startUntangling } from '../../survey/start-untangling'
import type { Moves, Overview } from '../../survey/survey-jobs'
import { type BoundaryMoves, type GhostLines, type PartUntangled, withMoves } from '../../survey/untangled-part'
import { saveFile } from '../../views/save-file'
import { ButtonSection } from './button-section'
import { fileStem } from './file-names'
import {
  allProofsWords,
  certificatesSentence,
  heldWords,
  linesWords,
  resultSentences,
  ringWords,
  takenSentences,
} from './untangle-words'

export interface UntangleHost {
  /** Null where no mesh is open. */
  survey(): OpenSurvey | null
  chosen(): number | null
  /** Lines over the picture; null for none. */
  ghost(lines: GhostLines | null): void
  take(moves: Moves): void
  goTo(cell: number): void
}

/** What was untangled, and by which margin. */
interface Asked {
  readonly of: { readonly cell: number; readonly rings: number } | null
  readonly margin: number
  /** The margin as it was typed. */
  readonly text: string
}

interface Shown {
  readonly overview: Overview | null
  /** Why it cannot be untangled; empty if it can. */
  readonly whyNot: string
  readonly margin: string
  /** Rings of cells around the chosen one; null for the whole mesh. */
  readonly rings: number | null
  readonly boundary: 'stays' | 'slides' | 'within'
  readonly distance: string
  readonly complaint: string
  readonly soFar: UntangledCounts | 'begun' | null
  readonly result: PartUntangled | null
  readonly message: string
  /** Vertices hold what is left of this, whether it has been taken or not; null if there are none. */
  readonly left: { readonly asked: Asked; readonly found: PartUntangled } | null
  /** Which part of their certificates is there, from 0 to 1; null where none are being written. */
  readonly certified: number | null
  readonly certificates: string
}

const BOUNDARIES: readonly { readonly value: Shown['boundary']; readonly name: string }[] = [
  { value: 'stays', name: 'stays' },
  { value: 'slides', name: 'slides where it is planar' },
  { value: 'within', name: 'moves within a distance' },
]

const MOST_RINGS = 5
const CHANGED = 'The mesh has changed: untangle it again.'
const NOTHING_WRITTEN = { certified: null, certificates: '' } as const
const FIRST: Shown = {
  overview: null,
  whyNot: '',
  margin: '0.1',
  rings: null,
  boundary: 'stays',
  distance: '',
  complaint: '',
  soFar: null,
  result: null,
  message: '',
  left: null,
  ...NOTHING_WRITTEN,
}

export class UntanglePanel {
  readonly #section = new ButtonSection('untangle', 'Untangle')
  readonly #host: UntangleHost
  #shown = FIRST
  #running: AbortController | null = null
  /** True while what was found is on its way into the mesh. */
  #isTaking = false

  constructor(host: UntangleHost) {
    this.#host = host
  }

  /** Shows and hides the panel. */
  get button(): HTMLElement {
    return this.#section.button
  }

  get root(): HTMLElement {
    return this.#section.root
  }

  /** Another mesh, or none. */
  open(overview: Overview | null, whyNot: string): void {
    this.#stop()
    this.button.hidden = overview === null
    this.#section.open(false)
    this.#set({ ...FIRST, overview, whyNot })
  }

  /** The same mesh with vertices elsewhere: what was found for it before holds no more. */
  moved(overview: Overview): void {
    const { result, soFar } = this.#shown
    const isOutdated = result !== null || soFar !== null
    this.#stop()
    const { message, left } = this.#isTaking ? this.#shown : { message: isOutdated ? CHANGED : '', left: null }
    this.#isTaking = false
    this.#set({ ...this.#shown, ...NOTHING_WRITTEN, overview, result: null, soFar: null, message, left })
  }

  #stop(): void {
    this.#running?.abort(new Error('Cancelled.'))
    this.#running = null
    this.#host.ghost(null)
  }

  async #start(): Promise<void> {
    const { margin: text, rings } = this.#shown
    const margin = readNumber(text)
    const chosen = this.#host.chosen()
    const boundary = boundaryOf(this.#shown)
    if (!margin.ok || !(margin.value >= 0 && margin.value <= 1))
      return this.#complain('The least relative minimum is a number from 0 to 1.')
    if (boundary === null) return this.#complain('The distance is a number above 0, in units of the mesh.')
    if (rings !== null && chosen === null) return this.#complain('No cell is chosen.')
    const survey = this.#host.survey()
    if (!survey) return
    this.#stop()
    const running = new AbortController()
    this.#running = running
    this.#set({
      ...this.#shown,
      ...NOTHING_WRITTEN,
      complaint: '',
      message: '',
      result: null,
      left: null,
      soFar: 'begun',
    })
    try {
      const of = rings === null ? null : { cell: chosen as number, rings }
      const part = await survey.tangled(of)
      const onProgress = (soFar: UntangledCounts) => running === this.#running && this.#set({ ...this.#shown, soFar })
      const result = await startUntangling({ part, margin: margin.value, boundary }, onProgress, running.signal)
      if (running === this.#running) this.#took(result, { of, margin: margin.value, text })
    } catch (reason) {
      if (running === this.#running) this.#set({ ...this.#shown, soFar: null, message: wordsOf(reason) })
    }
  }

  #complain(complaint: string): void {
    this.#set({ ...this.#shown, complaint })
  }

  #took(result: PartUntangled | { readonly refused: string }, asked: Asked): void {
    this.#running = null
    if ('refused' in result) {
      this.#set({ ...this.#shown, soFar: null, message: result.refused })
      return
    }
    const hasMoved = result.moves.points.length > 0
    this.#set({
      ...this.#shown,
      soFar: null,
      result: hasMoved ? result : null,
      left: result.heldCount > 0 ? { asked, found: result } : null,
      message: resultSentences(result, asked.text).join(' '),
    })
    this.#host.ghost(hasMoved ? result.ghost : null)
    this.#refocus(hasMoved ? '.take' : '.begin')
  }

  /** A button that was disabled while something ran has lost the focus. */
  #refocus(selector: string): void {
    if (document.activeElement === document.body) this.root.querySelector<HTMLElement>(selector)?.focus()
  }

  #cancel(): void {
    this.#stop()
    this.#set({ ...this.#shown, soFar: null, message: 'Cancelled: nothing has moved.' })
  }

  #take(): void {
    const { result } = this.#shown
    if (!result) return
    this.#host.ghost(null)
    this.#isTaking = true
    this.#set({ ...this.#shown, result: null, message: takenSentences(result, this.#shown.margin).join(' ') })
    this.#host.take(result.moves)
    this.root.querySelector<HTMLElement>('.begin')?.focus()
  }

  #leave(): void {
    this.#stop()
    this.#set({
      ...this.#shown,
      ...NOTHING_WRITTEN,
      result: null,
      left: null,
      message: 'Left as it was: nothing has moved.',
    })
    this.root.querySelector<HTMLElement>('.begin')?.focus()
  }

  /** The proof of each vertex that holds what is left, as a file. */
  async #certify(): Promise<void> {
    const { left, overview } = this.#shown
    const survey = this.#host.survey()
    if (!left || !overview || !survey) return
    const running = new AbortController()
    this.#running = running
    this.#set({ ...this.#shown, certified: 0, certificates: '' })
    const { asked, found } = left
    const set = (certified: number | null, certificates: string) =>
      running === this.#running && this.#set({ ...this.#shown, certified, certificates })
    try {
      const part = withMoves(await survey.tangled(asked.of), found.moves)
      const wanted = { part, margin: asked.margin, holding: found.holding }
      const { text, count } = await startCertifying(wanted, done => set(done, ''), running.signal)
      if (running !== this.#running) return
      const file = `${fileStem(overview.name)}-held.json`
      saveFile(file, text, 'application/json')
      set(null, certificatesSentence(file, count, found.heldCount))
      this.#refocus('.certify')
    } catch (reason) {
      set(null, wordsOf(reason))
    }
  }

  #cancelCertificates(): void {
    this.#running?.abort(new Error('Cancelled.'))
    this.#running = null
    this.#set({ ...this.#shown, certified: null, certificates: 'Cancelled: nothing was saved.' })
    this.root.querySelector<HTMLElement>('.certify')?.focus()
  }

  #set(shown: Shown): void {
    this.#shown = shown
    render(this.#template(shown), this.root)
  }

  #template({ overview, whyNot, soFar, result, message, left }: Shown): TemplateResult | typeof nothing {
    if (!overview) return nothing
    if (whyNot !== '') return html`<p>${whyNot}</p>`
    return html`<p class="about">
        Moves vertices, one after the other, to where their worst cell is best. It knows no geometry but what stays, and a mesh whose topology
        forbids validity stays invalid.
      </p>
      ${this.#form(this.#shown)}
      <p class="result" role="status">${soFar ? 'Untangling.' : message}</p>
      ${soFar ? this.#progress(soFar) : nothing}
      ${
        result
          ? html`<p class="then">
              <span>Thin lines in the picture show the edges of these vertices as they would be${linesWords(result.ghost)}.</span>
              <button type="button" class="take" @click=${() => this.#take()}>Take it</button>
              <button type="button" @click=${() => this.#leave()}>Leave it</button>
            </p>`
          : nothing
      }
      ${left ? this.#leftTemplate(left.found) : nothing}`
  }

  #leftTemplate({ held, heldCount }: PartUntangled): TemplateResult {
    const { certified, certificates } = this.#shown
    return html`<ul class="held" aria-label="What holds the cells that are left">
        ${held.map(
          one => html`<li>
            ${heldWords(one)} <button type="button" @click=${() => this.#host.goTo(one.cell)}>Go to cell ${one.id}</button>
          </li>`,
        )}
      </ul>
      <p class="then">
        <button type="button" class="certify" title="For a checker, as JSON" ?disabled=${certified !== null} @click=${() => this.#certify()}>
          ${allProofsWords(heldCount)}
        </button>
        <span class="proofs" role="status">${certified === null ? certificates : 'Proving.'}</span>
        ${
          certified === null
            ? nothing
            : html`<progress aria-label="Proving" max="1" .value=${certified}></progress>
                <button type="button" @click=${() => this.#cancelCertificates()}>Cancel</button>`
        }
      </p>`
  }

  #form({ margin, rings, boundary, distance, complaint, soFar }: Shown): TemplateResult {
    const isChosen = (value: number | null) => value === rings
    return html`<form @submit=${(event: Event) => this.#onSubmit(event)}>
      <label>Where <select @change=${(event: Event) => this.#onWhere(event)}>
          <option value="" .selected=${isChosen(null)}>The whole mesh</option>
          ${Array.from({ length: MOST_RINGS + 1 }, (_, count) => html`<option value=${count} .selected=${isChosen(count)}>${ringWords(count)}</option>`)}
        </select></label>
      <label>The boundary <select @change=${(event: Event) => this.#onBoundary(event)}>
          ${BOUNDARIES.map(({ value, name }) => html`<option value=${value} .selected=${value === boundary}>${name}</option>`)}
        </select></label>
      ${
        boundary === 'within'
          ? html`<label>Distance <input
              name="distance"
              .value=${distance}
              inputmode="decimal"
              autocomplete="off"
              spellcheck="false"
              aria-describedby="untangle-complaint"
              @input=${(event: Event) => this.#set({ ...this.#shown, distance: (event.target as HTMLInputElement).value, complaint: '' })}
          /></label>`
          : nothing
      }
      <label>Relative minima at least <input
          name="margin"
          .value=${margin}
          inputmode="decimal"
          autocomplete="off"
          spellcheck="false"
          aria-invalid=${complaint === '' ? nothing : 'true'}
          aria-describedby="untangle-complaint"
          @input=${(event: Event) => this.#onMargin(event)}
      /></label>
      <button type="submit" class="begin" ?disabled=${soFar !== null}>Untangle</button>
      <p id="untangle-complaint" class="complaint" role="status">${complaint}</p>
    </form>`
  }

  #progress(soFar: UntangledCounts | 'begun'): TemplateResult {
    const [before, after] = soFar === 'begun' ? [1, 1] : [soFar.belowBefore, soFar.belowAfter]
    const words =
      soFar === 'begun'
        ? ''
        : `${after.toLocaleString('en')} of ${before.toLocaleString('en')} cells are left, sweep ${soFar.sweepCount}`
    return html`<p class="then">
      <progress aria-label="Untangling" max=${Math.max(1, before)} .value=${before - after}></progress> <span>${words}</span>
      <button type="button" @click=${() => this.#cancel()}>Cancel</button>
    </p>`
  }

  #onSubmit(event: Event): void {
    event.preventDefault()
    void this.#start()
  }

  #onWhere(event: Event): void {
    const { value } = event.target as HTMLSelectElement
    this.#set({ ...this.#shown, rings: value === '' ? null : Number(value), complaint: '' })
  }

  #onBoundary(event: Event): void {
    const boundary = (event.target as HTMLSelectElement).value as Shown['boundary']
    this.#set({ ...this.#shown, boundary, complaint: '' })
  }

  #onMargin(event: Event): void {
    this.#set({ ...this.#shown, margin: (event.target as HTMLInputElement).value, complaint: '' })
  }
}

/** Null where a distance is wanted and there is none. */
function boundaryOf({ boundary, distance }: Shown): BoundaryMoves | null {
  if (boundary !== 'within') return boundary
  const within = readNumber(distance)
  return within.ok && within.value > 0 ? { within: within.value } : null
}
