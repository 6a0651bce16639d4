/** Claims of a step as they are read: each with its numbers, and whether it holds for the element of a report. */
import { html, type TemplateResult } from 'lit-html'
import { numbers, quantitiesOf, shownNumber } from '../../core/quantities'
import type { Report } from '../../core/report'
import { type Condition, parseCondition, truthOf } from '../../model/condition'
import { isNumberName } from '../../model/condition/names'
import { formatJacdet, formatNumber } from '../../model/decimal'
import type { Vertices } from '../../model/hexahedron'
import type { LessonClaim } from './content/lessons'

/** Null is not known: no report yet, or numbers that are too near each other. */
const MARKS = new Map<boolean | null, { readonly sign: string; readonly said: string }>([
  [true, { sign: '✓', said: 'holds' }],
  [false, { sign: '✗', said: 'does not hold' }],
  [null, { sign: '·', said: 'not known' }],
])

/** `start` is the step's own element. */
export function claimList(claims: readonly LessonClaim[], report: Report | null, start: Vertices): TemplateResult {
  return html`<ul class="claims" aria-label="Computed">
    ${claims.map(({ says, holds }) => {
      const condition = conditionOf(holds)
      const truth = report && truthOf(condition, quantitiesOf(report, start))
      const { sign, said } = MARKS.get(truth) as { sign: string; said: string }
      return html`<li data-truth=${String(truth)}>
        <span class="sign" aria-hidden="true">${sign}</span>
        <span class="says">${says}<span class="said">: ${said}</span></span>
        <span class="numbers">${report ? numbersIn(condition, report, start) : ''}</span>
      </li>`
    })}
  </ul>`
}

function conditionOf(text: string): Condition {
  const result = parseCondition(text)
  if (!result.ok) throw new Error(`${text}: ${result.error.message}`)
  return result.value
}

/** Each number once, though two may have it. */
function numbersIn({ names }: Condition, report: Report, start: Vertices): TemplateResult[] {
  const shown = new Map<string, string>()
  for (const name of names.filter(isNumberName)) {
    const { value, exponent } = shownNumber(name, report, start)
    const text = numbers[name].unit === 'jacdet' ? formatJacdet(value, exponent, 'unit') : formatNumber(value)
    const title = shown.get(text)
    shown.set(text, title === undefined ? numbers[name].name : `${title}, ${numbers[name].name}`)
  }
  return [...shown].map(([text, title]) => html`<span title=${title}>${text}</span>`)
}
