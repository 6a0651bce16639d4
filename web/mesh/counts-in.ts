/** What batches count in their lists, of lists that did not come from one. */
import type { Counts } from '../core/batch/batch-core'
import type { Answers } from '../core/batch/lists'
import { CLASSES } from '../core/unpack'
import { CORNERS, VTK } from './accepted-invalid'
import { countOf } from './bytes'

const INVERTED = CLASSES.indexOf('inverted')

type InLists = Pick<Counts, 'invertedCount' | 'coincidentCount' | 'acceptedByCornersCount' | 'acceptedByVtkCount'>

export function countsIn({ classes, coincident, acceptedInvalid }: Partial<Answers>): InLists {
  const accepted = (checks: readonly number[]) =>
    acceptedInvalid ? checks.reduce((sum, mask) => sum + countOf(acceptedInvalid, mask), 0) : 0
  return {
    invertedCount: classes ? countOf(classes, INVERTED) : 0,
    coincidentCount: coincident ? countOf(coincident, 1) : 0,
    acceptedByCornersCount: accepted([CORNERS, CORNERS | VTK]),
    acceptedByVtkCount: accepted([VTK, CORNERS | VTK]),
  }
}
