/** A checked mesh as columns, which a worker hands over without copying; web/mesh/checked-cells.ts reads them. */
import { firstBlocks } from './check'
import { type CheckedColumns, type PackedNames, STANDINGS } from './checked-cells'
import type { MeshCheck } from './mesh-check'
import { shown } from './shown'

/** All cells must be among the check's worst. */
export function columnsOf(check: MeshCheck): CheckedColumns {
  const { mesh, answers, worst, openOrders } = check
  return {
    points: mesh.points,
    cells: mesh.cells,
    isOrderStated: mesh.isOrderStated,
    ids: mesh.ids === null || mesh.ids instanceof Float64Array ? mesh.ids : packedNames(mesh.ids),
    blockNames: mesh.blocks.map(({ name }) => shown(name).slice(1, -1)),
    blocks: firstBlocks(mesh),
    standings: Uint8Array.from({ length: check.hexahedra }, (_, cell) => STANDINGS.indexOf(check.standingOf(cell))),
    relativeMinima: answers.relativeMinima,
    worst,
    openOrders: new Map([...openOrders].map(([cell, { id }]) => [cell, id])),
  }
}

function packedNames(names: readonly string[]): PackedNames {
  const encoder = new TextEncoder()
  const encoded = names.map(name => encoder.encode(name))
  const ends = new Uint32Array(names.length)
  let end = 0
  for (const [i, { length }] of encoded.entries()) {
    end += length
    ends[i] = end
  }
  const bytes = new Uint8Array(end)
  for (const [i, name] of encoded.entries()) bytes.set(name, (ends[i] as number) - name.length)
  return { bytes, ends }
}
