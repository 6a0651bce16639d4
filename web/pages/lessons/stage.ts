/** What stands beside the column: the lens in a step with a hexahedron, the plane in one with a quadrilateral, nothing on the overview. */
import type { Report } from '../../core/report'
import type { Vertices } from '../../model/hexahedron'
import type { HistoryDocument } from '../../model/history-document'
import type { StateDocument } from '../../model/state-document'
import { scrollToTop } from '../scroll'
import { type HexahedronStep, isInPlane, type LessonStep } from './content/lessons'
import { Plane } from './plane/plane'
import { planeState, shownStep, stateOf, verticesOf } from './step-state'

type Lens = HTMLElementTagNameMap['hex-lens']

export class Stage {
  readonly #main: HTMLElement
  readonly #lens: Lens
  readonly #plane: Plane
  #shows: 'lens' | 'plane' | 'overview' = 'lens'

  /** `onChange` is called when there are other vertices or another report, `onPress` when a corner is pressed as an answer. */
  constructor(main: HTMLElement, lens: Lens, onChange: () => void, onPress: (corner: number) => void) {
    this.#main = main
    this.#lens = lens
    const root = main.querySelector('.plane') as HTMLElement
    this.#plane = new Plane(root, { analyze: vertices => lens.analyze(vertices), onChange, onPress })
    for (const type of ['hex-input', 'hex-change', 'hex-verdict']) lens.addEventListener(type, onChange)
  }

  /** Its box is what the column's steps stand beside or below. */
  get element(): HTMLElement {
    return this.#shows === 'plane' ? this.#plane.root : this.#lens
  }

  get vertices(): Vertices {
    return this.#shows === 'plane' ? this.#plane.vertices : this.#lens.vertices
  }

  get report(): Report | null {
    return this.#shows === 'plane' ? this.#plane.report : this.#lens.report
  }

  get state(): StateDocument {
    return this.#shows === 'plane' ? planeState(this.#plane.vertices) : this.#lens.state
  }

  /** Throws if it is none. The plane has nothing that is not in its history. */
  set state(state: StateDocument) {
    if (this.#shows === 'lens') this.#lens.state = state
  }

  get history(): HistoryDocument {
    return this.#shows === 'plane' ? this.#plane.history : this.#lens.history
  }

  /** Throws if it is none. */
  set history(history: HistoryDocument) {
    if (this.#shows === 'plane') this.#plane.history = history
    else this.#lens.history = history
  }

  /** The step as it begins; null is the overview. */
  show(step: LessonStep | null, isAsked: boolean): void {
    this.#shows = step === null ? 'overview' : isInPlane(step) ? 'plane' : 'lens'
    this.#main.dataset.shows = this.#shows
    if (step === null) return
    if (isInPlane(step)) {
      this.#plane.show({ quadrilateral: step.quadrilateral, probe: step.probe ?? null }, verticesOf(step))
      this.ask(step, isAsked)
    } else this.#showInLens(step, isAsked)
  }

  /** Hides what gives the answer away, or shows it. The reader's own changes stay in the plane, and where they are the answer. */
  ask(step: LessonStep, isAsked: boolean): void {
    if (!isInPlane(step)) {
      const dragged = step.question?.answer.kind === 'drag' && !isAsked ? this.#lens.vertices : null
      this.#showInLens(step, isAsked, dragged)
    } else if (!isAsked || !step.question) this.#plane.asks = 'nothing'
    else this.#plane.asks = step.question.answer.kind === 'drag' ? 'drag' : 'choice'
  }

  /** `vertices` in the place of the step's, if there are any. */
  #showInLens(step: HexahedronStep, isAsked: boolean, vertices: Vertices | null = null): void {
    const shown = shownStep(step, isAsked)
    if (this.#lens.views !== shown.views) this.#lens.views = shown.views
    this.#lens.state = vertices ? { ...stateOf(shown), vertices } : stateOf(shown)
    scrollToTop(this.#lens)
  }
}
