/** Grids of unit spacing with normal noise. */
import { vertexReference } from '../../web/model/hexahedron'
import { randomSource } from './random'

export interface NoisyGrid {
  readonly points: Float64Array
  readonly cells: Uint32Array
  isInside(point: number): boolean
}

/** `edge` points on each axis, x fastest. Boundary points have noise of their own, in their planes and along their edges only. */
export function noisyGrid(edge: number, sigma: number, seed: number, boundarySigma = 0): NoisyGrid {
  const random = randomSource(seed)
  const normal = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random())
  const gridOf = (p: number) => [p % edge, Math.floor(p / edge) % edge, Math.floor(p / edge ** 2)]
  const isEnd = (x: number) => x === 0 || x === edge - 1
  const isInside = (p: number) => !gridOf(p).some(isEnd)
  const noiseOf = (p: number, x: number) => (isInside(p) ? sigma : isEnd(x) ? 0 : boundarySigma)
  const points = Float64Array.from(
    Array.from({ length: edge ** 3 }, (_, p) =>
      gridOf(p).map(x => x + (noiseOf(p, x) && noiseOf(p, x) * normal())),
    ).flat(),
  )
  const side = edge - 1
  const cells = Uint32Array.from({ length: 8 * side ** 3 }, (_, i) => {
    const [x, y, z] = vertexReference[i % 8] as readonly [number, number, number]
    const c = Math.floor(i / 8)
    return (c % side) + x + edge * ((Math.floor(c / side) % side) + y + edge * (Math.floor(c / side ** 2) + z))
  })
  return { points, cells, isInside }
}
