/** The element's view and the reference cube's, which look along one line while they are linked. */
import type { State } from '../../model/state'
import type { Viewpoint } from './orbit-camera'

export class LinkedViews {
  readonly #own: Viewpoint
  readonly #state: () => State
  #isFollowing = false
  /** The reference cube's, once there is one. */
  other: Viewpoint | null = null

  constructor(own: Viewpoint, state: () => State) {
    this.#own = own
    this.#state = state
  }

  /** One of the two was turned. */
  follow(from: Viewpoint): void {
    const { referenceShown, camerasLinked } = this.#state()
    const to = from === this.#own ? this.other : this.#own
    if (!to || !referenceShown || !camerasLinked || this.#isFollowing) return
    this.#isFollowing = true
    to.direction = from.direction
    this.#isFollowing = false
  }

  /** What has just been shown or linked looks along the element's line. */
  join({ referenceShown, camerasLinked }: State, before: State | null): void {
    if (referenceShown && camerasLinked && !(before?.referenceShown && before.camerasLinked)) this.follow(this.#own)
  }
}
