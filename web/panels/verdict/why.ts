/** The reason for valid or not in a sentence: the first of vertices, edges, faces that fails. */
import { lowerInside } from '../../core/inside'
import type { Candidate, CandidateKind, Report } from '../../core/report'
import { VERTEX_COUNT } from '../../model/hexahedron'
import { coincidenceSentence, zerosAtSight } from '../../views/coincidences'
import { entityName, listed } from '../../views/entity-name'

/** "at vertex 3,", "on edge 0–1 at" or "on face −ζ at": coordinates follow. */
export function placeName({ kind, id }: Pick<Candidate, 'kind' | 'id'>): string {
  return kind === 'vertex' ? `at vertex ${id},` : `on ${kind} ${entityName({ kind, id })} at`
}

/** Coincident vertices come first if they explain it all, else last. */
export function whySentence(report: Report): string {
  const coincidence = coincidenceSentence(report)
  return isExplainedBy(zerosAtSight(report), report)
    ? coincidence
    : [sentenceWithoutCoincidences(report), coincidence].filter(sentence => sentence !== '').join(' ')
}

/** True if these vertices are why it is invalid, and its class says no more. */
function isExplainedBy(zeros: readonly number[], report: Report): boolean {
  if (zeros.length === 0 || report.class !== 'invalid' || lowerInsideOfZero(report)) return false
  return notPositive(report, 'vertex').every(name => zeros.includes(Number(name)))
}

/** True if jacdet is nowhere negative on the boundary, and negative inside. */
function lowerInsideOfZero(report: Report): boolean {
  return report.boundaryMinimum === 0 && lowerInside(report) !== null
}

function sentenceWithoutCoincidences(report: Report): string {
  if (report.valid) {
    return 'J > 0 on all six faces, so J > 0 everywhere (Knupp’s conjecture, now a theorem).'
  }
  if (report.class === 'inverted') {
    return 'J < 0 everywhere: the element is inverted. The usual cause is a mirrored node order.'
  }
  if (report.class === 'collapsed') return 'J = 0 everywhere: the element is collapsed.'
  if (lowerInsideOfZero(report)) {
    return 'J ≥ 0 on the boundary, yet J < 0 inside. The theorem needs J > 0 on the boundary: zero is not enough.'
  }
  if (report.boundaryMinimum === 0) {
    return 'The minimum is exactly zero, and a valid element needs J > 0 everywhere.'
  }
  if (report.cornerMinimum <= 0) return vertexSentence(notPositive(report, 'vertex'))
  if (report.edgeMinimum <= 0) {
    return `J > 0 at all eight vertices, yet J ≤ 0 on ${named('edge', notPositive(report, 'edge'))}.`
  }
  return `J > 0 at all vertices and on all edges, yet J ≤ 0 on ${named('face', notPositive(report, 'face'))}.`
}

function notPositive(report: Report, kind: CandidateKind): readonly string[] {
  const ids = report.candidates.filter(c => c.kind === kind && c.value <= 0).map(c => c.id)
  const names = [...new Set(ids)].sort((a, b) => a - b).map(id => entityName({ kind, id }))
  return kind === 'edge' ? names.sort() : names
}

function vertexSentence(names: readonly string[]): string {
  if (names.length === VERTEX_COUNT) return 'J ≤ 0 at all eight vertices.'
  return names.length === 1 ? `J ≤ 0 at vertex ${names[0]}.` : `J ≤ 0 at vertices ${listed(names)}.`
}

/** "edge 0–1" or "edges 0–1 and 2–6". */
function named(kind: CandidateKind, names: readonly string[]): string {
  return `${kind}${names.length === 1 ? '' : 's'} ${listed(names)}`
}
