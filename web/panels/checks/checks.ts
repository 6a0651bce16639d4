/** Other checks of this element, each against the exact verdict. */

import { html, render, type TemplateResult } from 'lit-html'
import type { Check, CheckId, Report } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import { type ReferenceCube, sliceChange } from '../../model/state'
import { copyable, copyableJacdet } from '../../views/copyable'
import { isNew } from '../../views/is-new'
import { marksSlice } from '../../views/scene-slices'
import type { CreateView, Frame, Update, View, ViewContext } from '../../views/view'
import { say, sayParts } from '../../words/say'
import { checks as descriptions } from './check-words'
import css from './checks.css?inline'

export const checksStyles = css

/** The number that Verdict returns for a length of zero. */
const NO_LENGTH = 1e30

/** The manuals' acceptable range of the scaled Jacobian of hexahedra, and what is usual. */
const CUBIT =
  'https://cubit.sandia.gov/files/cubit/16.14/help_manual/WebHelp/mesh_generation/mesh_quality_assessment/hexahedral_metrics.htm'
const VERDICT = 'https://public.kitware.com/Wiki/images/6/6b/VerdictManual-revA.pdf'
const PRACTICE = 'https://autotwin.github.io/automesh/cli/metrics_hexahedral.html'

class ChecksView implements View {
  readonly root = document.createElement('section')
  readonly updates: readonly Update[] = [frame => this.#draw(frame)]
  readonly #context: ViewContext
  readonly #listening = new AbortController()
  /** The check whose points are marked in the scene. */
  #marked: CheckId | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'checks'
    this.root.setAttribute('role', 'group')
    this.root.setAttribute('aria-labelledby', 'checks-title')
    this.#listen()
  }

  update({ report }: Frame): void {
    this.root.hidden = report === null
    if (report === null) this.#mark(null)
  }

  #draw({ state, report }: Frame): void {
    const { referenceCube } = state
    if (report && isNew(this.root, report, referenceCube)) render(template(report, referenceCube), this.root)
  }

  dispose(): void {
    this.#listening.abort()
    this.#mark(null)
  }

  /** The mouse, a number's focus or a tap points at a row; a tap holds until the next one. */
  #listen(): void {
    const { signal } = this.#listening
    const { root } = this
    const markRow = (event: Event) => this.#mark(checkOf(event.target))
    const markFocused = () => this.#mark(checkOf(root.querySelector(':focus')))
    root.addEventListener('pointerover', event => event.pointerType === 'mouse' && markRow(event), { signal })
    root.addEventListener('pointerleave', event => event.pointerType === 'mouse' && markFocused(), { signal })
    root.addEventListener('click', markRow, { signal })
    root.addEventListener('focusin', markRow, { signal })
    root.addEventListener('focusout', () => this.#mark(null), { signal })
    const leave = (event: Event) => !event.composedPath().includes(root) && this.#mark(null)
    document.addEventListener('click', leave, { signal }) // a scroll to the scene is none
  }

  #mark(id: CheckId | null): void {
    if (id === this.#marked) return
    this.#marked = id
    this.#context.dispatch(sliceChange(marksSlice, { samples: id && descriptions[id].marks }))
  }
}

function checkOf(target: EventTarget | null): CheckId | null {
  const row = target instanceof Element ? target.closest<HTMLElement>('[data-check]') : null
  return (row?.dataset.check as CheckId | undefined) ?? null
}

function template(report: Report, cube: ReferenceCube): TemplateResult {
  return html`<h2 id="checks-title">${say('Who would notice?')}</h2>
    <table aria-labelledby="checks-title">
      <thead>
        <tr><th scope="col"><span class="said">${say('Check')}</span></th><th scope="col">${say('number')}</th><th scope="col">${say('answer')}</th></tr>
      </thead>
      <tbody>
        ${report.checks.map((check, i) => row(check, report, cube, i === 0))}
      </tbody>
    </table>
    ${thresholds()}
    <details>
      <summary>${say('What each looks at')}</summary>
      <p>
        ${say('A check accepts an element if its number is above zero. Point at a row, and the scene marks what it looks at.')}
      </p>
      <dl>
        ${report.checks.map(({ id }) => html`<div><dt>${say(descriptions[id].name)}</dt><dd>${say(descriptions[id].looksAt)}</dd></div>`)}
      </dl>
    </details>`
}

const link = (href: string, text: string) => html`<a href=${href} target="_blank" rel="noreferrer">${text}</a>`

const thresholds = () =>
  html`<p class="by">${sayParts(
    'The scaled Jacobian (corners and centre) is acceptable from 0.5 on in the manuals of {cubit} and {verdict}, and {inPractice} often from 0.2 or 0.3 on.',
    { cubit: link(CUBIT, 'Cubit'), verdict: link(VERDICT, 'Verdict'), inPractice: link(PRACTICE, say('in practice')) },
  )}</p>`

function row(
  { id, value, passes }: Check,
  { valid, exponent }: Report,
  cube: ReferenceCube,
  isTabStop: boolean,
): TemplateResult {
  const { name, usedBy, unit } = descriptions[id]
  const [yes, no] = id === 'tangents' ? [say('certifies'), say('cannot tell')] : [say('accepts'), say('rejects')]
  const number =
    unit === 'none'
      ? copyable(formatNumber(value), String(value), { isTabStop })
      : copyableJacdet(value, exponent, cube, { isTabStop })
  const { said, mark } = judged(passes, valid, id)
  return html`<tr data-check=${id} class=${mark === '✗' ? 'is-wrong' : ''}>
    <th scope="row"><span>${say(name)}</span>${usedBy ? html` <span class="by">${say(usedBy)}</span>` : ''}
      ${unit === 'none' ? html` <span class="by">${say('usual limits 0.5, 0.3, 0.2')}</span>` : ''}
      ${unit === 'none' && value === NO_LENGTH ? html`<span class="by">${say('1e30: to Verdict an edge or axis has no length')}</span>` : ''}</th>
    <td class=${value < 0 ? 'negative' : ''}>${number}</td>
    <td>
      ${passes ? yes : no}<span class=${mark === '✗' ? '' : 'said'}>: ${said}</span>
      <span class="mark" aria-hidden="true">${mark}</span>
    </td>
  </tr>`
}

/** Compares with the verdict; a check that only certifies is not wrong if it cannot tell. */
function judged(passes: boolean, valid: boolean, id: CheckId): { said: string; mark: string } {
  if (passes === valid) return { said: say('agrees'), mark: '✓' }
  return id === 'tangents' && !passes ? { said: say('leaves it open'), mark: '–' } : { said: say('wrong'), mark: '✗' }
}

export const createChecks: CreateView = context => new ChecksView(context)
