/** The probe, and from it the columns of DF as arrows: the derivatives of position by xi, eta and zeta there. */
import type { JacobianReport } from '../../core/report'
import type { Vec3 } from '../../model/hexahedron'
import { moveTo, px, set, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import { at, map3 } from '../space/vec3'
import { toWorld } from '../space/world'
import type { Seen } from './overlay-picture'

/** Units of the longest column, were it parallel to the screen; in a low viewport this share of its height. */
const LONGEST = 64
const LONGEST_SHARE = 1 / 6
/** Units of an arrow's head, and of the shortest arrow that has one. */
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

  update(probe: JacobianReport | null, { world, camera, sight }: Seen): void {
    const from = probe && toWorld(world, probe.position)
    const middle = from && camera.project(from)
    const isShown = middle !== null && middle.depth > 0
    show(this.root, isShown)
    if (probe === null || from === null || !isShown) return
    this.root.classList.toggle('behind', sight.hides(probe.point))
    moveTo(this.#dot, middle)
    const columns = unitColumns(probe)
    const length = Math.min(LONGEST, LONGEST_SHARE * camera.height) * camera.lengthPerPixel(middle.depth)
    this.#arrows.forEach(({ halo, line, letter }, k) => {
      const column = columns?.[k]
      const tip = column && camera.project(map3(axis => at(from, axis) + at(column, axis) * length))
      const path = tip ? arrowPath(middle, tip) : null
      for (const mark of [halo, line, letter]) show(mark, path !== null)
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

/** The path of an arrow; null if it points at the eye. */
function arrowPath(from: ScreenPoint, to: ScreenPoint): string | null {
  const [dx, dy] = [to.x - from.x, to.y - from.y]
  const length = Math.hypot(dx, dy)
  if (length < SHORTEST) return null
  const [ux, uy] = [(dx / length) * Math.min(HEAD, length), (dy / length) * Math.min(HEAD, length)]
  const wing = (side: number) => `${px(to.x - ux - side * uy * 0.45)} ${px(to.y - uy + side * ux * 0.45)}`
  return `M${px(from.x)} ${px(from.y)}L${px(to.x)} ${px(to.y)}M${wing(1)}L${px(to.x)} ${px(to.y)}L${wing(-1)}`
}

/**
 * The columns times one common factor, the longest of length 1; null where all vanish. Physical and world space differ by a
 * shift and one scale, so these are directions in either.
 */
export function unitColumns({
  columns,
  axisExponents,
}: Pick<JacobianReport, 'columns' | 'axisExponents'>): readonly [Vec3, Vec3, Vec3] | null {
  // Components are numbers times 2^exponent of any size: the greatest exponent is taken out before there is a product.
  const exponents = columns.flatMap(column =>
    column.map((x, axis) => (x === 0 ? -Infinity : Math.log2(Math.abs(x)) + at(axisExponents, axis))),
  )
  const greatest = Math.ceil(Math.max(...exponents))
  if (!Number.isFinite(greatest)) return null
  const scaled = columns.map(column => map3(axis => timesPower(at(column, axis), at(axisExponents, axis) - greatest)))
  const longest = Math.max(...scaled.map(column => Math.hypot(...column)))
  return scaled.map(column => map3(axis => at(column, axis) / longest)) as unknown as readonly [Vec3, Vec3, Vec3]
}

/** x * 2^power, in two steps: 2^power alone may be no double though the product is. */
function timesPower(x: number, power: number): number {
  const half = Math.trunc(power / 2)
  return x * 2 ** half * 2 ** (power - half)
}
