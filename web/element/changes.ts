/** What the page is told of the element's changes: by events, and by the attributes `vertices` and `preset`. */
import type { Report } from '../core/report'
import type { Vertices } from '../model/hexahedron'
import type { State } from '../model/state'

export interface ChangeListener {
  tell(event: 'hex-input' | 'hex-change'): void
  tell(event: 'hex-verdict', detail: { readonly valid: boolean }): void
  /** The attributes are to say what is there now. */
  reflect(): void
}

export class Changes {
  readonly #listener: ChangeListener
  /** The vertices last told of; null before the first frame, in which there is nothing to compare with. */
  #told: Vertices | null = null
  /** The vertices after the last change that was done. */
  #committed: Vertices
  #toldValid: boolean | null = null

  constructor(vertices: Vertices, listener: ChangeListener) {
    this.#committed = vertices
    this.#listener = listener
  }

  /** Before that, what is set is what the element starts from, and no change. */
  get haveBegun(): boolean {
    return this.#told !== null
  }

  begin(vertices: Vertices): void {
    this.#committed = vertices
  }

  /** Whether anybody sees the element or not. */
  tell({ vertices, gestureStart }: State, report: Report | null): void {
    const isMoved = this.#told !== null && this.#told !== vertices
    this.#told = vertices
    if (isMoved) this.#listener.tell('hex-input')
    if (report && report.valid !== this.#toldValid) {
      this.#toldValid = report.valid
      this.#listener.tell('hex-verdict', { valid: report.valid })
    }
    if (gestureStart === null && this.#committed !== vertices) {
      this.#committed = vertices
      this.#listener.reflect()
      this.#listener.tell('hex-change')
    }
  }
}
