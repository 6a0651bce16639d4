/** The cell types of VTK (vtkCellType.h): how many nodes they have, and what becomes of them here. */
import type { OtherCell } from '../mesh-builder'
import { ALL_MIDDLES, EDGE_MIDDLES, FACE_MIDDLES } from '../middles'

export const [VTK_PIXEL, VTK_VOXEL, VTK_HEXAHEDRON, VTK_POLYHEDRON] = [8, 11, 12, 42] as const

export interface VtkCellType {
  readonly kind: 'hexahedron' | 'voxel' | 'not trilinear' | OtherCell
  /** 0: any number. */
  readonly nodes: number
  /** The corners at whose middle each further node lies, or the lattice; none if trilinear. */
  readonly middles?: readonly (readonly number[])[] | 'lattice'
}

export const vtkCellTypes: ReadonlyMap<number, VtkCellType> = new Map<number, VtkCellType>([
  [0, { kind: 'other', nodes: 0 }],
  [1, { kind: 'vertex', nodes: 1 }],
  [2, { kind: 'vertex', nodes: 0 }],
  [3, { kind: 'line', nodes: 2 }],
  [4, { kind: 'line', nodes: 0 }],
  [5, { kind: 'triangle', nodes: 3 }],
  [6, { kind: 'other', nodes: 0 }],
  [7, { kind: 'polygon', nodes: 0 }],
  [VTK_PIXEL, { kind: 'quadrilateral', nodes: 4 }],
  [9, { kind: 'quadrilateral', nodes: 4 }],
  [10, { kind: 'tetrahedron', nodes: 4 }],
  [VTK_VOXEL, { kind: 'voxel', nodes: 8 }],
  [VTK_HEXAHEDRON, { kind: 'hexahedron', nodes: 8 }],
  [13, { kind: 'wedge', nodes: 6 }],
  [14, { kind: 'pyramid', nodes: 5 }],
  [15, { kind: 'other', nodes: 10 }],
  [16, { kind: 'other', nodes: 12 }],
  [21, { kind: 'line', nodes: 3 }],
  [22, { kind: 'triangle', nodes: 6 }],
  [23, { kind: 'quadrilateral', nodes: 8 }],
  [24, { kind: 'tetrahedron', nodes: 10 }],
  [25, { kind: 'not trilinear', nodes: 20, middles: EDGE_MIDDLES }],
  [26, { kind: 'wedge', nodes: 15 }],
  [27, { kind: 'pyramid', nodes: 13 }],
  [28, { kind: 'quadrilateral', nodes: 9 }],
  [29, { kind: 'not trilinear', nodes: 27, middles: ALL_MIDDLES }],
  [30, { kind: 'quadrilateral', nodes: 6 }],
  [31, { kind: 'wedge', nodes: 12 }],
  [32, { kind: 'wedge', nodes: 18 }],
  [33, { kind: 'not trilinear', nodes: 24, middles: [...EDGE_MIDDLES, ...FACE_MIDDLES.slice(0, 4)] }],
  [34, { kind: 'triangle', nodes: 7 }],
  [35, { kind: 'line', nodes: 4 }],
  [36, { kind: 'polygon', nodes: 0 }],
  [37, { kind: 'pyramid', nodes: 19 }],
  [41, { kind: 'other', nodes: 0 }],
  [VTK_POLYHEDRON, { kind: 'polyhedron', nodes: 0 }],
  [51, { kind: 'line', nodes: 0 }],
  ...[52, 53, 54, 55, 56].map((type): [number, VtkCellType] => [type, { kind: 'other', nodes: 0 }]),
  // Higher order, Lagrange and Bezier cells of any order.
  ...[60, 68, 75].map((type): [number, VtkCellType] => [type, { kind: 'line', nodes: 0 }]),
  ...[61, 69, 76].map((type): [number, VtkCellType] => [type, { kind: 'triangle', nodes: 0 }]),
  ...[62, 70, 77].map((type): [number, VtkCellType] => [type, { kind: 'quadrilateral', nodes: 0 }]),
  [63, { kind: 'polygon', nodes: 0 }],
  ...[64, 71, 78].map((type): [number, VtkCellType] => [type, { kind: 'tetrahedron', nodes: 0 }]),
  ...[65, 73, 80].map((type): [number, VtkCellType] => [type, { kind: 'wedge', nodes: 0 }]),
  ...[66, 74, 81].map((type): [number, VtkCellType] => [type, { kind: 'pyramid', nodes: 0 }]),
  [67, { kind: 'not trilinear', nodes: 0 }],
  [72, { kind: 'not trilinear', nodes: 0, middles: 'lattice' }],
  [79, { kind: 'not trilinear', nodes: 0 }],
])

/** A voxel's nodes in the order of a hexahedron's. */
export const VOXEL_ORDER = [0, 1, 3, 2, 4, 5, 7, 6] as const
