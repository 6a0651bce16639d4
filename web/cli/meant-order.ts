/** The cells of a mesh with their nodes in the order that was meant, where that is not the one of the file. */
import type { RepairCore } from '../core/repair/best-place'
import type { Core } from '../core/report'
import type { ClassifyCells } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'
import type { MeantOrder } from '../outputs/repair-text'
import { exchangeBottomAndTop } from '../survey/mend'
import { permuted, wholeOrderOf } from '../survey/whole-order'

interface Means {
  readonly core: Core
  readonly repairCore: RepairCore
  readonly classify: ClassifyCells
}

/** Null where the file's order is the one that was meant, as far as can be told. */
export async function meantOrderOf(
  check: MeshCheck,
  { core, repairCore, classify }: Means,
): Promise<MeantOrder | null> {
  const { mesh } = check
  if (check.valid === check.hexahedra) return null
  const whole = await wholeOrderOf(check, { classify, core })
  if (whole) return { kind: 'whole', order: whole, cells: permuted(mesh, whole) }
  const reversed = await repairCore.reversedCells(mesh)
  const cells = mesh.cells.slice()
  let count = 0
  for (let cell = reversed.indexOf(1); cell >= 0; cell = reversed.indexOf(1, cell + 1)) {
    exchangeBottomAndTop(cells, 8 * cell)
    ++count
  }
  return count === 0 ? null : { kind: 'reversed', count, cells }
}
