/** The probe as this panel sets it. */
import type { Vec3 } from '../../model/hexahedron'
import type { ViewContext } from '../../views/view'

type Setter = 'maps' | 'marks' | 'plots'

export class OwnProbe {
  readonly #context: ViewContext
  #own: { readonly by: Setter; readonly point: Vec3 } | null = null

  constructor(context: ViewContext) {
    this.#context = context
  }

  /** Nobody ends another probe than their own, such as when a map is scrolled from under the pointer. */
  set(by: Setter, point: Vec3 | null): void {
    const { probe } = this.#context.state()
    const own = this.#own
    const isOwn = own?.by === by && probe !== null && own.point.every((x, axis) => x === probe[axis])
    if (point === null && !isOwn) return
    this.#own = point && { by, point }
    this.#context.dispatch({ type: 'probe', point })
  }
}
