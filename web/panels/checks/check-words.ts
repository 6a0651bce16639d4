/**
 * Other checks of a hexahedron, by their ids in the report: who uses each and what it looks at.
 * docs/algorithm.md, section 9, says how their numbers are computed.
 */
import type { CheckId } from '../../core/report'
import { type Vec3, vertexReference } from '../../model/hexahedron'
import { checkNames } from '../../views/check-names'
import type { Samples } from '../../views/scene-slices'
import type { PlainWord } from '../../words/say'

export interface CheckDescription {
  readonly name: PlainWord
  /** Programs or methods that check this; null if there is none in particular. */
  readonly usedBy: PlainWord | null
  /** Its samples in words. */
  readonly looksAt: PlainWord
  /** The number is a jacdet, or one without a unit that is the same on every reference cube. */
  readonly unit: 'jacdet' | 'none'
  /** The scene marks these. */
  readonly marks: Samples
}

const ENDS_AND_MIDDLE = [0, 1 / 2, 1]
const gaussAbscissae = (offset: number) => [(1 - offset) / 2, (1 + offset) / 2]

/** All points with coordinates among these. */
function grid(coordinates: readonly number[]): readonly Vec3[] {
  return coordinates.flatMap(x => coordinates.flatMap(y => coordinates.map((z): Vec3 => [x, y, z])))
}

function at(points: readonly Vec3[]): Samples {
  return { points, edges: false }
}

export const checks: Readonly<Record<CheckId, CheckDescription>> = {
  corners: {
    name: checkNames.corners,
    usedBy: 'deal.II',
    looksAt: 'The least jacdet at the eight vertices.',
    unit: 'jacdet',
    marks: at(vertexReference),
  },
  'corners-and-centre': {
    name: checkNames['corners-and-centre'],
    usedBy: 'Verdict in VTK, PyVista, ParaView',
    looksAt:
      'The scaled Jacobian: jacdet over the lengths of its three columns, the least at the vertices and the centre. It is from −1 to 1. Verdict gives 1e30 if an edge or an axis has no length.',
    unit: 'none',
    marks: at([...vertexReference, [1 / 2, 1 / 2, 1 / 2]]),
  },
  'gauss-2': {
    name: checkNames['gauss-2'],
    usedBy: 'solvers',
    looksAt: 'The least jacdet at eight points inside, where a solver with full integration evaluates it.',
    unit: 'jacdet',
    marks: at(grid(gaussAbscissae(Math.sqrt(1 / 3)))),
  },
  'gauss-3': {
    name: checkNames['gauss-3'],
    usedBy: null,
    looksAt: 'The least jacdet at the 27 points of the next finer integration rule.',
    unit: 'jacdet',
    marks: at(grid([...gaussAbscissae(Math.sqrt(3 / 5)), 1 / 2])),
  },
  edges: {
    name: checkNames.edges,
    usedBy: null,
    looksAt: 'The least jacdet along the twelve edges. It comes from the quadratic on each edge, not from samples.',
    unit: 'jacdet',
    marks: { points: [], edges: true },
  },
  bernstein: {
    name: checkNames.bernstein,
    usedBy: null,
    looksAt:
      'The least of the 27 Bernstein coefficients, which follow from 20 samples. It is a lower bound of jacdet, often a poor one: it rejects some valid elements.',
    unit: 'jacdet',
    // Corners and middles of edges: two coordinates at least are at an end.
    marks: at(grid(ENDS_AND_MIDDLE).filter(point => point.filter(x => x === 1 / 2).length < 2)),
  },
  subdivision: {
    name: checkNames.subdivision,
    usedBy: 'HXT',
    looksAt:
      'The number at which cutting into eight stops. An element still open at depth 4 is rejected, valid or not.',
    unit: 'jacdet',
    // The corners of the first eight parts; the later ones depend on the element.
    marks: at(grid(ENDS_AND_MIDDLE)),
  },
  tangents: {
    name: checkNames.tangents,
    usedBy: 'Knabner, Korotov, Summ',
    looksAt:
      'A lower bound of jacdet, by four tangents in two variables. If it is positive, it certifies the element. Otherwise it says nothing.',
    unit: 'jacdet',
    marks: at(grid([0, 1 / 3, 2 / 3, 1])),
  },
}
