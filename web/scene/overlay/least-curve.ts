/** The curve s*(t) on the face that the page speaks of: where the parabola in s has its least value between the edges. */
import { facePolynomials, vertexInS } from '../../core/face-polynomials'
import { sliceOf } from '../../model/state'
import { marksSlice } from '../../views/scene-slices'
import { px, set, show, svg } from '../paint/svg'
import { facePoint } from '../space/patches'
import { verticesInWorld } from '../space/world'
import type { OverlayPicture } from './overlay-picture'

/** Rows of the face that are looked at. */
const ROWS = 60

export class LeastCurve {
  readonly root = svg('g', { class: 'least-curve' })
  readonly #halo = svg('path', { class: 'halo' })
  readonly #line = svg('path', { class: 'line' })

  constructor() {
    this.root.append(this.#halo, this.#line)
  }

  update({ state, report, world, camera }: OverlayPicture): void {
    const { curveOn } = sliceOf(marksSlice, state)
    const face = curveOn === null ? undefined : report?.faces[curveOn]
    show(this.root, face !== undefined)
    if (!face) return
    const polynomials = facePolynomials(face.bernstein)
    const vertices = verticesInWorld(world, state.vertices)
    let path = ''
    let isOpen = false
    for (let row = 0; row <= ROWS; row++) {
      const t = row / ROWS
      const s = vertexInS(polynomials, t)
      const at = s !== null && s >= 0 && s <= 1 ? camera.project(facePoint(vertices, face.id, s, t)) : null
      const isSeen = at !== null && at.depth > 0
      if (isSeen) path += `${isOpen ? 'L' : 'M'}${px(at.x)} ${px(at.y)}`
      isOpen = isSeen
    }
    for (const part of [this.#halo, this.#line]) set(part, { d: path || 'M0 0' })
  }
}
