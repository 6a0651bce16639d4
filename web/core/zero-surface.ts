/**
 * The surface jacdet = 0 inside [0,1]^3 as triangles, by marching tetrahedra: each cell of a grid is cut into the six
 * tetrahedra around its diagonal, and a vertex lies on each of their edges whose ends differ in sign. Drawn, never a verdict.
 */
import type { Vec3 } from '../model/hexahedron'
import { gradientInside, valueInside } from './section'

export interface Surface {
  /** (xi, eta, zeta) of each vertex, flat. */
  readonly points: Float64Array
  /** The jacdet's derivatives by xi, eta and zeta there, relative to its largest coefficient. */
  readonly gradients: Float64Array
  /** Three vertices each, counter-clockwise seen from where the jacdet is positive. */
  readonly triangles: Uint32Array
}

/** Corners of a cell are masks of the axes along which they are one cell further: a tetrahedron's grow from 0 to 7. */
const TETRAHEDRA = [
  [0, 1, 3, 7],
  [0, 1, 5, 7],
  [0, 2, 3, 7],
  [0, 2, 6, 7],
  [0, 4, 5, 7],
  [0, 4, 6, 7],
] as const

/** Directions in which an edge can go: the masks 1 to 7. */
const DIRECTIONS = 8
/** Steps of regula falsi (Illinois) along an edge at most, and the value, relative to the largest coefficient, that ends them. */
const REFINEMENTS = 10
const NEAR_ZERO = 2 ** -16
/** Relative to the largest coefficient: what rounding may make of an exact zero counts as zero, which is not negative. */
const NOISE = 2 ** -45

export function zeroSurface(bernstein: readonly number[], cells: number): Surface {
  const greatest = Math.max(...bernstein.map(Math.abs))
  // The coefficients of an element of one sign share it, and so does every value between them.
  if (greatest === 0 || !bernstein.some(value => value < 0) || !bernstein.some(value => value > 0)) return EMPTY
  return new Marcher(
    bernstein.map(value => value / greatest),
    cells,
  ).surface()
}

const EMPTY: Surface = { points: new Float64Array(), gradients: new Float64Array(), triangles: new Uint32Array() }

class Marcher {
  readonly #bernstein: readonly number[]
  readonly #cells: number
  readonly #values: Float64Array
  /** Offsets of the corners in the grid by their masks. */
  readonly #offsets: readonly number[]
  /** One more than the vertex on an edge, by the edge's lower end and its direction; 0 where there is none yet. */
  readonly #vertexOf: Uint32Array
  readonly #points: number[] = []
  readonly #gradients: number[] = []
  readonly #triangles: number[] = []

