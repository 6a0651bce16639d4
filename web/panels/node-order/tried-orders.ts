/** The known node orders that make a valid element of an invalid one's points, exactly decided. */

import type { Core } from '../../core/report'
import type { Vertices } from '../../model/hexahedron'
import { distinctOrders, reordered } from '../../model/node-order'
import { type NodeOrder, nodeOrders } from '../../model/node-orders'
import type { Question } from '../panel'

/** The same eight points in another order, which is a valid element. */
export interface HelpfulOrder {
  /** Orders that differ by a rotation only; there is at least one. */
  readonly orders: readonly NodeOrder[]
  readonly vertices: Vertices
  /** Its least jacdet, times 2^exponent. */
  readonly boundaryMinimum: number
  readonly exponent: number
}

/** Other orders of an invalid element; while a gesture runs, of the one before it. */
export interface TriedOrders {
  readonly vertices: Vertices
  /** The number of orders tried, rotations of each counted once. */
  readonly count: number
  /** The one with the greatest minimum first. */
  readonly helpful: readonly HelpfulOrder[]
}

const distinct = distinctOrders(nodeOrders)

export function triedOrders(core: Core, vertices: Vertices): TriedOrders {
  const helpful = distinct.flatMap((orders): HelpfulOrder[] => {
    const other = reordered(vertices, orders[0]?.permutation ?? [])
    const verdict = core.isValid(other)
    if (!verdict.ok || !verdict.value) return []
    const result = core.analyze(other)
    if (!result.ok) return []
    const { boundaryMinimum, exponent } = result.value
    return [{ orders, vertices: other, boundaryMinimum, exponent }]
  })
  return { vertices, count: distinct.length, helpful: helpful.toSorted((a, b) => size(b) - size(a)) }
}

/** Grows with the minimum, which is positive and may be far outside the doubles. */
function size({ boundaryMinimum, exponent }: HelpfulOrder): number {
  return Math.log2(boundaryMinimum) + exponent
}

/** The orders are tried for invalid elements only. */
export const triedOrdersQuestion: Question<TriedOrders> = {
  name: 'node-order',
  start() {
    let tried: TriedOrders | null = null
    return {
      answer(core, { vertices, gestureStart, openPanels }, { valid }) {
        if (!openPanels.includes('node-order')) tried = null
        else if (gestureStart === null && tried?.vertices !== vertices)
          tried = valid ? null : triedOrders(core, vertices)
        return tried
      },
    }
  },
}
