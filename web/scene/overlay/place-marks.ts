/**
 * The best place of a vertex: its handle there with the edges to its neighbours, a line to it, and the points that forbid a better one,
 * the larger the more they weigh, with letter and weight.
 */
import { edgeVertices } from '../../model/hexahedron'
import { type PlaceMarks, type PlacePoint, shortWeight } from '../../views/place-marks'
import { moveTo, px, set, setText, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import type { Box, Point } from '../space/layout'
import { toWorld } from '../space/world'
import { meanOf, overlap } from './label-place'
import { markScale, type OverlayPicture } from './overlay-picture'

/** Radii of the handle at the place, of a point without a weight, and what a weight of 1 adds to the area's root. */
const PLACE = 7
const LEAST = 3.5
const MORE = 4.5
/** A point at a vertex is a ring about the handle. */
const RING = 11
/** Points this close are one to the eye. */
const SAME_POINT = 6
const LETTER_WIDTH = 7
const TEXT_HEIGHT = 15
const TEXT_GAP = 4
/** Half the side of a square about a handle, its number or a mark that words keep off. */
const DISC = 7
const TURNS = [0, 0.5, -0.5, 1, -1, 1.6, -1.6, 2.3, -2.3, 3.1]
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
  readonly #halo = svg('path', { class: 'around-halo' })
  readonly #edges = svg('path', { class: 'around' })
  readonly #wayHalo = svg('path', { class: 'way-halo' })
  readonly #way = svg('path', { class: 'way' })
  readonly #handle = svg(
    'g',
    { class: 'place' },
    svg('circle', { class: 'place-rim', r: PLACE + 2 }),
    svg('circle', { class: 'place-dot', r: PLACE }),
    svg('circle', { class: 'place-middle', r: 2 }),
  )
  readonly #holds: Hold[] = []

  constructor() {
    this.root.append(this.#halo, this.#edges, this.#wayHalo, this.#way, this.#handle)
  }

  /** Returns the boxes of its words and of the handle. */
  update(picture: OverlayPicture, numbers: readonly Point[]): Box[] {
    const { place } = picture
    show(this.root, place !== null)
    if (place === null) return []
    this.#updatePlace(picture, place)
    while (this.#holds.length < place.points.length) this.#holds.push(this.#createHold())
    const { report, world, handles, camera } = picture
    const points = place.points.map(({ position }) => camera.project(toWorld(world, position)))
    const first = points.map(point => points.findIndex(other => areOne(other, point)))
    const least = report ? [camera.project(toWorld(world, report.minimizer.position))] : []
    const better = place.position ? [camera.project(toWorld(world, place.position))] : []
    const discs = [...handles, ...numbers, ...points, ...least, ...better].map(discAt)
    const words: Box[] = []
    this.#holds.forEach((parts, i) => {
      const at = points[i]
      show(parts.group, at !== undefined && at.depth > 0)
      if (!at) return
      const here = place.points.filter((_, other) => first[other] === i)
      const box = this.#updateHold(parts, at, here.length > 0 ? here : [place.points[i] as PlacePoint], picture)
      show(parts.text, here.length > 0)
      if (here.length > 0) words.push(placeText(parts.text, at, box, { picture, words, discs }))
    })
    return [...words, ...better.map(discAt)]
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

  /** All holds that are seen at one point. Returns half the width of their words, and their distance from the point. */
  #updateHold(
    { group, rim, dot, text }: Hold,
    at: ScreenPoint,
    holds: readonly PlacePoint[],
    { camera, sight, handles }: OverlayPicture,
  ): TextSize {
    const [{ point }] = holds as [PlacePoint]
    const weight = weightOf(holds)
    moveTo(group, at)
    group.classList.toggle('behind', point !== null && sight.hides(point))
    const isVertex = handles.some(handle => areOne(handle, at))
    group.classList.toggle('ring', isVertex)
    const radius = markScale(camera) * (isVertex ? RING : LEAST + MORE * Math.sqrt(weight ?? 0))
    set(rim, { r: px(radius + (isVertex ? 0 : 1.5)) })
    set(dot, { r: px(radius) })
    const labels = holds.map(({ label }) => label).join(', ')
    const words = weight === null ? labels : `${labels} ${shortWeight(weight)}`
    setText(text, words)
    return { half: (LETTER_WIDTH / 2) * words.length, gap: radius + TEXT_GAP }
  }

  #createHold(): Hold {
    const rim = svg('circle', { class: 'hold-rim' })
    const dot = svg('circle', { class: 'hold-dot' })
    const text = svg('text', { class: 'hold-text', 'text-anchor': 'middle' })
    const group = svg('g', { class: 'hold' }, rim, dot, text)
    this.root.append(group)
    return { group, rim, dot, text }
  }
}

function weightOf(holds: readonly PlacePoint[]): number | null {
  return holds.reduce<number | null>((sum, { weight }) => (sum === null || weight === null ? null : sum + weight), 0)
}

interface TextSize {
  readonly half: number
  readonly gap: number
}

/** Outwards from the element, or turned from there to where it covers least. Returns its box. */
function placeText(
  text: SVGTextElement,
  at: Point,
  { half, gap }: TextSize,
  { picture, words, discs }: { picture: OverlayPicture; words: readonly Box[]; discs: readonly Box[] },
): Box {
  const { handles, taken, camera } = picture
  const middle = meanOf(handles)
  const outwards = Math.atan2(at.y - middle.y, at.x - middle.x)
  const boxes = TURNS.map(turn => {
    const [x, y] = [Math.cos(outwards + turn), Math.sin(outwards + turn)]
    const [cx, cy] = [at.x + x * (gap + half), at.y + y * (gap + TEXT_HEIGHT / 2 - 4)]
    return { x: cx - half, y: cy - TEXT_HEIGHT / 2, width: 2 * half, height: TEXT_HEIGHT }
  })
  const covered = (box: Box) =>
    [...discs, ...taken, ...words].filter(other => overlap(box, other)).length +
    (box.x < 4 || box.x + box.width > camera.width - 4 || box.y < 4 || box.y + box.height > camera.height - 4 ? 2 : 0)
  const costs = boxes.map(covered)
  const box = boxes[costs.indexOf(Math.min(...costs))] as Box
  set(text, { x: px(box.x + half - at.x), y: px(box.y + TEXT_HEIGHT / 2 - at.y) })
  return box
}

function areOne(a: Point, b: Point): boolean {
  return Math.hypot(a.x - b.x, a.y - b.y) < SAME_POINT
}

function discAt({ x, y }: Point): Box {
  return { x: x - DISC, y: y - DISC, width: 2 * DISC, height: 2 * DISC }
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
