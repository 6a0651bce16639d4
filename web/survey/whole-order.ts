/** The one order of nodes in which every cell of a mesh is valid, where the one that it has is wrong. */
import type { Core } from '../core/report'
import type { ClassifyCells } from '../mesh/check'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { verticesOf } from '../mesh/vertices-of'
import { distinctOrders, reordered } from '../model/node-order'
import { type NodeOrder, nodeOrders } from '../model/node-orders'

/** One of each kind: those that differ by a rotation say the same of every cell. */
const ORDERS = distinctOrders(nodeOrders).map(([first]) => first as NodeOrder)

/** Cells that decide at once against most orders; an order that they let pass is decided on all cells. */
const FIRST = 16

/**
 * The first order that programs use in which all cells are valid whose coordinates are finite. Null where most are valid in their own:
 * a cube with its top turned by one is valid, too, so that the cells that are not have another fault. Null as well where another
 * numbering of the mirrored cells alone makes all valid.
 */
export async function wholeOrderOf(
  check: MeshCheck,
  { classify, core }: { readonly classify: ClassifyCells; readonly core: Core },
): Promise<NodeOrder | null> {
  const { mesh, hexahedra, valid, mirrored, openOrders } = check
  const finite = hexahedra - check.unanswered + openOrders.size
  if (2 * valid >= finite || finite === valid + mirrored) return null
  const { points } = mesh
  const worst = [...check.worst.subarray(0, FIRST)].filter(cell => check.isAnswered(cell))
  const vertices = [...[...openOrders.keys()].slice(0, FIRST), ...worst].map(cell => verticesOf(mesh, cell))
  for (const order of ORDERS) {
    const isPossible = vertices.every(own => {
      const verdict = core.isValid(reordered(own, order.permutation))
      return verdict.ok && verdict.value
    })
    if (!isPossible) continue
    const { validCount } = await classify(points, permuted(mesh, order), {})
    if (validCount === finite) return order
  }
  return null
}

/** The cells with their nodes taken in another order. */
export function permuted({ cells }: Pick<Mesh, 'cells'>, { permutation }: NodeOrder): Uint32Array {
  return cells.map((_, i) => cells[(i & ~7) + (permutation[i & 7] as number)] as number)
}
