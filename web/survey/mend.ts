/** Meshes with their nodes in the order that was meant. */
import { CLASSES } from '../core/unpack'
import { counted } from '../mesh/check-summary'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import type { FixId } from './survey-jobs'

/** The mesh with another order of the nodes of some cells, which a note says. */
export function mended({ mesh, answers, hexahedra }: MeshCheck, _fix: FixId): Mesh {
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

function exchangeBottomAndTop(cells: Uint32Array, at: number): void {
  const bottom = cells.slice(at, at + 4)
  cells.copyWithin(at, at + 4, at + 8)
  cells.set(bottom, at + 4)
}
