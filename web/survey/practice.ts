/**
 * A mesh that nobody sees, opened while nothing else is to do: an engine makes fast code of what has run for a while, and the first mesh that
 * somebody opens finds it.
 */
import type { Mesh } from '../mesh/mesh'

/** Cells along each axis: enough for all that decide together. */
const SIDE = 41
/** Of an edge; a few cells in a thousand are invalid with it. */
const NOISE = 0.6

export function practiceMesh(): Mesh {
  const along = SIDE + 1
  const points = new Float64Array(3 * along ** 3)
  // A generator of Lehmer's: the same mesh each time.
  let seed = 1
  for (let i = 0; i < points.length; ++i) {
    seed = (48271 * seed) % 0x7fffffff
    const point = Math.floor(i / 3)
    const place = [point % along, Math.floor(point / along) % along, Math.floor(point / along ** 2)][i % 3] as number
    points[i] = place + NOISE * (seed / 0x7fffffff - 0.5)
  }
  const cells = new Uint32Array(8 * SIDE ** 3)
  const steps = [0, 1, along + 1, along]
  const offsets = [...steps, ...steps.map(step => step + along ** 2)]
  for (let at = 0, z = 0; z < SIDE; ++z)
    for (let y = 0; y < SIDE; ++y)
      for (let x = 0; x < SIDE; ++x)
        for (const offset of offsets) cells[at++] = x + along * (y + along * z) + offset
  return {
    format: 'VTU',
    points,
    cells,
    ids: null,
    blocks: [],
    notTrilinear: { corners: new Uint32Array(0), straight: null },
    other: new Map(),
    notes: [],
    isOrderStated: true,
    isCutOff: false,
    coordinatePlaces: null,
    steps: [],
  }
}
