/** The ends of a histogram's range, moved by keys. */
import { describe, expect, test } from 'vitest'
import { endsOf, rangeAfter, rangeOf } from '../../web/pages/mesh/histogram-range'

const EDGES = [-2.3, -1, -0.5, 0, 0.5, 1]

describe('keys', () => {
  test.each([
    ['ArrowRight', 'lower', null, [-1, 1]],
    ['ArrowRight', 'lower', [-1, 1], [-0.5, 1]],
    ['ArrowLeft', 'lower', [-1, 1], null],
    ['ArrowLeft', 'lower', null, null],
    ['ArrowLeft', 'upper', null, [-Infinity, 0.5]],
    ['ArrowUp', 'upper', [-Infinity, 0.5], null],
    ['ArrowDown', 'upper', [-0.5, 1], [-0.5, 0.5]],
    // Between two edges, as a pointer leaves it, an end goes to the one beside it.
    ['ArrowRight', 'lower', [-0.2, 1], [0, 1]],
    ['ArrowLeft', 'lower', [-0.2, 1], [-0.5, 1]],
    ['ArrowLeft', 'upper', [-1, 0.2], [-1, 0]],
    ['ArrowRight', 'upper', [-1, 0.2], [-1, 0.5]],
    // One bar is left.
    ['End', 'lower', null, [0.5, 1]],
    ['Home', 'upper', null, [-Infinity, -1]],
    ['ArrowRight', 'lower', [0, 0.5], [0, 0.5]],
    ['ArrowLeft', 'upper', [0, 0.5], [0, 0.5]],
    ['Home', 'lower', [0, 0.5], [-Infinity, 0.5]],
    ['End', 'upper', [0, 0.5], [0, 1]],
    ['PageUp', 'lower', null, [0.5, 1]],
    ['PageDown', 'upper', [0, 1], [0, 0.5]],
  ] as const)('%s on the %s end of %j', (key, end, before, after) => {
    expect(rangeAfter(key, end, before, EDGES)).toEqual(after)
  })

  test('others are for others', () => {
    expect(rangeAfter('a', 'lower', null, EDGES)).toBe(undefined)
    expect(rangeAfter('Tab', 'upper', [0, 1], EDGES)).toBe(undefined)
  })
})

test('all of it is no range, and what is below the first edge has no end', () => {
  expect(rangeOf(-2.3, 1, EDGES)).toBe(null)
  expect(rangeOf(-Infinity, 0, EDGES)).toEqual([-Infinity, 0])
  expect(endsOf(null, EDGES)).toEqual([-Infinity, 1])
})
