/** The counts of batches in their lists, and the box of their cells. */
import { describe, expect, test } from 'vitest'
import { type Box, countsOf, NOTHING_COUNTED, type Piece, sumOfCounts } from '../../web/core/batch/batch-core'
import { countsIn } from '../../web/mesh/counts-in'
import { cases, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { collapsedEdge, flat, invalidCorner, mirroredCube, notFinite } from './mesh-fixtures'
import { batchCores } from './node-workers'

const LISTS = {
  minima: true,
  classes: true,
  coincident: true,
  acceptedInvalid: true,
  statuses: true,
  box: true,
} as const
const EMPTY: Box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity]

const next = randomSource(33)
const odd = [mirroredCube, flat, collapsedEdge, invalidCorner, unitCube.map(x => -3 * x)]
/** More than one cut of the core's memory. */
const hexahedra = [
  ...cases.map(({ vertices }) => vertices.flat()),
  ...Array.from({ length: 2200 }, (_, i) =>
    i % 50 < 5 ? (odd[i % 50] as number[]) : randomHexahedron(next, 0.02 * (i % 20)),
  ),
]

/** The box of the coordinates that cells have. */
function boxOf(coordinates: ArrayLike<number>): number[] {
  const box: number[] = [...EMPTY]
  for (let i = 0; i < coordinates.length; ++i) {
    const own = coordinates[i] as number
    box[i % 3] = Math.min(box[i % 3] as number, own)
    box[3 + (i % 3)] = Math.max(box[3 + (i % 3)] as number, own)
  }
  return box
}

function plain(some: readonly (readonly number[])[]): Piece {
  return { points: new Float64Array(some.flat()), cells: null, firstPoint: 0 }
}

/** The same cells by indices of points that begin at `firstPoint`, backwards, behind a point that none has. */
function indexed(some: readonly (readonly number[])[], firstPoint: number): Piece {
  const points = new Float64Array([1e300, -1e300, 1e300, ...some.toReversed().flat()])
  const cells = Uint32Array.from({ length: 8 * some.length }, (_, i) => {
    const cell = some.length - 1 - Math.floor(i / 8)
    return firstPoint + 1 + 8 * cell + (i % 8)
  })
  return { points, cells, firstPoint }
}

describe.each(Object.entries(batchCores))('%s', (_, core) => {
  test('counts are those in the lists', () => {
    const found = core.classify(plain(hexahedra), LISTS)
    const { invertedCount, coincidentCount, acceptedByCornersCount, acceptedByVtkCount } = found
    const counts = { invertedCount, coincidentCount, acceptedByCornersCount, acceptedByVtkCount }
    expect(counts).toEqual(countsIn(found))
    for (const count of Object.values(counts)) expect(count).toBeGreaterThan(10)
    expect(acceptedByCornersCount).not.toBe(acceptedByVtkCount)
    expect([...found.valid].every(own => own === 0 || own === 1)).toBe(true)
  })

  test('what is in no list is not counted', () => {
    const found = core.classify(plain(hexahedra), { minima: true })
    expect(countsOf(found)).toMatchObject({
      invertedCount: 0,
      coincidentCount: 0,
      acceptedByCornersCount: 0,
      acceptedByVtkCount: 0,
      box: null,
    })
    expect(Object.keys(countsOf(found)).toSorted()).toEqual(Object.keys(NOTHING_COUNTED).toSorted())
  })

  test('unanswered cells are in no count', () => {
    const some = [notFinite, ...hexahedra.slice(-300), notFinite]
    const found = core.classify(plain(some), LISTS)
    const { invertedCount, coincidentCount, acceptedByCornersCount, acceptedByVtkCount } = found
    const counts = { invertedCount, coincidentCount, acceptedByCornersCount, acceptedByVtkCount }
    expect(counts).toEqual(countsIn(found))
    expect(counts).toEqual(countsIn(core.classify(plain(hexahedra.slice(-300)), LISTS)))
    expect([found.unansweredCount, found.firstUnanswered]).toEqual([2, 0])
    expect(found.valid[0]).toBe(0)
  })

  test('the box is that of the points that cells have, in every length, whatever else is asked for', () => {
    for (const some of [
      ...Array.from({ length: 20 }, (_, length) => hexahedra.slice(7 * length, 8 * length)),
      hexahedra,
    ]) {
      const expected = boxOf(some.flat())
      for (const piece of [plain(some), indexed(some, 0), indexed(some, 1_000_000)]) {
        expect(core.classify(piece, { box: true }).box).toEqual(expected)
        expect(core.classify(piece, LISTS).box).toEqual(expected)
      }
      expect(core.classify(plain(some), {}).box).toBeNull()
    }
  })

  test('an index before the first point is nobody’s', () => {
    const { points, cells } = indexed(hexahedra.slice(0, 3), 100)
    const own = Uint32Array.from(cells as Uint32Array)
    own[8] = 99
    const found = core.classify({ points, cells: own, firstPoint: 100 }, { statuses: true })
    expect([found.unansweredCount, found.firstUnanswered]).toEqual([1, 1])
  })

  test('counts of parts add up to those of the whole', () => {
    const parts = [hexahedra.slice(0, 900), hexahedra.slice(900, 901), hexahedra.slice(901)]
    let [sum, first] = [NOTHING_COUNTED, 0]
    for (const part of parts) {
      sum = sumOfCounts(sum, countsOf(core.classify(plain(part), LISTS)), first)
      first += part.length
    }
    expect(sum).toEqual(countsOf(core.classify(plain(hexahedra), LISTS)))
  })
})
