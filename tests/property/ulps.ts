/** Steps from one double to the next. */
const bits = new BigInt64Array(1)
const double = new Float64Array(bits.buffer)

/** The double `ulps` places further up; -0 and 0 are one place. */
export function moved(value: number, ulps: number): number {
  double[0] = value === 0 ? 0 : value
  const ordered = (bits[0] as bigint) < 0n ? -(1n << 63n) - (bits[0] as bigint) : (bits[0] as bigint)
  const target = ordered + BigInt(ulps)
  bits[0] = target < 0n ? -(1n << 63n) - target : target
  return double[0]
}
