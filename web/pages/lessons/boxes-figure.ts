/** The least jacdet of the whole element, from boxes and without the theorem, beside the least on the boundary. */
import { html, type TemplateResult } from 'lit-html'
import { approximation } from '../../core/inside'
import type { Report } from '../../core/report'
import { formatBound, formatJacdet } from '../../model/decimal'
import { leastByBoxes } from './least-by-boxes'

export function boxesFigure({ bernstein, exponent, boundaryMinimum }: Report): TemplateResult {
  const { lower, upper, boxes } = leastByBoxes(bernstein)
  const text = (value: number) => formatJacdet(value, exponent, 'unit')
  const { value, error } = approximation({ lower, upper })
  const isBelow = upper < boundaryMinimum && boundaryMinimum - upper > upper - lower
  const verdict = isBelow
    ? 'The least jacdet is inside, not on the boundary.'
    : 'The two agree, within the error of the first.'
  return html`<figure class="drawing">
    <dl class="two-numbers">
      <dt>Whole element, by ${boxes === 1 ? '1 box' : `${boxes} boxes`}</dt>
      <dd class=${value < 0 ? 'negative' : ''}>${text(value)}${error > 0 ? html` <span class="quiet">±\u00a0${formatBound(error, exponent, 'unit')}</span>` : ''}</dd>
      <dt>Boundary, by candidates</dt>
      <dd class=${boundaryMinimum < 0 ? 'negative' : ''}>${text(boundaryMinimum)}</dd>
    </dl>
    <figcaption>${verdict}</figcaption>
  </figure>`
}
