/** The six faces as maps of jacdet, the bound of each, and the quartic of the selected one. */

import { html, render } from 'lit-html'
import { type FacePolynomials, facePolynomials, leastInRow } from '../../core/face-polynomials'
import type { Candidate, FaceReport, Report } from '../../core/report'
import { formatJacdet, formatPoint } from '../../model/decimal'
import { type FaceTopology, faces, type Vec3 } from '../../model/hexahedron'
import { sliceChange, sliceOf } from '../../model/state'
import { candidateShapes } from '../../scene/overlay/candidate-shapes'
import { colourScaleOf, rampOf, type Theme } from '../../scene/paint/colour-map'
import { type Palette, paletteOf } from '../../scene/paint/face-raster'
import { figureOf } from '../../scene/paint/figure'
import { ThemeReader } from '../../scene/paint/theme'
import { isNew } from '../../views/is-new'
import { inUnit } from '../../views/point-steps'
import { marksSlice } from '../../views/scene-slices'
import type { CreateView, Figure, FigureName, Frame, Update, View, ViewContext } from '../../views/view'
import { boundsTable } from './bounds-table'
import { FaceMap } from './face-map'
import css from './face-maps.css?inline'
import { formulas } from './formulas'
import { facePoint, isOnFace, NET_COLUMNS, netCells, type Place, placeOnFace, placesOf, pointInCell } from './net'
import { candidateText, NetOverlay } from './net-overlay'
import { Plots } from './plots'
import { quarticWords } from './quartic'
import { faceSlice } from './selected-face'

export const styles = css

/** CSS pixels: the largest cell, and how near to a candidate means the candidate. */
const LARGEST_CELL = 108
const NEAR = 7
/** A map is pointed at in steps of 1/200, about half a pixel. */
const GRID = 200
/** The most device pixels to a CSS pixel; and pixels a side while a gesture runs. */
const MOST_PIXEL_RATIO = 3
const GESTURE_SIZE = 64

const KEYS = 'Arrow keys move the point over this face. Escape removes it. Enter shows the face’s quartic.'
const HINT = 'Point at a map to read jacdet there, or use the arrow keys.'

