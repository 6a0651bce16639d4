/** A mesh of which it is known which cells share a face: all that pictures of it are made from. */
import type { MeshCheck } from '../mesh/mesh-check'
import type { Neighbours } from '../mesh/neighbours'
import type { Vec3 } from '../model/hexahedron'

export interface Faced {
  readonly check: MeshCheck
  readonly neighbours: Neighbours
  readonly origin: Vec3
  /** The middles of cells less the origin, three numbers each. */
  readonly middles: Float32Array
  readonly isListed: (cell: number) => boolean
}
