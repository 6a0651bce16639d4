/** The colour bar: maximum, zero and minimum at their true positions on the scene's own ramps, and the reference cube. */

import { approximation, lowerInside } from '../../core/inside'
import type { JacobianReport, Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import { type ReferenceCube, type State, sliceOf } from '../../model/state'
import { placeIn } from '../../views/place-in'
import { inUnit } from '../../views/point-steps'
import { sceneSlice } from '../../views/scene-slices'
import { say } from '../../words/say'
import {
  type ColourScale,
  cssColour,
  HATCH_PERIOD,
  RAMP_STEPS,
  type Ramp,
  rampColour,
  rampPosition,
  rampValue,
} from '../paint/colour-map'
import { px, set, setText, show, svg } from '../paint/svg'
import { TEXT_SIZE } from '../space/layout'

export interface ColourBarPicture {
  readonly state: State
  readonly report: Report | null
  readonly probe: JacobianReport | null
  readonly scale: ColourScale | null
  readonly ramp: Ramp
  /** Upright with the maximum on top, or lying with the maximum at the right. */
  readonly upright: boolean
  readonly length: number
}

const THICKNESS = 14
/** Thickness of the target of a pointer. */
const LEAST_TARGET = 28
const LABEL_HEIGHT = 15
const LABEL_GAP = 10
const CHARACTER_WIDTH = 7.4
/** Margins for labels beside an upright bar, and below a lying one. */
const MARGIN = { upright: 92, lying: 20 }
/** Length of the probe's arrowhead, on the side of the bar that has no labels. */
const PROBE_MARK = 7
/** Half a label's height sticks out at either end of an upright bar. */
const OVERHANG = 9
/** The most that a label sticks out at either end of a lying one. */
const END_OVERHANG = 8

type Tick = 'maximum' | 'zero' | 'minimum'

interface Label {
  readonly tick: Tick
  readonly value: number
  readonly text: string
}

let bars = 0

/** The least jacdet of the boundary, or of the whole element if its inside is shown. */
function leastShown(report: Report, state: State): number {
  const inside = sliceOf(sceneSlice, state).faceDisplay === 'inside' ? lowerInside(report) : null
  return inside ? approximation(inside).value : report.boundaryMinimum
}

export class ColourBar {
  readonly root = document.createElement('div')
  readonly #title = document.createElement('button')
  readonly #box = document.createElement('div')
  readonly #svg = svg('svg', { class: 'lettered', role: 'img' })
  readonly #gradient: SVGLinearGradientElement
  readonly #hatch: SVGPathElement
  readonly #bar: SVGRectElement
  readonly #clip = svg('rect')
  readonly #ticks: Readonly<Record<Tick, { readonly line: SVGPathElement; readonly label: SVGTextElement }>> = {
    maximum: createTick('maximum'),
    zero: createTick('zero'),
    minimum: createTick('minimum'),
  }
  /** The bar, and as much around it as a finger needs. */
  readonly #target = svg('rect', { class: 'target' })
  readonly #probe = svg('g', { class: 'probe' }, svg('path', { class: 'halo' }), svg('path', { class: 'line' }))
  #ramp: Ramp | null = null
  #shown: ColourBarPicture | null = null
  /** The ends and size that the ramp was last drawn with. */
  #drawn = ''

  /** `onCube` is told the reference cube that the reader asked for, `onProbe` the value under the pointer, or null. */
  constructor(onCube: (referenceCube: ReferenceCube) => void, onProbe: (value: number | null) => void) {
    const id = `scene-ramp-${++bars}`
    this.root.className = 'scene-scale'
    this.#title.type = 'button'
    this.#title.className = 'on-paper'
    this.#title.addEventListener('click', () => {
      onCube(this.#title.dataset.cube === 'unit' ? 'biunit' : 'unit')
    })
    this.#gradient = svg('linearGradient', { id })
    this.#bar = svg('rect', { fill: `url(#${id})` })
    this.#hatch = svg('path', { class: 'hatch', 'clip-path': `url(#${id}-clip)` })
    this.#svg.append(
      svg('defs', {}, this.#gradient, svg('clipPath', { id: `${id}-clip` }, this.#clip)),
      this.#bar,
      this.#hatch,
    )
    for (const { line, label } of Object.values(this.#ticks)) this.#svg.append(line, label)
    this.#svg.append(this.#probe, this.#target)
    this.#listen(onProbe)
    this.#box.className = 'bar'
    this.#box.append(this.#svg)
    this.root.append(this.#title, this.#box)
  }

  update(picture: ColourBarPicture): void {
    const { state, report, probe, scale, ramp, upright, length } = picture
    this.#shown = picture
    // A collapsed element has no colours to explain.
    const hasColours = report !== null && (report.boundaryMinimum !== 0 || report.boundaryMaximum !== 0)
    this.root.hidden = !hasColours
    if (!hasColours || scale === null) return
    this.#updateTitle(state.referenceCube)
    const { boundaryMaximum: maximum, exponent } = report
    const minimum = leastShown(report, state)
    const [bottom, top] = endsOf(minimum, maximum)
    const fromTop = (value: number) => ((top - rampPosition(scale, value)) / (top - bottom)) * length
    this.#updateRamp(ramp, top, bottom, fromTop(0), upright, length)
    const format = (value: number) => formatJacdet(value, exponent, state.referenceCube)
    const labels = labelsOf(minimum, maximum, format, upright)
    this.#updateTicks(labels, fromTop, upright, length)
    this.#updateProbe(probe && fromTop(timesPowerOfTwo(probe.jacdet, probe.exponent - exponent)), upright, length)
    set(this.#svg, {
      'aria-label': say('Colours of jacdet: maximum {maximum}, zero, minimum {minimum}', {
        maximum: format(maximum),
        minimum: format(minimum),
      }),
    })
  }

  #listen(onProbe: (value: number | null) => void): void {
    const target = this.#target
    const probe = (event: PointerEvent) => onProbe(this.#valueAt(event))
    target.addEventListener('pointermove', probe)
    target.addEventListener('pointerdown', probe)
    target.addEventListener('pointerleave', event => {
      if (event.pointerType !== 'touch') onProbe(null)
    })
  }

  #valueAt(event: PointerEvent): number | null {
    const place = placeIn(this.#box, event)
    if (!this.#shown || !place) return null
    const { state, report, scale, upright, length } = this.#shown
    if (!report || !scale) return null
    const fromTop = upright ? (place.y * (length + 2 * OVERHANG) - OVERHANG) / length : 1 - place.x
    const [bottom, top] = endsOf(leastShown(report, state), report.boundaryMaximum)
    return rampValue(scale, top - inUnit(fromTop) * (top - bottom))
  }

  #updateTitle(cube: ReferenceCube): void {
    if (this.#title.dataset.cube === cube) return
    this.#title.dataset.cube = cube
    this.#title.textContent = cube === 'unit' ? say('jacdet on [0,1]³') : say('jacdet on [−1,1]³')
    this.#title.title =
      cube === 'unit' ? say('Show jacdet on [−1,1]³, an eighth') : say('Show jacdet on [0,1]³, eight times')
  }

  #updateRamp(ramp: Ramp, top: number, bottom: number, zero: number, upright: boolean, length: number): void {
    const drawn = `${top} ${bottom} ${upright} ${length}`
    if (ramp === this.#ramp && drawn === this.#drawn) return
    this.#ramp = ramp
    this.#drawn = drawn
    const [width, height] = upright ? [THICKNESS, length] : [length, THICKNESS]
    const box = upright
      ? { x: -MARGIN.upright, y: -OVERHANG, width: MARGIN.upright + width, height: height + 2 * OVERHANG }
      : { x: 0, y: 0, width, height: height + MARGIN.lying }
    set(this.#svg, {
      viewBox: `${box.x} ${box.y} ${box.width} ${box.height}`,
      width: inEms(box.width),
      height: inEms(box.height),
    })
    set(this.#bar, { width, height })
    const reach = (LEAST_TARGET - THICKNESS) / 2
    const [across, along] = upright ? ['x', 'y'] : ['y', 'x']
    set(this.#target, {
      [across]: -reach,
      [along]: 0,
      width: upright ? LEAST_TARGET : width,
      height: upright ? height : LEAST_TARGET,
    })
    set(this.#gradient, upright ? { x1: 0, x2: 0, y1: 0, y2: 1 } : { x1: 1, x2: 0, y1: 0, y2: 0 })
    const steps = (top - bottom) * RAMP_STEPS
    this.#gradient.replaceChildren(
      ...Array.from({ length: steps + 1 }, (_, i) =>
        svg('stop', { offset: i / steps, 'stop-color': cssColour(rampColour(ramp, top - i / RAMP_STEPS)) }),
      ),
    )
    const negative = upright ? { y: zero, width, height: length - zero } : { x: 0, y: 0, width: length - zero, height }
    set(this.#clip, negative)
    let lines = ''
    for (let at = 0; at < length + THICKNESS; at += HATCH_PERIOD * Math.SQRT2) {
      lines += upright ? `M0 ${px(length - at)}l${width} ${width}` : `M${px(at - height)} 0l${height} ${height}`
    }
    set(this.#hatch, { d: lines })
    show(this.#hatch, bottom < 0)
  }

  #updateProbe(fromTop: number | null, upright: boolean, length: number): void {
    show(this.#probe, fromTop !== null)
    if (fromTop === null) return
    const [m, half] = [PROBE_MARK, PROBE_MARK * 0.6]
    const path = upright
      ? `M0 ${px(fromTop)}H${THICKNESS}l${m} ${-half}v${2 * half}l${-m} ${-half}`
      : `M${px(length - fromTop)} ${THICKNESS}V0l${-half} ${-m}h${2 * half}l${-half} ${m}`
    for (const child of this.#probe.children) set(child, { d: path })
  }

  #updateTicks(labels: readonly Label[], fromTop: (value: number) => number, upright: boolean, length: number): void {
    const heights = labels.map(({ value }) => fromTop(value))
    const sizes = labels.map(({ text }) => (upright ? LABEL_HEIGHT : CHARACTER_WIDTH * text.length + LABEL_GAP))
    const zero = labels.findIndex(({ tick }) => tick === 'zero')
    const spread = spreadLabels(heights, sizes, zero)
    const lying = () => spread.map((middle, i) => onBar(middle, (labels[i] as Label).text, length))
    const middles = upright ? spread : extremesApart(lying(), sizes, zero)
    const hasZeroLabel = upright || fits(middles, sizes, zero)
    for (const [tick, { line, label }] of Object.entries(this.#ticks)) {
      const i = labels.findIndex(shown => shown.tick === tick)
      show(line, i >= 0)
      show(label, i >= 0 && (i !== zero || hasZeroLabel))
      if (i < 0) continue
      const { text, value } = labels[i] as Label
      const [at, middle] = [heights[i] as number, middles[i] as number]
      setText(label, text)
      label.classList.toggle('negative', value < 0)
      if (upright) {
        set(line, { d: `M-3 ${px(at)}H${THICKNESS}` })
        set(label, { x: -8, y: px(middle), 'text-anchor': 'end' })
      } else {
        set(line, { d: `M${px(length - at)} 0V${THICKNESS + 3}` })
        set(label, { x: px(length - middle), y: THICKNESS + 12, 'text-anchor': 'middle' })
      }
    }
  }
}

/** The ramp positions at the ends of the bar, which has the signs that the element has. */
function endsOf(minimum: number, maximum: number): readonly [number, number] {
  const bottom = minimum < 0 ? -1 : 0
  return [bottom, maximum > 0 || bottom === 0 ? 1 : 0]
}

/** A length that grows with the text beside it. */
function inEms(length: number): string {
  return `${length / TEXT_SIZE}em`
}

/** A jacdet by the report's power of two: one too large or small for a double is at an end of the bar all the same. */
function timesPowerOfTwo(value: number, power: number): number {
  return value === 0 ? 0 : value * 2 ** power
}

function createTick(name: Tick) {
  return { line: svg('path', { class: `tick ${name}` }), label: svg('text', { class: `tick ${name}` }) }
}

/**
 * From the greatest to the least; an extreme that is zero, or a minimum that equals the maximum, says nothing new. A lying bar
 * has numbers only.
 */
function labelsOf(minimum: number, maximum: number, format: (value: number) => string, named: boolean): Label[] {
  const labels: Label[] = [{ tick: 'zero', value: 0, text: '0' }]
  if (maximum === minimum && maximum !== 0) labels.push({ tick: 'maximum', value: maximum, text: format(maximum) })
  else {
    if (maximum !== 0) labels.push({ tick: 'maximum', value: maximum, text: (named ? 'max ' : '') + format(maximum) })
    if (minimum !== 0) labels.push({ tick: 'minimum', value: minimum, text: (named ? 'min ' : '') + format(minimum) })
  }
  return labels.sort((a, b) => b.value - a.value)
}

/** The nearest middle, from the bar's maximum, that a label below a lying bar can have. */
function onBar(middle: number, text: string, length: number): number {
  const half = (CHARACTER_WIDTH * text.length) / 2 - END_OVERHANG
  return Math.max(half, Math.min(length - half, middle))
}

/** Of two extremes on one side of zero the inner label gives way: the end of the bar holds the outer one. */
export function extremesApart(middles: readonly number[], sizes: readonly number[], zero: number): readonly number[] {
  if (middles.length < 3 || zero === 1) return middles
  const outer = 2 - zero
  const [at, end] = [middles[1] as number, middles[outer] as number]
  const pitch = ((sizes[1] as number) + (sizes[outer] as number)) / 2
  return middles.with(1, outer === 0 ? Math.max(at, end + pitch) : Math.min(at, end - pitch))
}

/** True if a label touches none of its neighbours; a short bar keeps only its mark of zero. */
function fits(middles: readonly number[], sizes: readonly number[], label: number): boolean {
  return middles.every((middle, i) => {
    const apart = Math.abs(middle - (middles[label] as number))
    return i === label || apart + LABEL_GAP / 2 >= ((sizes[i] as number) + (sizes[label] as number)) / 2
  })
}

/** Middles of labels of these sizes, in order: each at its own, moved away from the fixed one if they would touch. */
export function spreadLabels(middles: readonly number[], sizes: readonly number[], fixed: number): number[] {
  const moved = middles.slice()
  const pitch = (i: number, j: number) => ((sizes[i] as number) + (sizes[j] as number)) / 2
  for (let i = fixed - 1; i >= 0; i--) {
    moved[i] = Math.min(middles[i] as number, (moved[i + 1] as number) - pitch(i, i + 1))
  }
  for (let i = fixed + 1; i < moved.length; i++) {
    moved[i] = Math.max(middles[i] as number, (moved[i - 1] as number) + pitch(i - 1, i))
  }
  return moved
}
