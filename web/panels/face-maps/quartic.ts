/** The selected face's quartic in words: if it was needed, and the outcome of each root. */
import { html, type TemplateResult } from 'lit-html'
import type { FaceReport, FaceRoot, Report } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import { faces } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { copyable, copyableJacdet } from '../../views/copyable'

const COUNTS = ['no root', 'one root', 'two roots', 'three roots', 'four roots']

export function quarticWords(report: Report, face: FaceReport, cube: ReferenceCube): TemplateResult {
  const number = (value: number) => copyableJacdet(value, report.exponent, cube)
  return html`<h3>Quartic of face ${faces[face.id]?.name}</h3>
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

function needOf(face: FaceReport, number: Numbers): TemplateResult {
  const bound = number(face.lowerBound)
  const { skippedByValidityRule: isPositive, skippedByMinimumRule: isSkipped } = face
  if (isPositive && isSkipped)
    return html`Its bound ${bound} alone settles this face. The quartic is not needed, but shown.`
  if (isPositive)
    return html`Its bound ${bound} shows that the face is positive. It is below ${number(face.runningMinimum)}, the least value so far, so the minimum needs the quartic.`
  if (isSkipped)
    return html`Its bound ${bound} is not below the least value so far, so this face has no lower minimum. The quartic is not needed, but shown.`
  return html`Its bound ${bound} decides nothing, so the quartic is needed.`
}

function rootsSentence({ quarticIsZero, roots }: FaceReport): string {
  const count = COUNTS[roots.length] ?? `${roots.length} roots`
  if (!quarticIsZero) {
    const end = roots.length === 0 ? ', so the least value is on an edge.' : ':'
    return `P has ${count} in (0, 1)${end}`
  }
  const end = roots.length === 0 ? '' : ' Roots that rounding may have left are tried as well:'
  return `P cannot be told from zero. If it is zero, the least value is on an edge (a lemma of the paper).${end}`
}

function rootText({ t, a, s, fate }: FaceRoot, number: Numbers): TemplateResult {
  const plain = (value: number) => copyable(formatNumber(value), String(value))
  const at = html`t = ${plain(t)}: `
  if (s === null) return html`${at}dropped, a = ${number(a)} ≤ 0: concave in s, or straight`
  if (fate === 'kept') return html`${at}kept, a = ${number(a)} > 0 and s* = ${plain(s)} inside`
  const where = s === 0 || s === 1 ? 'on an edge' : 'outside the face'
  return html`${at}dropped, s* = ${plain(s)} ${where}`
}
