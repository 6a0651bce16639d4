/** A section of the reference cube as a flat map of jacdet, with the minimizer and the probe. */
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import { axesOn, pointOn, sectionBernstein } from '../../core/section'
import { formatJacdet, formatNumber } from '../../model/decimal'
import type { Vec3 } from '../../model/hexahedron'
import { type State, sliceOf } from '../../model/state'
import { colourScaleInside, rampOf, type Theme } from '../../scene/paint/colour-map'
import { type Palette, paintFace, paletteOf } from '../../scene/paint/face-raster'
import { px, set, setText, show, svg } from '../../scene/paint/svg'
import { isNew } from '../../views/is-new'
import { placeIn } from '../../views/place-in'
import { inUnit, isForeign, pointStep } from '../../views/point-steps'
import { type Section, sceneSlice } from '../../views/scene-slices'
import { say } from '../../words/say'

export interface SectionPicture {
  readonly report: Report
  readonly theme: Theme
  readonly state: State
  /** CSS pixels a side. */
  readonly side: number
}

export const AXIS_NAMES = ['ξ', 'η', 'ζ'] as const

/** Pixels a side while a gesture runs, and the most to a CSS pixel when none does. */
const GESTURE_SIZE = 80
const MOST_PIXEL_RATIO = 2
/** The probe moves in steps of 1/200. */
const GRID = 200
const RING = 8
const CELL = { column: 0, row: 0, sToLeft: false, tDown: false }

const DIRECTIONS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

export class SectionMap {
  readonly root = document.createElement('div')
  readonly #canvas = document.createElement('canvas')
  readonly #context = this.#canvas.getContext('2d')
  readonly #svg = svg('svg', { 'aria-hidden': 'true' })
  readonly #border = svg('rect', { class: 'border' })
  readonly #rings = [svg('circle', { class: 'rim', r: RING }), svg('circle', { class: 'ring', r: RING })] as const
  readonly #minimizer = svg('g', { class: 'minimizer' }, ...this.#rings, svg('circle', { class: 'pupil', r: 3 }))
  readonly #label = svg('text', { class: 'value' })
  readonly #cross = svg('g', { class: 'cross' }, svg('path', { class: 'halo' }), svg('path'))
  readonly #names = [0, 1].map(() => svg('text', { class: 'axis' }))
  readonly #ends = [0, 1, 2].map(i => svg('text', { class: i === 1 ? 'axis last' : 'axis' }, i === 0 ? '0' : '1'))
  readonly #setProbe: (point: Vec3 | null) => void
  #image: ImageData | null = null
  #palette: { readonly theme: Theme; readonly palette: Palette } | null = null
  #section: Section = { axis: 2, value: 0.5 }
  #probe: Vec3 | null = null

