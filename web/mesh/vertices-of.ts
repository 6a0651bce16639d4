/** One cell of a mesh as an element. */
import type { Vertices } from '../model/hexahedron'
import type { Mesh } from './mesh'

/** 24 coordinates. */
export function verticesOf({ points, cells }: Pick<Mesh, 'points' | 'cells'>, cell: number): Vertices {
  return Array.from({ length: 24 }, (_, i) => {
    const index = cells[8 * cell + Math.floor(i / 3)] as number
    return points[3 * index + (i % 3)] as number
  })
}
