/** The colour bar: maximum, zero and minimum at their true places on the scene's own ramps, and the units, said once. */
import type { Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import type { ReferenceCube, State } from '../../model/state'
import { type ColourScale, cssColour, RAMP_STEPS, type Ramp, rampColour, rampPosition } from './colour-map'
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
    const places = spread([y(maximum), y(0), y(minimum)], [maximum !== 0, true, minimum !== 0 && minimum !== maximum])
    place(this.#maximum, y(maximum), places[0], maximum === minimum ? format(maximum) : `max ${format(maximum)}`)
    place(this.#zero, y(0), places[1], '0')
    place(this.#minimum, y(minimum), places[2], `min ${format(minimum)}`)
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
    for (let y = zero; y < height + WIDTH; y += 7 * Math.SQRT2) lines += `M0 ${px(y)}l${WIDTH} ${-WIDTH}`
    set(this.#hatch, { d: lines || 'M0 0' })
    show(this.#hatch, bottom < 0)
  }
}

function createTick(name: string): Tick {
  return { line: svg('path', { class: name }), label: svg('text', { class: name, x: -8, 'text-anchor': 'end' }) }
}

function place({ line, label }: Tick, y: number, labelY: number | null, text: string): void {
  show(label, labelY !== null)
  show(line, labelY !== null)
  if (labelY === null) return
  set(line, { d: `M-3 ${px(y)}H${WIDTH}` })
  set(label, { y: px(labelY) })
  setText(label, text)
}

type Places = [number | null, number | null, number | null]

/**
 * Heights of the three labels, top to bottom: each at its value, the outer ones moved away from zero where they would touch it.
 * `shown` says which there are; the zero is always there.
 */
function spread(ys: readonly [number, number, number], shown: readonly [boolean, boolean, boolean]): Places {
  const order = [0, 1, 2].filter(i => shown[i]).sort((a, b) => (ys[a] as number) - (ys[b] as number) || a - b)
  const places: Places = [null, null, null]
  const zeroAt = order.indexOf(1)
  places[1] = ys[1]
  for (let k = zeroAt - 1; k >= 0; k--) {
    const below = places[order[k + 1] as number] as number
    places[order[k] as 0 | 1 | 2] = Math.min(ys[order[k] as number] as number, below - LABEL_PITCH)
  }
  for (let k = zeroAt + 1; k < order.length; k++) {
    const above = places[order[k - 1] as number] as number
    places[order[k] as 0 | 1 | 2] = Math.max(ys[order[k] as number] as number, above + LABEL_PITCH)
  }
  return places
}
