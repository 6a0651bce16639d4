/** The presets' claims, in exact arithmetic if a point or an edge decides them. */
import { describe, expect, it } from 'vitest'
import { type Vec3, vertexReference } from '../../web/model/hexahedron'
import { reordered } from '../../web/model/node-order'
import { nodeOrders } from '../../web/model/node-orders'
import { type Preset, presets, presetVertices } from '../../web/model/presets'
import { cases, caseVertices, core, randomSource } from './core-fixtures'
import { edgesArePositive, exactJacdet, verticesArePositive } from './exact'

const CENTRE: Vec3 = [0.5, 0.5, 0.5]

/** A point where jacdet is not positive, and what is positive all the same. */
const claims: Record<
  string,
  { witness: Vec3; value: 'zero' | 'negative'; positive: 'nothing' | 'vertices' | 'edges' }
> = {
  'looks-fine': { witness: [0, 0.59375, 1], value: 'negative', positive: 'vertices' },
  'non-strict': { witness: CENTRE, value: 'negative', positive: 'nothing' },
  'edge-negative': { witness: [0, 0, 0.578125], value: 'negative', positive: 'vertices' },
  'face-negative': { witness: [0.5, 0.5, 0], value: 'negative', positive: 'edges' },
  touching: { witness: [0.5, 0.5, 0], value: 'zero', positive: 'edges' },
  'twisted-after': { witness: [0, 0, 0.5], value: 'negative', positive: 'vertices' },
  inverted: { witness: CENTRE, value: 'negative', positive: 'nothing' },
  'wrong-order': { witness: [1, 1, 0], value: 'negative', positive: 'nothing' },
  wedge: { witness: [0, 1, 0], value: 'zero', positive: 'nothing' },
}

function preset(id: string): Preset {
  const found = presets.find(candidate => candidate.id === id)
  if (!found) throw new Error(`There is no preset ${id}.`)
  return found
}

function report(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

describe('every preset', () => {
  it('has a name of its own and 24 finite numbers', () => {
    expect(new Set(presets.map(({ id }) => id)).size).toBe(presets.length)
    expect(new Set(presets.map(({ title }) => title)).size).toBe(presets.length)
    for (const each of presets) {
      const vertices = presetVertices(each)
      expect(vertices.length).toBe(24)
      expect(vertices.every(Number.isFinite)).toBe(true)
      expect(each.note).toMatch(/\.$/)
    }
  })

  for (const each of presets.filter(({ valid }) => valid !== null))
    it(`${each.title}: the core's verdict is the claimed one`, () => {
      expect(report(presetVertices(each)).valid).toBe(each.valid)
      expect(each.valid).toBe(!(each.id in claims))
    })

  for (const [id, { witness, value, positive }] of Object.entries(claims))
    it(`${preset(id).title}: not positive at its witness, yet positive on its ${positive}`, () => {
      const vertices = presetVertices(preset(id))
      const jacdet = exactJacdet(vertices, witness)
      expect(value === 'zero' ? jacdet === 0n : jacdet < 0n).toBe(true)
      expect(verticesArePositive(vertices)).toBe(positive !== 'nothing')
      expect(edgesArePositive(vertices)).toBe(positive === 'edges')
    })
})

describe('the presets of the paper and of the exact cases', () => {
  it('are the same doubles', () => {
    const same: Record<string, string> = {
      cube: 'pub/degenerate/cube',
      'non-strict': 'pub/nonstrict/paper',
      'edge-negative': 'pub/corner_pos/three_moved',
      'face-negative': 'pub/edge_pos/s4_in_cube',
      wedge: 'pub/degenerate/wedge2',
    }
    for (const [id, name] of Object.entries(same)) expect(presetVertices(preset(id))).toEqual(caseVertices(name))
    expect(cases.length).toBe(103)
  })

  it('have the values of their notes', () => {
    const counterexample = presetVertices(preset('non-strict'))
    expect(report(counterexample).boundaryMinimum).toBe(0)
    expect(core.jacobian(counterexample, CENTRE)).toMatchObject({ value: { jacdet: -0.25 } })
    expect(report(presetVertices(preset('touching'))).boundaryMinimum).toBe(0)
    const wrongOrder = presetVertices(preset('wrong-order'))
    expect(vertexReference.filter(point => exactJacdet(wrongOrder, point) < 0n).length).toBe(4)
    const lexicographic = nodeOrders.find(({ id }) => id === 'lexicographic')
    const putRight = reordered(wrongOrder, lexicographic?.permutation ?? [])
    expect(verticesArePositive(putRight) && edgesArePositive(putRight) && report(putRight).valid).toBe(true)
    const inverted = report(presetVertices(preset('inverted')))
    expect([inverted.boundaryMinimum, inverted.boundaryMaximum]).toEqual([-1, -1])
  })
})

it('draws a random element anew each time, half of them valid', () => {
  const random = randomSource(11)
  const draws = Array.from({ length: 400 }, () => presetVertices(preset('random'), random))
  expect(new Set(draws.map(String)).size).toBe(draws.length)
  const valid = draws.filter(vertices => report(vertices).valid).length
  expect(Math.abs(valid - 0.558 * draws.length)).toBeLessThan(4 * Math.sqrt(0.25 * draws.length))
})

it('never draws a coordinate that would read -0', () => {
  const random = randomSource(12)
  const draws = Array.from({ length: 4000 }, () => presetVertices(preset('random'), random))
  expect(draws.flat().filter(x => x === 0).length).toBeGreaterThan(0)
  expect(draws.flat().some(x => Object.is(x, -0))).toBe(false)
})
