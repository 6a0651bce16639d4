/** What is left of the cells in the picture when some are cut away, with the real core. */
import { describe, expect, test } from 'vitest'
import type { Mesh } from '../../web/mesh/mesh'
import { part } from '../../web/pages/mesh/part'
import { cutFaces } from '../../web/survey/cut'
import { FACE_VERTICES, NO_TONE, toneOf, VERTEX_NUMBERS } from '../../web/survey/face-list'
import { Survey } from '../../web/survey/survey'
import type { CutCells, CutFaces, FaceList } from '../../web/survey/survey-jobs'
import { core, randomSource, unitCube } from './core-fixtures'
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
  hasBoundary: false,
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

/** Each of the points with one number in place of its y. */
function withPoints(mesh: Mesh, others: readonly (readonly [point: number, y: number])[]): Mesh {
  const points = Float64Array.from(mesh.points)
  for (const [point, y] of others) points[3 * point + 1] = y
  return { ...mesh, points }
}

const elbow = await surveyOf({ ...meshOf([]), ...part() })
const few = await surveyOf(meshOf([unitCube, notFinite, mirroredCube, flat, invalidCorner]))
const torn = await surveyOf(
  withPoints(block(7), [
    [0, Number.NaN],
    [200, Infinity],
    [201, -Infinity],
    [350, 1e30],
  ]),
)

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
    const { vertices } = faces
    for (let vertex = 0; vertex < vertices.length / VERTEX_NUMBERS; ++vertex) {
      if (vertex % FACE_VERTICES === FACE_VERTICES - 1) continue
      const at = VERTEX_NUMBERS * vertex
      const [x, y, z] = [0, 1, 2].map(axis => (vertices[at + axis] as number) + origin[axis as 0])
      corners.add(key(x as number, y as number, z as number))
    }
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

/** One text for each face: its cell and its vertices. */
function facesIn({ cells, vertices }: FaceList): string[] {
  const each = FACE_VERTICES * VERTEX_NUMBERS
  return Array.from(cells, (cell, face) => `${cell}: ${vertices.subarray(each * face, each * (face + 1))}`)
}

describe('for whoever has the boundary', () => {
  const next = randomSource(20)
  const boundaryOf = (survey: Survey) =>
    facesIn(survey.faces({ cells: { which: 'all' }, isWhole: false, most: Infinity }))

  /** The faces of the boundary that are not hidden, and the others. */
  function bothOf(survey: Survey, cut: Partial<CutCells>): string[] {
    const faces = facesLeft(survey, { ...cut, hasBoundary: true })
    const { hidden } = faces
    if (hidden === null) throw new Error('Nothing is said of the boundary.')
    const boundary = boundaryOf(survey)
    expect(hidden.length).toBe(FACE_VERTICES * boundary.length)
    expect(hidden.every((flag, i) => flag === hidden[i - (i % FACE_VERTICES)])).toBe(true)
    return [...boundary.filter((_, face) => hidden[FACE_VERTICES * face] === 0), ...facesIn(faces)].sort()
  }

  test.each<[string, Partial<CutCells>]>([
    ['nothing', {}],
    ['all', { relative: [2, 3] }],
    ['by relative minimum', { relative: [-Infinity, 0.9] }],
    ['by layers', { layers: 2 }],
    ['one by one', { away: [0, 1, 2951, 7167] }],
    ['all but the invalid ones and a ring', { set: { which: 'invalid', rings: 1 } }],
    ['all but the worst', { set: { which: 'invalid', rings: 3 }, most: 20 }],
    ['by a plane and by relative minimum', { plane: { normal: [0, 1, 0], offset: 0 }, relative: [0.9, 1] }],
  ])('the faces are the same where %s is cut away', (_, cut) => {
    for (const survey of [elbow, few]) {
      const plain = facesLeft(survey, cut)
      expect(bothOf(survey, cut)).toEqual(facesIn(plain).sort())
      const { shown, wanted } = facesLeft(survey, { ...cut, hasBoundary: true })
      expect([shown, wanted]).toEqual([plain.shown, plain.wanted])
    }
  })

  test('behind planes through any place, near them and far', () => {
    for (const survey of [elbow, few, torn])
      for (let round = 0; round < 20; ++round) {
        // Most planes go through a middle.
        const { middles } = survey.faced
        const at = 3 * Math.floor((middles.length / 3) * next())
        const normal = [0, 1, 2].map(() => Math.round(4 * next() - 2)) as [number, number, number]
        const offset = normal.reduce((sum, part, axis) => sum + part * (middles[at + axis] as number), 0)
        const plane = { normal, offset }
        expect(bothOf(survey, { plane })).toEqual(facesIn(facesLeft(survey, { plane })).sort())
      }
  })

  test('cells that are drawn whole have all their faces in the list, and their middles', () => {
    const { hidden, middles, cells } = facesLeft(elbow, { isWhole: true, hasBoundary: true })
    expect(hidden).toBe(null)
    expect(cells.length).toBe(6 * 7168)
    const own = (vertex: number) => [...(middles as Float32Array).subarray(3 * vertex, 3 * vertex + 3)]
    for (const face of [0, 1000, 6 * 7168 - 1])
      for (let vertex = 0; vertex < FACE_VERTICES; ++vertex) {
        const cell = cells[face] as number
        expect(own(FACE_VERTICES * face + vertex)).toEqual([...elbow.faced.middles.subarray(3 * cell, 3 * cell + 3)])
      }
  })
})

describe('tones', () => {
  test('keep the sign, and what is not valid is seen', () => {
    expect([1, 0.5, 2].map(toneOf)).toEqual([1, 0.5, 1])
    expect(Math.fround(toneOf(5e-324))).toBeGreaterThan(0)
    for (const value of [0, -0, -5e-324, -1, -1e300, -Infinity]) expect(toneOf(value)).toBeLessThanOrEqual(-0.35)
    expect(toneOf(-Infinity)).toBe(-1)
    expect(toneOf(Number.NaN)).toBe(NO_TONE)
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
