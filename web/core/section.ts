/** The jacdet's 27 Bernstein coefficients on [0,1]^3, restricted to a section or evaluated. Drawn and read, never a verdict. */
import { bernsteinIndex, bernsteinStrides, edgeBernstein, faceBernstein } from '../model/bernstein'
import { type Axis, faces, type Vec3 } from '../model/hexahedron'

/** The two axes that vary on a section, in the order xi, eta, zeta: s and t, as on the faces. */
export function axesOn(axis: Axis): readonly [Axis, Axis] {
  const { s, t } = faces[2 * axis] as (typeof faces)[number]
  return [s, t]
}

/** An edge's three coefficients, from its lower to its upper end. */
export function bernsteinOnEdge(bernstein: readonly number[], edge: number): Vec3 {
  return edgeBernstein[edge]?.map(index => bernstein[index]) as unknown as Vec3
}

/** The nine coefficients where the axis' coordinate is `value`, `[3 * i + j]` with i in s, j in t; at 0 and 1 a face's. */
export function sectionBernstein(bernstein: readonly number[], axis: Axis, value: number): number[] {
  const [b0, b1, b2] = basis(value)
  const across = bernsteinStrides[axis]
  const lower = faceBernstein[2 * axis] as readonly number[]
  return lower.map(at => {
    const coefficient = (k: number) => bernstein[at + k * across] as number
    return b0 * coefficient(0) + b1 * coefficient(1) + b2 * coefficient(2)
  })
}

/** The jacdet at a point of [0,1]^3, in doubles. */
export function valueInside(bernstein: readonly number[], [xi, eta, zeta]: Vec3): number {
  return weighted(bernstein, [basis(xi), basis(eta), basis(zeta)])
}

/** The jacdet's derivatives by xi, eta and zeta at a point of [0,1]^3, in doubles. */
export function gradientInside(bernstein: readonly number[], point: Vec3): Vec3 {
  const bases = point.map(basis) as unknown as readonly [Vec3, Vec3, Vec3]
  const slopes = point.map(slopeOfBasis) as unknown as readonly [Vec3, Vec3, Vec3]
  const along = (axis: Axis) => weighted(bernstein, bases.with(axis, slopes[axis]) as unknown as typeof bases)
  return [along(0), along(1), along(2)]
}

function weighted(bernstein: readonly number[], [x, y, z]: readonly [Vec3, Vec3, Vec3]): number {
  let sum = 0
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < 3; j++) {
      const row = bernsteinIndex(i, j, 0)
      const alongZ =
        z[0] * (bernstein[row] as number) +
        z[1] * (bernstein[row + 1] as number) +
        z[2] * (bernstein[row + 2] as number)
      sum += (x[i] as number) * (y[j] as number) * alongZ
    }
  }
  return sum
}

/** The point of a section with these coordinates s and t. */
export function pointOn(axis: Axis, value: number, s: number, t: number): Vec3 {
  const [sAxis, tAxis] = axesOn(axis)
  const point: [number, number, number] = [value, value, value]
  point[sAxis] = s
  point[tAxis] = t
  return point
}

/** Bernstein polynomials of degree 2. */
function basis(x: number): Vec3 {
  return [(1 - x) * (1 - x), 2 * x * (1 - x), x * x]
}

function slopeOfBasis(x: number): Vec3 {
  return [2 * x - 2, 2 - 4 * x, 2 * x]
}
