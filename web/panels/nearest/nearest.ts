/** The least moves to the other verdict, to preview and to apply. */
import { html, render, type TemplateResult } from 'lit-html'
import type { Report } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import type { Vertices } from '../../model/hexahedron'
import { type State, sliceChange, sliceOf } from '../../model/state'
import { copyable } from '../../views/copyable'
import { isNew } from '../../views/is-new'
import { NumberField } from '../../views/number-field'
import { previewSlice } from '../../views/scene-slices'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { answerTo } from '../panel'
import css from './nearest.css?inline'
import { nearestQuestion, nearestSlice, SHARES } from './nearest-question'
import type { Nearest, NearestAnswer, NearestMove } from './search/nearest'

export const styles = css

class NearestView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  readonly #share = new NumberField({
    name: 'Relative minimum',
    refusalId: 'nearest-refusal',
    onRefusal: () => this.#context.requestFrame(),
    limits: SHARES,
    step: 1 / 8,
    commit: nearestRelativeMinimum => this.#context.dispatch(sliceChange(nearestSlice, { nearestRelativeMinimum })),
  })
  /** The vertices after the last move that was applied. */
  #applied: Vertices | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'nearest'
  }

  update(frame: Frame): void {
    const { state, report } = frame
    const nearest = answerTo(nearestQuestion, frame)
    const { preview } = sliceOf(previewSlice, state)
    if (preview?.move && !state.openPanels.includes('nearest')) this.#preview(null)
    const share = sliceOf(nearestSlice, state).nearestRelativeMinimum
    this.#share.show(share)
    const known = nearest?.vertices === state.vertices && nearest.share === share ? nearest : null
    const isMoving = state.gestureStart !== null
    const { refusal } = this.#share
    const goal = goalOf(report, known, share)
    if (isNew(this.root, goal?.words, known, share, refusal, isMoving, preview, this.#applied === state.vertices))
      render(this.#template(goal, isMoving, known, state), this.root)
  }

  dispose(): void {
    this.#preview(null)
  }

  #template(goal: Goal | null, isMoving: boolean, nearest: Nearest | null, state: State): TemplateResult {
    return html`<label class="wanted">Relative minimum of a valid element, at least ${this.#share.input}</label>
      <p id="nearest-refusal" class="says" aria-live="polite">${this.#share.refusal}</p>
      <p tabindex="-1" class="answer">${this.#answer(goal, isMoving, state)}</p>
      ${goal === null || isMoving ? '' : [this.#moves(goal, nearest, state), this.#each(goal, nearest, state)]}`
  }

  #answer(goal: Goal | null, isMoving: boolean, { vertices }: State): string {
    if (goal === null) return 'There is no verdict, so there is none to change.'
    if (isMoving) return 'The search starts when this change is done.'
    const applied = this.#applied === vertices ? 'The move is applied. Undo takes it back. ' : ''
    return `${applied}What is the smallest move that makes this element ${goal.words}?`
  }

  #moves(goal: Goal, nearest: Nearest | null, state: State): TemplateResult {
    return html`<dl>
      <div>
        <dt>One vertex</dt>
        <dd>${nearest?.ofOne === undefined ? LOOKING : this.#best(nearest.ofOne, goal, nearest, state)}</dd>
      </div>
      <div>
        <dt>All eight</dt>
        <dd>${nearest?.ofAll === undefined ? LOOKING : this.#all(nearest.ofAll, state)}</dd>
      </div>
    </dl>`
  }

  #best(one: NearestMove | null, goal: Goal, { ofVertex }: Nearest, state: State): TemplateResult {
    if (one === null) {
      const isCertain = ofVertex.every(answer => answer === 'impossible')
      return html`<p>
        ${
          isCertain
            ? `No vertex alone can make it ${goal.words}, wherever it goes.`
            : `No move of one vertex was found that makes it ${goal.words}.`
        }
      </p>`
    }
    return html`<p>Vertex ${one.vertex} by <b>${lengthOf(one.length)}</b></p>
      ${claim(one)}${this.#buttons(one, `vertex ${one.vertex}`, state)}`
  }

  #all(move: NearestAnswer, state: State): TemplateResult {
    if (move === null || move === 'impossible') return html`<p>No such move of all eight vertices was found.</p>`
    return html`<p>Together by <b>${lengthOf(move.length)}</b>, the farthest by ${lengthOf(move.longest)}</p>
      ${claim(move)}${this.#buttons(move, 'all eight', state)}`
  }

  #buttons(move: NearestMove, what: string, state: State): TemplateResult {
    const isOpen = sliceOf(previewSlice, state).preview?.move === move.vertices
    return html`<p class="go">
      <button
        type="button"
        aria-label=${`Preview the move of ${what}`}
        aria-pressed=${isOpen}
        @click=${() => this.#preview(isOpen ? null : move.vertices)}
      >
        Preview
      </button>
      <button type="button" aria-label=${`Apply the move of ${what}`} @click=${() => this.#apply(move)}>Apply</button>
    </p>`
  }

  #each(goal: Goal, nearest: Nearest | null, state: State): TemplateResult {
    return html`<details>
        <summary>Each vertex alone</summary>
        <ol start="0">
          ${(nearest?.ofVertex ?? []).map((answer, vertex) => this.#row(answer, vertex, state))}
        </ol>
      </details>
      <details>
        <summary>What these lengths are, and what is certain</summary>
        <p>
          A length is Euclidean: the square root of the sum of the squared changes of all coordinates. For one vertex it is how far
          the vertex moves.
        </p>
        <p>
          The verdicts are exact on both sides. On the straight way to the element found, the place one double before it is still
          ${goal.before}. If this element itself is on the border, the two places are at most 2⁻⁶⁴ of the way apart.
        </p>
        <p>
          The relative minimum is the least jacdet over the volume: 1 of a box, near 0 where an element is just valid. An element
          found certainly has what is asked for.
        </p>
        <p>
          If one vertex moves, jacdet at each point changes linearly with it. So the places that make a valid element form a convex set.
          The nearest of them is found, with a bound for all others. If all vertices move, there is a bound, too. If the bound is
          smaller than the move, quite different moves may be shorter.
        </p>
      </details>`
  }

  #row(answer: NearestAnswer, vertex: number, state: State): TemplateResult {
    if (answer === 'impossible') return html`<li><span>Vertex ${vertex}</span> <span class="says">cannot</span></li>`
    if (answer === null) return html`<li><span>Vertex ${vertex}</span> <span class="says">none was found</span></li>`
    return html`<li>
      <span>Vertex ${vertex}</span>
      <span>${lengthOf(answer.length)}</span>
      ${this.#buttons(answer, `vertex ${vertex} alone`, state)}
    </li>`
  }

  #preview(move: Vertices | null): void {
    this.#context.dispatch(sliceChange(previewSlice, { preview: move && { move } }))
  }

  /** One step to undo. What is said is new, so the focus moves there. */
  #apply({ vertices }: NearestMove): void {
    this.#context.dispatch({ type: 'move-all', vertices })
    this.#applied = this.#context.state().vertices
    this.root.querySelector<HTMLElement>('.answer')?.focus({ preventScroll: true })
  }
}

