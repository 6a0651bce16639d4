/** The verdict in words: the minimum with its error bound and point, why, and how it is certain. */
import { html, render, type TemplateResult } from 'lit-html'
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import { formatBound, formatJacdet, jacdetInFull } from '../../model/decimal'
import type { Vec3 } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { kindName } from '../../views/coincidences'
import { copyable, copyableJacdet, copyablePoint } from '../../views/copyable'
import type { CreateView, Frame, View } from '../../views/view'
import { certainBy, noLowerInside } from './certainty'
import css from './verdict.css?inline'
import { placeName, whySentence } from './why'

export const verdictStyles = css

const BOUND_MEANS = 'The exact minimum is at most this far from the computed one, which has more digits than are shown.'
const JACDET_MEANS = 'jacdet: the map’s change of volume at a point'
const VOLUME_MEANS = 'The integral of jacdet.'
const RELATIVE_MEANS = 'The boundary minimum on [0,1]³ over |volume|.'

class VerdictView implements View {
  readonly root = document.createElement('section')

  constructor() {
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
    const { minimizer, valid, boundaryMinimum, boundaryMinimumError, exponent } = report
    const inside = lowerInside(report)
    const minimum = (value: number, error: number, where: TemplateResult | null) =>
      html`<p class="minimum">min J = ${copyableJacdet(value, exponent, cube)} ${bound(error, exponent, cube)} ${where && html`<span class="where">${where}</span>`}</p>`
    const kind = kindName(report)
    return html`<p class=${valid ? 'word valid' : 'word negative'}>${valid ? 'VALID' : 'INVALID'}</p>
      ${kind && html`<p class="kind">${kind}</p>`}
      ${minimum(boundaryMinimum, boundaryMinimumError, inside && html`<span class="filler">on the </span>boundary`)}
      ${pointLine(`${placeName(minimizer)} (ξ, η, ζ)`, minimizer.point)}
      ${pointLine('(x, y, z)', minimizer.position)}
      ${
        inside && [
          minimum(approximation(inside).value, approximation(inside).error, html`inside`),
          pointLine('at (ξ, η, ζ)', inside.point),
        ]
      }
      <p class="why">${unbrokenNames(whySentence(report))}</p>
      <dl>
        <div><dt>J</dt><dd>${JACDET_MEANS}</dd></div>
        ${!valid && !inside ? html`<div><dt>Inside</dt><dd>${noLowerInside(report, cube)}</dd></div>` : ''}
        <div><dt>Certain by</dt><dd>${certainBy(report, cube)}</dd></div>
        ${size(report)}
      </dl>`
  }
}

const loading = html`<p class="word">–</p>`

const noVerdict = html`<p class="word">NO VERDICT</p>
  <p class="why">The core that computes jacdet did not start, so nothing is known of this element.</p>`

/** The names of edges, and what is said of J, stay on one line each: every second part is one. */
function unbrokenNames(sentence: string): (TemplateResult | string)[] {
  return sentence
    .split(/(\d–\d|J [<>=≤≥] 0)/)
    .map((text, i) => (i % 2 === 1 ? html`<span class="name">${text}</span>` : text))
}

/** "± 1.8×10⁻¹³"; nothing for an exact value. */
function bound(error: number, exponent: number, cube: ReferenceCube): TemplateResult | string {
  if (error === 0) return ''
  const full = jacdetInFull(error, exponent, cube)
  return html`<span class="bound">±\u00a0${copyable(formatBound(error, exponent, cube), full, { means: BOUND_MEANS })}</span>`
}

/** The volume is the same on either reference cube, and so is the relative minimum. */
function size({ volume, volumeExponent, relativeMinimum }: Report): TemplateResult {
  const number = (value: number, exponent: number, means: string) =>
    copyable(formatJacdet(value, exponent, 'unit'), jacdetInFull(value, exponent, 'unit'), { means })
  return html`<div><dt>Volume</dt><dd>${number(volume, volumeExponent, VOLUME_MEANS)} <span class="unit">length³</span></dd></div>
    <div><dt>Relative minimum</dt><dd>${
      relativeMinimum === null
        ? 'none, as the volume is 0'
        : html`${number(relativeMinimum, 0, RELATIVE_MEANS)} <span class="unit">no dimension</span>`
    }</dd></div>`
}

function pointLine(name: string, point: Vec3): TemplateResult {
  return html`<p class="place">${name} = ${copyablePoint(point)}</p>`
}

export const createVerdict: CreateView = () => new VerdictView()
