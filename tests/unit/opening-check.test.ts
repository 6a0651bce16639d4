/** A mesh that is opened in two steps is checked as at once. */
import { describe, expect, test } from 'vitest'
import { acceptedInvalid } from '../../web/mesh/accepted-invalid'
import type { Mesh } from '../../web/mesh/mesh'
import { openingCheck } from '../../web/survey/opening-check'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import {
  checked,
  classifyCells as classify,
  collapsedEdge,
  flat,
  invalidCorner,
  meshOf,
  mirroredCube,
  notFinite,
} from './mesh-fixtures'

const LISTS = { minima: true, minimizers: false, volumes: true, exact: true, acceptedBy: true, acceptedInvalid: true }
const next = randomSource(20)
const random = (count: number, sigma: number) => Array.from({ length: count }, () => randomHexahedron(next, sigma))
const scaled = (elements: readonly (readonly number[])[], by: number) => elements.map(own => own.map(x => x * by))
const odd = [notFinite, flat, mirroredCube, collapsedEdge, invalidCorner, flat, unitCube.map(x => 1e9 + 1e-3 * x)]

const meshes: Readonly<Record<string, Mesh>> = {
  valid: meshOf(random(500, 0.02)),
  'valid but for three': meshOf([...random(500, 0.02), mirroredCube, flat, notFinite]),
  invalid: meshOf(random(800, 0.35)),
  odd: meshOf([...odd, ...random(300, 0.2), ...odd]),
  alike: meshOf(Array.from({ length: 300 }, () => unitCube)),
  tiny: meshOf(scaled(random(300, 0.3), 1e-120)),
  huge: meshOf(scaled(random(300, 0.3), 1e110)),
  'of all sizes': meshOf([
    ...scaled(random(200, 0.3), 1e-110),
    ...random(200, 0.3),
    ...scaled(random(200, 0.3), 2 ** 40),
  ]),
  'far away': meshOf(random(300, 0.3).map(own => own.map(x => x + 2 ** 30))),
  'hardly any': meshOf(random(20, 0.3)),
  'hardly any answered': meshOf([...random(20, 0.3), ...Array.from({ length: 300 }, () => notFinite)]),
  'all collapsed but some': meshOf([...Array.from({ length: 300 }, () => flat), ...random(40, 0.35)]),
}

describe.each(Object.entries(meshes))('%s', (_, mesh) => {
  test('first the worst cells, then all as at once', async () => {
    const expected = await checked(mesh, { worst: Infinity, lists: LISTS })
    const { check, finish } = await openingCheck(mesh, { classify, core }, 1)
    const { relativeMinima, volumes } = expected.answers
    const first = check.worst
    expect([...first]).toEqual([...expected.worst.subarray(0, first.length)])
    for (const cell of first) {
      expect(check.answers.relativeMinima[cell]).toBe(relativeMinima[cell])
      expect(check.answers.volumes?.values[cell]).toBe(volumes?.values[cell])
    }
    const whole = finish ? await finish() : check
    const { minima, ...others } = whole.answers
    expect([...whole.worst]).toEqual([...expected.worst])
    expect(minima).toEqual(expected.answers.minima)
    for (const list of ['valid', 'relativeMinima', 'volumes', 'classes', 'exact', 'statuses'] as const)
      expect(others[list]).toEqual(expected.answers[list])
    expect(whole.notes).toEqual(expected.notes)
  })

  test('others accept as many of the invalid cells', async () => {
    const check = await checked(mesh, { worst: 0, lists: LISTS })
    const answers = { ...check.answers, acceptedInvalid: null }
    expect(acceptedInvalid(check)).toEqual(acceptedInvalid({ ...check, answers }))
  })
})

test('two steps are gone where that saves something', async () => {
  const { finish, check } = await openingCheck(meshes.invalid as Mesh, { classify, core }, 1)
  expect(finish).not.toBeNull()
  expect(check.worst.length).toBe(64)
})

test('one step is gone where too few cells are answered for the list on top, and where all may be among the worst', async () => {
  for (const name of ['hardly any', 'hardly any answered'] as const) {
    const { finish, check } = await openingCheck(meshes[name] as Mesh, { classify, core }, 1)
    expect(finish).toBeNull()
    expect(check.worst.length).toBe(check.hexahedra)
  }
  const alike = meshOf(Array.from({ length: 20_100 }, () => unitCube))
  const { finish, check } = await openingCheck(alike, { classify, core }, 1)
  expect(finish).toBeNull()
  expect([...check.worst.subarray(0, 3)]).toEqual([0, 1, 2])
})
