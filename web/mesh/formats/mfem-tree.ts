/** Vertices of MFEM's non-conforming meshes: each lies between two parents, which may lie between others. */
import type { Refusing } from '../mesh'
import type { MeshBuilder } from '../mesh-builder'

const STRIDE = 4

/** `parents` has vertex, two parents and the place between them, four numbers each. Vertices without parents are points already. */
export function placeNonConforming(cursor: Refusing, builder: MeshBuilder, parents: Float64Array): void {
  const rowOf = new Map<number, number>()
  for (let row = 0; row < parents.length; row += STRIDE) rowOf.set(parents[row] as number, row)
  for (const id of rowOf.keys()) {
    const open = [id]
    while (open.length > 0) {
      const vertex = open.at(-1) as number
      if (builder.hasPointWithId(vertex)) {
        open.pop()
        continue
      }
      const row = rowOf.get(vertex)
      if (row === undefined) cursor.refuse(`vertex ${vertex} has neither coordinates nor parents.`)
      const [a, b, between] = [parents[row + 1] as number, parents[row + 2] as number, parents[row + 3] as number]
      const missing = [a, b].filter(parent => !builder.hasPointWithId(parent))
      if (missing.length > 0) {
        if (open.length > rowOf.size) cursor.refuse(`vertex ${vertex} is a parent of its own parents.`)
        open.push(missing[0] as number)
        continue
      }
      open.pop()
      const [from, to] = [builder.indexOfId(a, 'a vertex'), builder.indexOfId(b, 'a vertex')]
      const at = (axis: number) =>
        (1 - between) * builder.coordinate(from, axis) + between * builder.coordinate(to, axis)
      builder.pointWithId(vertex, at(0), at(1), at(2))
    }
  }
}
