/**
 * Other checks of a hexahedron, by what the report calls them: who uses each and what it looks at. docs/algorithm.md,
 * section 9, says how their numbers are computed.
 */
import type { CheckId } from '../core/report'

export interface CheckDescription {
  readonly name: string
  /** Programs or methods that ask this; null where it is nobody's in particular. */
  readonly usedBy: string | null
  /** One plain sentence. */
  readonly looksAt: string
  /** The number is a jacdet, or one without a unit that is the same on every reference cube. */
  readonly unit: 'jacdet' | 'none'
}

export const checks: Readonly<Record<CheckId, CheckDescription>> = {
  corners: {
    name: 'Eight corners',
    usedBy: 'deal.II',
    looksAt: 'The least jacdet at the eight vertices.',
    unit: 'jacdet',
  },
  'corners-and-centre': {
    name: 'Corners and centre',
    usedBy: 'scaled Jacobian in HexaLab, Verdict',
    looksAt:
      'The least scaled Jacobian at the eight vertices and the centre: a number from −1 to 1, jacdet over three lengths.',
    unit: 'none',
  },
  'gauss-2': {
    name: '2×2×2 Gauss points',
    usedBy: 'solvers',
    looksAt: 'The least jacdet at eight points inside, where a solver with full integration evaluates it.',
    unit: 'jacdet',
  },
  'gauss-3': {
    name: '3×3×3 Gauss points',
    usedBy: null,
    looksAt: 'The least jacdet at the 27 points of the next finer integration rule.',
    unit: 'jacdet',
  },
  edges: {
    name: 'Twelve edges',
    usedBy: null,
    looksAt: 'The least jacdet along the twelve edges, from the quadratic on each, not from samples.',
    unit: 'jacdet',
  },
  bernstein: {
    name: 'One Bernstein bound',
    usedBy: null,
    looksAt:
      'The least of the 27 Bernstein coefficients, which 20 samples give: below jacdet everywhere, often by much, so that valid elements are rejected.',
    unit: 'jacdet',
  },
  subdivision: {
    name: 'Subdivision to depth\u00a04',
    usedBy: 'HXT',
    looksAt:
      'The number at which cutting into eight stops. The guard of the released code rejects what is still open at depth 4, valid or not.',
    unit: 'jacdet',
  },
}
