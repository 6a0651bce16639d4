/** A mesh that moves: rechecked it is what a check of all says; steps lead back bit for bit; what is around a cell; parts that are untangled. */
import { describe, expect, it, test } from 'vitest'
import { MOVES } from '../../web/core/repair/untangling'
import type { Mesh } from '../../web/mesh/mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { LiveCells } from '../../web/pages/mesh/live-cells'
import { part } from '../../web/pages/mesh/part'
import { thrownBlock } from '../../web/pages/mesh/thrown-block'
import { aroundOf } from '../../web/survey/around'
import { meeting } from '../../web/survey/meeting'
import { mended } from '../../web/survey/mend'
import { Movement } from '../../web/survey/movement'
import { inOwnFormat, movingJobs, roundedNote } from '../../web/survey/moving-jobs'
import { OpenedSurvey } from '../../web/survey/opened-survey'
import { cellsWith, recheck } from '../../web/survey/recheck'
import { Survey } from '../../web/survey/survey'
import { heldCertificates, MOST_LINES, untangledPart, withMoves } from '../../web/survey/untangled-part'
import { checked as checkedByPython } from './certificate-checker'
import { core, randomSource } from './core-fixtures'
import { checked, classifyCells as classify, meshOf } from './mesh-fixtures'
import { repairCore } from './stars'

const LISTS = { minima: true, volumes: true, exact: true } as const
const elbow: Mesh = { ...meshOf([]), ...part() }
const wholeCheck = (mesh: Mesh) => checked(mesh, { worst: Infinity, lists: LISTS })

function randomMoves(mesh: Mesh, seed: number, count = 5) {
  const next = randomSource(seed)
  const points = Uint32Array.from({ length: count }, () => Math.floor((next() * mesh.points.length) / 3))
  const to = new Float64Array(3 * count).map((_, i) => {
    const at = 3 * (points[Math.floor(i / 3)] as number) + (i % 3)
    return (mesh.points[at] as number) + 0.2 * (next() - 0.5)
  })
  return { points, to }
}

/** An open mesh as the worker has it. */
async function opened(mesh: Mesh) {
  const survey = new Survey(await wholeCheck(mesh), { core, meeting })
  const open = {
    name: 'made.vtk',
    survey: new OpenedSurvey(survey, null, classify),
    movement: new Movement(mesh),
    classify,
    core,
    files: [fileOfBytes('made.vtk', new Uint8Array())],
  }
  return {
    open,
    jobs: movingJobs(
      () => open,
      survey => Object.assign(open, { survey }),
    ),
  }
}

describe('a check of moved points', () => {
  it('is what a check of the whole mesh says', async () => {
    const movement = new Movement(elbow)
    let check = await wholeCheck(elbow)
    for (let seed = 1; seed <= 6; ++seed) {
      const points = seed === 6 ? movement.undo() : movement.move(randomMoves(movement.now, seed))
      check = await recheck(check, movement.now, points, { classify, core })
      const whole = await wholeCheck(movement.now)
      const { answers, standingOf, isAnswered, isBelow, idOf, blockOf, answerTo, ...others } = check
      expect(answers).toEqual(whole.answers)
      expect(others).toEqual(expect.objectContaining({ ...others, notes: whole.notes }))
      expect([others.invalid, others.valid, [...others.worst]]).toEqual([whole.invalid, whole.valid, [...whole.worst]])
    }
  })

  it('decides the cells of the moved points and no others', () => {
    const own = Uint32Array.from([3, 900])
    const expected = Array.from({ length: elbow.cells.length / 8 }, (_, cell) => cell).filter(cell =>
      elbow.cells.subarray(8 * cell, 8 * cell + 8).some(point => own.includes(point)),
    )
    expect([...cellsWith(elbow, own)]).toEqual(expected)
  })
})

