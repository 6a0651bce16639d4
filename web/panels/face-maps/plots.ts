/**
 * P, D, a and s* of the selected face over t in [0,1], with the roots of P. They share one t: that
 * of the probe, set by pointing at a plot or, as a slider, by keys.
 */
import { type FacePolynomials, valueAt, vertexInS } from '../../core/face-polynomials'
import type { FaceReport } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import type { ReferenceCube } from '../../model/state'
import { px, set, setText, show, svg } from '../../scene/paint/svg'
import { placeIn } from '../../views/place-in'
import { inUnit, isForeign, pointStep } from '../../views/point-steps'
import { say } from '../../words/say'
import { decimalText } from './formulas'

export interface PlotsPicture {
  readonly name: string
  readonly face: FaceReport
  readonly polynomials: FacePolynomials
  /** The exponent of the report. */
  readonly exponent: number
  readonly cube: ReferenceCube
}

interface Curve {
  readonly name: string
  readonly title: string
  /** The curve's value, null where it is not defined. */
  readonly at: (t: number) => number | null
  /** The range of values: fixed, or fitted to the curve and zero. */
  readonly range: readonly [number, number] | null
  readonly text: (value: number) => string
  readonly lines: readonly number[]
}

const WIDTH = 180
const HEIGHT = 110
const BOX = { left: 1, right: WIDTH - 1, top: 19, bottom: HEIGHT - 21 }
const SAMPLES = 80
const KEYS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }
const ROOT_SHAPES = { kept: 'M-3.4 -3.4H3.4V3.4H-3.4Z', dropped: 'M-3 -3L3 3M-3 3L3 -3' }
const MOST_ROOTS = 4

export class Plots {
  readonly root = document.createElement('div')
  readonly #plots = [new Plot(), new Plot(), new Plot(), new Plot()]
  readonly #values = document.createElement('p')
  readonly #slider = document.createElement('div')
  readonly #choose: (t: number | null) => void
  #curves: readonly Curve[] = []
  #picture: PlotsPicture | null = null
  #t: number | null = null

  /** `choose` gets the t that is pointed at. */
  constructor(choose: (t: number | null) => void) {
    this.#choose = choose
    this.root.className = 'plots'
    this.#slider.className = 'plot-grid'
    this.#slider.tabIndex = 0
    this.#slider.append(...this.#plots.map(plot => plot.root))
    for (const [name, value] of Object.entries({ role: 'slider', 'aria-valuemin': 0, 'aria-valuemax': 1 }))
      this.#slider.setAttribute(name, String(value))
    this.#values.className = 'values'
    this.root.append(this.#slider, this.#values)
    this.#listen()
  }

  update(picture: PlotsPicture, t: number | null): void {
    const shown = this.#picture
    const isSame = shown?.face === picture.face && shown.cube === picture.cube && shown.exponent === picture.exponent
    if (isSame && t === this.#t) return
    this.#t = t
    if (!isSame) {
      this.#picture = picture
      this.#curves = curvesOf(picture)
      this.#curves.forEach((curve, i) => {
        this.#plots[i]?.draw(curve, picture.face)
      })
      this.#slider.setAttribute(
        'aria-label',
        say('t on face {face}, with P, D, a and s* there', { face: picture.name }),
      )
    }
    for (const plot of this.#plots) plot.point(t)
    const text = t === null ? '' : this.#valuesText(t)
    this.#values.classList.toggle('off-paper', t === null)
    setText(
      this.#values,
      text ||
        say(
          'Point at a plot: the maps mark the least point of that row of the face. The dashed line in the picture joins these points.',
        ),
    )
    this.#slider.setAttribute('aria-valuenow', String(t ?? 0))
    this.#slider.setAttribute('aria-valuetext', text || say('no t chosen'))
  }

  #valuesText(t: number): string {
    const values = this.#curves.map(({ name, at, text }) => {
      const value = at(t)
      return `${name} = ${value === null ? '–' : text(value)}`
    })
    return [`t = ${formatNumber(t)}`, ...values].join(', ').replaceAll(' = ', '\u00a0=\u00a0')
  }

  #listen(): void {
    const slider = this.#slider
    const point = (event: PointerEvent) => {
      const plot = (event.target as Element).closest<HTMLElement>('.plot')
      const place = plot && placeIn(plot, event)
      if (!place) return
      const t = (place.x * WIDTH - BOX.left) / (BOX.right - BOX.left)
      this.#choose(Math.round(inUnit(t) * 200) / 200)
    }
    slider.addEventListener('pointermove', point)
    slider.addEventListener('pointerdown', point)
    slider.addEventListener('pointerleave', event => {
      if (event.pointerType !== 'touch') this.#choose(null)
    })
    slider.addEventListener('blur', () => this.#choose(null))
    slider.addEventListener('keydown', event => {
      const way = KEYS[event.key]
      if (isForeign(event)) return
      if (event.key === 'Escape' && this.#t !== null) this.#choose(null)
      else if (event.key === 'Home') this.#choose(0)
      else if (event.key === 'End') this.#choose(1)
      else if (way === undefined) return
      else this.#choose(this.#t === null ? 0.5 : inUnit(this.#t + way * pointStep(event)))
      event.preventDefault()
    })
  }
}

