/** Medit's keywords: their numbers in .meshb, and of those that are cells, what they are (libmeshb7.h). */
import type { OtherCell } from '../mesh-builder'

export interface MeditCells {
  readonly name: string
  /** 'curved' is a hexahedron of more than eight nodes. */
  readonly kind: OtherCell | 'hexahedron' | 'curved'
  /** Vertices; a reference follows them. */
  readonly nodes: number
}

export const DIMENSION = 3
export const VERTICES = 4
export const END = 54
export const FLOATING_POINT_PRECISION = 155

/** HexahedraQ2Ordering and its kin, with the nodes that they order. */
export const meditOrderings: readonly (readonly [number, number])[] = [
  [139, 27],
  [140, 64],
  [153, 8],
  [154, 125],
]

const TABLE: readonly (readonly [number, string, MeditCells['kind'], number])[] = [
  [5, 'Edges', 'line', 2],
  [6, 'Triangles', 'triangle', 3],
  [7, 'Quadrilaterals', 'quadrilateral', 4],
  [8, 'Tetrahedra', 'tetrahedron', 4],
  [9, 'Prisms', 'wedge', 6],
  [10, 'Hexahedra', 'hexahedron', 8],
  [24, 'TrianglesP2', 'triangle', 6],
  [25, 'EdgesP2', 'line', 3],
  [27, 'QuadrilateralsQ2', 'quadrilateral', 9],
  [30, 'TetrahedraP2', 'tetrahedron', 10],
  [33, 'HexahedraQ2', 'curved', 27],
  [49, 'Pyramids', 'pyramid', 5],
  [86, 'PrismsP2', 'wedge', 18],
  [87, 'PyramidsP2', 'pyramid', 14],
  [88, 'QuadrilateralsQ3', 'quadrilateral', 16],
  [89, 'QuadrilateralsQ4', 'quadrilateral', 25],
  [90, 'TrianglesP3', 'triangle', 10],
  [91, 'TrianglesP4', 'triangle', 15],
  [92, 'EdgesP3', 'line', 4],
  [93, 'EdgesP4', 'line', 5],
  [96, 'TetrahedraP3', 'tetrahedron', 20],
  [97, 'TetrahedraP4', 'tetrahedron', 35],
  [98, 'HexahedraQ3', 'curved', 64],
  [99, 'HexahedraQ4', 'curved', 125],
  [100, 'PyramidsP3', 'pyramid', 30],
  [101, 'PyramidsP4', 'pyramid', 55],
  [102, 'PrismsP3', 'wedge', 40],
  [103, 'PrismsP4', 'wedge', 75],
]

export const meditCellsByCode: ReadonlyMap<number, MeditCells> = new Map(
  TABLE.map(([code, name, kind, nodes]) => [code, { name, kind, nodes }]),
)
/** Some programs spell it so; meshio reads it, too. */
const HEXAEDRA = [10, 'Hexaedra', 'hexahedron', 8] as const
export const meditCellsByName: ReadonlyMap<string, MeditCells> = new Map(
  [...TABLE, HEXAEDRA].map(([, name, kind, nodes]) => [name, { name, kind, nodes }]),
)

/** Cells of which only the number matters here. */
const COUNTED: readonly (readonly [number, string, OtherCell])[] = [
  [46, 'Polyhedra', 'polyhedron'],
  [200, 'Prisms9', 'wedge'],
  [201, 'Hexahedra12', 'other'],
  [202, 'Quadrilaterals6', 'quadrilateral'],
  [207, 'PolyhedraHeaders', 'polyhedron'],
]
export const meditCountedByCode: ReadonlyMap<number, OtherCell> = new Map(COUNTED.map(([code, , kind]) => [code, kind]))
export const meditCounted: ReadonlyMap<string, OtherCell> = new Map(COUNTED.map(([, name, kind]) => [name, kind]))
