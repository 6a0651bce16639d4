/** The histogram of relative minima: logarithmic counts, zero marked; a range of it is dragged to list its cells alone. */
import { html, nothing, svg, type TemplateResult } from 'lit-html'
import { formatNumber } from '../../model/decimal'
import type { Histogram } from '../../survey/survey-jobs'

const WIDTH = 320
const HEIGHT = 72

export type Range = readonly [number, number] | null

export function histogramTemplate(
  histogram: Histogram,
  range: Range,
  onRange: (range: Range) => void,
): TemplateResult | typeof nothing {
  const { edges, counts, percentiles } = histogram
  if (counts.length === 0) return nothing
  const least = edges[0] as number
  const greatest = edges.at(-1) as number
  const most = Math.log1p(Math.max(...counts))
  // What is below -1 has a bar of its own width at the left.
  const from = Math.max(least, -1 - 1 / 40)
  const x = (value: number) => ((Math.max(value, from) - from) / (greatest - from)) * WIDTH
  const valueAt = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect()
    const value = from + ((event.clientX - box.left) / box.width) * (greatest - from)
    return value <= from ? -Infinity : Math.min(value, greatest)
  }
  let begun: number | null = null
  const onDown = (event: PointerEvent) => {
    begun = valueAt(event)
    ;(event.currentTarget as Element).setPointerCapture(event.pointerId)
  }
  const onUp = (event: PointerEvent) => {
    if (begun === null) return
    const end = valueAt(event)
    const [lower, upper] = begun < end ? [begun, end] : [end, begun]
    begun = null
    onRange(x(upper) - x(lower) < 2 ? null : [lower, upper])
  }
  const bars = counts.map((count, i) => {
    if (count === 0) return nothing
    const [left, right] = [x(edges[i] as number), x(edges[i + 1] as number)]
    const height = (Math.log1p(count) / most) * (HEIGHT - 4)
    const isNegative = (edges[i + 1] as number) <= 0
    return svg`<rect class=${isNegative ? 'negative' : ''} x=${left} y=${HEIGHT - height} width=${Math.max(1, right - left - 0.5)} height=${height}><title>${`${count.toLocaleString('en')} from ${formatNumber(edges[i] as number)} to ${formatNumber(edges[i + 1] as number)}`}</title></rect>`
  })
  const chosen =
    range === null
      ? nothing
      : svg`<rect class="range" x=${x(range[0])} y="0" width=${Math.max(2, x(range[1]) - x(range[0]))} height=${HEIGHT}></rect>`
  const zero = from < 0 && greatest > 0 ? svg`<path class="zero" d=${`M${x(0)} 0V${HEIGHT}`}></path>` : nothing
  const text = percentiles
    .map(({ percent, value }) => `${percent}\u00a0%:\u00a0${formatNumber(rounded(value))}`)
    .join(' · ')
  return html`<figure class="histogram">
    <svg
      viewBox=${`0 0 ${WIDTH} ${HEIGHT}`}
      preserveAspectRatio="none"
      role="img"
      aria-label=${`Relative minima, from ${formatNumber(least)} to ${formatNumber(greatest)}. Below which so many per cent of the cells are: ${text}.`}
      @pointerdown=${onDown}
      @pointerup=${onUp}
    >
      ${bars}${zero}${chosen}
    </svg>
    <figcaption>
      <span>${formatNumber(least)}</span><span title="The heights are logarithms of the counts.">Relative minimum: least jacdet / volume</span><span>${formatNumber(greatest)}</span>
    </figcaption>
    <p class="percentiles">${text}</p>
  </figure>`
}

/** A percentile is read at a glance; bars, list and files have more digits. */
function rounded(value: number): number {
  return Number(value.toPrecision(3))
}
