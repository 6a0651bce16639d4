/** The time steps of an open mesh: a slider that shows one, and the line of the least relative minimum over all, read one after the other. */
import { html, nothing, render, svg, type TemplateResult } from 'lit-html'
import { wordsOf } from '../../core/workers'
import type { ReadingProgress } from '../../input/reading'
import { besideSentences, firstInvalid, lineSentence, type StepAnswer, timeWords } from '../../mesh/step-answers'
import { formatNumber } from '../../model/decimal'
import type { OpenSurvey } from '../../survey/open-survey'
import type { Opening, StepList, StepOpening } from '../../survey/survey-jobs'
import { type StepLine, stepLineOf, stepWords } from './step-line'

export interface StepsHost {
  /** The cell that is chosen. */
  chosen(): number | null
  /** Shows a step that was opened in the place of another, unless another mesh is open. */
  show(survey: OpenSurvey, opening: Extract<StepOpening, { opened: unknown }>): Promise<void>
  /** The mesh of all files. */
  take(opening: Opening): Promise<void>
  goTo(cell: number): Promise<void>
}

const WIDTH = 640
const HEIGHT = 64

export class StepsView {
  readonly #root: HTMLElement
  readonly #host: StepsHost
  #survey: OpenSurvey | null = null
  #list: StepList | null = null
  #answers: readonly (StepAnswer | null)[] = []
  #shown = 0
  #wanted = 0
  #showing: Promise<void> | null = null
  /** The step that is being read for the line, and how far. */
  #reading: { readonly step: number; readonly fraction: number } | null = null
  /** How far the step is that is being opened. */
  #opening = 0
  #refused = ''

  constructor(root: HTMLElement, host: StepsHost) {
    this.#root = root
    this.#host = host
  }

