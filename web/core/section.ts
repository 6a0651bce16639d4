/** The jacdet's 27 Bernstein coefficients on [0,1]^3, restricted to a section or evaluated. Drawn and read, never a verdict. */
import { type Axis, faces, type Vec3 } from '../model/hexahedron'

/** Coefficients are `bernstein[9 * i + 3 * j + k]`, i in xi, j in eta, k in zeta. */
const STRIDES = [9, 3, 1] as const

/** The two axes that vary on a section, in the order xi, eta, zeta: s and t, as on the faces. */
export function axesOn(axis: Axis): readonly [Axis, Axis] {
  const { s, t } = faces[2 * axis] as (typeof faces)[number]
  return [s, t]
}

/** The nine coefficients where the axis' coordinate is `value`, `[3 * i + j]` with i in s, j in t; at 0 and 1 a face's. */
export function sectionBernstein(bernstein: readonly number[], axis: Axis, value: number): number[] {
  const [b0, b1, b2] = basis(value)
  const across = STRIDES[axis]
  const [s, t] = axesOn(axis)
  return Array.from({ length: 9 }, (_, index) => {
    const at = STRIDES[s] * Math.floor(index / 3) + STRIDES[t] * (index % 3)
    const coefficient = (k: number) => bernstein[at + k * across] as number
    return b0 * coefficient(0) + b1 * coefficient(1) + b2 * coefficient(2)
  })
}

/** The jacdet at a point of [0,1]^3, in doubles. */
export function valueInside(bernstein: readonly number[], [xi, eta, zeta]: Vec3): number {
  const [x0, x1, x2] = basis(xi)
  const [y0, y1, y2] = basis(eta)
  const [z0, z1, z2] = basis(zeta)
  const along = (k: number) =>
    z0 * (bernstein[k] as number) + z1 * (bernstein[k + 1] as number) + z2 * (bernstein[k + 2] as number)
  const over = (k: number) => y0 * along(k) + y1 * along(k + 3) + y2 * along(k + 6)
  return x0 * over(0) + x1 * over(9) + x2 * over(18)
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
