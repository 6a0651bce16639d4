/** The curve s*(t) on the face that the page speaks of: where the parabola in s has its least value between the edges. */
import { facePolynomials, vertexInS } from '../../core/face-polynomials'
import { pointOn } from '../../core/section'
import { type FaceTopology, faces } from '../../model/hexahedron'
import { sliceOf } from '../../model/state'
import { marksSlice } from '../../views/scene-slices'
import { px, set, show, svg } from '../paint/svg'
import type { OverlayPicture } from './overlay-picture'

/** Rows of the face that are looked at. */
const ROWS = 60

export class LeastCurve {
  readonly root = svg('g', { class: 'least-curve' })
  readonly #halo = svg('path', { class: 'halo' })
  readonly #line = svg('path', { class: 'line' })
  readonly #behind = svg('path', { class: 'line behind' })

  constructor() {
    this.root.append(this.#halo, this.#behind, this.#line)
  }

  update({ state, report, camera, sight }: OverlayPicture): void {
    const { curveOn } = sliceOf(marksSlice, state)
    const face = curveOn === null ? undefined : report?.faces[curveOn]
    show(this.root, face !== undefined)
    if (!face) return
    const polynomials = facePolynomials(face.bernstein)
    const { axis, side } = faces[face.id] as FaceTopology
    const paths = { seen: '', behind: '' }
    let from: string | null = null
    let last: keyof typeof paths | null = null
    for (let row = 0; row <= ROWS; row++) {
      const t = row / ROWS
      const s = vertexInS(polynomials, t)
      const point = s !== null && s >= 0 && s <= 1 ? pointOn(axis, side, s, t) : null
      const at = point && camera.project(sight.positionOf(point))
      const to: string | null = at && at.depth > 0 ? `${px(at.x)} ${px(at.y)}` : null
      const part = point && from && to ? (sight.hides(point) ? 'behind' : 'seen') : null
      // A path goes on where it can: dashes would begin anew.
      if (part) paths[part] += part === last ? `L${to}` : `M${from}L${to}`
      last = part
      from = to
    }
    set(this.#halo, { d: paths.seen || 'M0 0' })
    set(this.#line, { d: paths.seen || 'M0 0' })
    set(this.#behind, { d: paths.behind || 'M0 0' })
  }
}
