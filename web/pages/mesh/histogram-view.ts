/** The histogram of relative minima: logarithmic counts, zero marked; a range of it, by pointer or keys, lists its cells alone. */
import { html, nothing, render, svg, type TemplateResult } from 'lit-html'
import { formatNumber } from '../../model/decimal'
import type { Histogram } from '../../survey/survey-jobs'
import { type End, endsOf, type Range, rangeAfter, rangeOf } from './histogram-range'

const WIDTH = 320
const HEIGHT = 72
/** Units of the width: a pointer that has moved less has clicked. */
const CLICK = 2

const ENDS: readonly (readonly [End, string])[] = [
  ['lower', 'Least relative minimum in the list'],
  ['upper', 'Greatest relative minimum in the list'],
]

interface Drag {
  readonly pointer: number
  /** The end that stays, and the one that moves. */
  readonly anchor: number
  readonly to: number
}

export class HistogramView {
  readonly root = document.createElement('figure')
  readonly #onRange: (range: Range) => void
  #histogram: Histogram | null = null
  #range: Range = null
  #drag: Drag | null = null

  constructor(onRange: (range: Range) => void) {
    this.#onRange = onRange
    this.root.className = 'histogram'
  }

  show(histogram: Histogram | null, range: Range): HTMLElement | typeof nothing {
    if (histogram !== this.#histogram) this.#drag = null
    this.#histogram = histogram
    this.#range = range
    this.#render()
    if (histogram === null) render(nothing, this.root)
    return histogram?.counts.length === 0 ? nothing : this.root
  }

  #render(): void {
    const histogram = this.#histogram
    if (histogram && histogram.counts.length > 0) render(this.#template(histogram), this.root)
  }

  #template(histogram: Histogram): TemplateResult {
    const { edges, counts } = histogram
    const [least, greatest] = [edges[0] as number, edges.at(-1) as number]
    const most = Math.log1p(Math.max(...counts))
    const x = (value: number) => placeOf(value, edges) * WIDTH
    const bars = counts.map((count, i) => {
      if (count === 0) return nothing
      const [from, to] = [edges[i] as number, edges[i + 1] as number]
      const height = (Math.log1p(count) / most) * (HEIGHT - 4)
      return svg`<rect class=${to <= 0 ? 'negative' : ''} x=${x(from)} y=${HEIGHT - height} width=${Math.max(1, x(to) - x(from) - 0.5)} height=${height}><title>${`${count.toLocaleString('en')} from ${formatNumber(from)} to ${formatNumber(to)}`}</title></rect>`
    })
    const drawn = this.#drag ? rangeBetween(this.#drag, edges) : this.#range
    const [lower, upper] = endsOf(drawn, edges)
    const chosen =
      drawn === null
        ? nothing
        : svg`<rect class="range" x=${x(lower)} y="0" width=${Math.max(2, x(upper) - x(lower))} height=${HEIGHT}></rect>`
    const zero = least < 0 && greatest > 0 ? svg`<path class="zero" d=${`M${x(0)} 0V${HEIGHT}`}></path>` : nothing
    const text = percentileWords(histogram)
    return html`<div
        class="plot"
        @pointerdown=${this.#onDown}
        @pointermove=${this.#onMove}
        @pointerup=${this.#onUp}
        @pointercancel=${this.#onCancel}
      >
        <svg
          viewBox=${`0 0 ${WIDTH} ${HEIGHT}`}
          preserveAspectRatio="none"
          role="img"
          aria-label=${`Relative minima, from ${formatNumber(least)} to ${formatNumber(greatest)}. Below which so many per cent of the cells are: ${text}.`}
        >
          ${bars}${zero}${chosen}
        </svg>
        ${ENDS.map(([end, name]) => this.#handle(end, name, end === 'lower' ? lower : upper, edges))}
      </div>
      <figcaption>
        <span title=${`From ${formatNumber(least)}`}>${leftOf(edges) > least ? '≤ −1' : formatNumber(least)}</span
        ><span title="The heights are logarithms of the counts.">Relative minimum: least jacdet / volume</span
        ><span>${formatNumber(greatest)}</span>
      </figcaption>
      <p class="percentiles" title="Below which so many per cent of the cells are">${text}</p>`
  }

