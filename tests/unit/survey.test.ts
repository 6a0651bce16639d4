/** An open mesh as its worker answers for it, with the real core. */
import { describe, expect, test } from 'vitest'
import { quantitiesOf } from '../../web/core/quantities'
import type { Reply, WorkerPort } from '../../web/core/workers'
import { cellClassifier } from '../../web/input/classify-cells'
import type { Mesh } from '../../web/mesh/mesh'
import { isMet, parseCondition } from '../../web/model/condition'
import { part } from '../../web/pages/mesh/part'
import { FACE_VERTICES, NO_TONE, VERTEX_NUMBERS } from '../../web/survey/face-list'
import { meeting } from '../../web/survey/meeting'
import { mended } from '../../web/survey/mend'
import { OpenSurvey } from '../../web/survey/open-survey'
import { Survey } from '../../web/survey/survey'
import type { Column, FaceList, Selection, ShownCells } from '../../web/survey/survey-jobs'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import {
  checked,
  classifyCells as classify,
  flat,
  invalidCorner,
  meshOf,
  mirroredCube,
  moved,
  notFinite,
} from './mesh-fixtures'

const LISTS = { minima: true, volumes: true, acceptedBy: true }
const ALL: ShownCells = { cells: { which: 'all' }, isWhole: false, most: Infinity }

async function surveyOf(mesh: Mesh): Promise<Survey> {
  return new Survey(await checked(mesh, { worst: Infinity, lists: LISTS }), { core, meeting })
}

/** One for each face: all its vertices have the same. */
function tonesOf({ vertices, cells }: FaceList): Float32Array {
  const at = (i: number) => vertices[VERTEX_NUMBERS * i + 3] as number
  for (let i = 0; i < FACE_VERTICES * cells.length; ++i)
    expect(at(i)).toBe(at(FACE_VERTICES * Math.floor(i / FACE_VERTICES)))
  return Float32Array.from(cells, (_, face) => at(FACE_VERTICES * face))
}

/** The cells of the list as it is. */
function listed(survey: Survey): number[] {
  return survey.rows(0, Infinity).map(({ cell }) => cell)
}

function select(survey: Survey, selection: Partial<Selection>): number[] {
  survey.select({ condition: null, range: null, ...selection })
  while (survey.selectOn(1e3).done < survey.check.hexahedra);
  return listed(survey)
}

const accepted = [0, 1, 0, 1, 1, -4, 1, 4, -3, -2, -1, -2, -4, 1, 4, 4, -1, 4, 4, 1, 3, -2, 3, 1]
const wedge = unitCube.with(9, 1)
const elbow: Mesh = { ...meshOf([]), ...part() }
const few = meshOf([unitCube, notFinite, mirroredCube, flat, invalidCorner])
const next = randomSource(11)
const many = meshOf(Array.from({ length: 400 }, () => randomHexahedron(next, 0.35)))

describe('the sentence on top', () => {
  test('says how many are invalid, and how many of those others accept', async () => {
    const survey = await surveyOf(elbow)
    expect(survey.overview('elbow.vtk').headline).toBe(
      '12 of 7,168 hexahedra are invalid. The eight corners would accept 4 of them, VTK’s scaled Jacobian 4.',
    )
    expect(survey.overview('elbow.vtk').worst.map(({ cell }) => cell)).toEqual(
      survey.rows(0, 64).map(({ cell }) => cell),
    )
    expect(survey.overview('elbow.vtk').worst.filter(({ standing }) => standing === 'invalid')).toHaveLength(12)
  })

  test.each([
    [[unitCube, unitCube], 'All 2 hexahedra are valid.'],
    [[unitCube], 'The hexahedron is valid.'],
    [[mirroredCube], 'The hexahedron is invalid. The eight corners and VTK’s scaled Jacobian reject it, too.'],
    [[wedge], 'The hexahedron is invalid. The eight corners reject it, VTK’s scaled Jacobian would accept it.'],
    [[accepted, unitCube], '1 of 2 hexahedra is invalid. The eight corners and VTK’s scaled Jacobian would accept it.'],
    [[unitCube, notFinite], 'None of 2 hexahedra is known to be invalid. 1 is unanswered.'],
    [
      [mirroredCube, flat, notFinite, notFinite],
      '2 of 4 hexahedra are invalid. The eight corners would accept none of them, VTK’s scaled Jacobian 1. 2 are unanswered.',
    ],
  ])('%#', async (elements, sentence) => {
    expect((await surveyOf(meshOf(elements))).overview('a').headline).toBe(sentence)
  })
})

