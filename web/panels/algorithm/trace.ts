/**
 * Algorithm 1 step by step (docs/algorithm.md 4 and 6), from a report alone: vertices, then edges,
 * then faces in order, with what each adds to M, the least jacdet so far. The report holds every
 * candidate, whatever a query would have skipped.
 */

import type { Candidate, CandidateKind, Report } from '../../core/report'
import { bernsteinOnEdge } from '../../core/section'
import { edgeVertices, faces, VERTEX_COUNT } from '../../model/hexahedron'
import type { Query, Variant } from './following'

/**
 * The outcome of a step. An edge without candidate: its parabola is concave, no parabola, or its
 * vertex is not strictly inside. A face without: skipped by its bound, P identically zero, P
 * without root in (0,1), or none of the roots kept.
 */
export type Outcome =
  | 'evaluated'
  | 'concave'
  | 'straight'
  | 'vertex-outside'
  | 'bound'
  | 'quartic-zero'
  | 'no-root'
  | 'no-root-kept'

export interface TraceStep {
  readonly kind: CandidateKind
  readonly id: number
  readonly outcome: Outcome
  /** The points evaluated here, in order: up to four on a face, where a validity query may stop. */
  readonly points: readonly Candidate[]
  /** The least of their jacdets, times 2^exponent. */
  readonly value: number | null
  /** M before and after this step, times 2^exponent; null before the first. */
  readonly before: number | null
  readonly after: number | null
  /** The answer is known: a validity query has come to a value that is not positive. */
  readonly stops: boolean
}

export interface TraceOptions {
  readonly query: Query
  readonly variant: Variant
}

export function traceOf(report: Report, { query, variant }: TraceOptions): readonly TraceStep[] {
  const steps: TraceStep[] = []
  let least: number | null = null

  /** Returns true if the algorithm goes on. */
  function take(kind: CandidateKind, id: number, without: Outcome, found: readonly Candidate[]): boolean {
    const end = query === 'validity' ? found.findIndex(({ value }) => value <= 0) : -1
    const points = end < 0 ? found : found.slice(0, end + 1)
    const before = least
    const value = points.length > 0 ? Math.min(...points.map(point => point.value)) : null
    if (value !== null && (least === null || value < least)) least = value
    const outcome = points.length > 0 ? 'evaluated' : without
    steps.push({ kind, id, outcome, points, value, before, after: least, stops: end >= 0 })
    return end < 0
  }

  const candidatesOf = (kind: CandidateKind, id: number) =>
    report.candidates.filter(c => c.kind === kind && c.id === id)

  function isSkipped(id: number, found: readonly Candidate[]): boolean {
    if (variant === 'roots') return false
    const { lowerBound } = report.faces[id] as Report['faces'][number]
    if (query === 'validity') return lowerBound > 0
    const before = least as number
    // Exact arithmetic rounds both; a candidate below M then says that the exact bound is, too.
    return lowerBound >= before && found.every(({ value }) => value >= before)
  }

  for (let v = 0; v < VERTEX_COUNT; v++) if (!take('vertex', v, 'evaluated', candidatesOf('vertex', v))) return steps
  for (let e = 0; e < edgeVertices.length; e++)
    if (!take('edge', e, edgeOutcome(report, e), candidatesOf('edge', e))) return steps
  for (let f = 0; f < faces.length; f++) {
    const found = candidatesOf('face', f)
    const goesOn = isSkipped(f, found) ? take('face', f, 'bound', []) : take('face', f, faceOutcome(report, f), found)
    if (!goesOn) return steps
  }
  return steps
}

/** Tells from Bernstein coefficients why an edge has no candidate: docs/algorithm.md (9). */
function edgeOutcome({ bernstein }: Report, edge: number): Outcome {
  const [q0, q1, q2] = bernsteinOnEdge(bernstein, edge)
  // Differences first, so that nothing overflows that does not in the report.
  const [down, up] = [q0 - q1, q2 - q1]
  if (down === -up) return 'straight'
  return down < -up ? 'concave' : 'vertex-outside'
}

function faceOutcome(report: Report, face: number): Outcome {
  const { quarticIsZero, roots } = report.faces[face] as Report['faces'][number]
  if (quarticIsZero) return 'quartic-zero'
  return roots.length === 0 ? 'no-root' : 'no-root-kept'
}
