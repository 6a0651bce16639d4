/** What is left of the cells in the picture when some are cut away, with the real core. */
import { describe, expect, test } from 'vitest'
import type { Mesh } from '../../web/mesh/mesh'
import { part } from '../../web/pages/mesh/part'
import { cutFaces } from '../../web/survey/cut'
import { Survey } from '../../web/survey/survey'
import type { CutCells, CutFaces } from '../../web/survey/survey-jobs'
import { core, unitCube } from './core-fixtures'
import { checked, flat, invalidCorner, meshOf, mirroredCube, notFinite } from './mesh-fixtures'

const LISTS = { minima: true, volumes: true, acceptedBy: true }
const NOTHING_CUT: CutCells = {
  set: { which: 'all' },
  plane: null,
  relative: null,
  layers: 0,
  away: [],
  onlyInvalid: false,
  isWhole: false,
  most: Infinity,
}

async function surveyOf(mesh: Mesh): Promise<Survey> {
  return new Survey(await checked(mesh, { worst: Infinity, lists: LISTS }), { core, meeting: null })
}

/** Cells with all their faces, so that each cell that is left is in the list. */
function left(survey: Survey, cut: Partial<CutCells>): number[] {
  return [...new Set(facesLeft(survey, { isWhole: true, ...cut }).cells)].sort((a, b) => a - b)
}

function facesLeft(survey: Survey, cut: Partial<CutCells>): CutFaces {
  return cutFaces(survey.faced, { ...NOTHING_CUT, ...cut })
}

/** A block of n by n by n cubes, the one at (i, j, k) being i + n (j + n k); some may be missing. */
function block(n: number, isThere: (i: number, j: number, k: number) => boolean = () => true): Mesh {
  const range = Array.from({ length: n }, (_, i) => i)
  const point = (i: number, j: number, k: number) => i + (n + 1) * (j + (n + 1) * k)
  const places = range.flatMap(k => range.flatMap(j => range.map(i => [i, j, k] as const)))
  const cells = places
    .filter(([i, j, k]) => isThere(i, j, k))
    .flatMap(([i, j, k]) =>
      [0, 1].flatMap(up => [
        point(i, j, k + up),
        point(i + 1, j, k + up),
        point(i + 1, j + 1, k + up),
        point(i, j + 1, k + up),
      ]),
    )
  const points = Array.from({ length: (n + 1) ** 3 }, (_, at) => [
    at % (n + 1),
    Math.floor(at / (n + 1)) % (n + 1),
    Math.floor(at / (n + 1) ** 2),
  ]).flat()
  return { ...meshOf([]), points: Float64Array.from(points), cells: Uint32Array.from(cells) }
}

const elbow = await surveyOf({ ...meshOf([]), ...part() })
const few = await surveyOf(meshOf([unitCube, notFinite, mirroredCube, flat, invalidCorner]))

describe('nothing', () => {
  test('cut away leaves the boundary; all faces, where cells are drawn whole', () => {
    expect(facesLeft(elbow, {}).cells.length).toBe(elbow.faced.neighbours.boundary.length)
    expect(facesLeft(elbow, { isWhole: true }).cells.length).toBe(6 * 7168)
    expect(facesLeft(elbow, {}).layers).toBe(null)
  })
})

describe('relative minima', () => {
  const { relativeMinima } = elbow.check.answers
  test.each([
    [-Infinity, 0.5],
    [0.9, Infinity],
    [0.2, 0.8],
    [2, 3],
  ])('from %d to %d', (lower, upper) => {
    const wanted = [...relativeMinima.keys()].filter(
      cell => (relativeMinima[cell] as number) >= lower && (relativeMinima[cell] as number) <= upper,
    )
    expect(left(elbow, { relative: [lower, upper] })).toEqual(wanted)
    const { shown, wanted: count } = facesLeft(elbow, { relative: [lower, upper] })
    expect([shown, count]).toEqual([wanted.length, wanted.length])
  })

  test('take both ends in, and none of a cell that has no number', () => {
    const least = relativeMinima[elbow.check.worst[0] as number] as number
    expect(left(elbow, { relative: [least, least] })).toEqual([elbow.check.worst[0]])
    expect(left(few, { relative: [-Infinity, Infinity] })).not.toContain(1)
    expect(left(few, { relative: [1, 1] })).toEqual([0])
  })
})

