/** The verdict in words, why, and the minimum. */
import { html, render, type TemplateResult } from 'lit-html'
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import type { ReferenceCube } from '../../model/state'
import { kindName } from '../../views/coincidences'
import { copyableJacdet } from '../../views/copyable'
import type { CreateView, Frame, View } from '../../views/view'
import { say, sayParts } from '../../words/say'
import css from './verdict.css?inline'
import { whySentence } from './why'

export const verdictStyles = css

class VerdictView implements View {
  readonly root = document.createElement('section')

  constructor() {
    this.root.className = 'verdict'
    this.root.setAttribute('role', 'status')
    this.root.setAttribute('aria-label', say('Verdict'))
    // The announcer speaks, at most once a second; this region is for reading at any time.
    this.root.setAttribute('aria-live', 'off')
  }

  update({ state, report, problems }: Frame): void {
    const failed = problems.some(problem => problem.code === 'core-failed')
    render(report ? this.#verdict(report, state.referenceCube) : failed ? noVerdict() : loading, this.root)
  }

  dispose(): void {}

  #verdict(report: Report, cube: ReferenceCube): TemplateResult {
    const { valid, boundaryMinimum, exponent } = report
    const inside = lowerInside(report)
    const minimum = (value: number, where: TemplateResult | null) =>
      html`<p class="minimum">min J = ${copyableJacdet(value, exponent, cube)} ${where && html`<span class="where">${where}</span>`}</p>`
    const kind = kindName(report)
    return html`<p class=${valid ? 'word valid' : 'word negative'}>${valid ? say('VALID') : say('INVALID')}</p>
      ${kind && html`<p class="kind">${kind}</p>`}
      <p class="why">${unbrokenNames(whySentence(report))}</p>
      ${minimum(boundaryMinimum, inside && onBoundary())}
      ${inside && minimum(approximation(inside).value, html`${say('inside')}`)}
      <p class="means">${say('J is jacdet: the map’s change of volume at a point.')}</p>`
  }
}

const loading = html`<p class="word">–</p>`

const noVerdict = () => html`<p class="word">${say('NO VERDICT')}</p>
  <p class="why">${say('The core that computes jacdet did not start, so nothing is known of this element.')}</p>`

/** Where there is little room the words in the filler are left out. */
function onBoundary(): TemplateResult {
  return html`${sayParts('{filler} boundary', { filler: html`<span class="filler">${say('on the')}</span>` })}`
}

/** The names of edges, and what is said of J, stay on one line each: every second part is one. */
function unbrokenNames(sentence: string): (TemplateResult | string)[] {
  return sentence
    .split(/(\d–\d|J [<>=≤≥] 0)/)
    .map((text, i) => (i % 2 === 1 ? html`<span class="name">${text}</span>` : text))
}

export const createVerdict: CreateView = () => new VerdictView()
