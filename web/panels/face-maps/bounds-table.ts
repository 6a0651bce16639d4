/** Per face: its Bernstein lower bound, and whether that bound or the quartic settles it. */
import { html, type TemplateResult } from 'lit-html'
import type { FaceReport, Report } from '../../core/report'
import { faces } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { copyableJacdet } from '../../views/copyable'
import { say, sayParts } from '../../words/say'

export function boundsTable(
  { faces: reports, exponent }: Report,
  cube: ReferenceCube,
  selected: number,
): TemplateResult {
  const number = (value: number, isTabStop: boolean) =>
    html`<td>${copyableJacdet(value, exponent, cube, { isTabStop })}</td>`
  const row = ({ id, lowerBound, runningMinimum, skippedByValidityRule, skippedByMinimumRule }: FaceReport) =>
    html`<tr class=${id === selected ? 'is-selected' : ''}>
      <th scope="row">${faces[id]?.name}</th>
      ${number(lowerBound, id === 0)}${number(runningMinimum, false)}
      <td>${settledBy(skippedByValidityRule)}</td>
      <td>${settledBy(skippedByMinimumRule)}</td>
    </tr>`
  return html`<table aria-label=${say('What settles each face')}>
      <thead>
        <tr>
          <th scope="col">${say('Face')}</th>
          <th scope="col"><abbr title=${say('The least of the face’s nine Bernstein coefficients')}>L<sub>R</sub></abbr></th>
          <th scope="col"><abbr title=${say('The least jacdet found before this face')}>M</abbr></th>
          <th scope="col">${say('sign by')}</th>
          <th scope="col"><abbr title=${say('minimum by')}>${say('min by')}</abbr></th>
        </tr>
      </thead>
      <tbody>
        ${reports.map(row)}
      </tbody>
    </table>
    <p class="note">
      ${sayParts(
        '{bound} is a lower bound of jacdet on the face. If {bound}\u00a0>\u00a00, the face is positive. If {bound}\u00a0≥\u00a0M, the least value so far, the face has no lower minimum. Otherwise the quartic decides.',
        { bound: html`L<sub>R</sub>` },
      )}
    </p>`
}

function settledBy(bound: boolean): string {
  return bound ? say('bound') : say('quartic')
}
