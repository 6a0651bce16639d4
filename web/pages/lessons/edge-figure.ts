/**
 * jacdet along an edge: the graph of a polynomial with Bernstein coefficients q0, q1, q2 on [0,1] is the Bézier curve with the control
 * points (0, q0), (1/2, q1), (1, q2), so the curve drawn is the polynomial itself. The polygon through them is dashed.
 */
import { html, svg, type TemplateResult } from 'lit-html'
import type { Report } from '../../core/report'
import { bernsteinOnEdge } from '../../core/section'
import { formatJacdet, formatNumber } from '../../model/decimal'
import { edgeName, edgeVertices } from '../../model/hexahedron'

const WIDTH = 400
const HEIGHT = 190
const SUBSCRIPTS = '₀₁₂'
const BOX = { left: 22, right: WIDTH - 22, top: 24, bottom: HEIGHT - 30 }

export function edgeFigure({ bernstein, exponent }: Report, edge: number, hasCoefficients: boolean): TemplateResult {
  const [q0, q1, q2] = bernsteinOnEdge(bernstein, edge)
  const [from, to] = edgeVertices[edge] as readonly [number, number]
  const hasLowest = q1 < q0 && q1 < q2
  const along = hasLowest ? (q0 - q1) / (q0 - q1 + (q2 - q1)) : q0 <= q2 ? 0 : 1
  const lowest = (1 - along) * ((1 - along) * q0 + along * q1) + along * ((1 - along) * q1 + along * q2)
  const [least, greatest] = [Math.min(0, q0, q1, q2), Math.max(0, q0, q1, q2)]
  const x = (r: number) => BOX.left + r * (BOX.right - BOX.left)
  const y = (value: number) => BOX.bottom - ((value - least) / (greatest - least || 1)) * (BOX.bottom - BOX.top)
  const text = (value: number) => formatJacdet(value, exponent, 'unit')
  const curve = `M${x(0)} ${y(q0)}Q${x(0.5)} ${y(q1)} ${x(1)} ${y(q2)}`
  const names = hasCoefficients ? [q0, q1, q2].map((q, i) => `q${SUBSCRIPTS[i]} = ${text(q)}`) : []
  const label = `jacdet along the edge ${edgeName(edge)}: ${text(q0)} at vertex ${from}, ${text(q2)} at vertex ${to}, lowest ${text(lowest)} at ${formatNumber(along)} of the way.${names.length > 0 ? ` Coefficients: ${names.join(', ')}.` : ''}`
  return html`<figure class="drawing">
    <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${label}>
      <path class="polygon" d="M${x(0)} ${y(q0)}L${x(0.5)} ${y(q1)}L${x(1)} ${y(q2)}" />
      <path class="zero" d="M0 ${y(0)}H${WIDTH}" />
      <text class="muted" x="0" y=${y(0) - 5}>0</text>
      <path class="curve" d=${curve} />
      <svg aria-hidden="true" y=${y(0)} width=${WIDTH} height=${HEIGHT} viewBox="0 ${y(0)} ${WIDTH} ${HEIGHT}">
        <path class="curve negative" d=${curve} />
      </svg>
      ${dot(x(0), y(q0))} ${dot(x(1), y(q2))} ${dot(x(0.5), y(q1), 'control')}
      ${dot(x(along), y(lowest), lowest > 0 ? 'lowest' : 'lowest negative')}
      <text class=${lowest > 0 ? 'value' : 'value negative'} x=${x(along)} y=${lowest > 0 ? y(lowest) - 10 : y(lowest) + 19} text-anchor=${anchorAt(along)}>
        ${text(lowest)}
      </text>
      ${hasCoefficients ? [q0, q1, q2].map((q, i) => coefficientName(i, x(i / 2), y(q), q < Math.min(q0, q2))) : ''}
      <text x=${x(0)} y=${HEIGHT - 4} text-anchor="middle">${from}</text>
      <text x=${x(1)} y=${HEIGHT - 4} text-anchor="middle">${to}</text>
    </svg>
    <figcaption>jacdet along the edge ${edgeName(edge)}${names.length > 0 ? `: ${names.join(', ')}` : ''}</figcaption>
  </figure>`
}

function dot(x: number, y: number, kind = ''): TemplateResult {
  return svg`<circle class="dot ${kind}" cx=${x} cy=${y} r=${kind === 'control' ? 2.5 : 4} />`
}

/** Beside an end, and above or below the middle. */
function coefficientName(i: number, x: number, y: number, isBelow: boolean): TemplateResult {
  const [dx, dy] = i === 1 ? [0, isBelow ? 17 : -9] : [i === 0 ? 9 : -9, -7]
  return svg`<text class="muted" x=${x + dx} y=${y + dy} text-anchor=${['start', 'middle', 'end'][i]}>q${SUBSCRIPTS[i]}</text>`
}

function anchorAt(along: number): string {
  return along < 0.15 ? 'start' : along > 0.85 ? 'end' : 'middle'
}
