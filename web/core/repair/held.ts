/** Why a point that untangling has left could not help its cells: its best place, and the proof that none is better. */
import { VERTEX_COUNT } from '../../model/hexahedron'
import type { BestPlace, RepairCore, Star } from './best-place'
import { type PlaceProof, provePlace } from './place-proof'
import type { PointMesh, Untangled } from './untangling'

export interface Reason {
  readonly point: number
  /** The cells around the point; the star and the holds name them by their place in this list. */
  readonly cells: readonly number[]
  /** Which vertex of the first of them the point is. */
  readonly vertex: number
  readonly star: Star
  readonly best: BestPlace
  readonly proof: PlaceProof
  /** Proved: no place of the point makes all of these cells valid; or none gives them the margin. Null if neither is. */
  readonly forbids: 'valid' | 'margin' | null
}

/** Reasons of the points of `untangled.heldPoints`, by their place there; each is found when it is asked for. */
export function reasonsOf(
  core: RepairCore,
  { cells }: Pick<PointMesh, 'cells'>,
  { points, heldPoints, heldLimits }: Pick<Untangled, 'points' | 'heldPoints' | 'heldLimits'>,
  margin: number,
): (held: number) => Reason {
  const around = cellsAround(cells, heldPoints)
  return held => {
    const point = heldPoints[held] as number
    const own = around.get(point) as number[]
    const indices = own.flatMap(c => [...cells.subarray(VERTEX_COUNT * c, VERTEX_COUNT * (c + 1))])
    const star = { points, cells: indices, vertex: point, limits: heldLimits[held] ?? undefined }
    const found = core.bestPlace(star)
    if (!found.ok) throw new Error(found.error.message)
    const proof = provePlace(star, found.value)
    const forbids = whatIsForbidden(found.value, proof, margin)
    return { point, cells: own, vertex: indices.indexOf(point), star, best: found.value, proof, forbids }
  }
}

function whatIsForbidden(best: BestPlace, proof: PlaceProof, margin: number): Reason['forbids'] {
  if (!proof.isProved) return null
  if (best.measure === 'scale') return proof.isImpossible ? 'valid' : null
  return best.bound < margin ? 'margin' : null
}

function cellsAround(cells: PointMesh['cells'], points: Uint32Array): Map<number, number[]> {
  const around = new Map<number, number[]>(Array.from(points, point => [point, []]))
  cells.forEach((point, i) => {
    const list = around.get(point)
    const cell = Math.floor(i / VERTEX_COUNT)
    if (list && list.at(-1) !== cell) list.push(cell)
  })
  return around
}
