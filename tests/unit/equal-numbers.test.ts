/** The shortcut of `toEqual` for arrays of numbers keeps what it says of them. */
import { expect, it } from 'vitest'

it('tells arrays of numbers apart by length, kind, and every number, the sign of zero included', () => {
  const numbers = Float64Array.of(1, 0, Number.NaN)
  expect(Float64Array.of(1, 0, Number.NaN)).toEqual(numbers)
  for (const other of [
    Float64Array.of(1, -0, Number.NaN),
    Float64Array.of(1, 0),
    Float64Array.of(1, 0, 2),
    Float32Array.of(1, 0, Number.NaN),
  ]) {
    expect(other).not.toEqual(numbers)
    expect({ list: [other] }).not.toEqual({ list: [numbers] })
  }
  expect(BigInt64Array.of(1n)).toEqual(BigInt64Array.of(1n))
  expect(BigInt64Array.of(1n)).not.toEqual(BigInt64Array.of(2n))
})
