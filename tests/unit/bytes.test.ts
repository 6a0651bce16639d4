/** Loops over bytes are what a plain loop is, in every length and wherever a list begins. */
import { expect, test } from 'vitest'
import { countOf, eachPlace, turned } from '../../web/mesh/bytes'
import { headText } from '../../web/mesh/snippet-text'
import { randomSource } from './core-fixtures'

/** Lists of 0 to 20 bytes and of thousands, from an even place and an odd one in memory with other bytes around. */
function* lists(most: number): Generator<Uint8Array> {
  const random = randomSource(34)
  for (const length of [...Array.from({ length: 21 }, (_, i) => i), 8191, 8192, 8195])
    for (const from of [0, 1, 2, 3]) {
      const memory = Uint8Array.from({ length: from + length + 5 }, () => Math.floor((most + 1) * random()))
      yield memory.subarray(from, from + length)
    }
}

test('each place of a value in its order, and how many there are', () => {
  for (const list of [...lists(2), ...lists(0), ...lists(255)])
    for (const value of [0, 1, 255]) {
      const places: number[] = []
      eachPlace(list, value, at => places.push(at))
      expect(places).toEqual([...list.keys()].filter(at => list[at] === value))
      expect(countOf(list, value)).toBe(places.length)
    }
})

test('zeros and ones turned, in memory of their own', () => {
  for (const list of lists(1)) {
    const before = [...list]
    const own = turned(list)
    expect([...own]).toEqual(before.map(bit => 1 - bit))
    own.fill(7)
    expect([...list]).toEqual(before)
  }
})

test('the text of a head has a character for each byte', () => {
  const all = Uint8Array.from({ length: 256 }, (_, byte) => byte)
  expect(headText(all)).toBe(String.fromCharCode(...all))
  expect(headText(all, 10)).toBe(String.fromCharCode(...all.subarray(0, 10)))
  // Marks of byte orders are bytes as any others.
  for (const mark of [
    [0xff, 0xfe],
    [0xfe, 0xff],
    [0xef, 0xbb, 0xbf],
    [0xd8, 0xdc],
  ])
    expect(headText(Uint8Array.from([...mark, 65]))).toBe(String.fromCharCode(...mark, 65))
  for (const list of lists(255))
    expect(headText(list)).toBe(Array.from(list, byte => String.fromCharCode(byte)).join(''))
})