describe('steps', () => {
  it('lead back and forth bit for bit, and one that is taken ends what was undone', () => {
    const movement = new Movement(elbow)
    const states = [movement.now.points]
    for (let seed = 1; seed <= 4; ++seed) {
      movement.move(randomMoves(movement.now, seed))
      states.push(movement.now.points)
    }
    for (let i = 3; i >= 0; --i) {
      movement.undo()
      expect(movement.now.points).toEqual(states[i])
    }
    expect([movement.movedCount, movement.canUndo, movement.now.notes]).toEqual([0, false, elbow.notes])
    for (let i = 1; i <= 4; ++i) {
      movement.redo()
      expect(movement.now.points).toEqual(states[i])
    }
    expect(movement.canRedo).toBe(false)
    movement.undo()
    movement.move(randomMoves(movement.now, 9))
    expect(movement.canRedo).toBe(false)
  })

  it('to where points were read are steps, too', () => {
    const movement = new Movement(elbow)
    movement.move({ points: Uint32Array.of(7), to: Float64Array.of(1, 2, 3) })
    movement.move({ points: Uint32Array.of(8), to: Float64Array.of(4, 5, 6) })
    expect(movement.movedCount).toBe(2)
    expect(movement.now.notes.at(-1)).toBe('2 vertices have been moved here.')
    expect([...movement.restore(Uint32Array.of(7, 9))]).toEqual([7])
    expect([movement.isMoved(7), movement.isMoved(8)]).toEqual([false, true])
    movement.restore(null)
    expect(movement.now.points).toEqual(elbow.points)
    movement.undo()
    movement.undo()
    expect(movement.movedCount).toBe(2)
    // There is nothing to bring back, so there is no step.
    expect(new Movement(elbow).restore(null).length).toBe(0)
  })

  it('go on when nodes are put into another order', () => {
    const movement = new Movement(elbow)
    movement.move({ points: Uint32Array.of(7), to: Float64Array.of(1, 2, 3) })
    const renumbered = { ...movement.now, cells: movement.now.cells.slice().reverse() }
    const after = new Movement(renumbered, movement)
    expect([after.movedCount, after.isRenumbered, after.canUndo]).toEqual([1, true, true])
    after.undo()
    expect([after.now.points, after.now.cells, after.now.notes]).toEqual([elbow.points, renumbered.cells, elbow.notes])
  })
})

describe('the jobs', () => {
  it('tell of the moved mesh, its steps, and why there is no file of its own format', async () => {
    const { jobs } = await opened(elbow)
    const first = await jobs.move({ points: Uint32Array.of(4000), to: Float64Array.of(0, 0, 0) })
    expect(first.movement).toEqual({
      movedCount: 1,
      canUndo: true,
      canRedo: false,
      whyNotInPlace: expect.stringMatching(/the coordinates are packed, in several files/),
    })
    expect(first.opened.sentences).toContain('1 vertex has been moved here.')
    const second = await jobs.undo(null)
    expect(second.opened.headline).toMatch(/^12 of 7,168 hexahedra are invalid/)
    expect(second.movement).toMatchObject({ movedCount: 0, canUndo: false, canRedo: true })
  })

  it('say nothing is around a cell until it is known which cells share faces; then its cells and the boundary', async () => {
    const { open } = await opened(elbow)
    const survey = await open.survey.whole()
    expect(aroundOf(new Survey(survey.check, { core, meeting }), open.movement, 3000)).toBe(null)
    survey.join(Infinity)
    const around = aroundOf(survey, open.movement, 3000)
    if (!around) throw new Error('There is nothing around it.')
    expect(around.cells.length).toBe(27)
    expect(around.onBoundary).toEqual([])
    for (const { row, vertices, shared } of around.cells) {
      for (const [v, own] of shared.entries()) {
        const point = elbow.cells[8 * row.cell + v] as number
        expect(own).toBe(around.points.indexOf(point))
        expect(vertices.slice(3 * v, 3 * v + 3)).toEqual([...elbow.points.subarray(3 * point, 3 * point + 3)])
      }
    }
    const [face] = survey.faced.neighbours.boundary
    const outer = aroundOf(survey, open.movement, Math.floor((face as number) / 6))
    expect(outer?.onBoundary.length).toBeGreaterThanOrEqual(4)
  })
})

test('the block of the page is untangled: all valid, with the margin', async () => {
  const { open, jobs } = await opened({ ...meshOf([]), ...thrownBlock() })
  expect((await open.survey.whole()).check.invalid).toBeGreaterThan(50)
  const result = await untangledPart(
    repairCore,
    { part: await jobs.tangled(null), margin: 0.1, boundary: 'stays' },
    () => {},
  )
  if ('refused' in result) throw new Error(result.refused)
  expect([result.counts.belowAfter, result.heldCount]).toEqual([0, 0])
  expect((await jobs.move(result.moves)).opened.counts.invalid).toBe(0)
})

describe('the file that was read', () => {
  const single: Mesh = {
    ...elbow,
    points: elbow.points.map(Math.fround),
    coordinatePlaces: { kind: 'block', from: 0, type: 'float32', isLittleEndian: true },
  }

  it('in single precision: it says that moved vertices are rounded, and what that does', async () => {
    const { open, jobs } = await opened(single)
    await jobs.move({ points: Uint32Array.of(4000), to: single.points.slice(12000, 12003) })
    expect(await roundedNote(open)).toEqual([])
    const to = single.points.slice(12000, 12003).map(x => x + 1e-9)
    await jobs.move({ points: Uint32Array.of(4000), to })
    expect(await roundedNote(open)).toEqual([
      'The file has single precision, to which the moved vertices are rounded: none of their cells is invalid by that.',
    ])
  })

  it('is refused once nodes have been renumbered', async () => {
    const { open } = await opened(single)
    const moving = { ...open, movement: new Movement(single, open.movement) }
    expect(() => [...inOwnFormat(moving)]).toThrow('The file has the nodes of its cells in another order')
    expect(() => [...inOwnFormat({ ...open, files: [] })]).toThrow('The mesh was read from several files.')
  })
})