describe('layers', () => {
  test('go from the boundary inwards, as in a block of cubes', async () => {
    const survey = await surveyOf(block(7))
    for (const [layers, side] of [
      [1, 5],
      [2, 3],
      [3, 1],
      [4, 0],
    ] as const) {
      const faces = facesLeft(survey, { layers })
      expect([faces.shown, faces.layers]).toEqual([side ** 3, 4])
      expect(faces.cells.length).toBe(6 * side ** 2)
    }
    expect(left(survey, { layers: 3 })).toEqual([3 + 7 * (3 + 7 * 3)])
  })

  test('begin with each cell that has a point on the boundary, also at an edge that points inwards', async () => {
    const survey = await surveyOf(block(6, (i, j, k) => !(i < 3 && j < 3 && k < 3)))
    const { points, cells } = survey.check.mesh
    const onBoundary = new Set<number>()
    const faces = facesLeft(survey, {})
    const { origin } = faces
    const key = (x: number, y: number, z: number) => [x, y, z].map(Math.round).join()
    const corners = new Set<string>()
    for (let at = 0; at < faces.corners.length; at += 3)
      corners.add(
        key(
          (faces.corners[at] as number) + origin[0],
          (faces.corners[at + 1] as number) + origin[1],
          (faces.corners[at + 2] as number) + origin[2],
        ),
      )
    for (const [at, point] of cells.entries())
      if (
        corners.has(key(points[3 * point] as number, points[3 * point + 1] as number, points[3 * point + 2] as number))
      )
        onBoundary.add(at >> 3)
    const wanted = [...Array(cells.length / 8).keys()].filter(cell => !onBoundary.has(cell))
    expect(left(survey, { layers: 1 })).toEqual(wanted)
    expect(wanted.length).toBeGreaterThan(0)
  })

  test('are counted by the boundary of the mesh, whatever else is cut away', async () => {
    const survey = await surveyOf(block(5))
    const plane = { normal: [1, 0, 0], offset: 0 } as const
    expect(left(survey, { layers: 1, plane })).toEqual(left(survey, { layers: 1 }).filter(cell => cell % 5 <= 2))
  })
})

describe('one by one, and around a cell', () => {
  test('a cell that is taken away shows the faces behind it', async () => {
    const survey = await surveyOf(block(3))
    const faces = facesLeft(survey, { away: [4] })
    expect(faces.shown).toBe(26)
    expect(faces.cells.length).toBe(54 - 1 + 5)
    expect(facesLeft(survey, { away: [4, 13] }).cells.length).toBe(58 - 1 + 5)
    expect(facesLeft(survey, { away: [13] }).cells.length).toBe(54 + 6)
  })

  test('rings around a cell are those that share a point', async () => {
    const survey = await surveyOf(block(5))
    const counts = [0, 1, 2, 3].map(rings => left(survey, { set: { which: 'around', cell: 0, rings } }).length)
    expect(counts).toEqual([1, 8, 27, 64])
    expect(left(survey, { set: { which: 'around', cell: 62, rings: 1 }, away: [62] }).length).toBe(26)
  })

  test('the invalid cells alone, of a set', () => {
    const set = { which: 'around', cell: 2951, rings: 2 } as const
    const around = left(elbow, { set })
    const invalid = left(elbow, { set, onlyInvalid: true })
    expect(invalid).toEqual(around.filter(cell => elbow.check.standingOf(cell) === 'invalid'))
    expect(invalid).toContain(2951)
    expect(invalid.length).toBeLessThan(12)
  })
})

describe('of many', () => {
  test('the worst are left, once there are six times so many faces', async () => {
    const set = { which: 'invalid', rings: 0 } as const
    expect(facesLeft(elbow, { set, most: 12 })).toMatchObject({ shown: 12, wanted: 12 })
    const worst = facesLeft(elbow, { set, most: 5 })
    expect([worst.shown, worst.wanted]).toEqual([5, 12])
    expect(new Set(worst.cells)).toEqual(new Set(elbow.check.worst.subarray(0, 5)))
    const whole = await surveyOf(block(6))
    expect(facesLeft(whole, { relative: [1, 1], most: 36 })).toMatchObject({ shown: 216, wanted: 216 })
    expect(facesLeft(whole, { relative: [1, 1], most: 35 })).toMatchObject({ shown: 35, wanted: 216 })
    expect(facesLeft(whole, { isWhole: true, most: 35 }).cells.length).toBe(6 * 35)
  })
})
