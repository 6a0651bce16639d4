/** Sentences on the inside, as far as the boundary decides. */
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import type { ReferenceCube } from '../../model/state'
import { say } from '../../words/say'

export function insideSentence(report: Report, cube: ReferenceCube): string {
  if (report.valid) return say('J > 0 on the boundary, so J > 0 everywhere. By the theorem nothing inside is lower.')
  const inside = lowerInside(report)
  if (inside === null)
    return say('The boundary already shows that the element is invalid. Nothing lower is found inside.')
  const least = formatJacdet(approximation(inside).value, report.exponent, cube)
  return report.boundaryMinimum === 0
    ? say('J ≥ 0 on the boundary, yet inside it falls to {least}. Zero is not enough: valid means more than zero.', {
        least,
      })
    : say('The boundary already shows that the element is invalid. Inside, J falls further, to {least}.', { least })
}
