/**
 * The bilinear map of a quadrilateral, F = p + xi a + eta b + xi eta c on [0,1]^2, and its jacdet
 *
 *   J = det(a + eta c, b + xi c) = det(a, b) + xi det(a, c) + eta det(c, b):
 *
 * the term in xi eta has the factor det(c, c) = 0, so J is affine and least at a corner. Drawn and read, never a verdict: the
 * core decides, on the quadrilateral drawn out to a hexahedron of height 1, whose jacdet is the same.
 */
import { type Vertices, vertexOf } from '../../../model/hexahedron'

export type Vec2 = readonly [number, number]

/** The images of the corners (0, 0), (1, 0), (1, 1) and (0, 1): those of a hexahedron's face 4 in the order of its vertices. */
export type Quadrilateral = readonly [Vec2, Vec2, Vec2, Vec2]

export const cornerReference: Quadrilateral = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
]

export const CORNER_COUNT = 4

interface Coefficients {
  readonly p: Vec2
  readonly a: Vec2
  readonly b: Vec2
  readonly c: Vec2
}

export function coefficientsOf([p0, p1, p2, p3]: Quadrilateral): Coefficients {
  return { p: p0, a: minus(p1, p0), b: minus(p3, p0), c: minus(minus(p2, p1), minus(p3, p0)) }
}

export function pointAt(quadrilateral: Quadrilateral, [xi, eta]: Vec2): Vec2 {
  const { p, a, b, c } = coefficientsOf(quadrilateral)
  const along = (i: 0 | 1) => p[i] + xi * a[i] + eta * b[i] + xi * eta * c[i]
  return [along(0), along(1)]
}

/** The derivatives of F by xi and by eta. */
export function columnsAt(quadrilateral: Quadrilateral, [xi, eta]: Vec2): readonly [Vec2, Vec2] {
  const { a, b, c } = coefficientsOf(quadrilateral)
  return [
    [a[0] + eta * c[0], a[1] + eta * c[1]],
    [b[0] + xi * c[0], b[1] + xi * c[1]],
  ]
}

export function jacdetAt(quadrilateral: Quadrilateral, point: Vec2): number {
  return cross(...columnsAt(quadrilateral, point))
}

export function cornerJacdets(quadrilateral: Quadrilateral): readonly number[] {
  return cornerReference.map(corner => jacdetAt(quadrilateral, corner))
}

/** How far outside the square a point may be computed that is on its rim: pointing needs no more. */
const RIM = 1e-9

/**
 * The points of the square that F maps to `point`, the one with the least jacdet first: where the map folds over there are two. Their xi
 * are roots of det(point - p - xi a, b + xi c).
 */
export function preimages(quadrilateral: Quadrilateral, point: Vec2): Vec2[] {
  const { p, a, b, c } = coefficientsOf(quadrilateral)
  const d = minus(point, p)
  return rootsOf(-cross(a, c), cross(d, c) - cross(a, b), cross(d, b))
    .flatMap((xi): Vec2[] => {
      const column: Vec2 = [b[0] + xi * c[0], b[1] + xi * c[1]]
      const rest: Vec2 = [d[0] - xi * a[0], d[1] - xi * a[1]]
      const eta = dot(rest, column) / dot(column, column)
      return isInside(xi) && isInside(eta) ? [[inside(xi), inside(eta)]] : []
    })
    .sort((left, right) => jacdetAt(quadrilateral, left) - jacdetAt(quadrilateral, right))
}

/** The hexahedron of height 1 above it. */
export function drawnOut(quadrilateral: Quadrilateral): Vertices {
  return [0, 1].flatMap(z => quadrilateral.flatMap(([x, y]) => [x, y, z]))
}

/** The quadrilateral that was drawn out. */
export function baseOf(vertices: Vertices): Quadrilateral {
  return [0, 1, 2, 3].map(corner => vertexOf(vertices, corner).slice(0, 2)) as unknown as Quadrilateral
}

/** Real roots of a x^2 + b x + c, without differences of nearly equal numbers. */
function rootsOf(a: number, b: number, c: number): number[] {
  const discriminant = b * b - 4 * a * c
  if (discriminant < 0) return []
  const half = (-b - (b < 0 ? -1 : 1) * Math.sqrt(discriminant)) / 2
  const roots = [...(half === 0 ? [] : [c / half]), ...(a === 0 ? [] : [half / a])]
  return roots[0] === roots[1] ? roots.slice(0, 1) : roots
}

const isInside = (value: number) => value >= -RIM && value <= 1 + RIM
const inside = (value: number) => Math.max(0, Math.min(1, value))
const minus = (u: Vec2, v: Vec2): Vec2 => [u[0] - v[0], u[1] - v[1]]
const dot = (u: Vec2, v: Vec2): number => u[0] * v[0] + u[1] * v[1]
export const cross = (u: Vec2, v: Vec2): number => u[0] * v[1] - u[1] * v[0]
