/** What is said of a mesh on top. */
import { countSentences } from '../mesh/check-summary'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { grouped, headlineOf } from '../mesh/mesh-headline'
import { shown } from '../mesh/shown'
import type { NodeOrder } from '../model/node-orders'
import type { Bounds, Fix, Overview, Row } from './survey-jobs'

const OPTIONS = { skipsDegenerate: false }

export function overviewOf(
  name: string,
  check: MeshCheck,
  {
    worst,
    bounds,
    wholeOrder,
  }: { readonly worst: readonly Row[]; readonly bounds: Bounds | null; readonly wholeOrder: NodeOrder | null },
): Overview {
  const { mesh, hexahedra } = check
  // What the answers add may have a button, or tell what the counts leave out.
  const [own, added] = [check.notes.slice(0, mesh.notes.length), check.notes.slice(mesh.notes.length)]
  return {
    name,
    format: mesh.format,
    headline: headlineOf(check),
    sentences: [...added, ...countSentences(check, OPTIONS), ...own],
    hexahedra,
    counts: { valid: check.valid, invalid: check.invalid, unanswered: check.unanswered, degenerate: 0 },
    fixes: fixesOf(check, wholeOrder),
    blocks: mesh.blocks.map(block => ({ name: shown(block.name).slice(1, -1), cells: block.cells.length })),
    hasIds: mesh.ids !== null,
    bounds,
    worst,
  }
}

function fixesOf({ mirrored }: MeshCheck, wholeOrder: NodeOrder | null): Fix[] {
  if (wholeOrder) return [{ id: `order-${wholeOrder.id}`, words: `Take the nodes in the order “${wholeOrder.name}”` }]
  if (mirrored === 0) return []
  return [{ id: 'mirrored', words: `Correct ${grouped(mirrored)} mirrored ${mirrored === 1 ? 'cell' : 'cells'}` }]
}

/** Of the points that cells have. */
export function boundsOf({ points, cells }: Mesh): Bounds | null {
  const least = [Infinity, Infinity, Infinity]
  const greatest = [-Infinity, -Infinity, -Infinity]
  for (const point of cells)
    for (let axis = 0; axis < 3; ++axis) {
      const value = points[3 * point + axis] as number
      if (!Number.isFinite(value)) continue
      if (value < (least[axis] as number)) least[axis] = value
      if (value > (greatest[axis] as number)) greatest[axis] = value
    }
  if (least.some(value => value === Infinity)) return null
  return { least: least as unknown as Bounds['least'], greatest: greatest as unknown as Bounds['greatest'] }
}
