/** The selected face's quartic in words: if it was needed, and the outcome of each root. */
import { html, type TemplateResult } from 'lit-html'
import type { FaceReport, FaceRoot, Report } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import { faces } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { copyable, copyableJacdet } from '../../views/copyable'
import { say, sayParts } from '../../words/say'

export function quarticWords(report: Report, face: FaceReport, cube: ReferenceCube): TemplateResult {
  const number = (value: number) => copyableJacdet(value, report.exponent, cube)
  return html`<h3>${say('Quartic of face {face}', { face: faces[face.id]?.name ?? '' })}</h3>
    <p>${needOf(face, number)} ${rootsSentence(face)}</p>
    ${
      face.roots.length > 0
        ? html`<ol>
            ${face.roots.map(root => html`<li>${rootText(root, number)}</li>`)}
          </ol>`
        : ''
    }`
}

type Numbers = (value: number) => TemplateResult

function needOf(face: FaceReport, number: Numbers): (TemplateResult | string)[] {
  const bound = number(face.lowerBound)
  const { skippedByValidityRule: isPositive, skippedByMinimumRule: isSkipped } = face
  if (isPositive && isSkipped)
    return sayParts('Its bound {bound} alone settles this face. The quartic is not needed, but shown.', { bound })
  if (isPositive)
    return sayParts(
      'Its bound {bound} shows that the face is positive. It is below {minimum}, the least value so far, so the minimum needs the quartic.',
      { bound, minimum: number(face.runningMinimum) },
    )
  if (isSkipped)
    return sayParts(
      'Its bound {bound} is not below the least value so far, so this face has no lower minimum. The quartic is not needed, but shown.',
      { bound },
    )
  return sayParts('Its bound {bound} decides nothing, so the quartic is needed.', { bound })
}

function rootsSentence({ quarticIsZero, roots }: FaceReport): string {
  if (!quarticIsZero) {
    if (roots.length === 0) return say('P has no root in (0, 1), so the least value is on an edge.')
    return roots.length === 1
      ? say('P has one root in (0, 1):')
      : say('P has {count} roots in (0, 1):', { count: roots.length })
  }
  const lemma = say('P cannot be told from zero. If it is zero, the least value is on an edge (a lemma of the paper).')
  return roots.length === 0 ? lemma : `${lemma} ${say('Roots that rounding may have left are tried as well:')}`
}

function rootText({ t, a, s, fate }: FaceRoot, number: Numbers): (TemplateResult | string)[] {
  const plain = (value: number) => copyable(formatNumber(value), String(value))
  if (s === null)
    return sayParts('t = {t}: dropped, a = {a} ≤ 0: concave in s, or straight', { t: plain(t), a: number(a) })
  if (fate === 'kept')
    return sayParts('t = {t}: kept, a = {a} > 0 and s* = {s} inside', { t: plain(t), a: number(a), s: plain(s) })
  return s === 0 || s === 1
    ? sayParts('t = {t}: dropped, s* = {s} on an edge', { t: plain(t), s: plain(s) })
    : sayParts('t = {t}: dropped, s* = {s} outside the face', { t: plain(t), s: plain(s) })
}
