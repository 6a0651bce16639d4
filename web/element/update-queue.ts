/**
 * The updates of a frame. While a gesture runs, those that may come later queue up: a frame takes
 * as many as it has time for, and every second frame at least one. So a frame of a drag costs
 * hardly more the more panels are open, a fast machine is never a frame behind, and nothing stays
 * out of date when the pointer rests.
 */
import type { Update, View } from '../views/view'

/** Milliseconds of a frame in which updates may begin: an eighth of it at 60 a second. */
const SHARE = 2

export class UpdateQueue {
  #waiting: readonly Update[] = []
  /** True if the last frame had no time for any update. */
  #isOwed = false
  readonly #now: () => number

  /** `now` is a clock in milliseconds. */
  constructor(now = () => performance.now()) {
    this.#now = now
  }

  get isWaiting(): boolean {
    return this.#waiting.length > 0
  }

  /** The updates to do now. `isNews`: something is new since the last frame, for every view. */
  *due(views: readonly View[], isNews: boolean, isGesture: boolean): Generator<Update> {
    const end = isGesture ? this.#now() + SHARE : Number.POSITIVE_INFINITY
    if (isNews) for (const view of views) yield frame => view.update(frame)
    const all = views.flatMap(view => view.updates ?? [])
    const patient = this.#waiting.filter(update => all.includes(update))
    this.#waiting = isNews ? [...patient, ...all.filter(update => !patient.includes(update))] : patient
    let taken = 0
    while (this.#waiting.length > 0 && (this.#now() < end || (taken === 0 && this.#isOwed))) {
      const [update, ...others] = this.#waiting as [Update, ...Update[]]
      this.#waiting = others
      taken++
      yield update
    }
    this.#isOwed = taken === 0
  }
}
