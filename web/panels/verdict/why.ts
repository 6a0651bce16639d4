/** The reason for valid or not in a sentence: the first of vertices, edges, faces that fails. */
import { lowerInside } from '../../core/inside'
import type { Candidate, CandidateKind, Report } from '../../core/report'
import { VERTEX_COUNT } from '../../model/hexahedron'
import { coincidenceSentence, zerosAtSight } from '../../views/coincidences'
import { entityName } from '../../views/entity-name'
import { listed, say } from '../../words/say'

/** "at vertex 3, (ξ, η, ζ)", "on edge 0–1 at (ξ, η, ζ)" or "on face −ζ at (ξ, η, ζ)": coordinates follow. */
export function placeName({ kind, id }: Pick<Candidate, 'kind' | 'id'>): string {
  const [name, point] = [entityName({ kind, id }), '(ξ, η, ζ)']
  if (kind === 'vertex') return say('at vertex {name}, {point}', { name, point })
  return kind === 'edge'
    ? say('on edge {name} at {point}', { name, point })
    : say('on face {name} at {point}', { name, point })
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
    return say('J > 0 on all six faces, so J > 0 everywhere (Knupp’s conjecture, now a theorem).')
  }
  if (report.class === 'inverted') {
    return say('J < 0 everywhere: the element is inverted. The usual cause is a mirrored node order.')
  }
  if (report.class === 'collapsed') return say('J = 0 everywhere: the element is collapsed.')
  if (lowerInsideOfZero(report)) {
    return say('J ≥ 0 on the boundary, yet J < 0 inside. The theorem needs J > 0 on the boundary: zero is not enough.')
  }
  if (report.boundaryMinimum === 0) {
    return say('The minimum is exactly zero, and a valid element needs J > 0 everywhere.')
  }
  if (report.cornerMinimum <= 0) return vertexSentence(notPositive(report, 'vertex'))
  if (report.edgeMinimum <= 0) {
    const names = notPositive(report, 'edge')
    return names.length === 1
      ? say('J > 0 at all eight vertices, yet J ≤ 0 on edge {names}.', { names: listed(names) })
      : say('J > 0 at all eight vertices, yet J ≤ 0 on edges {names}.', { names: listed(names) })
  }
  const names = notPositive(report, 'face')
  return names.length === 1
    ? say('J > 0 at all vertices and on all edges, yet J ≤ 0 on face {names}.', { names: listed(names) })
    : say('J > 0 at all vertices and on all edges, yet J ≤ 0 on faces {names}.', { names: listed(names) })
}

function notPositive(report: Report, kind: CandidateKind): readonly string[] {
  const ids = report.candidates.filter(c => c.kind === kind && c.value <= 0).map(c => c.id)
  const names = [...new Set(ids)].sort((a, b) => a - b).map(id => entityName({ kind, id }))
  return kind === 'edge' ? names.sort() : names
}

function vertexSentence(names: readonly string[]): string {
  if (names.length === VERTEX_COUNT) return say('J ≤ 0 at all eight vertices.')
  return names.length === 1
    ? say('J ≤ 0 at vertex {names}.', { names: listed(names) })
    : say('J ≤ 0 at vertices {names}.', { names: listed(names) })
}
