/** What the search's property and measure say of the element in the lens, and what can be done with it. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { quantitiesOf } from '../../core/quantities'
import type { Report } from '../../core/report'
import { isMet } from '../../model/condition'
import { formatNumber } from '../../model/decimal'
import { encodePermalink } from '../../model/permalink'
import { measured } from './engine/measure'
import type { ParsedQuery } from './engine/query'
import { type ImprovementButton, type ImprovementRequest, improvementButton, outcomeText } from './improvement'
import { isSame } from './kept'

export interface InTheLensProps extends Pick<ImprovementButton, 'improvement' | 'ended' | 'onStart'> {
  readonly parsed: ParsedQuery
  readonly report: Report
  readonly name: string
  readonly isKept: boolean
  onKeep(): void
}

export function inTheLensTemplate(props: InTheLensProps): TemplateResult {
  const { parsed, report, name, isKept, improvement, ended, onStart, onKeep } = props
  const { query, property, measure, start } = parsed
  const { vertices } = report
  const isPossible = isMet(property, quantitiesOf(report, start))
  const button = (kind: ImprovementRequest['kind'], label: string) =>
    improvementButton({ request: { kind, query, vertices, name }, label, isPossible, improvement, ended, onStart })
  return html`<section aria-labelledby="in-lens">
    <h2 id="in-lens">In the lens</h2>
    ${ended && isSame(ended.best, vertices) ? html`<p>${outcomeText(ended)}</p>` : nothing}
    <p>
      ${
        isPossible
          ? html`The element in the lens has the property; <code>${query.measure}</code> is
              ${formatNumber(measured(measure, report, start))}.`
          : 'The element in the lens does not have the property.'
      }
    </p>
    <div class="actions">
      <button type="button" ?disabled=${isKept} @click=${onKeep}>${isKept ? 'Kept' : 'Keep'}</button>
      ${button('polish', 'Polish')} ${button('climb', 'More extreme from here')}
      <a class="button" href=${`./#${encodePermalink(vertices)}`}>Open on the page Lens</a>
    </div>
  </section>`
}
