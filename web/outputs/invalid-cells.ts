/** The cells that are written where only invalid ones are, and their names. */
import type { MeshCheck } from '../mesh/mesh-check'

/** In the file's order. */
export function invalidCells(check: MeshCheck): number[] {
  const cells: number[] = []
  for (let cell = 0; cell < check.hexahedra; ++cell) if (check.standingOf(cell) === 'invalid') cells.push(cell)
  return cells
}

/** The id in the file; the index, counted from 0, if it has none. */
export function nameOf({ idOf }: Pick<MeshCheck, 'idOf'>, cell: number): string {
  return idOf(cell) ?? String(cell)
}
