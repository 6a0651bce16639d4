/**
 * The curve jacdet = 0 on a section zeta = constant, xi to the right and eta upwards: for each eta
 * jacdet is a quadratic in xi, whose roots are the curve. At the curve's ends in xi arrows show the
 * gradient. Drawn and read, never a verdict.
 */
import { html, svg, type TemplateResult } from 'lit-html'
import { valueAt } from '../../core/face-polynomials'
import type { Report } from '../../core/report'
import { gradientInside, sectionBernstein } from '../../core/section'
import { formatJacdet, formatNumber } from '../../model/decimal'

const WIDTH = 400
const HEIGHT = 300
const SIDE = 240
const LEFT = (WIDTH - SIDE) / 2
const TOP = 26
/** Rows that are solved; an even number, so that the middle is one of them. */
const ROWS = 160
/** Rows are halved this often where the curve turns. */
const TURN_DEPTH = 7
const ARROW = 34

interface End {
  readonly xi: number
  readonly eta: number
}

export function sectionFigure({ bernstein, exponent }: Report, zeta: number): TemplateResult {
  const beta = sectionBernstein(bernstein, 2, zeta)
  const rowAt = (eta: number): Row => {
    const [q0, q1, q2] = [0, 1, 2].map(i => valueAt(beta.slice(3 * i, 3 * i + 3), eta)) as [number, number, number]
    return { eta, roots: rootsOf(q0, q1, q2), isNegativeAtLeft: q0 < 0 }
  }
  const rows = Array.from({ length: ROWS + 1 }, (_, row) => rowAt(row / ROWS))
  const points = rows.flatMap(({ eta, roots }) => roots.map(xi => ({ xi, eta })))
  const ends = endsOf(points)
  const slopeAt = ({ xi, eta }: End) => gradientInside(bernstein, [xi, eta, zeta])
  const text = (value: number) => formatJacdet(value, exponent, 'unit')
  const caption =
    ends === null
      ? points.length === 0
        ? 'On this section jacdet has one sign.'
        : 'The curve leaves the section through its rim: it has no two ends inside.'
      : `Slopes in ξ: ${text(slopeAt(ends.left)[0])} at the left end, ${text(slopeAt(ends.right)[0])} at the right one.`
  return html`<figure class="drawing">
    <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${`The section ζ = ${formatNumber(zeta)} of the reference cube. ${caption}`}>
      <path class="inside" d=${rows.map(strip).join('')} />
      <rect class="rim" x=${LEFT} y=${TOP} width=${SIDE} height=${SIDE} />
      <path class="curve" d=${rows
        .slice(1)
        .map((row, i) => links(rows[i] as Row, row, rowAt))
        .join('')} />
      ${ends ? [ends.left, ends.right].map((end, i) => marked(end, slopeAt(end), i === 0 ? '−' : '+')) : ''}
      <text x=${LEFT + SIDE} y=${TOP + SIDE + 20} text-anchor="end">ξ</text>
      <text x=${LEFT - 10} y=${TOP + 10} text-anchor="end">η</text>
    </svg>
    <figcaption>${caption}</figcaption>
  </figure>`
}

interface Row {
  readonly eta: number
  /** Roots in [0,1], ascending. */
  readonly roots: readonly number[]
  readonly isNegativeAtLeft: boolean
}

const x = (xi: number) => LEFT + xi * SIDE
const y = (eta: number) => TOP + (1 - eta) * SIDE

/** Roots of the polynomial with Bernstein coefficients q0, q1, q2. */
function rootsOf(q0: number, q1: number, q2: number): number[] {
  const [a, b] = [q0 - 2 * q1 + q2, q1 - q0]
  const discriminant = b * b - a * q0
  if (discriminant < 0) return []
  // No difference of nearly equal numbers occurs in either root.
  const half = -b - Math.sign(b || 1) * Math.sqrt(discriminant)
  return [half / a, q0 / half].filter(root => root >= 0 && root <= 1).sort((left, right) => left - right)
}

/** The intervals of the row where jacdet is negative. */
function strip({ eta, roots, isNegativeAtLeft }: Row): string {
  const cuts = [...(isNegativeAtLeft ? [0] : []), ...roots, 1]
  const height = SIDE / ROWS
  return cuts
    .flatMap((from, i) => (i % 2 === 0 && i + 1 < cuts.length ? [[from, cuts[i + 1] as number] as const] : []))
    .map(([from, to]) => `M${x(from)} ${y(eta) - height / 2}H${x(to)}v${height}H${x(from)}Z`)
    .join('')
}

/** Lines from root to root between rows with as many roots; else rows between are added. */
function links(below: Row, above: Row, rowAt: (eta: number) => Row, depth = TURN_DEPTH): string {
  if (below.roots.length === above.roots.length)
    return below.roots
      .map((xi, i) => `M${x(xi)} ${y(below.eta)}L${x(above.roots[i] as number)} ${y(above.eta)}`)
      .join('')
  if (depth > 0) {
    const middle = rowAt((below.eta + above.eta) / 2)
    return links(below, middle, rowAt, depth - 1) + links(middle, above, rowAt, depth - 1)
  }
  const { roots, eta } = below.roots.length > above.roots.length ? below : above
  return roots.length === 2 ? `M${x(roots[0] as number)} ${y(eta)}H${x(roots[1] as number)}` : ''
}

/** Null if there is no curve, or one of its ends is on the rim. */
function endsOf(points: readonly End[]): { readonly left: End; readonly right: End } | null {
  if (points.length === 0) return null
  const left = points.reduce((a, b) => (b.xi < a.xi ? b : a))
  const right = points.reduce((a, b) => (b.xi > a.xi ? b : a))
  return [left, right].some(({ xi, eta }) => [xi, eta].some(value => value === 0 || value === 1))
    ? null
    : { left, right }
}

function marked(end: End, [slope, across]: readonly [number, number, number], sign: string): TemplateResult {
  const size = Math.hypot(slope, across) || 1
  const [dx, dy] = [(slope / size) * ARROW, (-across / size) * ARROW]
  const [px, py] = [x(end.xi), y(end.eta)]
  const side = slope < 0 ? -1 : 1
  return svg`
    <path class="arrow" d="M${px} ${py}l${dx} ${dy}" />
    <path class="head" d="M${px + dx} ${py + dy}l${-dx / 4 - dy / 7} ${-dy / 4 + dx / 7}l${(2 * dy) / 7} ${(-2 * dx) / 7}Z" />
    <circle class="dot" cx=${px} cy=${py} r="4" />
    <text x=${px - side * 14} y=${py + 5} text-anchor="middle">p${sign === '−' ? '₋' : '₊'}</text>`
}
