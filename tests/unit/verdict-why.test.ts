import { describe, expect, it } from 'vitest'
import type { Candidate, CandidateKind, Report } from '../../web/core/report'
import { placeName, whySentence } from '../../web/panels/verdict/why'

const candidate = (kind: CandidateKind, id: number, value: number): Candidate => ({
  kind,
  id,
  value,
  point: [0, 0, 0],
  position: [0, 0, 0],
})

/** A report as far as the sentence looks at one: the numbers follow from the candidates. */
function reportOf(candidates: readonly Candidate[], boundaryMaximum = 1, inside = Number.POSITIVE_INFINITY): Report {
  const least = (kinds: readonly CandidateKind[]) =>
    Math.min(...candidates.filter(c => kinds.includes(c.kind)).map(c => c.value))
  const boundaryMinimum = least(['vertex', 'edge', 'face'])
  return {
    valid: boundaryMinimum > 0,
    boundaryMinimum,
    boundaryMinimumError: 0,
    volumeMinimum: { lower: inside, upper: inside },
    boundaryMaximum,
    cornerMinimum: least(['vertex']),
    edgeMinimum: least(['vertex', 'edge']),
    candidates,
    class: boundaryMinimum > 0 ? 'valid' : 'invalid',
    coincident: [],
  } as unknown as Report
}

const vertices = (value: (id: number) => number) =>
  Array.from({ length: 8 }, (_, id) => candidate('vertex', id, value(id)))
const positive = vertices(() => 1)

describe('the sentence that says why', () => {
  it('names the theorem for a valid element', () => {
    expect(whySentence(reportOf(positive))).toBe(
      'J > 0 on all six faces, so J > 0 everywhere (Knupp’s conjecture, now a theorem).',
    )
  })

  it('names the vertices that are not positive, whatever the edges and faces do', () => {
    const one = vertices(id => (id === 3 ? -1 : 1))
    expect(whySentence(reportOf([...one, candidate('edge', 0, -2)]))).toBe('J ≤ 0 at vertex 3.')
    const two = vertices(id => (id === 3 || id === 7 ? -1 : 1))
    expect(whySentence(reportOf(two))).toBe('J ≤ 0 at vertices 3 and 7.')
    const three = vertices(id => (id > 4 ? -1 : 1))
    expect(whySentence(reportOf(three))).toBe('J ≤ 0 at vertices 5, 6 and 7.')
    expect(whySentence(reportOf(vertices(() => -1)))).toBe('J ≤ 0 at all eight vertices.')
  })

  it('names edges only when all vertices are positive', () => {
    expect(whySentence(reportOf([...positive, candidate('edge', 0, -1), candidate('face', 2, -2)]))).toBe(
      'J > 0 at all eight vertices, yet J ≤ 0 on edge 0–1.',
    )
    expect(whySentence(reportOf([...positive, candidate('edge', 0, -1), candidate('edge', 11, -2)]))).toBe(
      'J > 0 at all eight vertices, yet J ≤ 0 on edges 0–1 and 2–6.',
    )
  })

  it('names faces only when all vertices and edges are positive, each of them once', () => {
    const twice = [...positive, candidate('edge', 0, 1), candidate('face', 4, -1), candidate('face', 4, -2)]
    expect(whySentence(reportOf(twice))).toBe('J > 0 at all vertices and on all edges, yet J ≤ 0 on face −ζ.')
    expect(whySentence(reportOf([...twice, candidate('face', 5, -2)]))).toBe(
      'J > 0 at all vertices and on all edges, yet J ≤ 0 on faces −ζ and +ζ.',
    )
  })

  it('tells an inverted element, a collapsed one and a touching one from the rest', () => {
    const negative = reportOf(vertices(() => -1))
    expect(whySentence({ ...negative, class: 'inverted' })).toBe(
      'J < 0 everywhere: the element is inverted. The usual cause is a mirrored node order.',
    )
    const nothing = reportOf(vertices(() => 0))
    expect(whySentence({ ...nothing, class: 'collapsed' })).toBe('J = 0 everywhere: the element is collapsed.')
    expect(whySentence(reportOf([...positive, candidate('face', 4, 0)]))).toContain('needs J > 0 everywhere')
  })

  it('says first which vertices coincide, if that is why, and else last', () => {
    const wedge = {
      ...reportOf(vertices(id => (id < 4 ? 1 : 0))),
      coincident: [
        [4, 5],
        [6, 7],
      ],
    }
    expect(whySentence(wedge)).toBe('Vertices 4 and 5 coincide, and so do 6 and 7: jacdet is 0 there.')
    const negativeElsewhere = {
      ...reportOf(vertices(id => [1, -1, 1, 1, 0, 0, 1, 1][id] as number)),
      coincident: [[4, 5]],
    }
    expect(whySentence(negativeElsewhere)).toBe(
      'J ≤ 0 at vertices 1, 4 and 5. Vertices 4 and 5 coincide: jacdet is 0 there.',
    )
    const flat = { ...reportOf(vertices(() => 0)), class: 'collapsed' as const, coincident: [[0, 1, 2]] }
    expect(whySentence(flat)).toBe('J = 0 everywhere: the element is collapsed. Vertices 0, 1 and 2 coincide.')
    expect(whySentence({ ...reportOf(positive), coincident: [[0, 6]] })).toMatch(
      /theorem\)\. Vertices 0 and 6 coincide\.$/,
    )
  })

  it('tells an element that is negative inside alone', () => {
    expect(whySentence(reportOf([...positive, candidate('face', 4, 0)], 1, -0.25))).toContain('yet J < 0 inside')
    const negative = [...positive, candidate('face', 4, -1)]
    expect(whySentence(reportOf(negative, 1, -2))).toBe(whySentence(reportOf(negative)))
  })
})

describe('the name of a place', () => {
  it('leads to the coordinates', () => {
    expect(placeName({ kind: 'vertex', id: 3 })).toBe('at vertex 3, (ξ, η, ζ)')
    expect(placeName({ kind: 'edge', id: 2 })).toBe('on edge 2–3 at (ξ, η, ζ)')
    expect(placeName({ kind: 'face', id: 5 })).toBe('on face +ζ at (ξ, η, ζ)')
  })
})
