/** The checks that accept each cell, found in steps, with the real core. */
import { expect, test } from 'vitest'
import { Accepting } from '../../web/survey/accepting'
import { OpenedSurvey } from '../../web/survey/opened-survey'
import { Survey } from '../../web/survey/survey'
import { core, randomHexahedron, randomSource } from './core-fixtures'
import { checked, classifyCells as classify, meshOf } from './mesh-fixtures'

const next = randomSource(3)
const mesh = meshOf(Array.from({ length: 300 }, () => randomHexahedron(next, 0.35)))
const check = await checked(mesh, { worst: Infinity, lists: { minima: true, volumes: true } })
const { acceptedBy: all, minima } = await classify(mesh.points, mesh.cells, { acceptedBy: true, minima: true })

test('invalid cells come first, each with the same checks as among all', async () => {
  const accepting = new Accepting(check, classify, 16)
  while ((await accepting.run('invalid')) < 1);
  const invalid = [...all.keys()].filter(cell => check.standingOf(cell) === 'invalid')
  expect(invalid.length).toBeGreaterThan(16)
  expect(invalid.map(cell => accepting.lists.acceptedBy[cell])).toEqual(invalid.map(cell => all[cell]))
  const parts: number[] = []
  for (let part = 0; part < 1; parts.push(part)) part = await accepting.run('all')
  expect(parts).toEqual([...parts].sort((a, b) => a - b))
  expect(parts.length).toBeGreaterThan(2)
  expect([...accepting.lists.acceptedBy]).toEqual([...all])
  expect(accepting.lists.minima.minimizers).toEqual(minima.minimizers)
  expect(accepting.lists.minima.values).toBe(check.answers.minima?.values)
})

test('two who ask at once wait for the same step', async () => {
  const counted: number[] = []
  const counting = ((points, cells, wanted) => {
    counted.push(cells.length / 8)
    return classify(points, cells, wanted)
  }) as typeof classify
  const accepting = new Accepting(check, counting, 200)
  await Promise.all([accepting.run('all'), accepting.run('invalid'), accepting.run('all')])
  await Promise.all([accepting.run('all'), accepting.run('all')])
  expect(counted).toEqual([200, 100])
})

test('the survey has them once all are there; invalid ones alone leave it as it is', async () => {
  const opened = new OpenedSurvey(new Survey(check, { core, meeting: null }), null, classify)
  const first = await opened.acceptingInvalid()
  expect(first.answers.acceptedBy).not.toBe(null)
  expect(opened.survey.check.answers.acceptedBy).toBe(null)
  expect([...((await opened.accepting()).check.answers.acceptedBy ?? [])]).toEqual([...all])
})
