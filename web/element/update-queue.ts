/**
 * What is brought up to date in a frame. While a gesture runs, what takes updates waits for its own, and a frame takes as many as fit into its
 * time, every second frame one at least: so a frame of a drag costs hardly more the more panels are open, a fast machine is never a frame
 * behind, and none is left behind when the pointer rests.
 */
import type { Update, View } from '../views/view'

/** Milliseconds of a frame, from its first update on, in which updates may begin: less than a quarter of a frame at 60 a second. */
const SHARE = 2

export class UpdateQueue {
  #waiting: readonly Update[] = []
  /** Whether the last frame had no time for a update. */
  #isOwed = false
  readonly #now: () => number

  /** `now` is a clock in milliseconds. */
  constructor(now = () => performance.now()) {
    this.#now = now
  }

  /** Whether anything is not up to date. */
  get isWaiting(): boolean {
    return this.#waiting.length > 0
  }

  /** To be taken one after the other. `isNews` says whether there is anything new since the last frame, for every view. */
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
