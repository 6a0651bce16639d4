/** What the page says of an untangling: what is repaired, how far, what is left and why. */
import { expect, test } from 'vitest'
import type { UntangledCounts } from '../../web/core/repair/untangling'
import { heldWords, resultSentences, takenSentences } from '../../web/pages/mesh/untangle-words'

const COUNTS: UntangledCounts = {
  invalidBefore: 1200,
  invalidAfter: 2,
  belowBefore: 1500,
  belowAfter: 3,
  movedCount: 1,
  placeCount: 9,
  sweepCount: 4,
  tooManyCount: 0,
  greatestDistance: 0.5,
  meanDistance: 0.25,
  leastBefore: -3,
  leastAfter: -0.5,
}
const said = (counts: Partial<UntangledCounts>, heldCount: number) =>
  resultSentences({ counts: { ...COUNTS, ...counts }, heldCount }, '0.1').join(' ')

test('what would be, and what is', () => {
  expect(said({}, 4)).toBe(
    '1,198 of 1,200 invalid cells would be valid. 1 vertex moves, by 0.25 on average and 0.5 at most. 3 cells stay below 0.1, 2 of them invalid: 4 vertices that may move hold them.',
  )
  expect(said({ invalidBefore: 0, invalidAfter: 0, belowAfter: 0 }, 0)).toBe(
    '1,500 cells would reach 0.1. 1 vertex moves, by 0.25 on average and 0.5 at most. All reach 0.1.',
  )
  expect(said({ movedCount: 0, tooManyCount: 1 }, 0)).toBe(
    'No vertex has a better place. 3 cells stay below 0.1, 2 of them invalid: none of their vertices may move. 1 vertex has more cells than are looked at.',
  )
  expect(said({ belowBefore: 0 }, 0)).toBe('All relative minima are 0.1 at least: there is nothing to do.')
  expect(
    takenSentences({ counts: { ...COUNTS, movedCount: 2000, belowAfter: 0 }, heldCount: 0 }, '0.1').join(' '),
  ).toBe('2,000 vertices have moved: one step to undo. All reach 0.1.')
})

test('why a vertex is held', () => {
  const held = { cell: 6, id: '7', vertex: 3, cellCount: 8, bound: 0.05, pointCount: 4 }
  expect(heldWords({ ...held, forbids: 'valid' })).toBe(
    'Vertex 3 of cell 7: no place makes its 8 cells valid: 4 points forbid it, proved.',
  )
  expect(heldWords({ ...held, forbids: 'margin', cellCount: 1, pointCount: 1 })).toBe(
    'Vertex 3 of cell 7: no place makes its cell better than 0.05: 1 point forbids it, proved.',
  )
  expect(heldWords({ ...held, forbids: null })).toBe(
    'Vertex 3 of cell 7: no better place was found for its 8 cells; that there is none is not proved.',
  )
})