class FaceMapsView implements View {
  readonly root = document.createElement('div')
  readonly updates: readonly Update[]
  readonly #context: ViewContext
  readonly #net = document.createElement('div')
  readonly #maps: readonly FaceMap[]
  readonly #overlay = new NetOverlay(candidate => this.#setProbe('marks', candidate?.point ?? null))
  readonly #readout = document.createElement('p')
  readonly #tooltip = document.createElement('p')
  readonly #table = document.createElement('div')
  readonly #words = document.createElement('div')
  readonly #formulas = document.createElement('div')
  readonly #plots = new Plots(t => this.#probeRow(t))
  readonly #theme: ThemeReader
  readonly #resizes: ResizeObserver
  #width = 0
  #cell = 0
  #palette: { readonly theme: Theme; readonly palette: Palette } | null = null
  #report: Report | null = null
  /** The face last pointed at or focused: the tooltip stands beside the point's place there. */
  #pointedFace = 0
  #ownProbe: { readonly by: 'maps' | 'marks' | 'plots'; readonly point: Vec3 } | null = null
  #polynomials: { readonly face: FaceReport; readonly of: FacePolynomials } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.#maps = faces.map((_, face) => new FaceMap(face, this.#actions, 'face-map-keys'))
    this.updates = [
      ...this.#maps.map(map => this.#updating((frame, report) => this.#cell > 0 && this.#drawMap(map, frame, report))),
      this.#updating((frame, report) => this.#cell > 0 && this.#drawMarks(frame, report)),
      this.#updating((frame, report) => this.#drawReadout(frame, report)),
      this.#updating((frame, report) => this.#drawWords(frame, report)),
      this.#updating((frame, report) => this.#drawFormulas(frame, report)),
      this.#updating((frame, report) => this.#drawPlots(frame, report)),
    ]
    this.#build()
    this.#theme = new ThemeReader(this.root, () => context.requestFrame())
    this.#resizes = new ResizeObserver(entries => {
      this.#width = Math.floor(entries.at(-1)?.contentRect.width ?? 0)
      context.requestFrame()
    })
    this.#resizes.observe(this.root)
  }

  update({ report }: Frame): void {
    this.root.hidden = report === null
    this.#report = report
    if (report !== null) this.#layOut()
  }

  #updating(draw: (frame: Frame, report: Report) => void): Update {
    return frame => {
      if (frame.report !== null) draw(frame, frame.report)
    }
  }

  figure(name: FigureName): Figure | null {
    if (name !== 'face-maps' || this.#report === null || this.#cell === 0) return null
    return figureOf(this.#net, this.#net.querySelectorAll('canvas, .face-overlay'))
  }

  dispose(): void {
    this.#resizes.disconnect()
    this.#theme.dispose()
  }

  #build(): void {
    const inReadingOrder = this.#maps.toSorted((a, b) => readingOrder(a.face) - readingOrder(b.face))
    this.#readout.className = 'readout'
    this.#tooltip.className = 'tooltip'
    this.#tooltip.setAttribute('role', 'tooltip')
    this.#tooltip.hidden = true
    this.#net.className = 'face-net'
    const roots = inReadingOrder.map(map => map.root)
    render([roots, this.#readout, legend, this.#overlay.root, this.#tooltip], this.#net)
    // Words for pointers are silent; where keys move the point, its value is spoken.
    this.#net.addEventListener('focusin', () => this.#readout.setAttribute('aria-live', 'polite'))
    this.#net.addEventListener('focusout', () => this.#readout.setAttribute('aria-live', 'off'))
    this.root.className = 'face-maps'
    const keys = html`<span id="face-map-keys" class="said">${KEYS}</span>`
    render([this.#net, keys, this.#table, this.#words, this.#plots.root, this.#formulas], this.root)
  }

  readonly #actions = {
    point: (face: number, x: number, y: number) => {
      this.#pointedFace = face
      const near = this.#candidateNear(face, x, y)
      this.#setProbe('maps', near?.point ?? pointInCell(face, Math.round(x * GRID) / GRID, Math.round(y * GRID) / GRID))
    },
    leave: () => this.#setProbe('maps', null),
    step: (face: number, right: number, down: number) => {
      this.#pointedFace = face
      const { probe } = this.#context.state()
      const { column, row } = netCells[face] as (typeof netCells)[number]
      const isHere = probe !== null && isOnFace(face, probe)
      const from = isHere ? placeOnFace(face, probe) : { x: column + 0.5, y: row + 0.5 }
      this.#setProbe('maps', pointInCell(face, inUnit(from.x - column + right), inUnit(from.y - row + down)))
    },
    clear: (face: number) => {
      const { probe } = this.#context.state()
      if (probe === null || !isOnFace(face, probe)) return false
      this.#context.dispatch({ type: 'probe', point: null })
      return true
    },
    select: (selectedFace: number) => this.#context.dispatch(sliceChange(faceSlice, { selectedFace })),
  }

  /** A map ends no other probe than its own, such as when it is scrolled from under the pointer. */
  #setProbe(by: 'maps' | 'marks' | 'plots', point: Vec3 | null): void {
    const { probe } = this.#context.state()
    const own = this.#ownProbe
    const isOwn = own?.by === by && probe !== null && own.point.every((x, axis) => x === probe[axis])
    if (point === null && !isOwn) return
    this.#ownProbe = point && { by, point }
    this.#context.dispatch({ type: 'probe', point })
  }

  /** Probes the point at which the face's row t has its least value. */
  #probeRow(t: number | null): void {
    const { selectedFace } = sliceOf(faceSlice, this.#context.state())
    const face = this.#report?.faces[selectedFace]
    this.#pointedFace = selectedFace
    this.#setProbe(
      'plots',
      t === null || !face ? null : facePoint(selectedFace, leastInRow(this.#polynomialsOf(face), t), t),
    )
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

  #polynomialsOf(face: FaceReport): FacePolynomials {
    if (this.#polynomials?.face !== face) this.#polynomials = { face, of: facePolynomials(face.bernstein) }
    return this.#polynomials.of
  }

  #layOut(): void {
    const cell = Math.min(LARGEST_CELL, Math.floor(this.#width / NET_COLUMNS))
    if (cell === this.#cell) return
    this.#cell = cell
    this.#net.style.setProperty('--cell', `${cell}px`)
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
    const { highlight } = sliceOf(marksSlice, state)
    const { selectedFace } = sliceOf(faceSlice, state)
    if (!isNew(this.#overlay, report, this.#cell, probe, selectedFace, highlight, referenceCube)) return
    for (const { root, face } of this.#maps) root.setAttribute('aria-pressed', String(face === selectedFace))
    this.#overlay.update({ state, report, cell: this.#cell })
  }

  #drawReadout({ state, probe }: Frame, report: Report): void {
    if (!isNew(this.#readout, report, probe, state.referenceCube, this.#cell, this.#pointedFace)) return
    const onFaces = probe === null ? [] : faces.filter((_, face) => isOnFace(face, probe.point))
    const isOn = probe !== null && onFaces.length > 0
    const value = isOn ? formatJacdet(probe.jacdet, probe.exponent, state.referenceCube) : ''
    const words = isOn
      ? html`<b class=${probe.jacdet < 0 ? 'negative' : ''}>J = ${value}</b>
          <span>${formatPoint(probe.point)}</span>
          <span>on ${onFaces.map(({ name }) => name).join(', ')}</span>`
      : html`<span class="off-paper">${HINT}</span>`
    render(words, this.#readout)
    const candidate = probe && report.candidates.find(({ point }) => point.every((x, axis) => x === probe.point[axis]))
    this.#tooltip.hidden = !candidate
    if (candidate) this.#placeTooltip(candidateText(candidate, report, state.referenceCube), candidate.point)
  }

  /** Puts the tooltip above the candidate, or below if it would leave the net. */
  #placeTooltip(text: string, point: Vec3): void {
    const cell = this.#cell
    const here = isOnFace(this.#pointedFace, point)
      ? placeOnFace(this.#pointedFace, point)
      : (placesOf(point)[0] as Place)
    this.#tooltip.textContent = text
    const width = this.#tooltip.offsetWidth
    const left = Math.max(0, Math.min(NET_COLUMNS * cell - width, here.x * cell - width / 2))
    this.#tooltip.style.left = `${Math.round(left)}px`
    this.#tooltip.style.top = `${Math.round(here.y * cell)}px`
    this.#tooltip.classList.toggle('below', here.y * cell < 40)
  }

  #drawWords({ state }: Frame, report: Report): void {
    const { referenceCube } = state
    const { selectedFace } = sliceOf(faceSlice, state)
    if (!isNew(this.#words, report, referenceCube, selectedFace)) return
    render(boundsTable(report, referenceCube, selectedFace), this.#table)
    render(quarticWords(report, report.faces[selectedFace] as FaceReport, referenceCube), this.#words)
  }

  #drawFormulas({ state }: Frame, report: Report): void {
    const { referenceCube } = state
    const { selectedFace } = sliceOf(faceSlice, state)
    if (!isNew(this.#formulas, report, referenceCube, selectedFace)) return
    const face = report.faces[selectedFace] as FaceReport
    render(formulas(face, this.#polynomialsOf(face), report.exponent, referenceCube), this.#formulas)
  }

  #drawPlots({ state }: Frame, report: Report): void {
    const face = report.faces[sliceOf(faceSlice, state).selectedFace] as FaceReport
    const onFace = state.probe !== null && isOnFace(face.id, state.probe)
    const t = onFace ? (state.probe as Vec3)[(faces[face.id] as FaceTopology).t] : null
    const { name } = faces[face.id] as FaceTopology
    const picture = { name, face, exponent: report.exponent, cube: state.referenceCube }
    this.#plots.update({ ...picture, polynomials: this.#polynomialsOf(face) }, t)
  }
}

function readingOrder(face: number): number {
  const { column, row } = netCells[face] as (typeof netCells)[number]
  return row * NET_COLUMNS + column
}

const legend = html`<p class="legend">${Object.entries(candidateShapes).map(
  ([kind, d]) =>
    html`<span><svg viewBox="-6 -6 12 12" aria-hidden="true"><path class="candidate" d=${d} /></svg>${kind}</span>`,
)}<span><svg viewBox="-9 -9 18 18" aria-hidden="true"><circle class="ring" r="7" /></svg>minimum</span></p>`

export const create: CreateView = context => new FaceMapsView(context)
