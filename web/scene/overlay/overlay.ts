/** The SVG over the canvas: edges through the body, handles and their numbers, ghost, marks, axes. */

import type { JacobianReport } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import { edgeVertices, VERTEX_COUNT, type Vec3, type Vertices, vertexOf, vertexReference } from '../../model/hexahedron'
import { sliceOf } from '../../model/state'
import { sceneSlice, spokenOf, surroundingsSlice } from '../../views/scene-slices'
import { moveTo, px, set, setText, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import { gridStep, lengthOf, roundTo } from '../space/decimal-step'
import type { Box, Point } from '../space/layout'
import { at, map3, mix } from '../space/vec3'
import { extentOf, toWorld, verticesInWorld } from '../space/world'
import { Highlights } from './highlight'
import { meanOf, numberDirection, overlap } from './label-place'
import { LeastCurve } from './least-curve'
import { Marks } from './marks'
import { markScale, type OverlayPicture } from './overlay-picture'
import { BestPlaceMarks } from './place-marks'
import { type ProbeLook, ProbeMark } from './probe-mark'
import { SampleMarks } from './sample-marks'
import { SurroundingLines } from './surroundings'
import { type AxisLetters, Triad } from './triad'

export interface OverlayKind {
  readonly letters: AxisLetters
  /** Vertices that cannot be moved are dots, and the minimizer has no label. */
  readonly isFixed: boolean
}

const COORDINATE_WIDTH = 7.5
const DIGIT_WIDTH = 8
/** Radii of a handle, and of a vertex that cannot be moved. */
const RADIUS = 6
const FIXED_RADIUS = 3
/** Paper around a handle. */
const RIM = 2.5
/** The vertex whose handle shows that it can be dragged, while a hint says so: in most views it is at the rim. */
const CUED = 6
/** Arrowheads around it, up, right, down and left. */
const CUE = 'M-4-12L0-16L4-12M12-4L16 0L12 4M4 12L0 16L-4 12M-12 4L-16 0L-12-4'
/** Handles this close are one to the eye. */
const SAME_HANDLE = 3
/** Pieces of an edge, each hidden or seen as its middle is. */
const EDGE_PIECES = 6
/** Distance from a handle's middle to the middle of its number. */
const NUMBER_DISTANCE = 17
/** The same with a ring around the handle: the minimizer's, or that of the vertex spoken of. */
const RINGED_NUMBER_DISTANCE = 24

interface Handle {
  readonly group: SVGGElement
  readonly rim: SVGCircleElement
  readonly dot: SVGCircleElement
  readonly number: SVGTextElement
}

export class Overlay {
  readonly root = svg('svg', { class: 'scene-overlay lettered', 'aria-hidden': 'true' })
  readonly #edgeHalo = svg('path', { class: 'edge-halo' })
  readonly #haloBehind = svg('path', { class: 'edge-halo behind' })
  readonly #edges = svg('path', { class: 'edges' })
  readonly #edgesBehind = svg('path', { class: 'edges behind' })
  readonly #ghostHalo = svg('path', { class: 'ghost-halo' })
  readonly #ghost = svg('path', { class: 'ghost' })
  readonly #ghostHandle = svg('circle', { class: 'ghost', r: 6 })
  readonly #grid = svg('path', { class: 'grid' })
  readonly #axisLine = svg('path', { class: 'axis-line' })
  readonly #isFixed: boolean
  readonly #radius: number
  readonly #handles: readonly Handle[]
  readonly #coordinates = svg('text', { class: 'coordinates', 'text-anchor': 'middle' })
  readonly #surroundings = new SurroundingLines()
  readonly #highlights = new Highlights()
  readonly #curve = new LeastCurve()
  readonly #samples = new SampleMarks()
  readonly #bestPlace = new BestPlaceMarks()
  readonly #marks: Marks
  readonly #triad: Triad
  readonly #probe = new ProbeMark()
  #picture: OverlayPicture | null = null

  /** `onMinimum` is called when the number of the minimum is pressed. */
  constructor({ letters, isFixed }: OverlayKind, onMinimum: () => void) {
    this.#isFixed = isFixed
    this.#radius = isFixed ? FIXED_RADIUS : RADIUS
    this.#handles = Array.from({ length: VERTEX_COUNT }, (_, v) => createHandle(v, v === CUED && !isFixed))
    this.#marks = new Marks(!isFixed, onMinimum)
    this.#triad = new Triad(letters)
    this.root.append(
      this.#surroundings.root,
      this.#edgeHalo,
      this.#edges,
      this.#haloBehind,
      this.#edgesBehind,
      this.#highlights.root,
      this.#grid,
      this.#curve.root,
      this.#axisLine,
      this.#ghostHalo,
      this.#ghost,
      this.#ghostHandle,
      this.#probe.box.root,
      this.#marks.candidates,
      this.#bestPlace.root,
      ...this.#handles.map(handle => handle.group),
      this.#marks.minimizer,
      this.#samples.root,
      this.#probe.root,
      this.#coordinates,
      this.#triad.root,
    )
  }

  showHover(vertex: number | null): void {
    this.#handles.forEach((handle, v) => {
      handle.group.classList.toggle('hovered', v === vertex)
    })
  }

  /** Everything but the probe. */
  update(picture: OverlayPicture): void {
    this.#picture = picture
    const { camera } = picture
    this.root.classList.toggle('opaque', sliceOf(sceneSlice, picture.state).faceDisplay === 'opaque')
    set(this.root, { viewBox: `0 0 ${camera.width} ${camera.height}` })
    const edges = this.#updateEdges(picture)
    if (!this.#isFixed) this.#surroundings.update(picture)
    this.#highlights.update(picture)
    this.#curve.update(picture)
    this.#samples.update(picture, edges)
    const numbers = this.#updateHandles(picture)
    this.#updateGhost(picture)
    const labels = this.#bestPlace.update(picture, numbers)
    this.#updateAxisLine(picture)
    const coordinates = this.#updateCoordinates(picture)
    const taken = [...picture.taken, ...labels, ...(coordinates ? [coordinates] : [])]
    this.#marks.update({ ...picture, taken, numbers })
    this.#triad.update(camera)
  }

  /** `readout` is the box of the words about the point, if there are any. */
  updateProbe(probe: JacobianReport | null, look: ProbeLook, readout: Box | null = null): void {
    this.#marks.makeWay(probe && readout)
    if (this.#picture === null) return
    const taken = [...this.#picture.taken, readout, this.#marks.shownLabel].filter(box => box !== null)
    this.#probe.update(probe, look, { ...this.#picture, taken })
  }

  /** Dashed where a face hides them. Returns the path of all. */
  #updateEdges({ handles, camera, sight }: OverlayPicture): string {
    const paths = { seen: '', behind: '' }
    for (const [from, to] of edgeVertices) {
      const on = (share: number) => mix(vertexReference[from] as Vec3, vertexReference[to] as Vec3, share)
      let last = handles[from] as ScreenPoint
      let drawn: keyof typeof paths | null = null
      for (let piece = 1; piece <= EDGE_PIECES; piece++) {
        const next = camera.project(sight.positionOf(on(piece / EDGE_PIECES)))
        const kind = sight.hides(on((piece - 0.5) / EDGE_PIECES)) ? 'behind' : 'seen'
        const isInFront = last.depth > 0 && next.depth > 0
        if (isInFront)
          paths[kind] += `${drawn === kind ? '' : `M${px(last.x)} ${px(last.y)}`}L${px(next.x)} ${px(next.y)}`
        drawn = isInFront ? kind : null
        last = next
      }
    }
    for (const path of [this.#edgeHalo, this.#edges]) set(path, { d: paths.seen })
    for (const path of [this.#haloBehind, this.#edgesBehind]) set(path, { d: paths.behind })
    return edgePath(edgeVertices, handles)
  }

  /** Returns the middles of the numbers. */
  #updateHandles({ handles, state, preview, report, camera, sight, taken }: OverlayPicture): Point[] {
    const middle = meanOf(handles)
    const spoken = [report?.minimizer, ...spokenOf(state)]
    const ringed = spoken.map(part => (part?.kind === 'vertex' ? part.id : null))
    const texts = numberTexts(handles, preview?.order ?? null)
    const { fixed } = sliceOf(surroundingsSlice, state)
    const shown: Point[] = []
    const scale = markScale(camera)
    const numbers = handles.map((at, v) => {
      const { group, rim, dot, number } = this.#handles[v] as Handle
      const text = texts[v] as string
      setText(number, text)
      show(group, at.depth > 0)
      moveTo(group, at)
      set(rim, { r: px(scale * (this.#radius + RIM)) })
      set(dot, { r: px(scale * this.#radius) })
      const [dx, dy] = [at.x - middle.x, at.y - middle.y]
      const length = Math.hypot(dx, dy)
      const outwards = length > 1 ? { x: dx / length, y: dy / length } : { x: 0, y: -1 }
      const middleDistance = ringed.includes(v) ? RINGED_NUMBER_DISTANCE : NUMBER_DISTANCE
      const distance = middleDistance - (1 - scale) * this.#radius
      const others = [...shown, ...handles.filter((_, other) => other !== v && texts[other] !== '')]
      const { x: ux, y: uy } = text === '' ? outwards : numberDirection(at, outwards, distance, others, taken)
      const half = (DIGIT_WIDTH / 2) * Math.max(text.length - 1, 0)
      const x = ux * (distance + half)
      // A long number stays in the picture.
      const inside = half > 0 ? clamp(at.x + x, half + DIGIT_WIDTH, camera.width - half - DIGIT_WIDTH) - at.x : x
      set(number, { x: px(inside), y: px(uy * distance) })
      group.classList.toggle('selected', state.isVertexChosen && v === state.selectedVertex)
      group.classList.toggle('fixed', fixed.includes(v))
      group.classList.toggle('behind', sight.hides(vertexReference[v] as Vec3))
      const place = { x: at.x + ux * distance, y: at.y + uy * distance }
      if (text !== '') shown.push(place)
      return place
    })
    const selected = this.#handles[state.selectedVertex]?.group
    // The selected handle is drawn over its neighbours.
    if (selected && selected.nextSibling !== this.#marks.minimizer) this.#marks.minimizer.before(selected)
    return numbers
  }

  /** The edges of the vertex being moved as they were, or those of the order or the move that is previewed. */
  #updateGhost({ state, preview, world, camera, handles }: OverlayPicture): void {
    const { vertices, gestureStart, selectedVertex } = state
    const moved = gestureStart !== null && gestureStart !== vertices
    const moving = preview?.move ? verticesThatDiffer(vertices, preview.move) : []
    for (const path of [this.#ghostHalo, this.#ghost]) show(path, moved || preview !== null)
    show(this.#ghostHandle, moved || moving.length === 1)
    if (moved) {
      const before = verticesInWorld(world, gestureStart).map(point => camera.project(point))
      const own = edgeVertices.filter(edge => edge.includes(selectedVertex))
      this.#drawGhost(edgePath(own, before))
      moveTo(this.#ghostHandle, before[selectedVertex] as ScreenPoint)
    } else if (preview?.order) {
      const inOrder = preview.order.map(v => handles[v] as ScreenPoint)
      this.#drawGhost(edgePath(edgeVertices, inOrder))
    } else if (preview?.move) {
      const after = verticesInWorld(world, preview.move).map(point => camera.project(point))
      const own = edgeVertices.filter(edge => edge.some(v => moving.includes(v)))
      this.#drawGhost(edgePath(own, after))
      moveTo(this.#ghostHandle, after[moving[0] ?? 0] as ScreenPoint)
    }
  }

  #drawGhost(path: string): void {
    set(this.#ghostHalo, { d: path })
    set(this.#ghost, { d: path })
  }

  /** The position of the vertex being moved, in words. Returns their box. */
  #updateCoordinates({ state, drag, handles, camera, taken }: OverlayPicture): Box | null {
    const isMoving = state.gestureStart !== null
    show(this.#coordinates, isMoving)
    if (!isMoving) return null
    const handle = handles[state.selectedVertex] as ScreenPoint
    const position = vertexOf(state.vertices, state.selectedVertex)
    setText(this.#coordinates, `(${position.map(formatNumber).join(', ')})`)
    const width = COORDINATE_WIDTH * (this.#coordinates.textContent?.length ?? 0)
    const lift = drag?.byTouch ? 56 : 32
    const x = clamp(handle.x, width / 2 + 8, camera.width - width / 2 - 8)
    const beside = width / 2 + 28
    const boxes = [
      lineBox(x, handle.y - lift, width),
      lineBox(x, handle.y + lift, width),
      lineBox(handle.x - beside, handle.y, width),
      lineBox(handle.x + beside, handle.y, width),
    ] as const
    const box = boxes.find(box => box.x > 4 && box.y > 4 && !taken.some(other => overlap(box, other))) ?? boxes[0]
    set(this.#coordinates, { x: px(box.x + box.width / 2), y: px(box.y + box.height / 2) })
    return box
  }

  /** The axis, or the grid, that the vertex is held to. */
  #updateAxisLine(picture: OverlayPicture): void {
    const { state, drag, world, camera } = picture
    const axis = drag?.axis ?? null
    show(this.#grid, drag?.snaps === true)
    if (drag?.snaps) set(this.#grid, { d: gridPath(picture) })
    show(this.#axisLine, axis !== null)
    if (axis === null) return
    const middle = toWorld(world, vertexOf(state.vertices, state.selectedVertex))
    const ends = [-4, 4].map(length => camera.project(map3(k => at(middle, k) + (k === axis ? length : 0))))
    set(this.#axisLine, { d: edgePath([[0, 1]], ends) })
  }
}

/** The grid's lines on both sides of the vertex. */
const GRID_LINES = 6

/** The lines of Alt's grid about a vertex, in the two directions that are seen best. */
function gridPath({ state, world, camera }: OverlayPicture): string {
  const step = gridStep(extentOf(state.gestureStart ?? state.vertices))
  const vertex = vertexOf(state.vertices, state.selectedVertex)
  const back = camera.axes()[2].map(Math.abs)
  const axes = [0, 1, 2].filter(axis => axis !== back.indexOf(Math.max(...back)))
  const onGrid = (along: number, steps: number, across: number) =>
    map3(axis => {
      if (!axes.includes(axis)) return at(vertex, axis)
      return roundTo(at(vertex, axis), step) + (axis === along ? steps : across) * lengthOf(step)
    })
  let path = ''
  for (const along of axes)
    for (let across = -GRID_LINES; across <= GRID_LINES; across++) {
      const ends = [-GRID_LINES, GRID_LINES].map(steps => camera.project(toWorld(world, onGrid(along, steps, across))))
      path += edgePath([[0, 1]], ends)
    }
  return path
}

/** The box of a line of text with its middle at (x, y). */
function lineBox(x: number, y: number, width: number): Box {
  return { x: x - width / 2, y: y - 10, width, height: 20 }
}

function createHandle(vertex: number, hasCue: boolean): Handle {
  const rim = svg('circle', { class: 'rim' })
  const dot = svg('circle', { class: 'dot' })
  const number = svg('text', { class: 'number', 'text-anchor': 'middle' }, String(vertex))
  const group = svg('g', { class: 'handle' }, rim, dot, number)
  if (hasCue) group.prepend(svg('path', { class: 'cue', d: CUE }))
  return { group, rim, dot, number }
}

/**
 * Numbers of handles that coincide would hide each other: the first of them says them all, "2, 6". A vertex that the previewed
 * order gives another number has both, "2 → 3".
 */
function numberTexts(handles: readonly ScreenPoint[], order: readonly number[] | null): readonly string[] {
  const first = handles.map(({ x, y }) =>
    handles.findIndex(other => Math.hypot(other.x - x, other.y - y) < SAME_HANDLE),
  )
  const name = (v: number) => (order === null || order[v] === v ? `${v}` : `${v} → ${order.indexOf(v)}`)
  return handles.map((_, v) =>
    [...first.keys()]
      .filter(other => first[other] === v)
      .map(name)
      .join(', '),
  )
}

function verticesThatDiffer(one: Vertices, other: Vertices): number[] {
  return [...Array(VERTEX_COUNT).keys()].filter(v =>
    [0, 1, 2].some(axis => !Object.is(one[3 * v + axis], other[3 * v + axis])),
  )
}

/** Lines between those points that are in front of the eye. */
function edgePath(edges: readonly (readonly [number, number])[], points: readonly ScreenPoint[]): string {
  let path = ''
  for (const [from, to] of edges) {
    const [a, b] = [points[from], points[to]]
    if (a && b && a.depth > 0 && b.depth > 0) path += `M${px(a.x)} ${px(a.y)}L${px(b.x)} ${px(b.y)}`
  }
  return path || 'M0 0'
}

function clamp(value: number, least: number, greatest: number): number {
  return Math.max(least, Math.min(greatest, value))
}