  constructor(setProbe: (point: Vec3 | null) => void) {
    this.#setProbe = setProbe
    this.root.className = 'section-map'
    this.root.tabIndex = 0
    this.root.setAttribute('role', 'img')
    this.#svg.append(this.#border, ...this.#names, ...this.#ends, this.#cross, this.#minimizer, this.#label)
    this.root.append(this.#canvas, this.#svg)
    this.#listen()
  }

  update({ report, theme, state, side }: SectionPicture): void {
    const { section } = sliceOf(sceneSlice, state)
    this.#section = section
    this.#probe = state.probe
    const isMoving = state.gestureStart !== null
    if (!isNew(this, section, report, theme, side, isMoving, state.probe, state.referenceCube)) return
    if (isNew(this.#canvas, section, report, theme, side, isMoving)) this.#paint(section, report, theme, side, isMoving)
    this.#layOut(section, side)
    this.#mark(section, report, state, side)
  }

  #paint(section: Section, report: Report, theme: Theme, side: number, isMoving: boolean): void {
    if (this.#palette?.theme !== theme) this.#palette = { theme, palette: paletteOf(rampOf(theme), theme) }
    const sharp = Math.round(side * Math.min(devicePixelRatio, MOST_PIXEL_RATIO))
    const size = isMoving ? Math.min(sharp, GESTURE_SIZE) : sharp
    if (this.#image?.width !== size) {
      this.#canvas.width = size
      this.#canvas.height = size
      this.#image = new ImageData(size, size)
    }
    const { palette } = this.#palette
    const bernstein = sectionBernstein(report.bernstein, section.axis, section.value)
    const scale = colourScaleInside(report)
    const pixels = new Int32Array(this.#image.data.buffer)
    paintFace(pixels, { bernstein, cell: CELL, scale, palette, size, pixelRatio: size / side })
    this.#context?.putImageData(this.#image, 0, 0)
  }

  #layOut({ axis, value }: Section, side: number): void {
    const name = `${AXIS_NAMES[axis]} = ${formatNumber(value)}`
    this.root.setAttribute('aria-label', say('Map of jacdet on the section {section}', { section: name }))
    set(this.#svg, { width: side, height: side, viewBox: `0 0 ${side} ${side}` })
    set(this.#border, { width: side, height: side })
    const [s, t] = axesOn(axis)
    const [sName, tName] = this.#names as [SVGTextElement, SVGTextElement]
    setText(sName, `${AXIS_NAMES[s]} →`)
    setText(tName, `${AXIS_NAMES[t]} →`)
    set(sName, { x: px(side / 2), y: px(side + 15) })
    set(tName, { transform: `translate(-9 ${px(side / 2)}) rotate(-90)` })
    const places = [
      [-9, side + 15],
      [side, side + 15],
      [-9, 8],
    ] as const
    this.#ends.forEach((end, i) => {
      set(end, { x: px(places[i]?.[0] ?? 0), y: px(places[i]?.[1] ?? 0) })
    })
  }

  #mark({ axis, value }: Section, report: Report, { probe, referenceCube }: State, side: number): void {
    const [s, t] = axesOn(axis)
    const place = (point: Vec3) => ({ x: px(point[s] * side), y: px((1 - point[t]) * side) })
    const inside = lowerInside(report)
    const point = inside?.point ?? report.minimizer.point
    const least = inside ? approximation(inside).value : report.boundaryMinimum
    const isHere = point[axis] === value
    const at = place(point)
    set(this.#minimizer, { transform: `translate(${at.x} ${at.y})` })
    this.#minimizer.classList.toggle('off', !isHere)
    this.#minimizer.classList.toggle('positive', least > 0)
    show(this.#label, isHere)
    const text = `min J = ${formatJacdet(least, report.exponent, referenceCube)}`
    setText(this.#label, text)
    const onRight = point[s] > 0.55
    set(this.#label, {
      x: px(point[s] * side + (onRight ? -1 : 1) * (RING + 6)),
      y: px(Math.max(10, Math.min(side - 10, (1 - point[t]) * side))),
      'text-anchor': onRight ? 'end' : 'start',
    })
    const shown = probe !== null && probe[axis] === value
    show(this.#cross, shown)
    if (shown) {
      const { x, y } = place(probe)
      for (const path of this.#cross.children) set(path, { d: `M${x} 0V${side}M0 ${y}H${side}` })
    }
  }

  #listen(): void {
    const { root } = this
    root.addEventListener('pointermove', event => {
      const place = placeIn(root, event)
      const onGrid = (way: number) => Math.round(inUnit(way) * GRID) / GRID
      if (place) this.#probeAt(onGrid(place.x), onGrid(1 - place.y))
    })
    root.addEventListener('pointerleave', () => this.#setProbe(null))
    root.addEventListener('blur', () => this.#setProbe(null))
    root.addEventListener('keydown', event => this.#onKey(event))
  }

  #probeAt(s: number, t: number): void {
    const { axis, value } = this.#section
    this.#setProbe(pointOn(axis, value, s, t))
  }

  #onKey(event: KeyboardEvent): void {
    if (isForeign(event)) return
    const direction = DIRECTIONS[event.key]
    const { axis, value } = this.#section
    const probe = this.#probe?.[axis] === value ? this.#probe : null
    if (direction) {
      const step = pointStep(event)
      const [s, t] = axesOn(axis).map(a => probe?.[a] ?? 0.5) as [number, number]
      this.#probeAt(inUnit(s + step * direction[0]), inUnit(t + step * direction[1]))
    } else if (event.key === 'Escape' && probe) this.#setProbe(null)
    else return
    event.preventDefault()
  }
}
