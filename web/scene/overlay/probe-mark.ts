/** The probe, its volume box, and as sides of that the columns of DF: the derivatives of position by xi, eta and zeta there. */
import type { JacobianReport } from '../../core/report'
import { say } from '../../words/say'
import { moveTo, px, set, setText, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import { toWorld } from '../space/world'
import { type LabelPlace, meanOf, placeLabel } from './label-place'
import type { OverlayPicture } from './overlay-picture'
import { boxCorners, VolumeBox } from './volume-box'

/** Units of an arrow's head, and of the shortest arrow that has one. */
const HEAD = 7
const SHORTEST = 4
/** Each with the corner of the box that it points at from corner 0. */
const LETTERS = [
  ['ξ', 1],
  ['η', 3],
  ['ζ', 4],
] as const
const LETTER_DISTANCE = 9
const CHARACTER_WIDTH = 8
const LINE = 16
const NOTE_CHARACTER_WIDTH = 6.5

/** How the probe looks beyond its place. */
export interface ProbeLook {
  /** The colour of jacdet there. */
  readonly colour: string
  /** The box's volume in words; none at the little cube. */
  readonly words: string
}

type ProbePicture = Pick<OverlayPicture, 'world' | 'camera' | 'handles' | 'taken' | 'sight'>

export class ProbeMark {
  readonly root = svg('g', { class: 'probe' })
  /** Under the marks. */
  readonly box = new VolumeBox()
  readonly #arrows = LETTERS.map(([letter, corner]) => ({
    halo: svg('path', { class: 'halo' }),
    line: svg('path', { class: 'arrow' }),
    letter: svg('text', { 'text-anchor': 'middle' }, letter),
    corner,
  }))
  readonly #dot = svg('circle', { class: 'point', r: 4 })
  readonly #volume = svg('text')
  readonly #note = svg('text', { class: 'note', y: LINE }, say('linear image, enlarged'))
  readonly #words = svg('g', { 'text-anchor': 'middle' }, this.#volume, this.#note)
  readonly #leader = svg('path', { class: 'leader' })
  #place: LabelPlace | null = null

  constructor() {
    this.box.root.prepend(this.#leader)
    this.root.append(
      ...this.#arrows.map(({ halo }) => halo),
      ...this.#arrows.map(({ line }) => line),
      this.#dot,
      ...this.#arrows.map(({ letter }) => letter),
      this.#words,
    )
  }

  update(probe: JacobianReport | null, look: ProbeLook, picture: ProbePicture): void {
    const { world, camera, sight } = picture
    const corners = probe ? boxCorners(probe, world).map(corner => camera.project(corner)) : []
    const isShown = corners.length > 0 && corners.every(({ depth }) => depth > 0)
    for (const { root } of [this, this.box]) {
      show(root, isShown)
      root.classList.toggle('behind', isShown && probe !== null && sight.hides(probe.point))
    }
    if (probe === null || !isShown) return
    moveTo(this.#dot, camera.project(toWorld(world, probe.position)))
    const isHidden = this.box.update(corners, look.colour, probe.jacdet < 0)
    const [from] = corners as [ScreenPoint]
    for (const { halo, line, letter, corner } of this.#arrows) {
      const tip = corners[corner] as ScreenPoint
      const path = arrowPath(from, tip)
      for (const mark of [halo, line, letter]) show(mark, path !== null)
      if (path === null) continue
      set(halo, { d: path })
      set(line, { d: path })
      line.classList.toggle('hidden', isHidden([0, corner]))
      const reach = Math.hypot(tip.x - from.x, tip.y - from.y)
      const beyond = (reach + LETTER_DISTANCE) / reach
      set(letter, { x: px(from.x + (tip.x - from.x) * beyond), y: px(from.y + (tip.y - from.y) * beyond) })
    }
    this.#updateWords(look.words, corners, picture)
  }

  #updateWords(words: string, corners: readonly ScreenPoint[], { camera, handles, taken }: ProbePicture): void {
    setText(this.#volume, words)
    for (const mark of [this.#words, this.#leader]) show(mark, false)
    if (words === '') return
    const anchor = meanOf(corners)
    const width = Math.max(CHARACTER_WIDTH * words.length, NOTE_CHARACTER_WIDTH * (this.#note.textContent ?? '').length)
    const place = placeLabel({
      anchor,
      width,
      height: 2 * LINE,
      bounds: { x: 8, y: 8, width: camera.width - 16, height: camera.height - 16 },
      points: handles,
      numbers: corners,
      boxes: taken,
      body: corners,
      previous: this.#place?.index ?? null,
    })
    this.#place = place
    for (const mark of [this.#words, this.#leader]) show(mark, place.isFree)
    moveTo(this.#words, { x: place.x, y: place.y - LINE / 2 })
    const near = place.x - (Math.sign(place.x - anchor.x) * width) / 2
    set(this.#leader, { d: `M${px(anchor.x)} ${px(anchor.y)}L${px(near)} ${px(place.y)}` })
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
