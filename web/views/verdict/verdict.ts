/** The answer in words: valid or invalid, the minimum with its error bound and its place, why, and how that is certain. */
import { html, render, type TemplateResult } from 'lit-html'
import type { Report } from '../../core/report'
import { formatBound, formatJacdet, formatPoint } from '../../model/decimal'
import type { Vec3 } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { copyText } from '../copy-text'
import { approximation, lowerInside } from '../inside'
import type { CreateView, Frame, View, ViewHost } from '../view'
import { certainBy, noLowerInside } from './certainty'
import css from './verdict.css?inline'
import { placeName, whySentence } from './why'

export const verdictStyles = css

const BOUND_MEANS = 'The exact minimum is at most this far from the computed one, of which fewer digits are shown.'

class VerdictView implements View {
  readonly root = document.createElement('section')
  readonly #host: ViewHost
  /** The point last copied; told for as long as it is the one shown. */
  #copied: Vec3 | null = null

  constructor(host: ViewHost) {
    this.#host = host
    this.root.className = 'verdict'
    this.root.setAttribute('role', 'status')
    this.root.setAttribute('aria-label', 'Verdict')
    // The announcer speaks, at most once a second; this region is for reading at any time.
    this.root.setAttribute('aria-live', 'off')
  }

  update({ state, report, problems }: Frame): void {
    const failed = problems.some(problem => problem.code === 'core-failed')
    render(report ? this.#verdict(report, state.referenceCube) : failed ? noVerdict : loading, this.root)
  }

  dispose(): void {}

  #verdict(report: Report, cube: ReferenceCube): TemplateResult {
    const { minimizer, valid, boundaryMinimum, boundaryMinimumError } = report
    const inside = lowerInside(report)
    const minimum = (value: number, error: number, where: TemplateResult | null) => {
      const jacdet = signed(value, formatJacdet(value, report.exponent, cube))
      return html`<p class="minimum">min J = ${jacdet} ${bound(error, report.exponent, cube)} ${where && html`<span class="where">${where}</span>`}</p>`
    }
    return html`<p class=${valid ? 'word valid' : 'word negative'}>${valid ? 'VALID' : 'INVALID'}</p>
      ${minimum(boundaryMinimum, boundaryMinimumError, inside && html`<span class="filler">on the </span>boundary`)}
      ${this.#place(`${placeName(minimizer)} (ξ, η, ζ)`, minimizer.point, 'reference coordinates')}
      ${this.#place('(x, y, z)', minimizer.position, 'physical coordinates')}
      ${
        inside && [
          minimum(approximation(inside).value, approximation(inside).error, html`inside`),
          this.#place('at (ξ, η, ζ)', inside.point, 'reference coordinates of the minimum inside'),
        ]
      }
      <p class="why">${unbrokenNames(whySentence(report))}</p>
      <dl>
        ${!valid && !inside ? html`<div><dt>Inside</dt><dd>${noLowerInside(report, cube)}</dd></div>` : ''}
        <div><dt>Certain by</dt><dd>${certainBy(report, cube)}</dd></div>
      </dl>`
  }

  #place(name: string, point: Vec3, what: string): TemplateResult {
    const word = this.#copied === point ? 'Copied' : 'Copy'
    return html`<p class="place">
      <span>${name} = <span>${formatPoint(point)}</span></span>
      <button type="button" aria-label=${`${word} ${what}`} @click=${(event: Event) => this.#copy(event, point)}>
        ${word}
      </button>
    </p>`
  }

  /** The numbers in full, as a program reads them; where the clipboard is closed, the shown ones are selected instead. */
  async #copy(event: Event, point: Vec3): Promise<void> {
    const shown = (event.currentTarget as Element).previousElementSibling as Element
    if (await copyText(point.join(', '))) {
      this.#copied = point
      this.#host.requestFrame()
    } else getSelection()?.selectAllChildren(shown)
  }
}

const loading = html`<p class="word">–</p>`

const noVerdict = html`<p class="word">NO VERDICT</p>
  <p class="why">The core that computes the jacdet could not be started, so nothing is said about this element.</p>`

/** The names of edges stay on one line each: every second part is one. */
function unbrokenNames(sentence: string): (TemplateResult | string)[] {
  return sentence.split(/(\d–\d)/).map((part, i) => (i % 2 === 1 ? html`<span class="name">${part}</span>` : part))
}

/** "± 1.8×10⁻¹³"; nothing for an exact value. */
function bound(error: number, exponent: number, cube: ReferenceCube): TemplateResult | string {
  if (error === 0) return ''
  return html`<span class="bound" title=${BOUND_MEANS}>±\u00a0${formatBound(error, exponent, cube)}</span>`
}

/** A negative jacdet has its hue in prose too; its minus sign says the same. */
function signed(value: number, text: string): TemplateResult | string {
  return value < 0 ? html`<span class="negative">${text}</span>` : text
}

export const createVerdict: CreateView = host => new VerdictView(host)
