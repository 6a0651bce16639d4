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
  const { bounds, distances, greatest } = blocksOf(middles)
  const total = middles.length / 3
  const alongOf = (at: number) =>
    x * (middles[at] as number) + y * (middles[at + 1] as number) + z * (middles[at + 2] as number)
  const isBehind = (cell: number) => alongOf(3 * cell) <= offset

  // Two middles lie as far apart along the normal as their distance times its length, at most. Distances are rounded by 2^-24, and
  // what is computed here by less. Each of the two products is off by three roundings of at most 2^-53 of the sum of its terms.
  const length = Math.hypot(x, y, z) * (1 + 2 ** -22)
  const nearest = offset - 2 ** -50 * greatest * (Math.abs(x) + Math.abs(y) + Math.abs(z))
  // The signs of the normal say which bounds of a block have its least product; the others have its greatest.
  const [leastX, leastY, leastZ] = [x < 0 ? 3 : 0, y < 0 ? 4 : 1, z < 0 ? 5 : 2]
  const found: number[] = []
  let count = 0
  for (let block = 0, cell = 0, at = 0; cell < total; ++block, at += BOUNDS) {
    const end = Math.min(cell + BLOCK, total)
    // Rounding keeps the order: no product in the block is computed less, or greater. Both are NaN where a middle is.
    const least =
      x * (bounds[at + leastX] as number) + y * (bounds[at + leastY] as number) + z * (bounds[at + leastZ] as number)
    const most =
      x * (bounds[at + 3 - leastX] as number) +
      y * (bounds[at + 5 - leastY] as number) +
      z * (bounds[at + 7 - leastZ] as number)
    if (least > offset) {
      cell = end
      continue
    }
    if (distances[block] === UNKNOWN) distances[block] = distanceOf(cell, end, middles, across)
    const reach = length * (distances[block] as number)
    if (most <= offset && most + reach < nearest) {
      count += end - cell
      cell = end
      continue
    }
    for (; cell < end; ++cell) {
      const along = alongOf(3 * cell)
      if (!(along <= offset)) continue
      count++
      if (along + reach < nearest) continue
      for (let face = FACES * cell; face < FACES * cell + FACES; ++face) {
        const other = across[face] as number
        if (other >= 0 && !isBehind((other / FACES) | 0)) found.push(face)
      }
    }
  }
  return { faces: Uint32Array.from(found), count, isBehind }
}

/** Cells that follow each other in the file are often neighbours: most blocks of so many lie on one side of a plane. */
const BLOCK = 16

/** Numbers of a block's bounds: the least of each coordinate, then the greatest. */
const BOUNDS = 6

interface Blocks {
  /** The bounds of each block's middles; NaN where one of them is. */
  readonly bounds: Float32Array
  /** The farthest that a middle of a block has one of its neighbours' from itself, once somebody has asked for it. */
  readonly distances: Float32Array
  /** The greatest coordinate of a middle. */
  readonly greatest: number
}

const UNKNOWN = -1

/** Each mesh and each step of it has middles of its own. */
const known = new WeakMap<Float32Array, Blocks>()

function blocksOf(middles: Float32Array): Blocks {
  let blocks = known.get(middles)
  if (!blocks) {
    const count = Math.ceil(middles.length / 3 / BLOCK)
    const bounds = new Float32Array(BOUNDS * count)
    let greatest = 0
    for (let block = 0; block < count; ++block)
      for (let axis = 0; axis < 3; ++axis) {
        let [lower, upper] = [Infinity, -Infinity]
        const end = Math.min(3 * BLOCK * (block + 1), middles.length)
        for (let at = 3 * BLOCK * block + axis; at < end; at += 3) {
          lower = Math.min(lower, middles[at] as number)
          upper = Math.max(upper, middles[at] as number)
        }
        bounds[BOUNDS * block + axis] = lower
        bounds[BOUNDS * block + 3 + axis] = upper
        greatest = Math.max(greatest, -lower, upper)
      }
    blocks = { bounds, distances: new Float32Array(count).fill(UNKNOWN), greatest }
    known.set(middles, blocks)
  }
  return blocks
}

/** Infinite where a middle is not finite: all cells of such a block are asked. */
function distanceOf(from: number, to: number, middles: Float32Array, across: Int32Array): number {
  let farthest = 0
  for (let face = FACES * from; face < FACES * to; ++face) {
    const other = across[face] as number
    if (other < 0) continue
    const own = 3 * ((face / FACES) | 0)
    const at = 3 * ((other / FACES) | 0)
    const dx = (middles[at] as number) - (middles[own] as number)
    const dy = (middles[at + 1] as number) - (middles[own + 1] as number)
    const dz = (middles[at + 2] as number) - (middles[own + 2] as number)
    const square = dx * dx + dy * dy + dz * dz
    if (!(square <= farthest)) farthest = Number.isNaN(square) ? Infinity : square
  }
  return Math.sqrt(farthest)
}
