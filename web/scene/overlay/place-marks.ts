/**
 * The best place of a vertex: its handle there with the edges to its neighbours, a line to it, and the points that forbid a better one,
 * the larger the more they weigh, with letter and weight.
 */
import { edgeVertices, type Vec3, vertexReference } from '../../model/hexahedron'
import { type HoldMark, holdText, type PlaceMarks } from '../../views/place-marks'
import { moveTo, px, set, setText, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import type { Box, Point } from '../space/layout'
import { samePoint } from '../space/vec3'
import { toWorld } from '../space/world'
import { meanOf, numberDirection } from './label-place'
import { markScale, type OverlayPicture } from './overlay-picture'

/** Radii of the handle at the place, of a point without a weight, and what a weight of 1 adds to the area's root. */
const PLACE = 7
const LEAST = 3.5
const MORE = 4.5
/** A point at a vertex is a ring about the handle. */
const RING = 11
const LETTER_WIDTH = 7
const TEXT_GAP = 7
/** The line ends before the handles that it joins. */
const GAP = 10

interface Hold {
  readonly group: SVGGElement
  readonly rim: SVGCircleElement
  readonly dot: SVGCircleElement
  readonly text: SVGTextElement
}

export class BestPlaceMarks {
  readonly root = svg('g', { class: 'place-marks' })
  readonly #halo = svg('path', { class: 'ghost-halo' })
  readonly #edges = svg('path', { class: 'ghost' })
  readonly #wayHalo = svg('path', { class: 'way halo' })
  readonly #way = svg('path', { class: 'way' })
  readonly #handle = svg(
    'g',
    { class: 'place' },
    svg('circle', { class: 'rim', r: PLACE + 2 }),
    svg('circle', { class: 'dot', r: PLACE }),
    svg('circle', { class: 'middle', r: 2 }),
  )
  readonly #holds: Hold[] = []

  constructor() {
    this.root.append(this.#halo, this.#edges, this.#wayHalo, this.#way, this.#handle)
  }

  update(picture: OverlayPicture, numbers: readonly Point[]): void {
    const { place } = picture
    show(this.root, place !== null)
    if (place === null) return
    this.#updatePlace(picture, place)
    while (this.#holds.length < place.holds.length) this.#holds.push(this.#createHold())
    const shown: Point[] = []
    this.#holds.forEach((hold, i) => {
      this.#updateHold(hold, place.holds[i] ?? null, picture, [...numbers, ...shown], shown)
    })
  }

  #updatePlace({ world, camera, handles, state }: OverlayPicture, { vertex, position }: PlaceMarks): void {
    const at = position && camera.project(toWorld(world, position))
    const from = handles[vertex] as ScreenPoint
    const isShown = at !== null && at.depth > 0 && from.depth > 0
    // While the vertex is dragged its edges are shown as they were.
    const hasEdges = isShown && state.gestureStart === null
    for (const path of [this.#halo, this.#edges]) show(path, hasEdges)
    for (const part of [this.#wayHalo, this.#way, this.#handle]) show(part, isShown)
    if (!isShown) return
    const to = edgeVertices
      .flatMap(([a, b]) => (a === vertex ? [b] : b === vertex ? [a] : []))
      .map(neighbour => handles[neighbour] as ScreenPoint)
      .filter(({ depth }) => depth > 0)
    const edges = to.map(({ x, y }) => `M${px(at.x)} ${px(at.y)}L${px(x)} ${px(y)}`).join('')
    for (const path of [this.#halo, this.#edges]) set(path, { d: edges })
    for (const path of [this.#wayHalo, this.#way]) set(path, { d: arrow(from, at) })
    moveTo(this.#handle, at)
  }

  #updateHold(
    { group, rim, dot, text }: Hold,
    hold: HoldMark | null,
    { camera, sight, handles, taken }: OverlayPicture,
    numbers: readonly Point[],
    shown: Point[],
  ): void {
    const at = hold && camera.project(sight.positionOf(hold.point))
    show(group, at !== null && at.depth > 0)
    if (!hold || !at) return
    moveTo(group, at)
    group.classList.toggle('behind', sight.hides(hold.point))
    const isVertex = isAtVertex(hold.point)
    group.classList.toggle('ring', isVertex)
    const radius = markScale(camera) * (isVertex ? RING : LEAST + MORE * Math.sqrt(hold.weight ?? 0))
    set(rim, { r: px(radius + (isVertex ? 0 : 1.5)) })
    set(dot, { r: px(radius) })
    setText(text, holdText(hold))
    const middle = meanOf(handles)
    const [dx, dy] = [at.x - middle.x, at.y - middle.y]
    const length = Math.hypot(dx, dy)
    const outwards = length > 1 ? { x: dx / length, y: dy / length } : { x: 0, y: -1 }
    const half = (LETTER_WIDTH / 2) * holdText(hold).length
    const distance = radius + TEXT_GAP + half
    const way = numberDirection(at, outwards, distance, [...handles, ...numbers], taken as readonly Box[])
    const x = way.x * distance
    const y = way.y * (radius + TEXT_GAP + 5)
    set(text, { x: px(x), y: px(y) })
    for (const share of [-0.7, 0, 0.7]) shown.push({ x: at.x + x + share * half, y: at.y + y })
  }

  #createHold(): Hold {
    const rim = svg('circle', { class: 'rim' })
    const dot = svg('circle', { class: 'dot' })
    const text = svg('text', { 'text-anchor': 'middle' })
    const group = svg('g', { class: 'hold' }, rim, dot, text)
    this.root.append(group)
    return { group, rim, dot, text }
  }
}

function isAtVertex(point: Vec3): boolean {
  return vertexReference.some(corner => samePoint(corner, point))
}

/** A line from one handle to another with a head at its end; nothing where they touch. */
function arrow(from: Point, to: Point): string {
  const [dx, dy] = [to.x - from.x, to.y - from.y]
  const length = Math.hypot(dx, dy)
  if (length < 2 * GAP + 4) return 'M0 0'
  const [ux, uy] = [dx / length, dy / length]
  const end = { x: to.x - GAP * ux, y: to.y - GAP * uy }
  const wing = (side: number) => `${px(end.x - 8 * ux - side * 4 * uy)} ${px(end.y - 8 * uy + side * 4 * ux)}`
  return `M${px(from.x + GAP * ux)} ${px(from.y + GAP * uy)}L${px(end.x)} ${px(end.y)}M${wing(1)}L${px(end.x)} ${px(end.y)}L${wing(-1)}`
}
