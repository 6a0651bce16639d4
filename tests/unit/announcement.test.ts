import { expect, it } from 'vitest'
import type { Report } from '../../web/core/report'
import { createStore } from '../../web/model/store'
import { announcement } from '../../web/panels/announcer/announcement'

const vertices = [0, 0, 0, 1, 0, 0, 1, 1, 0, 1.25, 0.5, -1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

it('says the vertex, the minimum, its place and the verdict as they are heard', () => {
  const store = createStore(vertices, null)
  store.dispatch({ type: 'select-vertex', vertex: 3 })
  const minimizer = { kind: 'face', id: 2, value: -0.03, point: [0, 0, 0], position: [0, 0, 0] } as const
  const volumeMinimum = { lower: -0.03, upper: -0.03, point: [0, 0, 0], position: [0, 0, 0] } as const
  const known = { boundaryMinimum: -0.03, boundaryMinimumError: 0, volumeMinimum }
  const kind = { class: 'invalid', coincident: [], shape: null }
  const report = { ...known, ...kind, minimizer, exponent: 0, valid: false } as unknown as Report
  expect(announcement(store.state, report)).toBe('Vertex 3: 1.25, 0.5, -1. Minimum jacdet -0.03 on face 2. Invalid.')
  const lower = { ...report, volumeMinimum: { ...volumeMinimum, lower: -0.2501, upper: -0.2499 } } as Report
  expect(announcement(store.state, lower)).toContain('Minimum jacdet -0.03 on face 2, -0.25 inside. Invalid.')
  const onEdge = { ...report, minimizer: { ...minimizer, kind: 'edge', id: 6 } } as Report
  expect(announcement(store.state, onEdge)).toContain('-0.03 on edge 6-7.')
  store.dispatch({ type: 'show-reference-cube', referenceCube: 'biunit' })
  const atVertex = { ...report, valid: true, minimizer: { ...minimizer, kind: 'vertex', value: 8 } } as Report
  expect(announcement(store.state, atVertex)).toBe('Vertex 3: 1.25, 0.5, -1. Minimum jacdet 1 at vertex 2. Valid.')
  const wedge: Partial<Report> = {
    class: 'invalid',
    coincident: [
      [4, 5],
      [6, 7],
    ],
    shape: 'wedge',
  }
  expect(announcement(store.state, { ...report, ...wedge })).toMatch(
    /Invalid: a wedge stored as a hexahedron\. Vertices 4 and 5 coincide, and so do 6 and 7\.$/,
  )
  expect(announcement(store.state, { ...report, class: 'inverted' })).toMatch(/ Invalid: inverted\.$/)
})
