import { expect, test } from 'vitest'
import { byRisingKey } from '../../web/mesh/rising'
import { randomSource } from './random'

function byComparing(cells: readonly number[], keys: Float64Array): number[] {
  const rank = (key: number) => (Number.isNaN(key) ? 1 : 0)
  return cells.toSorted((a, b) => {
    const [x, y] = [keys[a] as number, keys[b] as number]
    return rank(x) - rank(y) || (x < y ? -1 : x > y ? 1 : 0)
  })
}

test('numbers of every size and sign rise, equal ones stay in their order, NaN comes last', () => {
  const special = [0, -0, 1, -1, Infinity, -Infinity, Number.NaN, 5e-324, -5e-324, 2 ** 1023, -(2 ** 1023), 2 ** -1060]
  const next = randomSource(3)
  const numbers = Array.from({ length: 3000 }, () => (next() - 0.5) * 2 ** Math.floor(2000 * (next() - 0.5)))
  const keys = Float64Array.from([...special, ...numbers, ...special, ...numbers.slice(0, 500)])
  const cells = Array.from(keys, (_, i) => i).sort(() => next() - 0.5)
  expect([...byRisingKey(Uint32Array.from(cells), keys)]).toEqual(byComparing(cells, keys))
})

test('few, one, none, and all the same', () => {
  const keys = Float64Array.of(3, 1, 2, 1, 1)
  expect([...byRisingKey(Uint32Array.of(4, 0, 2, 1), keys)]).toEqual([4, 1, 2, 0])
  expect([...byRisingKey(Uint32Array.of(4, 1, 3), keys)]).toEqual([4, 1, 3])
  expect([...byRisingKey(Uint32Array.of(2), keys)]).toEqual([2])
  expect([...byRisingKey(new Uint32Array(0), keys)]).toEqual([])
})
