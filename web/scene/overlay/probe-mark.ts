/** The point that is pointed at, and from it the three columns of DF as arrows, named for what they are derivatives by. */
import type { JacobianReport } from '../../core/report'
import { moveTo, px, set, show, svg } from '../paint/svg'
import type { SceneCamera, ScreenPoint } from '../space/camera'
import { at, map3, toView, type ViewFrame } from '../space/world'
import { unitColumns } from './arrows'

/** CSS pixels of the longest column, were it parallel to the screen; in a low view this share of its height. */
const LONGEST = 64
const LONGEST_SHARE = 1 / 6
/** Pixels of an arrow's head, and of the shortest arrow that has room for one. */
const HEAD = 7
const SHORTEST = 4
const LETTERS = ['ξ', 'η', 'ζ'] as const
const LETTER_DISTANCE = 9

export class ProbeMark {
  readonly root = svg('g', { class: 'probe' })
  readonly #arrows = LETTERS.map(letter => ({
    halo: svg('path', { class: 'halo' }),
    line: svg('path', { class: 'arrow' }),
    letter: svg('text', { 'text-anchor': 'middle' }, letter),
  }))
  readonly #dot = svg('circle', { class: 'point', r: 4 })

  constructor() {
    this.root.append(
      ...this.#arrows.map(({ halo }) => halo),
      ...this.#arrows.map(({ line }) => line),
      this.#dot,
      ...this.#arrows.map(({ letter }) => letter),
    )
  }

  update(probe: JacobianReport | null, frame: ViewFrame, camera: SceneCamera): void {
    const from = probe && toView(frame, probe.position)
    const middle = from && camera.project(from)
    const isShown = middle !== null && middle.depth > 0
    show(this.root, isShown)
    if (probe === null || from === null || !isShown) return
    moveTo(this.#dot, middle)
    const columns = unitColumns(probe)
    const length = Math.min(LONGEST, LONGEST_SHARE * camera.height) * camera.lengthPerPixel(middle.depth)
    this.#arrows.forEach(({ halo, line, letter }, k) => {
      const column = columns?.[k]
      const tip = column && camera.project(map3(axis => at(from, axis) + at(column, axis) * length))
      const path = tip ? arrowPath(middle, tip) : null
      for (const part of [halo, line, letter]) show(part, path !== null)
      if (!tip || path === null) return
      set(halo, { d: path })
      set(line, { d: path })
      const reach = Math.hypot(tip.x - middle.x, tip.y - middle.y)
      const beyond = (reach + LETTER_DISTANCE) / reach
      set(letter, {
        x: px(middle.x + (tip.x - middle.x) * beyond),
        y: px(middle.y + (tip.y - middle.y) * beyond),
      })
    })
  }
}

/** Null for one that points at the eye. */
function arrowPath(from: ScreenPoint, to: ScreenPoint): string | null {
  const [dx, dy] = [to.x - from.x, to.y - from.y]
  const length = Math.hypot(dx, dy)
  if (length < SHORTEST) return null
  const [ux, uy] = [(dx / length) * Math.min(HEAD, length), (dy / length) * Math.min(HEAD, length)]
  const wing = (side: number) => `${px(to.x - ux - side * uy * 0.45)} ${px(to.y - uy + side * ux * 0.45)}`
  return `M${px(from.x)} ${px(from.y)}L${px(to.x)} ${px(to.y)}M${wing(1)}L${px(to.x)} ${px(to.y)}L${wing(-1)}`
}
