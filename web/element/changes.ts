/** Tells the page of changes by events, and by the attributes `vertices` and `preset`. */
import type { Report } from '../core/report'
import { sameBits, type Vertices } from '../model/hexahedron'
import type { Action, ChangeSource, State } from '../model/state'

/** What `hex-input`, `hex-change` and `hex-verdict` bring. */
export interface ChangeDetail {
  /** A copy of the 24 coordinates. */
  readonly vertices: number[]
  /** Null without a core. */
  readonly valid: boolean | null
  /** Null without a core, and beyond the doubles’ normal range; `report` has it there, too. */
  readonly boundaryMinimum: number | null
  readonly source: ChangeSource
}

export type ChangeEvent = 'hex-input' | 'hex-change' | 'hex-verdict'

export interface ChangeListener {
  tell(event: ChangeEvent, detail: ChangeDetail): void
  /** Writes the present vertices and preset to the attributes. */
  reflect(): void
}

/** Elements that were told of last in a gesture, which a page may give back: four seconds of a drag. */
const MOST_TOLD = 240

export class Changes {
  readonly #listener: ChangeListener
  /** The vertices of the last frames, the newest first; none before the first, which has nothing to compare with. */
  #told: readonly Vertices[] = []
  /** The vertices after the last change that was done; likewise. */
  #committed: Vertices | null = null
  #toldValid: boolean | null = null
  /** Whose the last change is. */
  source: ChangeSource = 'program'
  /** Whose the gesture is that runs, or ran last. */
  gesture: ChangeSource = 'panel'
  #isTelling = false

  constructor(listener: ChangeListener) {
    this.#listener = listener
  }

  /** Notes whose the change from one state to the next is: the reader's by that action, or that of `source`. */
  note(before: State, after: State, action: Action, source: ChangeSource | null): void {
    if (action.type === 'begin-gesture') {
      this.gesture = action.by ?? 'panel'
      this.#told = this.#told.slice(0, 1)
    }
    const isDone = before.gestureStart !== null && after.gestureStart === null
    if (before.vertices !== after.vertices || isDone) this.source = source ?? this.#readers(action, before)
  }

  /**
   * True of numbers that events have brought of late, while a gesture runs: a page that gives them
   * back when it is done with them is behind the reader's hand. In an event's own listener they are
   * meant, such as the last ones that the page found good.
   */
  isEcho(vertices: Vertices): boolean {
    return !this.#isTelling && this.#told.some(told => sameBits(told, vertices))
  }

  /** Called in each frame, on the screen or not. */
  tell({ vertices, gestureStart }: State, report: Report | null): void {
    const [last = null] = this.#told
    this.#committed ??= vertices
    if (last !== vertices) this.#told = [vertices, ...this.#told.slice(0, MOST_TOLD - 1)]
    const { source } = this
    const tell = (event: ChangeEvent) => this.#listener.tell(event, detailOf(vertices, report, source))
    this.#isTelling = true
    if (last !== null && last !== vertices) tell('hex-input')
    if (report && report.valid !== this.#toldValid) {
      this.#toldValid = report.valid
      tell('hex-verdict')
    }
    if (gestureStart === null && this.#committed !== vertices) {
      this.#committed = vertices
      this.#listener.reflect()
      if (source !== 'program') tell('hex-change')
    }
    this.#isTelling = false
  }

  #readers(action: Action, { gestureStart }: State): ChangeSource {
    if (action.type === 'undo' || action.type === 'redo' || action.type === 'reset') return 'history'
    if (gestureStart !== null) return this.gesture
    return action.type === 'set-vertices' && action.preset !== null ? 'preset' : 'panel'
  }
}

function detailOf(vertices: Vertices, report: Report | null, source: ChangeSource): ChangeDetail {
  const boundaryMinimum = report?.exponent === 0 ? report.boundaryMinimum : null
  return { vertices: vertices.slice(), valid: report?.valid ?? null, boundaryMinimum, source }
}
