/** Cells whose verdict hangs on an order of nodes that nobody has stated. */

import type { Core } from '../core/report'
import { reordered } from '../model/node-order'
import { type NodeOrder, nodeOrders } from '../model/node-orders'
import type { Mesh } from './mesh'
import { verticesOf } from './vertices-of'

/** Cells that are not `valid`, but are in an order that programs use: with the first of these. */
export function openOrdersOf(mesh: Mesh, valid: Uint8Array, core: Core): Map<number, NodeOrder> {
  const open = new Map<number, NodeOrder>()
  for (let cell = 0; cell < valid.length; ++cell) {
    if (valid[cell] === 1) continue
    const vertices = verticesOf(mesh, cell)
    const order = nodeOrders.find(({ permutation }) => {
      const verdict = core.isValid(reordered(vertices, permutation))
      return verdict.ok && verdict.value
    })
    if (order) open.set(cell, order)
  }
  return open
}
