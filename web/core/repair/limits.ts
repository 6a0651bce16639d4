/** Where a vertex may go: hl_limits of wasm/include/hexlens.h. */
import type { Vec3 } from '../../model/hexahedron'

/**
 * Coordinates from `low` to `high`, which may be infinite, and from the present place only at right angles to the normals, none to two
 * of them. Normals that are an axis come first; then the coordinate on it stays as it is.
 */
export interface Limits {
  readonly low: Vec3
  readonly high: Vec3
  readonly normals: readonly Vec3[]
}
