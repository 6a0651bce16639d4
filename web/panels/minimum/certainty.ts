/** Short texts: how the verdict became certain, and if jacdet is lower inside. */
import { roundedUp } from '../../core/inside'
import type { Report } from '../../core/report'
import { formatBound, formatJacdet } from '../../model/decimal'
import type { ReferenceCube } from '../../model/state'
import { say } from '../../words/say'

/** Each number in it is rounded to the side on which the claim still holds. */
export function certainBy(report: Report, cube: ReferenceCube): string {
  const { valid, decidedBy, exponent, boundaryMinimum, boundaryMinimumError, volumeMinimum } = report
  if (decidedBy === 'exact') return say('exact arithmetic, not doubles')
  if (valid)
    return say('error bounds: all J ≥ {bound}', { bound: formatJacdet(volumeMinimum.lower, exponent, cube, 'down') })
  const certainlyBelow = roundedUp(boundaryMinimum + boundaryMinimumError)
  return say('a witness: J ≤ {bound} there', { bound: formatJacdet(certainlyBelow, exponent, cube, 'up') })
}

/** Bounds how far below the boundary minimum an invalid element can still be inside. */
export function noLowerInside(report: Report, cube: ReferenceCube): string {
  const { exponent, boundaryMinimum, boundaryMinimumError, volumeMinimum } = report
  const gap = roundedUp(roundedUp(boundaryMinimum + boundaryMinimumError) - volumeMinimum.lower)
  return gap > 0
    ? say('nowhere lower, to within {gap}', { gap: formatBound(gap, exponent, cube) })
    : say('nowhere lower')
}
