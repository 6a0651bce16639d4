/** The colour bar: maximum, zero and minimum at their true places on the scene's own ramps, and the units, said once. */
import type { Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import type { ReferenceCube, State } from '../../model/state'
import { type ColourScale, cssColour, RAMP_STEPS, type Ramp, rampColour, rampPosition } from './colour-map'
import { HATCH_PERIOD } from './faces-material'
import { px, set, setText, show, svg } from './svg'

const WIDTH = 14
/** Labels closer than this, middle to middle, are moved apart. */
const LABEL_PITCH = 15

export interface ColourBarPicture {
  readonly state: State
  readonly report: Report | null
  readonly scale: ColourScale | null
  readonly ramp: Ramp
  readonly height: number
}

interface Tick {
  readonly line: SVGPathElement
  readonly label: SVGTextElement
}

let bars = 0

export class ColourBar {
  readonly root = document.createElement('div')
  readonly #title = document.createElement('button')
  readonly #svg = svg('svg', { role: 'img' })
  readonly #gradient: SVGLinearGradientElement
  readonly #hatch: SVGPathElement
  readonly #bar: SVGRectElement
  readonly #clip = svg('rect', { width: WIDTH })
  readonly #maximum = createTick('tick maximum')
  readonly #zero = createTick('tick zero')
  readonly #minimum = createTick('tick minimum')
  #ramp: Ramp | null = null
  #signs = ''

  /** `toggleUnits` is told which reference cube the reader asked for. */
  constructor(toggleUnits: (referenceCube: ReferenceCube) => void) {
    const id = `scene-ramp-${++bars}`
    this.root.className = 'scene-scale'
    this.#title.type = 'button'
    this.#title.addEventListener('click', () => {
      toggleUnits(this.#title.dataset.cube === 'unit' ? 'biunit' : 'unit')
    })
    this.#gradient = svg('linearGradient', { id, x1: 0, x2: 0, y1: 0, y2: 1 })
    this.#bar = svg('rect', { width: WIDTH, fill: `url(#${id})` })
    this.#hatch = svg('path', { class: 'hatch', 'clip-path': `url(#${id}-clip)` })
    const clip = svg('clipPath', { id: `${id}-clip` }, this.#clip)
    const scale = svg('g', { class: 'bar' }, this.#bar, this.#hatch)
    this.#svg.append(svg('defs', {}, this.#gradient, clip), scale)
    for (const { line, label } of [this.#maximum, this.#minimum, this.#zero]) this.#svg.append(line, label)
    this.root.append(this.#title, this.#svg)
  }

  update({ state, report, scale, ramp, height }: ColourBarPicture): void {
    this.root.hidden = report === null
    if (report === null || scale === null) return
    this.#updateTitle(state.referenceCube)
    const { boundaryMinimum: minimum, boundaryMaximum: maximum, exponent } = report
    const top = maximum > 0 ? 1 : 0
    const bottom = minimum < 0 ? -1 : 0
    const span = Math.max(top - bottom, 1)
    const y = (value: number) => ((Math.max(top, bottom + 1) - rampPosition(scale, value)) / span) * height
    this.#updateRamp(ramp, Math.max(top, bottom + 1), bottom, y(0), height)
    const format = (value: number) => formatJacdet(value, exponent, state.referenceCube)
    const labels = [
      { tick: this.#maximum, value: maximum, text: maximum === minimum ? format(maximum) : `max ${format(maximum)}` },
      { tick: this.#zero, value: 0, text: '0' },
      { tick: this.#minimum, value: minimum, text: `min ${format(minimum)}` },
    ]
    const shown = labels
      .filter(
        ({ tick, value }) => tick === this.#zero || (value !== 0 && !(tick === this.#minimum && value === maximum)),
      )
      .sort((a, b) => b.value - a.value)
    const heights = shown.map(({ value }) => y(value))
    const places = spreadLabels(
      heights,
      shown.findIndex(({ tick }) => tick === this.#zero),
    )
    for (const { tick } of labels) showTick(tick, false)
    shown.forEach(({ tick, text }, i) => {
      showTick(tick, true)
      set(tick.line, { d: `M-3 ${px(heights[i] as number)}H${WIDTH}` })
      set(tick.label, { y: px(places[i] as number) })
      setText(tick.label, text)
    })
    this.#minimum.label.classList.toggle('negative', minimum < 0)
    this.#maximum.label.classList.toggle('negative', maximum < 0)
    set(this.#svg, {
      'aria-label': `Colours of jacdet: maximum ${format(maximum)}, zero, minimum ${format(minimum)}`,
      viewBox: `-92 -9 ${92 + WIDTH + 2} ${height + 18}`,
      width: 92 + WIDTH + 2,
      height: height + 18,
    })
  }

  #updateTitle(cube: ReferenceCube): void {
    if (this.#title.dataset.cube === cube) return
    this.#title.dataset.cube = cube
    this.#title.textContent = cube === 'unit' ? 'jacdet on [0,1]³' : 'jacdet on [−1,1]³'
    this.#title.title = cube === 'unit' ? 'Show jacdet on [−1,1]³, an eighth' : 'Show jacdet on [0,1]³, eight times'
  }

  #updateRamp(ramp: Ramp, top: number, bottom: number, zero: number, height: number): void {
    set(this.#bar, { height: px(height) })
    const signs = `${top} ${bottom} ${height}`
    if (ramp === this.#ramp && signs === this.#signs) return
    this.#ramp = ramp
    this.#signs = signs
    const steps = (top - bottom) * RAMP_STEPS
    const stops = Array.from({ length: steps + 1 }, (_, i) =>
      svg('stop', { offset: i / steps, 'stop-color': cssColour(rampColour(ramp, top - i / RAMP_STEPS)) }),
    )
    this.#gradient.replaceChildren(...stops)
    set(this.#clip, { y: px(zero), height: px(height - zero) })
    let lines = ''
    for (let y = zero; y < height + WIDTH; y += HATCH_PERIOD * Math.SQRT2) lines += `M0 ${px(y)}l${WIDTH} ${-WIDTH}`
    set(this.#hatch, { d: lines || 'M0 0' })
    show(this.#hatch, bottom < 0)
  }
}

function createTick(name: string): Tick {
  return { line: svg('path', { class: name }), label: svg('text', { class: name, x: -8, 'text-anchor': 'end' }) }
}

function showTick({ line, label }: Tick, shown: boolean): void {
  show(line, shown)
  show(label, shown)
}

/** Heights of labels, top to bottom: each at its own, moved away from the fixed one where they would touch. */
export function spreadLabels(heights: readonly number[], fixed: number): number[] {
  const places = heights.slice()
  for (let i = fixed - 1; i >= 0; i--) {
    places[i] = Math.min(heights[i] as number, (places[i + 1] as number) - LABEL_PITCH)
  }
  for (let i = fixed + 1; i < places.length; i++) {
    places[i] = Math.max(heights[i] as number, (places[i - 1] as number) + LABEL_PITCH)
  }
  return places
}
