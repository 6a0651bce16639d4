/** The minima with their error bounds and points, how the verdict is certain, and the size. */
import { html, render, type TemplateResult } from 'lit-html'
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import { formatBound, formatJacdet, jacdetInFull } from '../../model/decimal'
import type { Vec3 } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { copyable, copyableJacdet, copyablePoint } from '../../views/copyable'
import type { CreateView, Frame, View } from '../../views/view'
import { say } from '../../words/say'
import { placeName } from '../verdict/why'
import { certainBy, noLowerInside } from './certainty'
import css from './minimum.css?inline'

export const minimumStyles = css

class MinimumView implements View {
  readonly root = document.createElement('section')

  constructor() {
    this.root.className = 'minimum-panel'
    this.root.setAttribute('role', 'group')
    this.root.setAttribute('aria-labelledby', 'minimum-title')
  }

  update({ state, report }: Frame): void {
    this.root.hidden = report === null
    if (report) render(template(report, state.referenceCube), this.root)
  }

  dispose(): void {}
}

function template(report: Report, cube: ReferenceCube): TemplateResult {
  const { minimizer, valid, boundaryMinimum, boundaryMinimumError, exponent } = report
  const inside = lowerInside(report)
  const minimum = (value: number, error: number, where: string) =>
    html`<p class="minimum">min J = ${copyableJacdet(value, exponent, cube)} ${bound(error, exponent, cube)} <span class="where">${where}</span></p>`
  return html`<h2 id="minimum-title">${say('Minimum')}</h2>
    ${minimum(boundaryMinimum, boundaryMinimumError, inside ? say('on the boundary') : '')}
    ${pointLine(placeName(minimizer), minimizer.point)}
    ${pointLine('(x, y, z)', minimizer.position)}
    ${
      inside && [
        minimum(approximation(inside).value, approximation(inside).error, say('inside')),
        pointLine(say('at {point}', { point: '(ξ, η, ζ)' }), inside.point),
      ]
    }
    <dl>
      ${!valid && !inside ? html`<div><dt>${say('Inside')}</dt><dd>${noLowerInside(report, cube)}</dd></div>` : ''}
      <div><dt>${say('Certain by')}</dt><dd>${certainBy(report, cube)}</dd></div>
      ${size(report)}
    </dl>`
}

/** "± 1.8×10⁻¹³"; nothing for an exact value. */
function bound(error: number, exponent: number, cube: ReferenceCube): TemplateResult | string {
  if (error === 0) return ''
  const full = jacdetInFull(error, exponent, cube)
  return html`<span class="bound">±\u00a0${copyable(formatBound(error, exponent, cube), full, { means: boundMeans() })}</span>`
}

function boundMeans(): string {
  return say('The exact minimum is at most this far from the computed one, which has more digits than are shown.')
}

/** The volume is the same on either reference cube, and so is the relative minimum. */
function size({ volume, volumeExponent, relativeMinimum }: Report): TemplateResult {
  const number = (value: number, exponent: number, means: string) =>
    copyable(formatJacdet(value, exponent, 'unit'), jacdetInFull(value, exponent, 'unit'), { means })
  return html`<div><dt>${say('Volume')}</dt><dd>${number(volume, volumeExponent, say('The integral of jacdet.'))} <span class="unit">${say('length³')}</span></dd></div>
    <div><dt>${say('Relative minimum')}</dt><dd>${
      relativeMinimum === null
        ? say('none, as the volume is 0')
        : html`${number(relativeMinimum, 0, say('The boundary minimum on [0,1]³ over |volume|.'))} <span class="unit">${say('no dimension')}</span>`
    }</dd></div>`
}

function pointLine(name: string, point: Vec3): TemplateResult {
  return html`<p class="place">${name} = ${copyablePoint(point)}</p>`
}

export const createMinimum: CreateView = () => new MinimumView()
