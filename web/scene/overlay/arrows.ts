/** The columns of DF as arrows: the derivatives of position by xi, eta and zeta at the point that is pointed at. */
import type { JacobianReport } from '../../core/report'
import type { Vec3 } from '../../model/hexahedron'
import { at, map3 } from '../space/world'

/**
 * The columns times one common factor, the longest of length 1; null where all vanish. Physical and view frame differ by a shift
 * and one scale, so these are directions in either.
 */
export function unitColumns({
  columns,
  axisExponents,
}: Pick<JacobianReport, 'columns' | 'axisExponents'>): readonly [Vec3, Vec3, Vec3] | null {
  // Components are numbers times 2^exponent of any size: the greatest exponent is taken out before there is a product.
  const exponents = columns.flatMap(column =>
    column.map((x, axis) => (x === 0 ? -Infinity : Math.log2(Math.abs(x)) + at(axisExponents, axis))),
  )
  const greatest = Math.ceil(Math.max(...exponents))
  if (!Number.isFinite(greatest)) return null
  const scaled = columns.map(column => map3(axis => timesPower(at(column, axis), at(axisExponents, axis) - greatest)))
  const longest = Math.max(...scaled.map(column => Math.hypot(...column)))
  return scaled.map(column => map3(axis => at(column, axis) / longest)) as unknown as readonly [Vec3, Vec3, Vec3]
}

/** x * 2^power, in two steps where 2^power alone would not be a double though the product is. */
function timesPower(x: number, power: number): number {
  const half = Math.trunc(power / 2)
  return x * 2 ** half * 2 ** (power - half)
}
