/**
 * The searches that the page Search offers, in the order of its list: conditions, with the elements
 * among which such are soon found. tests/unit/search.test.ts finds one of each.
 */
import type { Distribution } from './engine/distribution'

export interface SearchKind {
  readonly id: string
  readonly title: string
  /** One or two plain sentences about it. */
  readonly note: string
  readonly property: string
  /** Greatest for the most extreme of them. */
  readonly measure: string
  readonly distribution: Distribution
}

const quarters: Distribution = { law: { kind: 'normal', sigma: 0.5 }, grid: 'quarters', symmetry: 'none', moved: 8 }
/** The symmetry of the paper's counterexample. */
const turned: Distribution = { ...quarters, symmetry: 'third-turn' }

export const searches: readonly [SearchKind, ...SearchKind[]] = [
  {
    id: 'corners',
    title: 'Corners positive, yet invalid',
    note: 'jacdet is positive at all eight vertices, and negative elsewhere on the boundary.',
    property: 'corner_min > 0 > boundary_min',
    measure: '-boundary_min / boundary_max',
    distribution: quarters,
  },
  {
    id: 'edges',
    title: 'Edges positive, yet invalid',
    note: 'jacdet is positive on all twelve edges, and negative inside a face. Such elements are rare; with the last symmetry of the list they are less rare.',
    property: 'edge_min > 0 > boundary_min',
    measure: '-boundary_min / boundary_max',
    distribution: quarters,
  },
  {
    id: 'depth-guard',
    title: 'Valid, though subdivision gives up',
    note: 'A valid element that a recursive subdivision rejects because it stops at depth 4.',
    property: 'valid and subdivision <= 0',
    measure: 'boundary_min / boundary_max',
    distribution: { ...quarters, law: { kind: 'normal', sigma: 0.3 }, grid: 'free' },
  },
  {
    id: 'nine-points',
    title: 'Passes the nine-point test, yet invalid',
    note: 'The scaled Jacobian is positive at the eight vertices and the centre, where some programs look. Elsewhere jacdet is negative.',
    property: 'scaled_jacobian > 0 > boundary_min',
    measure: 'scaled_jacobian',
    distribution: { ...quarters, law: { kind: 'box', least: -4, greatest: 4 }, grid: 'integers' },
  },
  {
    id: 'gap',
    title: 'Much lower inside than on the boundary',
    note: 'The least jacdet of the whole element is below the least on the boundary, by more than a quarter of the greatest. Only invalid elements are such.',
    property: 'not valid and 0 < boundary_max < 4 * (boundary_min - volume_min)',
    measure: '(boundary_min - volume_min) / boundary_max',
    distribution: turned,
  },
]

/** The first text of a reader's own inequality. */
export const ownSearch: SearchKind = {
  id: 'own',
  title: 'Your own inequality',
  note: 'Any condition on the numbers of an element.',
  property: 'not valid and gauss2_min > 0 and scaled_jacobian >= 0.2',
  measure: 'scaled_jacobian',
  distribution: quarters,
}
