/** Meshes with their nodes in the order that was meant. */
import { CLASSES } from '../core/unpack'
import { counted } from '../mesh/check-summary'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { type NodeOrder, nodeOrders } from '../model/node-orders'
import type { FixId } from './survey-jobs'
import { permuted } from './whole-order'

/** The mesh with another order of the nodes of some cells, or of all, which a note says. */
export function mended(check: MeshCheck, fix: FixId): Mesh {
  if (fix === 'mirrored') return turnedRound(check)
  const order = nodeOrders.find(({ id }) => fix === `order-${id}`)
  if (!order) throw new Error(`There is no order for ${fix}.`)
  return inOrder(check.mesh, order)
}

function turnedRound({ mesh, answers, hexahedra }: MeshCheck): Mesh {
  const cells = mesh.cells.slice()
  let count = 0
  for (let cell = 0; cell < hexahedra; ++cell) {
    if (CLASSES[answers.classes[cell] as number] !== 'inverted') continue
    exchangeBottomAndTop(cells, 8 * cell)
    count++
  }
  const note = `${counted(count, 'mirrored hexahedron has', 'mirrored hexahedra have')} been corrected here: nodes 0 to 3 and 4 to 7 are exchanged.`
  return { ...mesh, cells, notes: [...mesh.notes, note] }
}

/** Whoever takes an order has stated it. */
function inOrder(mesh: Mesh, order: NodeOrder): Mesh {
  const { name, usedBy } = order
  const users = usedBy === null ? '' : ` (${usedBy})`
  const note = `The nodes of all hexahedra have been taken here in the order “${name}”${users}.`
  return { ...mesh, cells: permuted(mesh, order), isOrderStated: true, notes: [...mesh.notes, note] }
}

/** Nodes 0 to 3 with 4 to 7, of the cell whose list begins there. */
export function exchangeBottomAndTop(cells: Uint32Array, at: number): void {
  const bottom = cells.slice(at, at + 4)
  cells.copyWithin(at, at + 4, at + 8)
  cells.set(bottom, at + 4)
}