describe('the page, ahead of the worker', () => {
  it('says of the cells around a vertex that moves what the worker says afterwards', async () => {
    const { open, jobs } = await opened(elbow)
    const survey = await open.survey.whole()
    survey.join(Infinity)
    const next = randomSource(5)
    for (const cell of [2951, 3000, 5000]) {
      const around = await jobs.around(cell)
      if (!around) throw new Error('There is nothing around it.')
      const live = new LiveCells(core, around)
      const vertex = Math.floor(8 * next())
      const point = around.points[vertex] as number
      const place = Array.from(elbow.points.subarray(3 * point, 3 * point + 3), x => x + 0.3 * (next() - 0.5)) as [
        number,
        number,
        number,
      ]
      const rows = live.move(new Map([[vertex, place]]))
      expect(rows.length).toBe(8)
      await jobs.move({ points: Uint32Array.of(point), to: Float64Array.from(place) })
      const after = await open.survey.whole()
      for (const row of rows) expect(row).toEqual(after.detail(row.cell).row)
      const invalid = rows.filter(({ standing }) => standing === 'invalid')
      const drawn = live.drawnAround(cell)
      expect(drawn.filter(({ isInvalid }) => isInvalid).length).toBeGreaterThanOrEqual(
        invalid.filter(row => row.cell !== cell).length,
      )
      expect(drawn.length).toBeGreaterThanOrEqual(6)
    }
  })
})

describe('untangling', () => {
  test.each([null, { cell: 2951, rings: 1 }])(
    'of the elbow, %o: one step, valid, the boundary where it was',
    async wanted => {
      const { open, jobs } = await opened(elbow)
      const before = (await open.survey.whole()).check
      const tangled = await jobs.tangled(wanted)
      const result = await untangledPart(repairCore, { part: { ...tangled }, margin: 0.1, boundary: 'stays' }, () => {})
      if ('refused' in result) throw new Error(result.refused)
      const { counts, moves, ghost, heldCount, held } = result
      expect(moves.points.length).toBe(counts.movedCount)
      expect(ghost.ends.length).toBe(6 * Math.min(ghost.wanted, MOST_LINES))
      const ids = new Set(before.mesh.cells.subarray(8 * 2951, 8 * 2951 + 8))
      if (wanted) expect([...moves.points].some(point => ids.has(point))).toBe(true)
      const { opened: overview } = await jobs.move(moves)
      expect(overview.counts.invalid).toBeLessThan(12)
      if (!wanted) {
        expect(overview.counts.invalid).toBe(counts.invalidAfter)
        expect(held.length).toBe(Math.min(heldCount, 10))
        // Each is said with a cell that has it, and what forbids the margin is proved by at most four points.
        for (const { cell, vertex, forbids, bound, pointCount } of held) {
          expect(elbow.cells[8 * cell + vertex]).toBeGreaterThanOrEqual(0)
          if (forbids === 'margin') expect(bound).toBeLessThan(0.1)
          if (forbids) expect([1, 2, 3, 4]).toContain(pointCount)
        }
        expect(held.some(({ forbids }) => forbids !== null)).toBe(true)
        // The same of the mesh as it is now: those of all are a file that the checker takes.
        const part = withMoves(await jobs.tangled(wanted), moves)
        const { text, count } = heldCertificates(repairCore, { part, margin: 0.1, holding: result.holding }, () => {})
        const names = JSON.parse(text).map((certificate: { name: string }) => certificate.name)
        expect(names.length).toBe(count)
        expect(count).toBeLessThanOrEqual(heldCount)
        for (const { id, vertex, forbids } of held)
          if (forbids)
            expect(names).toContain(`point ${elbow.cells[8 * Number(id) + vertex]}: vertex ${vertex} of cell ${id}`)
        expect(checkedByPython(text)).toMatchObject({ status: 0 })
      } else {
        // Outside the part everything is as it was.
        const inPart = new Set(tangled.indices ?? [])
        expect([...moves.points].every(point => inPart.has(point))).toBe(true)
        expect(tangled.moves.includes(MOVES.stays)).toBe(true)
      }
      await jobs.undo(null)
      expect((await open.survey.whole()).check.mesh.points).toEqual(elbow.points)
    },
  )
})

test('correcting mirrored cells of a moved mesh keeps its points', async () => {
  const { open, jobs } = await opened(elbow)
  await jobs.move({ points: Uint32Array.of(7), to: Float64Array.of(1, 2, 3) })
  const { check } = await open.survey.whole()
  expect([...mended(check, 'mirrored').points.subarray(21, 24)]).toEqual([1, 2, 3])
})
