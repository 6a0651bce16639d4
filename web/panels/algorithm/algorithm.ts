/** Algorithm 1 step by step: the points of each, M before and after, and the reasons to skip. */
import { html, nothing, render, svg, type TemplateResult } from 'lit-html'
import { sliceChange, sliceOf } from '../../model/state'
import { copyableJacdet } from '../../views/copyable'
import { entityTitle } from '../../views/entity-name'
import { type Entity, marksSlice } from '../../views/scene-slices'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import css from './algorithm.css?inline'
import { type Following, followingSlice, type Query, STEP_COUNT, type Variant } from './following'
import { minimumPlot } from './minimum-plot'
import { answerSentence, jacdet, stepOutcome, stepSentence, type TraceShown } from './step-text'
import { type TraceStep, traceOf } from './trace'

export const styles = css

const STEP_MS = 800
/** Vertices, edges and faces. */
const PHASES = [8, 12, 6]
const PLOT = { width: 312, height: 44 }

class AlgorithmView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  readonly #lessMotion = matchMedia('(prefers-reduced-motion: reduce)')
  readonly #listening = new AbortController()
  /** The step that is shown. */
  #at = 0
  #timer: ReturnType<typeof setTimeout> | undefined
  #steps: readonly TraceStep[] = []
  /** Screen readers hear the step that the reader went to, not those of a drag or the clock. */
  #said = ''
  #lit: Entity | null = null
  #shown: TraceShown | null = null
  #drawn: readonly unknown[] = []

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'algorithm'
    const { signal } = this.#listening
    this.#lessMotion.addEventListener('change', () => this.#onLessMotion(), { signal })
  }

  update({ state, report }: Frame): void {
    if (report === null || !state.openPanels.includes('algorithm')) {
      this.#pause()
      this.#light(null)
      if (report === null) render(html`<p>${say('There is no report to follow.')}</p>`, this.root)
      return
    }
    if (this.#drawn[0] !== report) this.#pause()
    const { following } = sliceOf(followingSlice, state)
    const drawn = [report, state.referenceCube, following, this.#timer, this.#said]
    if (drawn.every((value, i) => value === this.#drawn[i]) && this.#lit !== null) return
    const { query, variant, step } = following
    const shown = { report, cube: state.referenceCube, query, variant }
    this.#shown = shown
    this.#steps = traceOf(report, shown)
    const before = this.#at
    this.#at = Math.min(step, this.#steps.length - 1)
    this.#light(this.#current)
    render(this.#template(shown), this.root)
    if (this.#drawn.length === 0 || before !== this.#at) this.#showCurrent()
    this.#drawn = drawn
  }

  dispose(): void {
    this.#listening.abort()
    clearTimeout(this.#timer)
    this.#light(null)
  }

  get #following(): Following {
    return sliceOf(followingSlice, this.#context.state()).following
  }

  /** The step that the next action starts from, which may be ahead of the one that is drawn. */
  get #now(): number {
    return Math.min(this.#following.step, this.#steps.length - 1)
  }

  get #current(): TraceStep {
    return this.#steps[this.#at] as TraceStep
  }

  get #isLast(): boolean {
    return this.#at >= this.#steps.length - 1
  }

  #template(shown: TraceShown): TemplateResult {
    const step = this.#current
    return html`${this.#choices(shown)}
      <p class="sentence">${signedNumbers(stepSentence(step, shown))} ${this.#isLast ? html`<span>${signedNumbers(answerSentence(step, shown))}</span>` : ''}</p>
      <p class="said" aria-live="polite">${this.#said}</p>
      <div class="go" role="group" aria-label=${say('Steps')}>
        ${this.#button(say('First'), this.#at > 0, () => this.#go(0))}
        ${this.#button(say('Back'), this.#at > 0, () => this.#go(this.#now - 1))}
        ${
          this.#lessMotion.matches
            ? nothing
            : html`<button type="button" @click=${() => this.#toggle()}>${this.#timer === undefined ? say('Play') : say('Pause')}</button>`
        }
        ${this.#button(say('Forward'), !this.#isLast, () => this.#go(this.#now + 1))}
        ${this.#button(say('Last'), !this.#isLast, () => this.#go(this.#steps.length - 1))}
        <span>${say('{number} of {count}', { number: this.#at + 1, count: this.#steps.length })}</span>
      </div>
      ${this.#plot(shown)}
      <ol aria-label=${say('All steps')} @keydown=${(event: KeyboardEvent) => this.#onKey(event)}>
        ${this.#steps.map((each, i) => this.#row(each, i, shown))}
      </ol>`
  }

  #choices({ query, variant }: TraceShown): TemplateResult {
    return html`<p class="choices">
      <label>
        <span>${say('Find')}</span>
        <select class="on-paper" @change=${(event: Event) => this.#choose({ query: chosen(event) as Query })}>
          <option value="minimum" ?selected=${query === 'minimum'}>${say('the minimum')}</option>
          <option value="validity" ?selected=${query === 'validity'}>${say('only whether it is valid')}</option>
        </select>
      </label>
      <label>
        <span>${say('by')}</span>
        <select class="on-paper" @change=${(event: Event) => this.#choose({ variant: chosen(event) as Variant })}>
          <option value="roots-b" ?selected=${variant === 'roots-b'}>Roots+B</option>
          <option value="roots" ?selected=${variant === 'roots'}>Roots</option>
        </select>
      </label>
      <span class="means">${variant === 'roots' ? say('Every face’s quartic is solved.') : say('Faces that their Bernstein bounds rule out are skipped.')}</span>
    </p>`
  }

  /** `disabled` would take the focus from the button just pressed. */
  #button(name: string, isEnabled: boolean, go: () => void): TemplateResult {
    return html`<button type="button" aria-disabled=${!isEnabled} @click=${() => isEnabled && go()}>${name}</button>`
  }

  #row(step: TraceStep, i: number, shown: TraceShown): TemplateResult {
    const isCurrent = i === this.#at
    const value = stepOutcome(step, shown)
    return html`<li>
      <button
        type="button"
        class="row on-paper"
        tabindex=${isCurrent ? 0 : -1}
        aria-current=${isCurrent ? 'step' : nothing}
        @click=${() => this.#go(i)}
      >
        <span>${entityTitle(step)}</span>
        <span class=${step.value === null ? 'none' : step.value < 0 ? 'negative' : ''}>${value}</span>
        <span class="new">${step.stops ? say('stops') : step.after === step.before ? '' : say('new M')}</span>
      </button>
    </li>`
  }

  #plot(shown: TraceShown): TemplateResult {
    const { width, height } = PLOT
    const { path, marks, zero } = minimumPlot(this.#steps, STEP_COUNT, PLOT)
    const mark = marks[this.#at]
    const m = this.#current.after
    const ends = PHASES.map((_, i) => PHASES.slice(0, i + 1).reduce((a, b) => a + b) / STEP_COUNT)
    const [first, last] = [this.#steps[0]?.after ?? null, this.#steps.at(-1)?.after ?? null]
    const name = say('M over the steps, from {first} down to {last}', {
      first: jacdet(first, shown),
      last: jacdet(last, shown),
    })
    return html`<figure>
      <figcaption><span>M = ${m === null ? '' : copyableJacdet(m, shown.report.exponent, shown.cube)}</span></figcaption>
      <svg viewBox="-4 -6 ${width + 8} ${height + 12}" role="img" aria-label=${name}>
        ${ends.slice(0, -1).map(share => svg`<path class="phase" d="M${share * width} -4V${height + 4}" />`)}
        ${zero === null ? nothing : svg`<path class="zero" d="M0 ${zero}H${width}" />`}
        <path class="stairs" d=${path} />
        <circle cx=${mark?.x ?? 0} cy=${mark?.y ?? 0} r="3.5" />
      </svg>
      <p class="phases" aria-hidden="true"><span>${say('8 vertices')}</span><span>${say('12 edges')}</span><span>${say('6 faces')}</span></p>
    </figure>`
  }

  #onLessMotion(): void {
    this.#pause()
    this.#drawn = []
    this.#context.requestFrame()
  }

  #choose(choice: Partial<Following>): void {
    this.#pause()
    this.#said = ''
    this.#follow(choice)
  }

  /** Ends playing: the reader goes there. */
  #go(to: number): void {
    this.#pause()
    const step = Math.max(0, Math.min(this.#steps.length - 1, to))
    if (this.#shown) this.#said = stepSentence(this.#steps[step] as TraceStep, this.#shown)
    this.#follow({ step })
  }

  #follow(change: Partial<Following>): void {
    this.#context.dispatch(sliceChange(followingSlice, { following: { ...this.#following, ...change } }))
  }

  #toggle(): void {
    if (this.#timer !== undefined) this.#pause()
    else {
      if (this.#now >= this.#steps.length - 1) this.#follow({ step: 0 })
      this.#said = ''
      this.#timer = setTimeout(() => this.#advance(), STEP_MS)
    }
    this.#context.requestFrame()
  }

  #advance(): void {
    const step = this.#now + 1
    const isLast = step >= this.#steps.length - 1
    this.#timer = isLast ? undefined : setTimeout(() => this.#advance(), STEP_MS)
    this.#follow({ step })
  }

  #pause(): void {
    clearTimeout(this.#timer)
    this.#timer = undefined
  }

  /** Dispatches a new entity only, so that other views may highlight theirs in between. */
  #light(entity: Entity | null): void {
    if (entity?.kind === this.#lit?.kind && entity?.id === this.#lit?.id) return
    this.#lit = entity && { kind: entity.kind, id: entity.id }
    this.#context.dispatch(sliceChange(marksSlice, { highlight: this.#lit }))
  }

  #onKey(event: KeyboardEvent): void {
    const to = { ArrowUp: this.#now - 1, ArrowDown: this.#now + 1, Home: 0, End: this.#steps.length - 1 }[event.key]
    if (to === undefined || event.altKey || event.ctrlKey || event.metaKey) return
    event.preventDefault()
    this.#go(to)
  }

  /** Scrolls the list, and the page only if the focus is in the list; then the focus goes along. */
  #showCurrent(): void {
    const list = this.root.querySelector('ol') as HTMLOListElement
    const row = list.children[this.#at] as HTMLElement
    const [top, bottom] = [row.offsetTop, row.offsetTop + row.offsetHeight]
    if (top < list.scrollTop) list.scrollTop = top
    else if (bottom > list.scrollTop + list.clientHeight) list.scrollTop = bottom - list.clientHeight
    if (list.querySelector(':focus')) row.querySelector('button')?.focus()
  }
}

function chosen(event: Event): string {
  return (event.target as HTMLSelectElement).value
}

/** Negative numbers in the hue of negative jacdets; nothing else here has a minus sign. */
function signedNumbers(text: string): (TemplateResult | string)[] {
  return text
    .split(/(−\d\S*?(?=[,;:.]?(?:\s|$)))/)
    .map((text, i) => (i % 2 === 1 ? html`<span class="negative">${text}</span>` : text))
}

export const create: CreateView = context => new AlgorithmView(context)
