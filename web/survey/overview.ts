/** What is said of a mesh on top. */
import type { Box } from '../core/batch/batch-core'
import { countSentences } from '../mesh/check-summary'
import { inParts } from '../mesh/in-parts'
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
  }: {
    readonly worst: readonly Row[]
    readonly bounds: Bounds | null
    readonly wholeOrder: NodeOrder | null
  },
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

/** Of the points that cells have; null where they have none. */
export function boundsOf({ mesh: { points, cells }, answers }: MeshCheck): Bounds | null {
  return answers.box && answers.unansweredCount === 0 ? boundsOfBox(answers.box) : boundsOfBox(boxOf(points, cells))
}

function boundsOfBox([x0, y0, z0, x1, y1, z1]: Box): Bounds | null {
  const bounds: Bounds = { least: [x0, y0, z0], greatest: [x1, y1, z1] }
  return bounds.least.includes(Infinity) || bounds.greatest.includes(-Infinity) ? null : bounds
}

function boxOf(points: Float64Array, cells: Uint32Array): Box {
  const isUsed = new Uint8Array(points.length / 3)
  inParts(cells.length, (from, to) => {
    for (let i = from; i < to; ++i) isUsed[cells[i] as number] = 1
  })
  const box = Float64Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity)
  inParts(isUsed.length, (from, to) => widen(box, { points, isUsed, from, to }))
  return box as unknown as Box
}

interface Used {
  readonly points: Float64Array
  readonly isUsed: Uint8Array
  readonly from: number
  readonly to: number
}

/** Infinities and NaNs are nowhere. */
function widen(box: Float64Array, { points, isUsed, from, to }: Used): void {
  let [x0, y0, z0, x1, y1, z1] = box as unknown as [number, number, number, number, number, number]
  for (let point = from; point < to; ++point) {
    if (isUsed[point] !== 1) continue
    const x = points[3 * point] as number
    const y = points[3 * point + 1] as number
    const z = points[3 * point + 2] as number
    if (x < x0 && x > -Infinity) x0 = x
    if (x > x1 && x < Infinity) x1 = x
    if (y < y0 && y > -Infinity) y0 = y
    if (y > y1 && y < Infinity) y1 = y
    if (z < z0 && z > -Infinity) z0 = z
    if (z > z1 && z < Infinity) z1 = z
  }
  box.set([x0, y0, z0, x1, y1, z1])
}