  constructor(bernstein: readonly number[], cells: number) {
    const side = cells + 1
    this.#bernstein = bernstein
    this.#cells = cells
    this.#values = gridValues(bernstein, cells)
    this.#offsets = Array.from(
      { length: 8 },
      (_, mask) => side * side * (mask & 1) + side * bit(mask, 1) + bit(mask, 2),
    )
    this.#vertexOf = new Uint32Array(DIRECTIONS * side ** 3)
  }

  surface(): Surface {
    const n = this.#cells
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) {
        for (let k = 0; k < n; k++) this.#cell(((n + 1) * i + j) * (n + 1) + k)
      }
    }
    return {
      points: Float64Array.from(this.#points),
      gradients: Float64Array.from(this.#gradients),
      triangles: Uint32Array.from(this.#triangles),
    }
  }

  #cell(corner: number): void {
    let signs = 0
    for (let mask = 0; mask < 8; mask++) if (this.#isNegative(corner, mask)) signs |= 1 << mask
    if (signs === 0 || signs === 255) return
    for (const [negative, positive] of trianglesOf(signs)) {
      this.#triangles.push(this.#crossing(corner, negative, positive))
    }
  }

  #isNegative(corner: number, mask: number): boolean {
    return (this.#values[corner + (this.#offsets[mask] as number)] as number) < -NOISE
  }

  /** The vertex on the edge between a negative and a positive corner, made when it is first asked for. */
  #crossing(corner: number, negative: number, positive: number): number {
    const lower = Math.min(negative, positive)
    const edge = DIRECTIONS * (corner + (this.#offsets[lower] as number)) + (negative ^ positive)
    const known = this.#vertexOf[edge] as number
    if (known > 0) return known - 1
    const vertex = this.#points.length / 3
    const point = this.#zeroBetween(corner, negative, positive)
    this.#points.push(...point)
    this.#gradients.push(...gradientInside(this.#bernstein, point))
    this.#vertexOf[edge] = vertex + 1
    return vertex
  }

  #zeroBetween(corner: number, negative: number, positive: number): Vec3 {
    const from = this.#gridPoint(corner, negative)
    const to = this.#gridPoint(corner, positive)
    let [low, high] = [0, 1]
    let atLow = this.#values[corner + (this.#offsets[negative] as number)] as number
    let atHigh = Math.max(0, this.#values[corner + (this.#offsets[positive] as number)] as number)
    let way = 1
    let side = 0
    for (let step = 0; step < REFINEMENTS && atHigh > 0; step++) {
      way = low + ((high - low) * atLow) / (atLow - atHigh)
      const value = valueInside(this.#bernstein, between(from, to, way))
      if (Math.abs(value) < NEAR_ZERO) break
      if (value < 0) {
        ;[low, atLow] = [way, value]
        if (side < 0) atHigh /= 2
      } else {
        ;[high, atHigh] = [way, value]
        if (side > 0) atLow /= 2
      }
      side = Math.sign(value)
    }
    return between(from, to, way)
  }

  #gridPoint(corner: number, mask: number): Vec3 {
    const side = this.#cells + 1
    const index = corner + (this.#offsets[mask] as number)
    const k = index % side
    const j = ((index - k) / side) % side
    const i = (index - k - side * j) / (side * side)
    return [i / this.#cells, j / this.#cells, k / this.#cells]
  }
}

/** Values at the (cells + 1)^3 corners of the grid, zeta fastest: one axis after the other. */
function gridValues(bernstein: readonly number[], cells: number): Float64Array {
  const side = cells + 1
  let values = Float64Array.from(bernstein)
  // Each turn takes the slowest axis, samples it and makes it the fastest: after three the order is that of the axes again.
  for (let turn = 0; turn < 3; turn++) {
    const rest = values.length / 3
    const sampled = new Float64Array(rest * side)
    for (let i = 0; i < side; i++) {
      const x = i / cells
      const [b0, b1, b2] = [(1 - x) * (1 - x), 2 * x * (1 - x), x * x]
      for (let k = 0; k < rest; k++) {
        sampled[k * side + i] =
          b0 * (values[k] as number) + b1 * (values[rest + k] as number) + b2 * (values[2 * rest + k] as number)
      }
    }
    values = sampled
  }
  return values
}

/** An edge by its negative and its positive end. */
type CutEdge = readonly [number, number]

const cases: (readonly CutEdge[] | undefined)[] = []

/** The triangles in a cell whose negative corners are the bits of `signs`, three edges each. */
function trianglesOf(signs: number): readonly CutEdge[] {
  cases[signs] ??= TETRAHEDRA.flatMap(corners => {
    const isNegative = (mask: number) => (signs & (1 << mask)) !== 0
    const positive = corners.filter(mask => !isNegative(mask))
    return trianglesBetween(corners.filter(isNegative), positive)
  })
  return cases[signs]
}

/** One triangle around the corner that differs from the other three, or two between a pair and a pair. */
function trianglesBetween(negative: readonly number[], positive: readonly number[]): CutEdge[] {
  const [p, q, r, last] = negative.flatMap(from => positive.map(to => [from, to] as const))
  if (!p || !q || !r) return []
  const inFront = isInFront(p, q, r)
  const first = inFront ? [p, q, r] : [p, r, q]
  if (!last) return first
  return [...first, ...(inFront ? [q, last, r] : [q, r, last])]
}

function bit(mask: number, axis: number): number {
  return (mask >> axis) & 1
}

type Triple = readonly [Vec3, Vec3, Vec3]

/** True if positive corners are in front, by the edges' middles: the triangle may have no area. */
function isInFront(...edges: readonly (readonly [number, number])[]): boolean {
  const [p, q, r] = edges.map(([from, to]) =>
    [0, 1, 2].map(axis => bit(from, axis) + bit(to, axis)),
  ) as unknown as Triple
  const [from, to] = edges[0] as readonly [number, number]
  const out = [0, 1, 2].map(axis => bit(to, axis) - bit(from, axis)) as unknown as Vec3
  const u = minus(q, p)
  const v = minus(r, p)
  return (
    (u[1] * v[2] - u[2] * v[1]) * out[0] + (u[2] * v[0] - u[0] * v[2]) * out[1] + (u[0] * v[1] - u[1] * v[0]) * out[2] >
    0
  )
}

function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

function between(from: Vec3, to: Vec3, way: number): Vec3 {
  return [from[0] + way * (to[0] - from[0]), from[1] + way * (to[1] - from[1]), from[2] + way * (to[2] - from[2])]
}
