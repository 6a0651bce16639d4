/** Outlines of candidates by kind, about (0, 0) in CSS pixels; where a vertex has a handle it needs none. */
import type { CandidateKind } from '../../core/report'

export const candidateShapes: Readonly<Record<CandidateKind, string>> = {
  vertex: 'M3.6 0A3.6 3.6 0 1 1 -3.6 0A3.6 3.6 0 1 1 3.6 0Z',
  edge: 'M0 -4.6L4.6 0L0 4.6L-4.6 0Z',
  face: 'M-3.4 -3.4H3.4V3.4H-3.4Z',
}
