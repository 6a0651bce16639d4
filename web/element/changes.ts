/** Tells the page of changes by events, and by the attributes `vertices` and `preset`. */
import type { Report } from '../core/report'
import type { Vertices } from '../model/hexahedron'
import type { State } from '../model/state'

export interface ChangeListener {
  tell(event: 'hex-input' | 'hex-change'): void
  tell(event: 'hex-verdict', detail: { readonly valid: boolean }): void
  /** Writes the present vertices and preset to the attributes. */
  reflect(): void
}

export class Changes {
  readonly #listener: ChangeListener
  /** The vertices of the last frame; null before the first, which has nothing to compare with. */
  #told: Vertices | null = null
  /** The vertices after the last change that was done; likewise. */
  #committed: Vertices | null = null
  #toldValid: boolean | null = null

  constructor(listener: ChangeListener) {
    this.#listener = listener
  }

  /** Called in each frame, on the screen or not. */
  tell({ vertices, gestureStart }: State, report: Report | null): void {
    const isMoved = this.#told !== null && this.#told !== vertices
    this.#committed ??= vertices
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
