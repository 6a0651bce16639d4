/**
 * Which views are brought up to date in a frame. While a gesture runs those that take turns wait for theirs, one a frame: so a frame of
 * a drag costs hardly more the more panels are open, and none is left behind when the pointer rests.
 */
import type { View } from '../views/view'

export class Turns {
  #waiting: readonly View[] = []

  /** Whether a view is not up to date. */
  get isWaiting(): boolean {
    return this.#waiting.length > 0
  }

  /** `isNews` says whether there is anything new since the last frame, for every view. */
  due(views: readonly View[], isNews: boolean, isGesture: boolean): readonly View[] {
    const patient = isNews ? views.filter(view => view.takesTurns) : []
    const waiting = [...this.#waiting, ...patient.filter(view => !this.#waiting.includes(view))]
    const now = isGesture ? waiting.slice(0, 1) : waiting
    this.#waiting = waiting.slice(now.length)
    return [...(isNews ? views.filter(view => !view.takesTurns) : []), ...now]
  }
}