  #handle(end: End, name: string, value: number, edges: readonly number[]): TemplateResult {
    const [least, greatest] = [edges[0] as number, edges.at(-1) as number]
    const now = Math.max(value, least)
    return html`<span
      class=${`handle ${end}`}
      role="slider"
      tabindex="0"
      aria-label=${name}
      aria-valuemin=${least}
      aria-valuemax=${greatest}
      aria-valuenow=${now}
      aria-valuetext=${formatNumber(now)}
      title="Drag, or arrow keys"
      .style=${`left: ${100 * placeOf(value, edges)}%`}
      data-end=${end}
      @keydown=${(event: KeyboardEvent) => this.#onKey(event, end, edges)}
    ></span>`
  }

  #onKey(event: KeyboardEvent, end: End, edges: readonly number[]): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return
    const range = event.key === 'Escape' ? null : rangeAfter(event.key, end, this.#range, edges)
    if (range === undefined) return
    event.preventDefault()
    this.#onRange(range)
  }

  readonly #onDown = (event: PointerEvent): void => {
    const edges = this.#histogram?.edges
    if (!edges || event.button !== 0 || this.#drag) return
    const plot = event.currentTarget as HTMLElement
    plot.setPointerCapture(event.pointerId)
    const end = (event.target as HTMLElement).dataset.end as End | undefined
    const [lower, upper] = endsOf(this.#range, edges)
    const at = valueAt(event, edges)
    const [anchor, to] = end === 'lower' ? [upper, lower] : end === 'upper' ? [lower, upper] : [at, at]
    this.#drag = { pointer: event.pointerId, anchor, to }
  }

  readonly #onMove = (event: PointerEvent): void => {
    const edges = this.#histogram?.edges
    if (!edges || this.#drag?.pointer !== event.pointerId) return
    this.#drag = { ...this.#drag, to: valueAt(event, edges) }
    this.#render()
  }

  readonly #onUp = (event: PointerEvent): void => {
    const edges = this.#histogram?.edges
    if (!edges || this.#drag?.pointer !== event.pointerId) return
    const range = rangeBetween(this.#drag, edges)
    this.#drag = null
    this.#onRange(range)
    this.#render()
  }

  readonly #onCancel = ({ pointerId }: PointerEvent): void => {
    if (this.#drag?.pointer !== pointerId) return
    this.#drag = null
    this.#render()
  }
}

/** What is up to -1 has a bar as wide as the others. */
function leftOf(edges: readonly number[]): number {
  return Math.max(edges[0] as number, -1 - 1 / 40)
}

/** From 0 to 1. */
function placeOf(value: number, edges: readonly number[]): number {
  const from = leftOf(edges)
  return Math.min(1, (Math.max(value, from) - from) / ((edges.at(-1) as number) - from))
}

function valueAt({ currentTarget, clientX }: PointerEvent, edges: readonly number[]): number {
  const box = (currentTarget as Element).getBoundingClientRect()
  const [from, greatest] = [leftOf(edges), edges.at(-1) as number]
  const value = from + ((clientX - box.left) / box.width) * (greatest - from)
  return value <= from ? Number.NEGATIVE_INFINITY : Math.min(value, greatest)
}

function rangeBetween({ anchor, to }: Drag, edges: readonly number[]): Range {
  const [lower, upper] = anchor < to ? [anchor, to] : [to, anchor]
  const width = WIDTH * (placeOf(upper, edges) - placeOf(lower, edges))
  return width < CLICK ? null : rangeOf(lower, upper, edges)
}

function percentileWords({ percentiles }: Histogram): string {
  // A percentile is read at a glance; bars, list and files have more digits.
  const rounded = (value: number) => formatNumber(Number(value.toPrecision(3)))
  return percentiles.map(({ percent, value }) => `${percent}\u00a0%:\u00a0${rounded(value)}`).join(' · ')
}
