/** Untangling on the page Mesh: what is asked for, how far it is, what would move, drawn as lines before it is taken as one step. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { UntangledCounts } from '../../core/repair/untangling'
import { wordsOf } from '../../core/workers'
import { formatNumber } from '../../model/decimal'
import { readNumber } from '../../model/number-text'
import type { OpenSurvey } from '../../survey/open-survey'
import { startUntangling } from '../../survey/start-untangling'
import type { Moves, Overview } from '../../survey/survey-jobs'
import type { GhostLines, PartUntangled } from '../../survey/untangled-part'

export interface UntangleHost {
  /** Null where no mesh is open. */
  survey(): OpenSurvey | null
  chosen(): number | null
  /** Lines over the picture; null for none. */
  ghost(lines: GhostLines | null): void
  take(moves: Moves): void
  goTo(cell: number): void
}

interface Shown {
  readonly overview: Overview | null
  /** Why it cannot be untangled; empty if it can. */
  readonly whyNot: string
  readonly margin: string
  /** Rings of cells around the chosen one; null for the whole mesh. */
  readonly rings: number | null
  readonly complaint: string
  readonly soFar: UntangledCounts | 'begun' | null
  readonly result: PartUntangled | null
  readonly message: string
  /** Cells that are still held, after it was taken. */
  readonly held: Uint32Array | null
}

const MOST_RINGS = 5
const FIRST: Shown = {
  overview: null,
  whyNot: '',
  margin: '0.1',
  rings: null,
  complaint: '',
  soFar: null,
  result: null,
  message: '',
  held: null,
}

export class UntanglePanel {
  /** Shows and hides the panel. */
  readonly button = document.createElement('button')
  readonly root = document.createElement('section')
  readonly #host: UntangleHost
  #shown = FIRST
  #running: AbortController | null = null
  #nextHeld = 0

  constructor(host: UntangleHost) {
    this.#host = host
    this.button.type = 'button'
    this.button.textContent = 'Untangle'
    this.button.setAttribute('aria-controls', 'untangle')
    this.button.addEventListener('click', () => this.#open(Boolean(this.root.hidden)))
    this.root.className = 'untangle'
    this.root.id = 'untangle'
    this.root.setAttribute('aria-label', 'Untangle')
    this.root.addEventListener('keydown', event => {
      if (event.key !== 'Escape') return
      this.#open(false)
      this.button.focus()
    })
    this.#open(false)
    this.button.hidden = true
  }

  /** Another mesh, or none. */
  open(overview: Overview | null, whyNot: string): void {
    this.#stop()
    this.button.hidden = overview === null
    this.#open(false)
    this.#set({ ...FIRST, overview, whyNot })
  }

  /** The same mesh with vertices elsewhere: what was found for it before holds no more. */
  moved(overview: Overview): void {
    const { result, soFar } = this.#shown
    const isOutdated = result !== null || soFar !== null
    this.#stop()
    const message = isOutdated ? 'The mesh has changed: untangle it again.' : this.#shown.message
    this.#set({ ...this.#shown, overview, result: null, soFar: null, message })
  }

  #open(isOpen: boolean): void {
    this.root.hidden = !isOpen
    this.button.setAttribute('aria-expanded', String(isOpen))
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
    if (!margin.ok || !(margin.value >= 0 && margin.value <= 1))
      return this.#set({ ...this.#shown, complaint: 'The least relative minimum is a number from 0 to 1.' })
    if (rings !== null && chosen === null) return this.#set({ ...this.#shown, complaint: 'No cell is chosen.' })
    const survey = this.#host.survey()
    if (!survey) return
    this.#stop()
    const running = new AbortController()
    this.#running = running
    this.#set({ ...this.#shown, complaint: '', message: '', result: null, held: null, soFar: 'begun' })
    try {
      const part = await survey.tangled(rings === null ? null : { cell: chosen as number, rings })
      const onProgress = (soFar: UntangledCounts) => running === this.#running && this.#set({ ...this.#shown, soFar })
      const result = await startUntangling({ part, margin: margin.value }, onProgress, running.signal)
      if (running === this.#running) this.#took(result, text)
    } catch (reason) {
      if (running === this.#running) this.#set({ ...this.#shown, soFar: null, message: wordsOf(reason) })
    }
  }

  #took(result: PartUntangled | { readonly refused: string }, margin: string): void {
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
      held: hasMoved ? null : result.heldCells,
      message: resultSentences(result, margin).join(' '),
    })
    this.#nextHeld = 0
    this.#host.ghost(hasMoved ? result.ghost : null)
  }

  #cancel(): void {
    this.#stop()
    this.#set({ ...this.#shown, soFar: null, message: 'Cancelled: nothing has moved.' })
  }

  #take(): void {
    const { result } = this.#shown
    if (!result) return
    this.#host.ghost(null)
    this.#set({ ...this.#shown, result: null, held: result.heldCells })
    this.#host.take(result.moves)
    this.root.querySelector<HTMLElement>('.begin')?.focus()
  }

  #leave(): void {
    this.#host.ghost(null)
    this.#set({ ...this.#shown, result: null, message: 'Left as it was: nothing has moved.' })
    this.root.querySelector<HTMLElement>('.begin')?.focus()
  }

  #goToHeld(held: Uint32Array): void {
    this.#host.goTo(held[this.#nextHeld++ % held.length] as number)
  }

  #set(shown: Shown): void {
    this.#shown = shown
    render(this.#template(shown), this.root)
  }

  #template({ overview, whyNot, soFar, result, message, held }: Shown): TemplateResult | typeof nothing {
    if (!overview) return nothing
    if (whyNot !== '') return html`<p>${whyNot}</p>`
    return html`<p class="about">
        Moves vertices, one after the other, to where their worst cell is best. The boundary of the hexahedra stays. It knows no geometry
        but what stays, and a mesh whose topology forbids validity stays invalid.
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
      ${
        held && held.length > 0
          ? html`<p class="then"><button type="button" @click=${() => this.#goToHeld(held)}>Next cell that is held</button></p>`
          : nothing
      }`
  }

  #form({ margin, rings, complaint, soFar }: Shown): TemplateResult {
    const isChosen = (value: number | null) => value === rings
    return html`<form @submit=${(event: Event) => this.#onSubmit(event)}>
      <label>Where <select @change=${(event: Event) => this.#onWhere(event)}>
          <option value="" .selected=${isChosen(null)}>The whole mesh</option>
          ${Array.from({ length: MOST_RINGS + 1 }, (_, count) => html`<option value=${count} .selected=${isChosen(count)}>${ringWords(count)}</option>`)}
        </select></label>
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

  #onMargin(event: Event): void {
    this.#set({ ...this.#shown, margin: (event.target as HTMLInputElement).value, complaint: '' })
  }
}

