/** The candidates in the order in which a key goes through them. */
import type { Candidate, Report } from '../../core/report'
import type { Vec3 } from '../../model/hexahedron'

/** The minimizer first, then the others; after the last the minimizer again. Points that coincide are one. */
export function nextCandidate({ minimizer, candidates }: Report, probe: Vec3 | null): Candidate {
  const all = [minimizer, ...candidates].filter(
    ({ point }, i, list) => list.findIndex(other => samePoint(other.point, point)) === i,
  )
  const at = all.findIndex(({ point }) => probe !== null && samePoint(point, probe))
  return all[(at + 1) % all.length] as Candidate
}

export function samePoint(a: Vec3, b: Vec3): boolean {
  return a.every((value, axis) => value === b[axis])
}
