/** The coordinate axes as the camera sees them, in a corner. */
import { px, set, svg } from '../paint/svg'
import type { SceneCamera } from '../space/camera'
import { at } from '../space/vec3'

const LENGTH = 22
export type AxisLetters = readonly [string, string, string]

export class Triad {
  readonly root = svg('g', { class: 'triad', transform: 'translate(44 44)' })
  readonly #axes: readonly { readonly line: SVGPathElement; readonly text: SVGTextElement }[]

  constructor(letters: AxisLetters) {
    this.#axes = letters.map(letter => ({
      line: svg('path', { class: 'axis' }),
      text: svg('text', { class: 'axis-name', 'text-anchor': 'middle' }, letter),
    }))
    for (const { line, text } of this.#axes) this.root.append(line, text)
  }

  update(camera: SceneCamera): void {
    const [right, up] = camera.axes()
    this.#axes.forEach(({ line, text }, axis) => {
      const x = at(right, axis) * LENGTH
      const y = -at(up, axis) * LENGTH
      const length = Math.hypot(x, y)
      set(line, { d: `M0 0L${px(x)} ${px(y)}` })
      const beyond = length > 1 ? (length + 9) / length : 0
      set(text, { x: px(x * beyond), y: px(y * beyond) })
    })
  }
}
