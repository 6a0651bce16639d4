/** A mesh to untangle: an arched block, in which some inner vertices have been thrown out of their places. */
import { vertexReference } from '../../model/hexahedron'
import { vtkFile } from './vtk-file'

/** Cells along each axis. */
const SIDES = [18, 10, 10] as const
/** One inner vertex in so many is thrown, by up to so many cells on each axis. */
const ONE_IN = 40
const FARTHEST = 1.6
/** All other inner vertices are off by up to this. */
const NOISE = 0.12

export interface Block {
  readonly points: Float64Array
  readonly cells: Uint32Array
}

export function thrownBlock(): Block {
  const [nx, ny, nz] = SIDES
  const random = linearCongruence(5)
  const points: number[] = []
  for (let k = 0; k <= nz; ++k)
    for (let j = 0; j <= ny; ++j)
      for (let i = 0; i <= nx; ++i) {
        const isInside = i > 0 && i < nx && j > 0 && j < ny && k > 0 && k < nz
        const size = !isInside ? 0 : random() < 1 / ONE_IN ? FARTHEST : NOISE
        const [x, y, z] = [i, j, k].map(at => at + size * (2 * random() - 1)) as [number, number, number]
        points.push(...bent(x, y, z))
      }
  const cells: number[] = []
  for (let k = 0; k < nz; ++k)
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i)
        for (const [x, y, z] of vertexReference) cells.push(i + x + (nx + 1) * (j + y + (ny + 1) * (k + z)))
  return { points: Float64Array.from(points), cells: Uint32Array.from(cells) }
}

export function thrownBlockFile(): File {
  return vtkFile('block.vtk', 'A block with thrown vertices', thrownBlock())
}

/** An arch: the block is as wide at its feet as in its middle. */
function bent(x: number, y: number, z: number): readonly [number, number, number] {
  const middle = SIDES[0] / 2
  const rise = 1 - ((x - middle) / middle) ** 2
  return [x, y, z + 4 * rise]
}

/** Numbers in [0,1): the same wherever it runs. Numerical Recipes' constants. */
function linearCongruence(seed: number): () => number {
  let state = seed
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return state / 2 ** 32
  }
}