describe('the list', () => {
  test('has every cell, worst first, with its numbers and who accepts it', async () => {
    const survey = await surveyOf(few)
    expect(survey.rows(0, 2).map(({ cell, id, standing }) => [cell, id, standing])).toEqual([
      [4, '5', 'invalid'],
      [2, '3', 'invalid'],
    ])
    const [cube] = survey.rows(3, 4)
    expect(cube).toMatchObject({ class: 'valid', relativeMinimum: 1, minimum: { value: 1 }, volume: { value: 1 } })
    expect(cube?.acceptedBy.length).toBe(8)
    expect(survey.rows(4, 5)[0]).toMatchObject({ standing: 'unanswered', why: 'vertex 6 y is NaN' })
    expect(survey.rows(5, 9)).toEqual([])
  })

  test.each<[Column, (survey: Survey, cell: number) => number]>([
    ['id', (_, cell) => cell],
    ['minimum', (survey, cell) => survey.check.answers.minima?.values[cell] as number],
    ['volume', (survey, cell) => survey.check.answers.volumes?.values[cell] as number],
    ['class', (survey, cell) => survey.check.answers.classes[cell] as number],
  ])('is sorted by %s, up and down', async (column, keyOf) => {
    const survey = await surveyOf(many)
    for (const isDescending of [false, true]) {
      survey.arrange({ column, isDescending })
      const keys = listed(survey).map(cell => keyOf(survey, cell))
      expect(keys).toEqual(keys.toSorted((a, b) => (isDescending ? b - a : a - b)))
      expect(new Set(listed(survey)).size).toBe(400)
    }
  })

  test('finds cells by id, and the next invalid one, in its own order', async () => {
    const survey = await surveyOf(few)
    expect(survey.find('5', -1)).toEqual({ cell: 4, rank: 0 })
    expect(survey.find('77', -1)).toBe(null)
    expect([survey.nextInvalid(0, 1)?.cell, survey.nextInvalid(2, 1)?.cell, survey.nextInvalid(0, -1)?.cell]).toEqual([
      2, 4, 3,
    ])
    select(survey, { condition: 'valid' })
    expect(survey.find('5', -1)).toBe(null)
    expect(survey.nextInvalid(-1, 1)).toBe(null)
    expect(survey.placeOf(4)).toEqual({ cell: 4, rank: null })
  })
})

describe('a selection', () => {
  test.each([
    'not valid and corner_min > 0',
    'valid and scaled_jacobian < 0.4',
    'boundary_min / volume < 0.2',
    'gauss2_min > 0 and not valid',
    'twist > 20 or edge_min < -0.1',
  ])('has the cells that meet “%s”, as one by one', async condition => {
    const survey = await surveyOf(many)
    const parsed = parseCondition(condition)
    if (!parsed.ok) throw new Error(parsed.error.message)
    const expected = Array.from({ length: 400 }, (_, cell) => cell).filter(cell => {
      const answer = survey.check.answerTo(cell)
      return 'report' in answer && isMet(parsed.value, quantitiesOf(answer.report, answer.report.vertices))
    })
    const found = select(survey, { condition })
    expect(found.toSorted((a, b) => a - b)).toEqual(expected)
    expect(expected.length).toBeGreaterThan(0)
  })

  test('goes on in steps, and is cut by a range of relative minima', async () => {
    const survey = await surveyOf(many)
    expect(survey.select({ condition: 'not valid', range: null })).toEqual({ listed: 0, done: 0 })
    const relative = survey.check.answers.relativeMinima
    const within = select(survey, { range: [0, 0.25] })
    expect(within.length).toBe(relative.filter(value => value >= 0 && value <= 0.25).length)
    expect(select(survey, {}).length).toBe(400)
  })

  test('takes coordinates of any size', async () => {
    const sizes = [1e-150, 1e-90, 1, 1e90, 1e150]
    const survey = await surveyOf(
      meshOf(sizes.flatMap(size => [unitCube, invalidCorner].map(all => all.map(x => x * size)))),
    )
    expect(select(survey, { condition: 'corner_min > 0' }).toSorted()).toEqual([0, 2, 4, 6, 8])
    expect(select(survey, { condition: 'not valid' }).toSorted()).toEqual([1, 3, 5, 7, 9])
  })
})

test('the histogram counts each cell once, with zero as an edge, and its percentiles are those of the list', async () => {
  const survey = await surveyOf(many)
  const { edges, counts, percentiles, beside } = survey.histogram()
  expect(counts.reduce((sum, count) => sum + count, 0) + beside).toBe(400)
  expect(edges).toContain(0)
  expect(edges.length).toBe(counts.length + 1)
  const sorted = [...survey.check.answers.relativeMinima].sort((a, b) => a - b)
  expect(percentiles.map(({ value }) => value)).toEqual([1, 10, 50, 90, 99].map(percent => sorted[4 * percent - 1]))
  const least = sorted[0] as number
  expect(edges[0]).toBeLessThanOrEqual(least)
})

test('a cell whose relative minimum is 0 is invalid, and counted on that side of zero', async () => {
  const { edges, counts } = (await surveyOf(meshOf([wedge, unitCube]))).histogram()
  expect([edges.slice(0, 2), counts[0]]).toEqual([[-0.025, 0], 1])
  expect([edges.at(-1), counts.at(-1)]).toEqual([1, 1])
})

