/** VTK's cells with nodes beyond their corners: they are trilinear if these lie at middles, or on a lattice. */
import { isAtMean } from '../middles'
import type { VtkCellType } from './vtk-cells'
import type { NumberType } from './vtk-numbers'

/** The precision of coordinates: that of the coarsest grid counts. */
export interface Precision {
  readonly isFloat32: boolean
  /** Significant digits of printed ones; 0 for binary ones. */
  readonly digits: number
}

/** A Float32 needs nine digits; those that are printed with fewer are known to them. */
export function precisionOf(type: NumberType | undefined, isText: boolean, digits: number): Precision {
  return { isFloat32: type === 'Float32' && (!isText || digits >= 9), digits: isText ? digits : 0 }
}

/** Middles with fewer digits are numbers that somebody typed, none that were rounded: no printer's default has fewer. */
const FEWEST_DIGITS = 6
const ALL_DIGITS = 17

/**
 * The effect of rounding on a middle of coordinates of size 1: a sum of eight and a division in
 * doubles, after each was rounded when it was stored. Eight units in the last place are above all
 * of it.
 */
export function toleranceOf({ isFloat32, digits }: Precision): number {
  const printed = digits > 0 && digits < ALL_DIGITS ? 10 ** (1 - digits) : 0
  return Math.max(8 * 2 ** -52, isFloat32 ? 8 * 2 ** -24 : 0, digits >= FEWEST_DIGITS ? printed : 0)
}

/** True if the nodes beyond the corners lie at the middles that their cell type names; null where that is not looked at. */
export function areNodesAtMiddles(
  { middles }: VtkCellType,
  points: Float64Array,
  nodes: Uint32Array,
  tolerance: number,
): boolean | null {
  if (middles === undefined) return null
  let largest = 0
  for (let v = 0; v < 8; ++v)
    for (let axis = 0; axis < 3; ++axis)
      largest = Math.max(largest, Math.abs(points[3 * (nodes[v] as number) + axis] as number))
  const within = tolerance * largest
  if (middles === 'lattice') {
    const order = Math.round(Math.cbrt(nodes.length)) - 1
    if ((order + 1) ** 3 !== nodes.length || order > 255) return null
    return [false, true].some(hasOldEdges => isOnLattice(points, nodes, order, hasOldEdges, within))
  }
  const coordinate = (node: number, axis: number) => points[3 * (nodes[node] as number) + axis] as number
  return middles.every((corners, i) => isAtMean(coordinate, 8 + i, corners, within))
}

const lattices = new Map<string, Uint8Array>()

function isOnLattice(
  points: Float64Array,
  nodes: Uint32Array,
  order: number,
  hasOldEdges: boolean,
  within: number,
): boolean {
  const key = `${order} ${hasOldEdges}`
  const lattice = lattices.get(key) ?? latticeOf(order, hasOldEdges)
  lattices.set(key, lattice)
  for (let n = 8; n < nodes.length; ++n) {
    const [x, y, z] = [0, 1, 2].map(axis => (lattice[3 * n + axis] as number) / order) as [number, number, number]
    const weights = cornerWeights(x, y, z)
    for (let axis = 0; axis < 3; ++axis) {
      let sum = 0
      for (let v = 0; v < 8; ++v) sum += (weights[v] as number) * (points[3 * (nodes[v] as number) + axis] as number)
      if (!(Math.abs(sum - (points[3 * (nodes[n] as number) + axis] as number)) <= within)) return false
    }
  }
  return true
}

function cornerWeights(x: number, y: number, z: number): number[] {
  const around = [(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y]
  return [...around.map(weight => weight * (1 - z)), ...around.map(weight => weight * z)]
}

/**
 * The nodes of a Lagrange hexahedron of this order in the cube, three multiples of 1/order each
 * (vtkHigherOrderHexahedron). The four edges along zeta have two orders: that of VTK 9.1 and file
 * version 2.2 on, and the one before.
 */
function latticeOf(order: number, hasOldEdges: boolean): Uint8Array {
  const inside = order - 1
  const places = new Uint8Array(3 * (order + 1) ** 3)
  for (let k = 0; k <= order; ++k)
    for (let j = 0; j <= order; ++j) for (let i = 0; i <= order; ++i) places.set([i, j, k], 3 * nodeAt(i, j, k))
  return places

  function nodeAt(i: number, j: number, k: number): number {
    const [isX, isY, isZ] = [i % order === 0, j % order === 0, k % order === 0]
    const around = (a: number, b: number) => (a > 0 ? (b > 0 ? 2 : 1) : b > 0 ? 3 : 0)
    const faces = inside * inside
    if (isX && isY && isZ) return around(i, j) + (k > 0 ? 4 : 0)
    if (isY && isZ) return 8 + (i - 1) + (j > 0 ? 2 * inside : 0) + (k > 0 ? 4 * inside : 0)
    if (isX && isZ) return 8 + (j - 1) + (i > 0 ? inside : 3 * inside) + (k > 0 ? 4 * inside : 0)
    if (isX && isY) {
      const edge = hasOldEdges ? (i > 0 ? 1 : 0) + (j > 0 ? 2 : 0) : around(i, j)
      return 8 + 8 * inside + (k - 1) + inside * edge
    }
    const onFaces = 8 + 12 * inside
    if (isX) return onFaces + (j - 1) + inside * (k - 1) + (i > 0 ? faces : 0)
    if (isY) return onFaces + 2 * faces + (i - 1) + inside * (k - 1) + (j > 0 ? faces : 0)
    if (isZ) return onFaces + 4 * faces + (i - 1) + inside * (j - 1) + (k > 0 ? faces : 0)
    return onFaces + 6 * faces + (i - 1) + inside * (j - 1 + inside * (k - 1))
  }
}
