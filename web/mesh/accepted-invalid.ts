/** How many of the invalid cells the checks accept of which the sentence on top tells. */
import { CHECKS } from '../core/unpack'
import type { ClassifyCells } from './check'
import { type MeshCheck, STANDINGS } from './mesh-check'

export interface AcceptedInvalid {
  readonly corners: number
  readonly vtk: number
}

const INVALID = STANDINGS.indexOf('invalid')
const CORNERS = 1 << CHECKS.indexOf('corners')
const VTK = 1 << CHECKS.indexOf('corners-and-centre')

/** From the list `acceptedBy`, if the check has it. */
export function acceptedInvalid(check: MeshCheck): AcceptedInvalid {
  const { acceptedBy } = check.answers
  let [corners, vtk] = [0, 0]
  if (acceptedBy)
    for (let cell = 0; cell < check.hexahedra; ++cell) {
      const mask = acceptedBy[cell] as number
      if ((mask & (CORNERS | VTK)) === 0 || check.standingOf(cell) !== 'invalid') continue
      if (mask & CORNERS) corners++
      if (mask & VTK) vtk++
    }
  return { corners, vtk }
}

/** The same without that list, which is asked only of the cells that may be accepted. The check has the list of these. */
export async function acceptedOfInvalid(check: MeshCheck, classify: ClassifyCells): Promise<AcceptedInvalid> {
  const { mesh, answers, standings } = check
  const mayBeAccepted = answers.mayBeAccepted as Uint8Array
  const some: number[] = []
  for (let cell = mayBeAccepted.indexOf(1); cell >= 0; cell = mayBeAccepted.indexOf(1, cell + 1))
    if (standings[cell] === INVALID) some.push(cell)
  if (some.length === 0) return { corners: 0, vtk: 0 }
  const { acceptedBy } = await classify(mesh.points, cellsAt(mesh.cells, some), { acceptedBy: true })
  let [corners, vtk] = [0, 0]
  for (const mask of acceptedBy) {
    if (mask & CORNERS) corners++
    if (mask & VTK) vtk++
  }
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