describe('faces', () => {
  test('of all cells are the boundary; of fewer, what bounds these', async () => {
    const survey = await surveyOf(elbow)
    expect(survey.faces(ALL).cells.length).toBe(2 * 256 + 32 * 28)
    const one = survey.faces({ cells: { which: 'one', cell: 3000 }, isWhole: false, most: Infinity })
    expect([one.cells.length, one.shown, one.wanted]).toEqual([6, 1, 1])
    const invalid = survey.faces({ cells: { which: 'invalid', rings: 0 }, isWhole: true, most: Infinity })
    expect(invalid.cells.length).toBe(6 * 12)
    expect([...tonesOf(invalid)].every(tone => tone < 0)).toBe(true)
    const ring = survey.faces({ cells: { which: 'invalid', rings: 1 }, isWhole: true, most: Infinity })
    expect(ring.shown).toBeGreaterThan(60)
    const worst = survey.faces({ cells: { which: 'invalid', rings: 0 }, isWhole: true, most: 5 })
    expect([worst.shown, worst.wanted]).toEqual([5, 12])
    expect(new Set(worst.cells)).toEqual(new Set(survey.check.worst.subarray(0, 5)))
  })

  test('behind a plane are those of the cells whose middle is there, less the origin', async () => {
    const survey = await surveyOf(elbow)
    const { origin } = survey.faces(ALL)
    const half = survey.faces({
      cells: { which: 'behind-plane', normal: [0, 1, 0], offset: 0 },
      isWhole: false,
      most: Infinity,
    })
    expect(origin[1]).toBeCloseTo(0)
    expect(half.shown).toBe(7168 / 2)
    for (const cell of half.cells) expect(survey.faced.middles[3 * cell + 1]).toBeLessThanOrEqual(0)
  })

  test('of a cell that is not finite are those that are, without a number', async () => {
    const faces = (await surveyOf(few)).faces(ALL)
    const { cells } = faces
    expect([...tonesOf(faces)].filter((_, face) => cells[face] === 1)).toEqual([NO_TONE, NO_TONE, NO_TONE])
    expect(cells.length).toBe(5 * 6 - 3)
  })
})

test('a chosen cell comes with its neighbours, once faces are joined', async () => {
  const survey = await surveyOf(elbow)
  expect(survey.detail(3000).neighbours).toEqual([])
  expect(survey.join(Infinity)).toBe(1)
  const { neighbours, vertices, row } = survey.detail(3000)
  expect([row.cell, vertices?.length, neighbours.length]).toEqual([3000, 24, 6])
  expect(neighbours.map(({ cell }) => cell)).toContain(3000 - 256)
})

test('faces are joined in steps, and other questions are answered in between', async () => {
  const survey = await surveyOf(elbow)
  expect(survey.join(0)).toBeLessThan(1)
  expect(survey.rows(0, 3).length).toBe(3)
  expect(survey.detail(3000).neighbours).toEqual([])
  while (survey.join(0) < 1);
  expect(survey.detail(3000).neighbours.length).toBe(6)
})

test('joining tells of each step until all is done, or the mesh is closed', async () => {
  const asked: string[] = []
  const port: WorkerPort = {
    onreply: null,
    onbroken: null,
    postMessage({ kind }) {
      asked.push(kind)
      const joined = asked.filter(other => other === 'join').length
      const reply: Reply = kind === 'start' ? { kind: 'started', lock: null } : { kind: 'answer', answer: joined / 4 }
      queueMicrotask(() => port.onreply?.(reply))
    },
    terminate: () => asked.push('terminate'),
  }
  const parts: number[] = []
  await new OpenSurvey(() => port).join(part => parts.push(part))
  expect(parts).toEqual([0.25, 0.5, 0.75, 1])
  expect(asked).toEqual(['start', 'join', 'join', 'join', 'join'])

  asked.length = 0
  const closed = new OpenSurvey(() => port)
  await closed.join(part => part === 0.5 && closed.close())
  expect(asked).toEqual(['start', 'join', 'join', 'terminate'])
})

test('what is mirrored is corrected, with a note, and nothing else', async () => {
  const mesh = meshOf([unitCube, mirroredCube, mirroredCube, invalidCorner])
  const survey = await surveyOf(mesh)
  expect(survey.overview('a').fixes).toEqual([{ id: 'mirrored', words: 'Correct 2 mirrored cells' }])
  const better = await surveyOf(mended(survey.check, 'mirrored'))
  expect(better.check).toMatchObject({ valid: 3, invalid: 1, mirrored: 0 })
  expect(better.overview('a').sentences.join(' ')).toContain('2 mirrored hexahedra have been corrected here')
  expect([...mesh.cells.subarray(0, 8)]).toEqual([...better.check.mesh.cells.subarray(0, 8)])
})

test('where no batches run, cells are answered one by one, the same in all lists', async () => {
  const lists = { ...LISTS, relativeMinima: true, classes: true, statuses: true, exact: true } as const
  const wanted = { ...lists, coincident: true, acceptedInvalid: true } as const
  const alone = cellClassifier(
    core,
    () => Promise.reject(new Error('none')),
    () => {},
  )
  const mesh = meshOf([
    ...Array.from({ length: 80 }, () => randomHexahedron(next, 0.4)),
    notFinite,
    flat,
    moved(1, [0, 0, 0]),
  ])
  expect(await alone(mesh.points, mesh.cells, wanted)).toEqual(await classify(mesh.points, mesh.cells, wanted))
})