  /** Another mesh, with steps or without. */
  async open(survey: OpenSurvey): Promise<void> {
    this.#survey = survey
    this.#list = null
    this.#reading = null
    this.#showing = null
    this.#refused = ''
    this.#render()
    const list = await survey.steps()
    if (list === null || survey !== this.#survey) return
    this.#list = list
    this.#answers = list.steps.map((_, step) => (step === list.shown ? list.answer : null))
    this.#shown = list.shown
    this.#wanted = list.shown
    this.#render()
  }

  /** True if the open mesh has several time steps. */
  get hasSteps(): boolean {
    return this.#list !== null
  }

  /** Reads the steps that have not been read, until it is cancelled. */
  async readAll(): Promise<void> {
    const [survey, list] = [this.#survey, this.#list]
    if (!survey || !list || this.#reading) return
    for (const step of list.steps.keys()) {
      if (this.#answers[step] !== null) continue
      const reading = { step, fraction: 0 }
      this.#reading = reading
      this.#render()
      const isOurs = () => list === this.#list && this.#reading?.step === step
      const onProgress = (progress: ReadingProgress) => {
        if (!isOurs()) return
        this.#reading = { step, fraction: shareOf(progress) }
        this.#render()
      }
      const answer = await survey.readStep(step, onProgress).catch(refusal)
      if (list !== this.#list) return
      if ('missing' in answer) {
        this.#refused = answer.refused
        this.#reading = null
      } else this.#answers = this.#answers.with(step, answer)
      if (!isOurs()) return this.#render()
    }
    this.#reading = null
    this.#render()
  }

  #cancel(): void {
    this.#reading = null
    this.#render()
  }

  /** Of steps that are asked for while one is opened, the last is shown. */
  #show(step: number): Promise<void> {
    this.#wanted = step
    this.#refused = ''
    this.#showing ??= this.#showWanted()
    this.#render()
    return this.#showing
  }

  async #showWanted(): Promise<void> {
    const [survey, list] = [this.#survey, this.#list]
    while (survey && this.#wanted !== this.#shown) {
      const step = this.#wanted
      this.#opening = 0
      const onProgress = (progress: ReadingProgress) => {
        if (list !== this.#list) return
        this.#opening = shareOf(progress)
        this.#render()
      }
      const opening = await survey.showStep({ step, chosen: this.#host.chosen() }, onProgress).catch(refusal)
      if (list !== this.#list) return
      if ('refused' in opening) {
        this.#refused = opening.refused
        if (this.#wanted === step) this.#wanted = this.#shown
      } else {
        this.#shown = step
        this.#answers = this.#answers.with(step, opening.answer)
        await this.#host.show(survey, opening)
        if (list !== this.#list) return
      }
      this.#render()
    }
    this.#showing = null
  }

  async #goToFirst({ step, worst }: StepAnswer): Promise<void> {
    const list = this.#list
    await this.#show(step)
    if (worst && list === this.#list && this.#shown === step) await this.#host.goTo(worst.cell)
  }

  async #together(): Promise<void> {
    const [survey, list] = [this.#survey, this.#list]
    this.#reading = null
    this.#render()
    const opening = await survey?.together(() => {}).catch(refusal)
    if (!opening || list !== this.#list) return
    if ('refused' in opening) {
      this.#refused = opening.refused
      this.#render()
    } else await this.#host.take(opening)
  }

  #render(): void {
    this.#root.hidden = this.#list === null
    render(this.#list ? this.#template(this.#list) : nothing, this.#root)
  }

  #template(list: StepList): TemplateResult {
    const line = stepLineOf(list, this.#answers)
    const first = firstInvalid(this.#answers)
    const words = stepWords(list, this.#answers, this.#wanted)
    const sentence = lineSentence(list, this.#answers)
    // While steps are read it changes with each: it is read out when all are.
    const isRead = !this.#answers.includes(null)
    const isWaiting = this.#wanted !== this.#shown
    return html`${line ? this.#chart(list, line) : html`<div></div>`}
      <div class="words">
        <p class="slide">
          <input
            type="range"
            aria-label="Time step"
            min="1"
            max=${list.steps.length}
            step="1"
            .value=${String(this.#wanted + 1)}
            aria-valuetext=${words}
            @input=${(event: Event) => this.#show(Number((event.target as HTMLInputElement).value) - 1)}
          /><span class="now"
            >${words}
            ${isWaiting ? html`<progress max="1" aria-label=${`Opening step ${this.#wanted + 1}`} .value=${this.#opening}></progress>` : nothing}</span
          >
        </p>
        <p>
          <span role="status">${isRead ? sentence : ''} ${this.#refused}</span> ${isRead ? '' : sentence}
          ${first ? html`<button type="button" @click=${() => this.#goToFirst(first)}>Show it</button>` : nothing}
        </p>
        ${this.#progress(list)}
        <p class="beside">
          ${[...list.sentences, ...besideSentences(list, this.#answers)].join(' ')}
          ${list.areFiles ? html`<button type="button" @click=${() => this.#together()}>Take them together</button>` : nothing}
        </p>
      </div>`
  }

  #progress(list: StepList): TemplateResult | typeof nothing {
    if (this.#reading) {
      const { step, fraction } = this.#reading
      const read = this.#answers.filter(answer => answer !== null).length
      return html`<p class="progress">
        <label>Reading step ${step + 1} of ${list.steps.length} <progress max=${list.steps.length} .value=${read + fraction}></progress></label>
        <button type="button" @click=${() => this.#cancel()}>Cancel</button>
      </p>`
    }
    if (!this.#answers.includes(null)) return nothing
    const read = this.#answers.filter(answer => answer !== null).length
    return html`<p class="progress">
      ${read} of ${list.steps.length} steps are read.
      <button type="button" @click=${() => this.readAll()}>Read the others</button>
    </p>`
  }

  #chart(list: StepList, line: StepLine): TemplateResult {
    const { places, runs, zero, least, greatest, isByTime } = line
    const at = (x: number, y: number) => `${(WIDTH * x).toFixed(1)} ${(HEIGHT * y).toFixed(1)}`
    const onDown = (event: PointerEvent) => {
      const box = (event.currentTarget as Element).getBoundingClientRect()
      const x = (event.clientX - box.left) / box.width
      const distances = places.map(place => Math.abs(place - x))
      void this.#show(distances.indexOf(Math.min(...distances)))
    }
    const dots = (isInvalid: boolean) =>
      runs
        .flat()
        .filter(point => point.isInvalid === isInvalid)
        .map(({ x, y }) => `M${at(x, y)}h0`)
        .join('')
    const times = [0, list.steps.length - 1].map(step => list.steps[step]?.time ?? this.#answers[step]?.time)
    const end = (index: 0 | 1) =>
      isByTime ? `t = ${timeWords(times[index] ?? '')}` : `step ${index === 0 ? 1 : list.steps.length}`
    const range = least === greatest ? formatNumber(least) : `from ${formatNumber(least)} to ${formatNumber(greatest)}`
    return html`<figure class="line">
      <div class="plot">
      <svg
        viewBox=${`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label=${`Least relative minimum over the steps, ${range}. ${lineSentence(list, this.#answers)}`}
        @pointerdown=${onDown}
      >
        ${svg`<path class="zero" d=${`M${at(0, zero)}H${WIDTH}`}></path>
        <path class="shown" d=${`M${at(places[this.#wanted] as number, 0)}V${HEIGHT}`}></path>
        ${runs.map(run => svg`<path class="run" d=${`M${run.map(({ x, y }) => at(x, y)).join('L')}`}></path>`)}
        <path class="dots" d=${dots(false)}></path>
        <path class="dots invalid" d=${dots(true)}></path>`}
      </svg>
      <span class="zero-mark" .style=${`top: ${100 * zero}%`} aria-hidden="true">0</span>
      </div>
      <figcaption><span>${end(0)}</span><span>Least relative minimum, ${range}${least < -1 ? ', logarithmic below −1' : ''}</span><span>${end(1)}</span></figcaption>
    </figure>`
  }
}

/** Of reading and deciding together, which take about as long. */
function shareOf({ step, fraction }: ReadingProgress): number {
  return step === 'deciding' ? (1 + fraction) / 2 : fraction / 2
}

/** The worker has ended. */
function refusal(reason: unknown): { readonly refused: string; readonly missing: readonly string[] } {
  return { refused: wordsOf(reason), missing: [] }
}