function ringWords(count: number): string {
  if (count === 0) return 'The chosen cell'
  return `The chosen cell and ${count} ${count === 1 ? 'ring' : 'rings'} around it`
}

function linesWords({ ends, wanted }: GhostLines): string {
  const drawn = ends.length / 6
  return drawn === wanted
    ? ''
    : `: the ${drawn.toLocaleString('en')} that move farthest, of ${wanted.toLocaleString('en')}`
}

/** What was repaired, what moves and how far, what is left and why. */
export function resultSentences(
  { counts, heldCells }: Pick<PartUntangled, 'counts' | 'heldCells'>,
  margin: string,
): string[] {
  const {
    invalidBefore,
    invalidAfter,
    belowBefore,
    belowAfter,
    movedCount,
    greatestDistance,
    meanDistance,
    tooManyCount,
  } = counts
  const many = (count: number, one: string, more: string) => `${count.toLocaleString('en')} ${count === 1 ? one : more}`
  if (belowBefore === 0) return [`All relative minima are ${margin} at least: there is nothing to do.`]
  if (movedCount === 0) return ['No vertex has a better place.', ...whyLeft()]
  const repaired = invalidBefore - invalidAfter
  const first =
    invalidBefore === 0
      ? `${many(belowBefore - belowAfter, 'cell reaches', 'cells reach')} ${margin}.`
      : `${repaired.toLocaleString('en')} of ${many(invalidBefore, 'invalid cell', 'invalid cells')} would be valid.`
  const far = `${many(movedCount, 'vertex moves', 'vertices move')}, by ${formatNumber(meanDistance)} on average and ${formatNumber(greatestDistance)} at most.`
  return [first, far, ...(belowAfter === 0 ? [`All reach ${margin}.`] : whyLeft())]

  function whyLeft(): string[] {
    const left = `${many(belowAfter, 'cell stays', 'cells stay')} below ${margin}, ${invalidAfter.toLocaleString('en')} of them invalid`
    const why =
      heldCells.length === 0
        ? 'all of their vertices stay'
        : 'each vertex that may move has no better place while the others stay'
    const more =
      tooManyCount === 0 ? '' : ` ${many(tooManyCount, 'vertex has', 'vertices have')} more cells than are looked at.`
    return [`${left}: ${why}.${more}`]
  }
}