const LOOKING = html`<p class="says">looking…</p>`

interface Goal {
  /** "to make this element …" */
  readonly words: string
  /** "the place before it still …" */
  readonly before: string
}

function goalOf(report: Report | null, nearest: Nearest | null, share: number): Goal | null {
  if (report === null) return null
  const isMet = nearest?.isMet ?? (report.valid && (report.relativeMinimum ?? 0) >= share)
  if (isMet) return { words: 'invalid', before: 'valid' }
  return share === 0
    ? { words: 'valid', before: 'invalid' }
    : {
        words: `valid with a relative minimum of ${formatNumber(share)}`,
        before: 'without it, or not certain to have it',
      }
}

function lengthOf(length: number): TemplateResult {
  return copyable(formatNumber(length), String(length))
}

function claim({ claim: known, bound }: NearestMove): TemplateResult {
  const least = bound > 0 ? html` None shorter than ${lengthOf(bound)} is enough.` : ''
  switch (known) {
    case 'least':
      return html`<p class="says">As short as any such move can be, to one part in a million.</p>`
    case 'local':
      return html`<p class="says">A local optimum: no small change of this move makes it shorter.${least}</p>`
    case 'found':
      return html`<p class="says">The shortest move found. A shorter one may exist.${least}</p>`
  }
}

export const create: CreateView = context => new NearestView(context)
