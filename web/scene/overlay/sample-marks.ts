/** The points or the twelve edges that a check evaluates, while the pointer is on it: dots, or thick lines. */
import { sliceOf } from '../../model/state'
import { marksSlice } from '../../views/scene-slices'
import { px, set, show, svg } from '../paint/svg'
import { patchPoint, sectionCorners } from '../space/patches'
import { verticesInWorld } from '../space/world'
import type { OverlayPicture } from './overlay-picture'

export class SampleMarks {
  readonly root = svg('g', { class: 'samples' })
  readonly #halo = svg('path', { class: 'halo' })
  readonly #line = svg('path', { class: 'line' })

  constructor() {
    this.root.append(this.#halo, this.#line)
  }

  /** `edges` is the path of the twelve. */
  update({ state, world, camera }: OverlayPicture, edges: string): void {
    const { samples } = sliceOf(marksSlice, state)
    show(this.root, samples !== null)
    if (samples === null) return
    const inWorld = verticesInWorld(world, state.vertices)
    const dots = samples.points
      .map(([xi, eta, zeta]) => camera.project(patchPoint(sectionCorners(inWorld, { axis: 0, value: xi }), eta, zeta)))
      .filter(({ depth }) => depth > 0)
      .map(({ x, y }) => `M${px(x)} ${px(y)}h0`) // round ends make a dot of a line without a length
    this.root.setAttribute('class', `samples ${samples.edges ? '' : 'dots'}`)
    for (const path of [this.#halo, this.#line]) set(path, { d: samples.edges ? edges : dots.join('') })
  }
}
