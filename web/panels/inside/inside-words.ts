/** What the boundary says of the inside, in one sentence. */
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import type { ReferenceCube } from '../../model/state'

export function insideSentence(report: Report, cube: ReferenceCube): string {
  if (report.valid) return 'Positive on the boundary, so positive everywhere: by the theorem nothing inside is lower.'
  const inside = lowerInside(report)
  if (inside === null)
    return 'The boundary already shows that the element is invalid, and nothing lower is found inside.'
  const least = formatJacdet(approximation(inside).value, report.exponent, cube)
  return report.boundaryMinimum === 0
    ? `On the boundary the jacdet is never below zero, yet inside it falls to ${least}. Positive has to mean more than zero.`
    : `The boundary already shows that the element is invalid; inside the jacdet falls further, to ${least}.`
}
