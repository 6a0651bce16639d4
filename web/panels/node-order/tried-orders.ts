/** Which of the known node orders make a valid element of an invalid one's points: the core's verdicts, exact as always. */
import { nodeOrders } from '../../content/node-orders'
import type { Core } from '../../core/report'
import type { Vertices } from '../../model/hexahedron'
import { distinctOrders, reordered } from '../../model/node-order'
import type { HelpfulOrder, TriedOrders } from '../../views/view'

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
