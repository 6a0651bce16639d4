/** The histogram of relative minima as SVG and in numbers, for the document that `--html` writes. */
import { BIN, type Histogram, LEAST } from '../mesh/histogram'
import { grouped } from '../mesh/mesh-headline'
import { formatNumber } from '../model/decimal'
import { px } from '../scene/paint/svg'

const [WIDTH, HEIGHT] = [720, 190]
/** Room for the counts at the left, for the values below, and for a bar's count above. */
const [LEFT, BELOW, ABOVE, RIGHT] = [56, 24, 14, 12]

/** With a heading of this level; nothing where no cell has a relative minimum. */
export function histogramMarkup(histogram: Histogram, level: number): string {
  const { edges, counts, percentiles, beside } = histogram
  if (counts.length === 0) return ''
  const total = counts.reduce((sum, count) => sum + count, 0)
  const words = `Relative minima of ${grouped(total)} ${total === 1 ? 'hexahedron' : 'hexahedra'}`
  const others =
    beside === 0
      ? ''
      : ` ${grouped(beside)} ${beside === 1 ? 'has' : 'have'} none: the volume is 0, or there is no answer.`
  const shares = percentiles.map(
    ({ percent, value }, i) => `${formatNumber(value)} in ${percent}\u00a0%${i === 0 ? ' of them' : ''}`,
  )
  const least = edges[0] as number
  const below = least < LEAST - BIN ? ` The first bar is all up to −1, from ${formatNumber(least)}.` : ''
  return `<h${level} class="part">${words}</h${level}>
<p class="beside">Counts are logarithmic, negative values red and hatched.${below}${others}</p>
${svgOf(edges, counts, words)}
<p class="beside">At most ${shares.join(', ')}.</p>
`
}

function svgOf(edges: readonly number[], counts: readonly number[], words: string): string {
  const from = Math.max(edges[0] as number, LEAST - BIN)
  const to = edges.at(-1) as number
  const decades = Math.max(1, Math.ceil(Math.log10(Math.max(...counts) + 1)))
  const bottom = HEIGHT - BELOW
  const x = (value: number) => LEFT + ((Math.max(value, from) - from) / (to - from)) * (WIDTH - LEFT - RIGHT)
  // One cell has to be seen: a count of 0 is half a decade below it.
  const y = (count: number) => bottom - ((Math.log10(count) + 0.5) / (decades + 0.5)) * (bottom - ABOVE)
  const bars = counts.map((count, i) => {
    if (count === 0) return ''
    const [lower, upper] = [edges[i] as number, edges[i + 1] as number]
    const [left, top] = [x(lower), y(count)]
    const box = `x="${px(left)}" y="${px(top)}" width="${px(Math.max(1, x(upper) - left - 1))}" height="${px(bottom - top)}"`
    const title = `<title>${grouped(count)} from ${formatNumber(lower)} to ${formatNumber(upper)}</title>`
    return upper <= 0 ? `<g class="negative"><rect ${box}/>${title}<rect ${box}/></g>` : `<g><rect ${box}/>${title}</g>`
  })
  const levels = Array.from({ length: decades + 1 }, (_, decade) => 10 ** decade)
  const grid = levels.map(
    count =>
      `<path class="grid" d="M${LEFT} ${px(y(count))}H${WIDTH - RIGHT}"/><text x="${LEFT - 8}" y="${px(y(count) + 4)}" text-anchor="end">${grouped(count)}</text>`,
  )
  const ticks = [-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1].filter(value => value >= from && value <= to)
  const values = ticks.map(
    value =>
      `<path class="axis" d="M${px(x(value))} ${bottom}v4"/><text x="${px(x(value))}" y="${bottom + 17}" text-anchor="middle">${formatNumber(value)}</text>`,
  )
  const zero = from < 0 && to > 0 ? `<path class="zero" d="M${px(x(0))} ${ABOVE}V${bottom}"/>` : ''
  return `<svg class="histogram" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${words}, from ${formatNumber(edges[0] as number)} to ${formatNumber(to)}">${grid.join('')}${bars.join('')}${zero}<path class="axis" d="M${LEFT} ${bottom}H${WIDTH - RIGHT}"/>${values.join('')}</svg>`
}
