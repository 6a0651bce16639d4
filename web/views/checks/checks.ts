/** Who would notice: what other checks say of this element, each against the exact verdict. */
import { html, render, type TemplateResult } from 'lit-html'
import { checks as descriptions } from '../../content/checks'
import type { Check, Report } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import type { ReferenceCube } from '../../model/state'
import { copyable, copyableJacdet } from '../copyable'
import type { CreateView, Frame, Turn, View } from '../view'
import css from './checks.css?inline'

export const checksStyles = css

class ChecksView implements View {
  readonly root = document.createElement('section')
  readonly turns: readonly Turn[] = [frame => this.#draw(frame)]
  #drawn: Report | null = null
  #cube: ReferenceCube | null = null

  constructor() {
    this.root.className = 'checks'
    this.root.setAttribute('role', 'group')
    this.root.setAttribute('aria-labelledby', 'checks-title')
  }

  update({ report }: Frame): void {
    this.root.hidden = report === null
  }

  #draw({ state, report }: Frame): void {
    if (report === null || (report === this.#drawn && state.referenceCube === this.#cube)) return
    this.#drawn = report
    this.#cube = state.referenceCube
    render(template(report, state.referenceCube), this.root)
  }

  dispose(): void {}
}

function template(report: Report, cube: ReferenceCube): TemplateResult {
  return html`<h2 id="checks-title">Who would notice?</h2>
    <table aria-labelledby="checks-title">
      <thead>
        <tr><th scope="col"><span class="said">Check</span></th><th scope="col">number</th><th scope="col">answer</th></tr>
      </thead>
      <tbody>
        ${report.checks.map((check, i) => row(check, report, cube, i === 0))}
      </tbody>
    </table>
    <details>
      <summary>What each looks at</summary>
      <dl>
        ${report.checks.map(({ id }) => html`<div><dt>${descriptions[id].name}</dt><dd>${descriptions[id].looksAt}</dd></div>`)}
      </dl>
    </details>`
}

function row(
  { id, value, passes }: Check,
  { valid, exponent }: Report,
  cube: ReferenceCube,
  isTabStop: boolean,
): TemplateResult {
  const { name, usedBy, unit } = descriptions[id]
  const number =
    unit === 'none'
      ? copyable(formatNumber(value), String(value), { isTabStop })
      : copyableJacdet(value, exponent, cube, { isTabStop })
  const agrees = passes === valid
  return html`<tr class=${agrees ? '' : 'is-wrong'}>
    <th scope="row"><span>${name}</span>${usedBy ? html` <span class="by">${usedBy}</span>` : ''}</th>
    <td class=${value < 0 ? 'negative' : ''}>${number}</td>
    <td>
      ${passes ? 'passes it' : 'rejects it'}<span class="said">, ${agrees ? 'agrees' : 'wrong'}</span>
      <span class="mark" aria-hidden="true">${agrees ? '✓' : '✗'}</span>
    </td>
  </tr>`
}

export const createChecks: CreateView = () => new ChecksView()