class Plot {
  readonly root = document.createElement('div')
  readonly #title = svg('text', { class: 'title', x: BOX.left, y: 12 })
  readonly #greatest = svg('text', { class: 'extreme', x: BOX.right, y: 12, 'text-anchor': 'end' })
  readonly #least = svg('text', { class: 'extreme', x: WIDTH / 2, y: HEIGHT - 3, 'text-anchor': 'middle' })
  readonly #lines = svg('path', { class: 'line' })
  readonly #zero = svg('path', { class: 'zero' })
  readonly #curve = svg('path', { class: 'curve' })
  readonly #guide = svg('path', { class: 'guide' })
  readonly #dot = svg('circle', { class: 'dot', r: 3.2 })
  readonly #roots = Array.from({ length: MOST_ROOTS }, () => svg('path', { class: 'root' }))
  #shown: Curve | null = null
  #range: readonly [number, number] = [-1, 1]

  constructor() {
    const ends = [0, 1].map(t =>
      svg('text', { class: 'end', x: xOf(t), y: HEIGHT - 3, 'text-anchor': t === 0 ? 'start' : 'end' }, String(t)),
    )
    const picture = svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, 'aria-hidden': 'true' })
    picture.append(this.#lines, this.#zero, this.#guide, this.#curve, ...this.#roots, this.#dot)
    picture.append(this.#title, this.#greatest, this.#least, ...ends)
    this.root.className = 'plot'
    this.root.append(picture)
  }

  draw(curve: Curve, { roots }: FaceReport): void {
    this.#shown = curve
    const values = Array.from({ length: SAMPLES + 1 }, (_, i) => curve.at(i / SAMPLES))
    this.#range = curve.range ?? rangeOf(values)
    setText(this.#title, curve.title)
    const [least, greatest] = this.#range
    const isFitted = curve.range === null
    setText(this.#greatest, isFitted && greatest > 0 ? curve.text(greatest) : '')
    setText(this.#least, isFitted && least < 0 ? curve.text(least) : '')
    this.#least.classList.toggle('negative', isFitted && least < 0)
    set(this.#curve, { d: this.#path(values) })
    set(this.#zero, { d: this.#level(0) })
    set(this.#lines, { d: curve.lines.map(value => this.#level(value)).join('') })
    this.#roots.forEach((mark, i) => {
      const root = roots[i]
      const value = root && curve.at(root.t)
      const isSeen = root !== undefined && typeof value === 'number' && this.#isSeen(value)
      show(mark, isSeen)
      if (!isSeen) return
      set(mark, {
        d: root.fate === 'kept' ? ROOT_SHAPES.kept : ROOT_SHAPES.dropped,
        transform: `translate(${px(xOf(root.t))} ${px(this.#yOf(value))})`,
      })
    })
  }

  point(t: number | null): void {
    const value = t === null ? null : (this.#shown?.at(t) ?? null)
    const isSeen = value !== null && this.#isSeen(value)
    show(this.#guide, t !== null)
    show(this.#dot, isSeen)
    if (t !== null) set(this.#guide, { d: `M${px(xOf(t))} ${BOX.top}V${BOX.bottom}` })
    if (t !== null && isSeen) set(this.#dot, { cx: px(xOf(t)), cy: px(this.#yOf(value)) })
  }

  #level(value: number): string {
    return `M${BOX.left} ${px(this.#yOf(value))}H${BOX.right}`
  }

  /** The path breaks off at values outside the plot, or undefined ones. */
  #path(values: readonly (number | null)[]): string {
    let path = ''
    let isOpen = false
    values.forEach((value, i) => {
      const isSeen = value !== null && this.#isSeen(value)
      if (isSeen) path += `${isOpen ? 'L' : 'M'}${px(xOf(i / SAMPLES))} ${px(this.#yOf(value))}`
      isOpen = isSeen
    })
    return path
  }

  #isSeen(value: number): boolean {
    return value >= this.#range[0] && value <= this.#range[1]
  }

  #yOf(value: number): number {
    const [least, greatest] = this.#range
    return BOX.bottom - ((value - least) / (greatest - least)) * (BOX.bottom - BOX.top)
  }
}

function curvesOf({ face, polynomials, exponent, cube }: PlotsPicture): Curve[] {
  const scaling = polynomials.exponent + exponent
  const quartic = face.quarticIsZero ? [0] : face.quartic
  const text = (power: number, degree: number) => (value: number) => decimalText(value, power, degree, cube)
  const fitted = { range: null, lines: [] }
  return [
    { ...fitted, name: 'P', title: 'P(t)', at: t => valueAt(quartic, t), text: text(face.quarticExponent, 3) },
    { ...fitted, name: 'D', title: 'D(t)', at: t => valueAt(polynomials.d, t), text: text(2 * scaling, 2) },
    { ...fitted, name: 'a', title: 'a(t)', at: t => valueAt(polynomials.a, t), text: text(scaling, 1) },
    {
      name: 's*',
      title: say('s*(t), inside from 0 to 1'),
      at: t => vertexInS(polynomials, t),
      range: [-0.5, 1.5],
      text: formatNumber,
      lines: [1],
    },
  ]
}

function rangeOf(values: readonly (number | null)[]): readonly [number, number] {
  const known = values.filter(value => value !== null)
  const [least, greatest] = [Math.min(0, ...known), Math.max(0, ...known)]
  return least === greatest ? [-1, 1] : [least, greatest]
}

function xOf(t: number): number {
  return BOX.left + t * (BOX.right - BOX.left)
}
