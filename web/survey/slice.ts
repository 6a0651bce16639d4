/**
 * Faces where a plane cuts: those between a cell behind it and one before it. A cell is behind by its middle, so only the cells near the
 * plane are asked for their neighbours.
 */
import { FACES } from '../mesh/face-loops'
import type { Neighbours } from '../mesh/neighbours'
import type { Vec3 } from '../model/hexahedron'

export interface Sliced {
  readonly faces: Uint32Array
  /** Cells behind the plane. */
  readonly count: number
  readonly isBehind: (cell: number) => boolean
}

/** Three numbers each in `middles`; a cell is behind the plane if the product of its own with `normal` is `offset` at most. */
export function slicedBy(
  middles: Float32Array,
  { across }: Neighbours,
  { normal: [x, y, z], offset }: { readonly normal: Vec3; readonly offset: number },
): Sliced {
  const { distances, greatest } = reachOf(middles)
  const isBehind = (cell: number) =>
    x * (middles[3 * cell] as number) + y * (middles[3 * cell + 1] as number) + z * (middles[3 * cell + 2] as number) <=
    offset

  // Two middles lie as far apart along the normal as their distance times its length, at most. Distances are rounded by 2^-24, and
  // what is computed here by less. Each of the two products is off by three roundings of at most 2^-53 of the sum of its terms.
  const length = Math.hypot(x, y, z) * (1 + 2 ** -22)
  const nearest = offset - 2 ** -50 * greatest * (Math.abs(x) + Math.abs(y) + Math.abs(z))
  const found: number[] = []
  let count = 0
  for (let cell = 0, at = 0; cell < distances.length; ++cell, at += 3) {
    const along = x * (middles[at] as number) + y * (middles[at + 1] as number) + z * (middles[at + 2] as number)
    if (!(along <= offset)) continue
    count++
    const distance = distances[cell] as number
    if (distance !== UNKNOWN && along + length * distance < nearest) continue
    if (distance === UNKNOWN) distances[cell] = distanceOf(cell, middles, across)
    for (let face = FACES * cell; face < FACES * cell + FACES; ++face) {
      const other = across[face] as number
      if (other >= 0 && !isBehind((other / FACES) | 0)) found.push(face)
    }
  }
  return { faces: Uint32Array.from(found), count, isBehind }
}

interface Reach {
  /** From each cell's middle to the farthest of its neighbours', once somebody has asked for it. */
  readonly distances: Float32Array
  /** The greatest coordinate of a middle. */
  readonly greatest: number
}

const UNKNOWN = -1

/** Each mesh and each step of it has middles of its own. */
const known = new WeakMap<Float32Array, Reach>()

function reachOf(middles: Float32Array): Reach {
  let reach = known.get(middles)
  if (!reach) {
    let greatest = 0
    for (const coordinate of middles) greatest = Math.max(greatest, Math.abs(coordinate))
    reach = { distances: new Float32Array(middles.length / 3).fill(UNKNOWN), greatest }
    known.set(middles, reach)
  }
  return reach
}

/** Infinite where a middle is not finite: such a cell is always asked. */
function distanceOf(cell: number, middles: Float32Array, across: Int32Array): number {
  let farthest = 0
  for (let face = FACES * cell; face < FACES * cell + FACES; ++face) {
    const other = across[face] as number
    if (other < 0) continue
    const at = 3 * ((other / FACES) | 0)
    const dx = (middles[at] as number) - (middles[3 * cell] as number)
    const dy = (middles[at + 1] as number) - (middles[3 * cell + 1] as number)
    const dz = (middles[at + 2] as number) - (middles[3 * cell + 2] as number)
    const square = dx * dx + dy * dy + dz * dz
    if (!(square <= farthest)) farthest = Number.isNaN(square) ? Infinity : square
  }
  return Math.sqrt(farthest)
}
