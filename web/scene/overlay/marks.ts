/**
 * The minimizer with its value, and the candidates on edges and faces as small marks by kind. If the inside is shown, value and
 * mark are those of the least jacdet of the whole element, and a ring stays on the boundary's minimizer.
 */

import { approximation, lowerInside } from '../../core/inside'
import type { Candidate, Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import { edgeName, edgeVertices, faces, type Vec3 } from '../../model/hexahedron'
import { sliceOf } from '../../model/state'
import { type FaceDisplay, sceneSlice } from '../../views/scene-slices'
import { say } from '../../words/say'
import { moveTo, px, set, setText, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import type { Box, Point } from '../space/layout'
import { samePoint } from '../space/vec3'
import { toWorld } from '../space/world'
import { candidateShapes } from './candidate-shapes'
import { type LabelPlace, overlap, placeLabel } from './label-place'
import { markScale, type OverlayPicture } from './overlay-picture'

const RING = 9
const HANDLE_RING = 12
const PUPIL = 3
const LABEL_HEIGHT = 20
const CHARACTER_WIDTH = 9
const ELBOW = 14

export interface MarksPicture extends OverlayPicture {
  /** The middles of the vertex numbers. */
  readonly numbers: readonly Point[]
}

interface Mark {
  readonly group: SVGGElement
  readonly path: SVGPathElement
  readonly title: SVGTitleElement
}

/** The point marked as the least, and its words. */
interface Least {
  readonly words: string
  readonly value: number
  readonly point: Vec3
  readonly position: Vec3
  readonly isVertex: boolean
}

export class Marks {
  readonly candidates = svg('g', { class: 'candidates' })
  readonly minimizer = svg('g', { class: 'minimizer' })
  readonly #pool: Mark[] = []
  readonly #halo = svg('circle', { class: 'rim' })
  readonly #ring = svg('circle', { class: 'ring' })
  readonly #dot = svg('circle', { class: 'pupil' })
  readonly #leader = svg('path', { class: 'leader' })
  readonly #label = svg('text', { class: 'value' })
  /** The ring on the boundary's minimizer if another point has the label. */
  readonly #second = svg('circle', { class: 'second' })
  readonly #isLabelled: boolean
  #place: LabelPlace | null = null
  /** The label's box while it is shown. */
  shownLabel: Box | null = null
  /** The label's box; null if no place is free. */
  #labelBox: Box | null = null

  constructor(isLabelled: boolean, onMinimum: () => void) {
    this.#isLabelled = isLabelled
    // A press on the words is none on the scene.
    this.#label.addEventListener('pointerdown', event => event.stopPropagation())
    this.#label.addEventListener('click', onMinimum)
    this.minimizer.append(this.#second, this.#halo, this.#ring, this.#dot)
    if (isLabelled) this.minimizer.append(this.#label)
    if (isLabelled) this.minimizer.prepend(this.#leader)
  }

  update(picture: MarksPicture): void {
    const { report } = picture
    show(this.minimizer, report !== null)
    if (report === null) {
      this.#updateCandidates([], picture)
      return
    }
    const { minimizer } = report
    const { faceDisplay } = sliceOf(sceneSlice, picture.state)
    const inside = faceDisplay === 'inside' ? lowerInside(report) : null
    const marked = report.candidates.filter(
      c => c.kind !== 'vertex' && !samePoint(c.point, minimizer.point) && isOnFaces(c, faceDisplay),
    )
    this.#updateCandidates(marked, picture)
    this.#updateLeast(inside ? leastInside(inside) : leastOnBoundary(report), report.exponent, picture)
    const second = inside && picture.camera.project(toWorld(picture.world, minimizer.position))
    show(this.#second, second !== null && second.depth > 0)
    if (second) set(this.#second, { cx: px(second.x), cy: px(second.y), r: px(markScale(picture.camera) * RING) })
  }

  /** Hides the label behind words, if there are any: the verdict and the colour bar say its number, too. */
  makeWay(words: Box | null): void {
    const box = this.#labelBox
    const isShown = box !== null && !(words && overlap(box, words))
    for (const mark of [this.#leader, this.#label]) show(mark, isShown)
    this.shownLabel = isShown ? box : null
  }

  #updateCandidates(marked: readonly Candidate[], { world, camera, sight, report, state }: MarksPicture): void {
    while (this.#pool.length < marked.length) this.#pool.push(this.#createMark())
    this.#pool.forEach(({ group, path, title }, i) => {
      const candidate = marked[i]
      const at = candidate && camera.project(toWorld(world, candidate.position))
      show(group, at !== undefined && at.depth > 0)
      if (!candidate || !at) return
      moveTo(group, at)
      group.classList.toggle('behind', sight.hides(candidate.point))
      set(path, { d: candidateShapes[candidate.kind] })
      const value = formatJacdet(candidate.value, report?.exponent ?? 0, state.referenceCube)
      setText(title, say('Candidate {place}: J = {value}', { place: elementPartName(candidate), value }))
    })
  }

  #createMark(): Mark {
    const title = svg('title')
    const path = svg('path', { class: 'candidate' })
    const group = svg('g', {}, title, path)
    this.candidates.append(group)
    return { group, path, title }
  }

  #updateLeast({ words, value, point, position, isVertex }: Least, exponent: number, picture: MarksPicture): void {
    const { camera, world, sight, state } = picture
    const at = camera.project(toWorld(world, position))
    show(this.minimizer, at.depth > 0)
    const scale = markScale(camera)
    const radius = scale * (isVertex ? HANDLE_RING : RING)
    for (const circle of [this.#halo, this.#ring, this.#dot]) set(circle, { cx: px(at.x), cy: px(at.y) })
    set(this.#halo, { r: px(radius) })
    set(this.#ring, { r: px(radius) })
    set(this.#dot, { r: px(scale * PUPIL) })
    show(this.#dot, !isVertex)
    this.minimizer.classList.toggle('positive', value > 0)
    this.minimizer.classList.toggle('behind', sight.hides(point))
    if (!this.#isLabelled) return
    setText(this.#label, `${words} = ${formatJacdet(value, exponent, state.referenceCube)}`)
    this.#placeLabel(at, radius, picture)
  }

  #placeLabel(at: ScreenPoint, radius: number, { camera, handles, numbers, taken }: MarksPicture): void {
    const width = CHARACTER_WIDTH * (this.#label.textContent ?? '').length + 8
    const bounds: Box = { x: 10, y: 10, width: camera.width - 20, height: camera.height - 20 }
    const place = placeLabel({
      anchor: at,
      width: width + ELBOW,
      height: LABEL_HEIGHT,
      bounds,
      points: handles,
      numbers,
      boxes: taken,
      body: handles,
      previous: this.#place?.index ?? null,
    })
    this.#place = place
    this.#labelBox = place.isFree
      ? { x: place.x - (width + ELBOW) / 2, y: place.y - LABEL_HEIGHT / 2, width: width + ELBOW, height: LABEL_HEIGHT }
      : null
    const toRight = place.x >= at.x
    const side = toRight ? 1 : -1
    const near = place.x - (side * (width + ELBOW)) / 2
    const elbow = near + side * ELBOW
    const angle = Math.atan2(place.y - at.y, near - at.x)
    const start = { x: at.x + Math.cos(angle) * radius, y: at.y + Math.sin(angle) * radius }
    set(this.#leader, { d: `M${px(start.x)} ${px(start.y)}L${px(near)} ${px(place.y)}H${px(elbow)}` })
    set(this.#label, {
      x: px(elbow + side * 5),
      y: px(place.y),
      'text-anchor': toRight ? 'start' : 'end',
    })
  }
}

function leastOnBoundary({ minimizer }: Report): Least {
  const { value, point, position, kind } = minimizer
  return { words: 'min J', value, point, position, isVertex: kind === 'vertex' }
}

function leastInside(inside: Report['volumeMinimum']): Least {
  const { point, position } = inside
  return { words: say('min J inside'), value: approximation(inside).value, point, position, isVertex: false }
}

/** True if a candidate lies on the faces shown: one face alone has its own and those of its edges. */
function isOnFaces({ kind, id }: Candidate, display: FaceDisplay): boolean {
  const shown = typeof display === 'number' ? faces[display] : undefined
  if (shown === undefined) return true
  return kind === 'face' ? id === display : (edgeVertices[id] ?? []).every(v => shown.vertices.includes(v))
}

function elementPartName({ kind, id }: Candidate): string {
  return kind === 'edge'
    ? say('on edge {name}', { name: edgeName(id) })
    : say('on face {name}', { name: faces[id]?.name ?? '' })
}
