/**
 * Other orders of a hexahedron's eight points, as programs write them or as they get mixed up. Vertex i of this page's order
 * (VTK's, which Gmsh, Abaqus, Nastran, Exodus and CGNS share) is point `permutation[i]` of theirs.
 *
 * Sources: deal.II's GeometryInfo, DOLFINx's io::cells and VTK_VOXEL number lexicographically; Gmsh's MED writer,
 * MHexahedron::getVertexMED; meshio's AVS-UCD reader; OpenVolumeMesh's add_cell for eight vertices; PETSc's DMPlexInvertCell.
 */
import type { PlainWord } from '../words/say'
export interface NodeOrder {
  readonly id: string
  readonly name: PlainWord
  /** Programs or formats that use it; null where it is nobody's in particular. */
  readonly usedBy: PlainWord | null
  readonly permutation: readonly number[]
  /** One plain sentence. */
  readonly says: PlainWord
}

export const nodeOrders: readonly NodeOrder[] = [
  {
    id: 'lexicographic',
    name: 'Lexicographic',
    usedBy: 'deal.II, DOLFINx, VTK_VOXEL',
    permutation: [0, 1, 3, 2, 4, 5, 7, 6],
    says: 'The first coordinate runs fastest, then the second, then the third.',
  },
  {
    id: 'lexicographic-last',
    name: 'Lexicographic, last coordinate fastest',
    usedBy: null,
    permutation: [0, 4, 6, 2, 1, 5, 7, 3],
    says: 'Three nested loops, the third coordinate innermost.',
  },
  {
    id: 'med',
    name: 'Both the other way round',
    usedBy: 'Salome’s MED files',
    permutation: [0, 3, 2, 1, 4, 7, 6, 5],
    says: 'Bottom and top go round the other way, which turns the element inside out.',
  },
  {
    id: 'top-first',
    name: 'Top first',
    usedBy: 'AVS UCD',
    permutation: [4, 5, 6, 7, 0, 1, 2, 3],
    says: 'The top comes before the bottom, which turns it inside out as well.',
  },
  {
    id: 'top-backwards',
    name: 'Top the other way round',
    usedBy: 'OpenVolumeMesh',
    permutation: [0, 1, 2, 3, 4, 7, 6, 5],
    says: 'The top starts above vertex 0 and goes round against the bottom.',
  },
  {
    id: 'bottom-backwards',
    name: 'Bottom the other way round',
    usedBy: 'PETSc’s DMPlex',
    permutation: [0, 3, 2, 1, 4, 5, 6, 7],
    says: 'Both start at one upright edge; the bottom goes round against the top.',
  },
  {
    id: 'top-from-1',
    name: 'Top turned by one',
    usedBy: null,
    permutation: [0, 1, 2, 3, 7, 4, 5, 6],
    says: 'The top starts above vertex 1.',
  },
  {
    id: 'top-from-2',
    name: 'Top turned by two',
    usedBy: null,
    permutation: [0, 1, 2, 3, 6, 7, 4, 5],
    says: 'The top starts above vertex 2.',
  },
  {
    id: 'top-from-3',
    name: 'Top turned by three',
    usedBy: null,
    permutation: [0, 1, 2, 3, 5, 6, 7, 4],
    says: 'The top starts above vertex 3.',
  },
  {
    id: 'top-backwards-from-1',
    name: 'Top turned by one, the other way round',
    usedBy: null,
    permutation: [0, 1, 2, 3, 5, 4, 7, 6],
    says: 'The top starts above vertex 1 and goes round against the bottom.',
  },
  {
    id: 'top-backwards-from-2',
    name: 'Top turned by two, the other way round',
    usedBy: null,
    permutation: [0, 1, 2, 3, 6, 5, 4, 7],
    says: 'The top starts above vertex 2 and goes round against the bottom.',
  },
  {
    id: 'top-backwards-from-3',
    name: 'Top turned by three, the other way round',
    usedBy: null,
    permutation: [0, 1, 2, 3, 7, 6, 5, 4],
    says: 'The top starts above vertex 3 and goes round against the bottom: its four points are reversed.',
  },
  {
    id: 'top-first-from-1',
    name: 'Top first, bottom turned by one',
    usedBy: null,
    permutation: [7, 4, 5, 6, 0, 1, 2, 3],
    says: 'The top comes first, and the bottom starts under its second point.',
  },
  {
    id: 'top-first-from-2',
    name: 'Top first, bottom turned by two',
    usedBy: null,
    permutation: [6, 7, 4, 5, 0, 1, 2, 3],
    says: 'The top comes first, and the bottom starts under its third point.',
  },
  {
    id: 'top-first-from-3',
    name: 'Top first, bottom turned by three',
    usedBy: null,
    permutation: [5, 6, 7, 4, 0, 1, 2, 3],
    says: 'The top comes first, and the bottom starts under its fourth point.',
  },
  {
    id: 'top-first-backwards-from-1',
    name: 'Top first, bottom turned by one, the other way round',
    usedBy: null,
    permutation: [5, 4, 7, 6, 0, 1, 2, 3],
    says: 'The top comes first; the bottom starts under its second point and goes round against it.',
  },
  {
    id: 'top-first-backwards-from-2',
    name: 'Top first, bottom turned by two, the other way round',
    usedBy: null,
    permutation: [6, 5, 4, 7, 0, 1, 2, 3],
    says: 'The top comes first; the bottom starts under its third point and goes round against it.',
  },
  {
    id: 'top-first-backwards-from-3',
    name: 'Top first, bottom turned by three, the other way round',
    usedBy: null,
    permutation: [7, 6, 5, 4, 0, 1, 2, 3],
    says: 'The top comes first; the bottom starts under its fourth point and goes round against it.',
  },
  {
    id: 'two-and-three',
    name: 'Two points of the bottom exchanged',
    usedBy: null,
    permutation: [0, 1, 3, 2, 4, 5, 6, 7],
    says: 'Vertices 2 and 3 have changed places.',
  },
  {
    id: 'six-and-seven',
    name: 'Two points of the top exchanged',
    usedBy: null,
    permutation: [0, 1, 2, 3, 4, 5, 7, 6],
    says: 'Vertices 6 and 7 have changed places.',
  },
  {
    id: 'uprights',
    name: 'By upright edges',
    usedBy: null,
    permutation: [0, 2, 4, 6, 1, 3, 5, 7],
    says: 'One upright edge after the other, its lower end first.',
  },
  {
    id: 'uprights-down',
    name: 'By upright edges, downwards',
    usedBy: null,
    permutation: [1, 3, 5, 7, 0, 2, 4, 6],
    says: 'One upright edge after the other, its upper end first.',
  },
]
