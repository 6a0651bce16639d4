/** How many of the invalid cells the checks accept of which the sentence on top tells. */
import { CHECKS } from '../core/unpack'
import { eachPlace } from './bytes'
import { type MeshCheck, STANDINGS } from './mesh-check'

export interface AcceptedInvalid {
  readonly corners: number
  readonly vtk: number
}

const INVALID = STANDINGS.indexOf('invalid')
export const CORNERS = 1 << CHECKS.indexOf('corners')
export const VTK = 1 << CHECKS.indexOf('corners-and-centre')

/** From what was counted, or from either of the lists that tell, if the check has one. */
export function acceptedInvalid({ answers, standings, invalid }: MeshCheck): AcceptedInvalid {
  // Then what counts as invalid is what the verdicts are.
  if (answers.acceptedInvalid && invalid === answers.invalidCount)
    return { corners: answers.acceptedByCornersCount, vtk: answers.acceptedByVtkCount }
  const masks = answers.acceptedInvalid ?? answers.acceptedBy
  let [corners, vtk] = [0, 0]
  if (masks)
    eachPlace(standings, INVALID, cell => {
      const mask = masks[cell] as number
      if (mask & CORNERS) corners++
      if (mask & VTK) vtk++
    })
  return { corners, vtk }
}

/** Eight indices for each of some cells. */
export function cellsAt(cells: Uint32Array, some: ArrayLike<number>): Uint32Array {
  const own = new Uint32Array(8 * some.length)
  for (let i = 0; i < some.length; ++i) {
    const from = 8 * (some[i] as number)
    for (let v = 0; v < 8; ++v) own[8 * i + v] = cells[from + v] as number
  }
  return own
}
