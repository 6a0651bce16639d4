/** What is said of a mesh on top. */

import type { CheckId } from '../core/report'
import { CHECKS } from '../core/unpack'
import { countSentences } from '../mesh/check-summary'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
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
  return {
    name,
    format: mesh.format,
    headline: headlineOf(check),
    sentences: [...countSentences(check, OPTIONS), ...check.notes],
    hexahedra,
    counts: { valid: check.valid, invalid: check.invalid, unanswered: check.unanswered, degenerate: 0 },
    fixes: fixesOf(check, wholeOrder),
    blocks: mesh.blocks.map(block => ({ name: shown(block.name).slice(1, -1), cells: block.cells.length })),
    hasIds: mesh.ids !== null,
    bounds,
    worst,
  }
}

/** "12 of 88,432 hexahedra are invalid. The eight corners would accept 7 of them, VTK’s scaled Jacobian 9." */
export function headlineOf(check: MeshCheck): string {
  const { hexahedra, invalid, unanswered } = check
  const open = unanswered === 0 ? '' : ` ${grouped(unanswered)} ${unanswered === 1 ? 'is' : 'are'} unanswered.`
  if (invalid === 0) return `${noneInvalid(hexahedra, unanswered)}${open}`
  const [are, them] = invalid === 1 ? ['is', 'it'] : ['are', 'them']
  const of = hexahedra === 1 ? 'The hexahedron is' : `${grouped(invalid)} of ${grouped(hexahedra)} hexahedra ${are}`
  const corners = acceptedInvalid(check, 'corners')
  const vtk = acceptedInvalid(check, 'corners-and-centre')
  const others =
    corners + vtk === 0
      ? `The eight corners and VTK’s scaled Jacobian reject ${them}, too.`
      : `The eight corners would accept ${grouped(corners)} of them, VTK’s scaled Jacobian ${grouped(vtk)}.`
  return `${of} invalid. ${others}${open}`
}

function noneInvalid(hexahedra: number, unanswered: number): string {
  if (unanswered === hexahedra) return ''
  if (hexahedra === 1) return 'The hexahedron is valid.'
  return unanswered === 0
    ? `All ${grouped(hexahedra)} hexahedra are valid.`
    : `None of ${grouped(hexahedra)} hexahedra is known to be invalid.`
}

/** Invalid cells that a check accepts. */
export function acceptedInvalid(check: MeshCheck, id: CheckId): number {
  const bit = 1 << CHECKS.indexOf(id)
  const { acceptedBy } = check.answers
  let count = 0
  for (let cell = 0; cell < check.hexahedra; ++cell)
    if (((acceptedBy?.[cell] ?? 0) & bit) !== 0 && check.standingOf(cell) === 'invalid') count++
  return count
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

/** 88,432. */
export function grouped(count: number): string {
  return count.toLocaleString('en')
}
