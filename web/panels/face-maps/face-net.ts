/** The six faces unfolded: maps of jacdet with their marks, the readout and the tooltip of the point pointed at. */
import { html, render } from 'lit-html'
import type { Candidate, FaceReport, Report } from '../../core/report'
import { formatJacdet, formatPoint } from '../../model/decimal'
import { faces, type Vec3 } from '../../model/hexahedron'
import { sliceChange, sliceOf } from '../../model/state'
import { candidateShapes } from '../../scene/overlay/candidate-shapes'
import { colourScaleOf, rampOf, type Theme } from '../../scene/paint/colour-map'
import { type Palette, paletteOf } from '../../scene/paint/face-raster'
import { figureOf } from '../../scene/paint/figure'
import { ThemeReader } from '../../scene/paint/theme'
import { isNew } from '../../views/is-new'
import { inUnit } from '../../views/point-steps'
import { spokenOf } from '../../views/scene-slices'
import type { Figure, Frame, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import { FaceMap } from './face-map'
import { isOnFace, NET_COLUMNS, netCells, type Place, placeOnFace, placesOf, pointInCell } from './net'
import { candidateText, NetOverlay } from './net-overlay'
import type { OwnProbe } from './own-probe'
import { faceSlice } from './selected-face'

/** CSS pixels: the largest cell, and how near to a candidate means the candidate. */
const LARGEST_CELL = 108
const NEAR = 7
/** A map is pointed at in steps of 1/200, about half a pixel. */
const GRID = 200
/** The most device pixels to a CSS pixel; and pixels a side while a gesture runs. */
const MOST_PIXEL_RATIO = 3
const GESTURE_SIZE = 64

export type DrawReport = (frame: Frame, report: Report) => void

export class FaceNet {
  readonly root = document.createElement('div')
  readonly updates: readonly DrawReport[]
  /** The face last pointed at or focused: the tooltip stands beside the point's place there. */
  pointedFace = 0
  readonly #context: ViewContext
  readonly #probe: OwnProbe
  readonly #maps: readonly FaceMap[]
  readonly #overlay: NetOverlay
  readonly #readout = document.createElement('p')
  readonly #tooltip = document.createElement('p')
  readonly #theme: ThemeReader
  #cell = 0
  #palette: { readonly theme: Theme; readonly palette: Palette } | null = null
  #report: Report | null = null

  /** `describedBy` is the id of the sentence about keys. */
  constructor(context: ViewContext, probe: OwnProbe, describedBy: string) {
    this.#context = context
    this.#probe = probe
    this.#maps = faces.map((_, face) => new FaceMap(face, this.#actions, describedBy))
    this.#overlay = new NetOverlay(candidate => probe.set('marks', candidate?.point ?? null))
    this.#theme = new ThemeReader(this.root, () => context.requestFrame())
    this.updates = [
      ...this.#maps.map(
        (map): DrawReport =>
          (frame, report) =>
            this.#cell > 0 && this.#drawMap(map, frame, report),
      ),
      (frame, report) => this.#cell > 0 && this.#drawMarks(frame, report),
      (frame, report) => this.#drawReadout(frame, report),
    ]
    this.#build()
  }

  /** `width` is the panel's, in CSS pixels. */
  layOut(width: number, report: Report): void {
    this.#report = report
    const cell = Math.min(LARGEST_CELL, Math.floor(width / NET_COLUMNS))
    if (cell === this.#cell) return
    this.#cell = cell
    this.root.style.setProperty('--cell', `${cell}px`)
  }

  figure(): Figure | null {
    return this.#cell === 0 ? null : figureOf(this.root, this.root.querySelectorAll('canvas, .face-overlay'))
  }

  dispose(): void {
    this.#theme.dispose()
  }

  #build(): void {
    const inReadingOrder = this.#maps.toSorted((a, b) => readingOrder(a.face) - readingOrder(b.face))
    this.#readout.className = 'readout'
    this.#tooltip.className = 'tooltip'
    this.#tooltip.setAttribute('role', 'tooltip')
    this.#tooltip.hidden = true
    this.root.className = 'face-net'
    const roots = inReadingOrder.map(map => map.root)
    render([roots, this.#readout, legend(), this.#overlay.root, this.#tooltip], this.root)
    // Words for pointers are silent; where keys move the point, its value is spoken.
    this.root.addEventListener('focusin', () => this.#readout.setAttribute('aria-live', 'polite'))
    this.root.addEventListener('focusout', () => this.#readout.setAttribute('aria-live', 'off'))
  }

  readonly #actions = {
    point: (face: number, x: number, y: number) => {
      this.pointedFace = face
      const near = this.#candidateNear(face, x, y)
      this.#probe.set(
        'maps',
        near?.point ?? pointInCell(face, Math.round(x * GRID) / GRID, Math.round(y * GRID) / GRID),
      )
    },
    leave: () => this.#probe.set('maps', null),
    step: (face: number, right: number, down: number) => {
      this.pointedFace = face
      const { probe } = this.#context.state()
      const { column, row } = netCells[face] as (typeof netCells)[number]
      const isHere = probe !== null && isOnFace(face, probe)
      const from = isHere ? placeOnFace(face, probe) : { x: column + 0.5, y: row + 0.5 }
      this.#probe.set('maps', pointInCell(face, inUnit(from.x - column + right), inUnit(from.y - row + down)))
    },
    clear: (face: number) => {
      const { probe } = this.#context.state()
      if (probe === null || !isOnFace(face, probe)) return false
      this.#context.dispatch({ type: 'probe', point: null })
      return true
    },
    select: (selectedFace: number) => this.#context.dispatch(sliceChange(faceSlice, { selectedFace })),
  }

  #candidateNear(face: number, x: number, y: number): Candidate | null {
    const { column, row } = netCells[face] as (typeof netCells)[number]
    let nearest: Candidate | null = null
    let least = NEAR / this.#cell
    for (const candidate of this.#report?.candidates ?? []) {
      if (!isOnFace(face, candidate.point)) continue
      const place = placeOnFace(face, candidate.point)
      const distance = Math.hypot(place.x - column - x, place.y - row - y)
      if (distance >= least) continue
      least = distance
      nearest = candidate
    }
    return nearest
  }

  #drawMap(map: FaceMap, { state, isForPaper }: Frame, report: Report): void {
    const theme = this.#theme.read()
    if (this.#palette?.theme !== theme) this.#palette = { theme, palette: paletteOf(rampOf(theme), theme) }
    const ratio = isForPaper ? MOST_PIXEL_RATIO : Math.min(devicePixelRatio, MOST_PIXEL_RATIO)
    const sharp = Math.max(1, Math.round(this.#cell * ratio))
    const size = state.gestureStart !== null ? Math.min(sharp, GESTURE_SIZE) : sharp
    map.paint({
      bernstein: (report.faces[map.face] as FaceReport).bernstein,
      cell: netCells[map.face] as (typeof netCells)[number],
      scale: colourScaleOf(report.boundaryMinimum, report.boundaryMaximum),
      palette: this.#palette.palette,
      size,
      pixelRatio: size / this.#cell,
    })
  }

  #drawMarks({ state }: Frame, report: Report): void {
    const { probe, referenceCube } = state
    const spoken = JSON.stringify(spokenOf(state))
    const { selectedFace } = sliceOf(faceSlice, state)
    if (!isNew(this.#overlay, report, this.#cell, probe, selectedFace, spoken, referenceCube)) return
    for (const { root, face } of this.#maps) root.setAttribute('aria-pressed', String(face === selectedFace))
    this.#overlay.update({ state, report, cell: this.#cell })
  }

  #drawReadout({ state, probe }: Frame, report: Report): void {
    if (!isNew(this.#readout, report, probe, state.referenceCube, this.#cell, this.pointedFace)) return
    const onFaces = probe === null ? [] : faces.filter((_, face) => isOnFace(face, probe.point))
    const isOn = probe !== null && onFaces.length > 0
    const value = isOn ? formatJacdet(probe.jacdet, probe.exponent, state.referenceCube) : ''
    const words = isOn
      ? html`<b class=${probe.jacdet < 0 ? 'negative' : ''}>J = ${value}</b>
          <span>${formatPoint(probe.point)}</span>
          <span>${say('on {faces}', { faces: onFaces.map(({ name }) => name).join(', ') })}</span>`
      : html`<span class="off-paper">${say('Point at a map to read jacdet there, or use the arrow keys.')}</span>`
    render(words, this.#readout)
    const candidate = probe && report.candidates.find(({ point }) => point.every((x, axis) => x === probe.point[axis]))
    this.#tooltip.hidden = !candidate
    if (candidate) this.#placeTooltip(candidateText(candidate, report, state.referenceCube), candidate.point)
  }

  /** Puts the tooltip above the candidate, or below if it would leave the net. */
  #placeTooltip(text: string, point: Vec3): void {
    const cell = this.#cell
    const here = isOnFace(this.pointedFace, point)
      ? placeOnFace(this.pointedFace, point)
      : (placesOf(point)[0] as Place)
    this.#tooltip.textContent = text
    const width = this.#tooltip.offsetWidth
    const left = Math.max(0, Math.min(NET_COLUMNS * cell - width, here.x * cell - width / 2))
    this.#tooltip.style.left = `${Math.round(left)}px`
    this.#tooltip.style.top = `${Math.round(here.y * cell)}px`
    this.#tooltip.classList.toggle('below', here.y * cell < 40)
  }
}

function readingOrder(face: number): number {
  const { column, row } = netCells[face] as (typeof netCells)[number]
  return row * NET_COLUMNS + column
}

const KINDS = ['vertex', 'edge', 'face'] as const

const legend = () =>
  html`<p class="legend">${KINDS.map(
    kind =>
      html`<span><svg viewBox="-6 -6 12 12" aria-hidden="true"><path class="candidate" d=${candidateShapes[kind]} /></svg>${say(kind)}</span>`,
  )}<span><svg viewBox="-9 -9 18 18" aria-hidden="true"><circle class="ring" r="7" /></svg>${say('minimum')}</span></p>`
