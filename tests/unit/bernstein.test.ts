/** The places of the 27 Bernstein coefficients, against what the core computes of elements all of whose coefficients differ. */
import { expect, it } from 'vitest'
import {
  BERNSTEIN_COUNT,
  bernsteinIndex,
  bernsteinIndices,
  bernsteinMiddles,
  bernsteinStrides,
  edgeBernstein,
  faceBernstein,
  vertexBernstein,
} from '../../web/model/bernstein'
import { edgeAxes, edgesAlong, edgeVertices, VERTEX_COUNT, vertexReference } from '../../web/model/hexahedron'
import { core, entry, randomHexahedron, randomSource } from './core-fixtures'

const random = randomSource(27)
const reports = Array.from({ length: 20 }, () => {
  const result = core.analyze(randomHexahedron(random, 0.5))
  if (!result.ok) throw new Error(result.error.message)
  return result.value
})

it('are told apart by these elements', () => {
  for (const { bernstein } of reports) expect(new Set(bernstein).size).toBe(BERNSTEIN_COUNT)
})

it('of vertices and faces are those of the report', () => {
  for (const report of reports) {
    for (const { kind, id, value } of report.candidates)
      if (kind === 'vertex') expect(report.bernstein[entry(vertexBernstein, id)]).toBe(value)
    for (const { id, bernstein } of report.faces)
      expect(entry(faceBernstein, id).map(index => report.bernstein[index])).toEqual(bernstein)
  }
})

it('of edges make the parabola whose vertex is a candidate', () => {
  let count = 0
  for (const report of reports) {
    for (const { kind, id, value, point } of report.candidates) {
      if (kind !== 'edge') continue
      const [q0, q1, q2] = entry(edgeBernstein, id).map(index => entry(report.bernstein, index)) as [
        number,
        number,
        number,
      ]
      const r = entry(point, entry(edgeAxes, id))
      expect(r).toBeCloseTo((q0 - q1) / (q0 - 2 * q1 + q2), 12)
      expect(value).toBeCloseTo((q0 * q2 - q1 * q1) / (q0 - 2 * q1 + q2), 12)
      count++
    }
  }
  expect(count).toBeGreaterThan(10)
})

it('have indices, strides and middles that go together', () => {
  for (const [n, indices] of bernsteinIndices.entries()) {
    expect(bernsteinIndex(...indices)).toBe(n)
    expect(indices.reduce((sum, index, axis) => sum + index * entry(bernsteinStrides, axis), 0)).toBe(n)
  }
  const inMiddles = (count: number) => bernsteinMiddles.filter(middles => middles === count).length
  expect([0, 1, 2, 3].map(inMiddles)).toEqual([8, 12, 6, 1])
})

it('edges run along the axis on which their ends differ', () => {
  for (const [axis, edges] of edgesAlong.entries()) {
    const ends = edges.flatMap(edge => entry(edgeVertices, edge))
    expect(ends.toSorted((a, b) => a - b)).toEqual(Array.from({ length: VERTEX_COUNT }, (_, vertex) => vertex))
    for (const edge of edges) {
      const [from, to] = entry(edgeVertices, edge)
      const start = entry(vertexReference, from)
      expect(entry(vertexReference, to).map((x, r) => x - entry(start, r))).toEqual(
        [0, 1, 2].map(r => (r === axis ? 1 : 0)),
      )
    }
  }
})
