/** The points or the twelve edges that a check evaluates, while the pointer is on it: dots, or thick lines. */
import { sliceOf } from '../../model/state'
import { marksSlice } from '../../views/scene-slices'
import { px, set, show, svg } from '../paint/svg'
import type { OverlayPicture } from './overlay-picture'

export class SampleMarks {
  readonly root = svg('g', { class: 'samples' })
  readonly #halo = svg('path', { class: 'halo' })
  readonly #line = svg('path', { class: 'line' })
  readonly #behind = svg('path', { class: 'line behind' })

  constructor() {
    this.root.append(this.#halo, this.#behind, this.#line)
  }

  /** `edges` is the path of the twelve. */
  update({ state, camera, sight }: OverlayPicture, edges: string): void {
    const { samples } = sliceOf(marksSlice, state)
    show(this.root, samples !== null)
    if (samples === null) return
    const dots = { seen: '', behind: '' }
    for (const point of samples.points) {
      const { x, y, depth } = camera.project(sight.positionOf(point))
      // Round ends make a dot of a line without a length.
      if (depth > 0) dots[sight.hides(point) ? 'behind' : 'seen'] += `M${px(x)} ${px(y)}h0`
    }
    this.root.setAttribute('class', `samples ${samples.edges ? '' : 'dots'}`)
    set(this.#halo, { d: samples.edges ? edges : dots.behind + dots.seen })
    set(this.#line, { d: samples.edges ? edges : dots.seen })
    set(this.#behind, { d: dots.behind })
  }
}
