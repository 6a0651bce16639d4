/** What a page's script may say, and what it may not. */
import { describe, expect, it, test } from 'vitest'
import { readAttribute } from '../../web/element/attributes'
import { HexLensError } from '../../web/element/hex-lens-error'
import { Looking } from '../../web/element/looking'
import { cameraBetween } from '../../web/element/motion'
import {
  readCameraView,
  readHighlights,
  readPlace,
  readSeconds,
  readSurroundings,
} from '../../web/element/script-arguments'
import { hitFaces } from '../../web/scene/input/face-hit'
import { drawnFaces } from '../../web/views/scene-slices'

const views = { known: [], passedOver: [] }
const refusal = (read: () => unknown) => {
  try {
    return read()
  } catch (reason) {
    if (!(reason instanceof HexLensError)) throw reason
    return `${reason.code}: ${reason.message}`
  }
}

test('hexahedra around the element, and vertices that stay', () => {
  const vertices = Array.from({ length: 24 }, (_, i) => i)
  expect(readSurroundings({ hexahedra: [{ vertices }, { vertices, isInvalid: true }], fixed: 3 })).toEqual({
    hexahedra: [
      { vertices, isInvalid: false },
      { vertices, isInvalid: true },
    ],
    fixed: [3],
  })
  for (const none of [undefined, null, {}]) expect(readSurroundings(none)).toEqual({ hexahedra: [], fixed: [] })
  expect(refusal(() => readSurroundings({ hexahedra: [{ vertices: [1] }] }))).toBe(
    'bad-argument: surround.hexahedra[0].vertices has to be a list of 24.',
  )
})

test('a place of a vertex, and points with labels', () => {
  const points = [{ position: [0, 1, 2], label: 'A' }]
  expect(readPlace({ vertex: 7, position: [1, 2, 3], points })).toEqual({
    vertex: 7,
    position: [1, 2, 3],
    points: [{ position: [0, 1, 2], point: null, label: 'A', weight: null }],
  })
  expect(readPlace({ vertex: 0 })).toEqual({ vertex: 0, position: null, points: [] })
  expect(readPlace(null)).toBe(null)
  expect(refusal(() => readPlace({ vertex: 8 }))).toBe('bad-argument: markPlace.vertex has to be a number from 0 to 7.')
  expect(refusal(() => readPlace({ vertex: 1, position: [0, Number.NaN, 0] }))).toMatch(
    /^bad-argument: markPlace\.position has to be a number from/,
  )
})

describe('highlight', () => {
  it('takes numbers and lists of them', () => {
    expect(readHighlights({ vertices: 6, edges: [0, 11], faces: [], point: [0, 0.5, 1] })).toEqual([
      { kind: 'edge', id: 0 },
      { kind: 'edge', id: 11 },
      { kind: 'vertex', id: 6 },
      { kind: 'point', point: [0, 0.5, 1] },
    ])
    for (const none of [undefined, null, {}]) expect(readHighlights(none)).toEqual([])
  })

  it.each([
    [{ vertices: 8 }, 'highlight.vertices has to be a number from 0 to 7.'],
    [{ edges: [0.5] }, 'highlight.edges has to be a whole number.'],
    [{ faces: 'top' }, 'highlight.faces has to be a number from 0 to 5.'],
    [{ faces: Symbol('top') }, 'highlight.faces has to be a number from 0 to 5.'],
    [{ point: [0, 0] }, 'highlight.point has to be a list of 3.'],
    [{ point: [0, 0, 2] }, 'highlight.point has to be a number from 0 to 1.'],
    [{ vertex: 3 }, 'highlight takes vertices, edges, faces, point, not vertex.'],
    [7, 'highlight has to be an object.'],
  ])('refuses %j', (given, message) => {
    expect(refusal(() => readHighlights(given))).toBe(`bad-argument: ${message}`)
  })
})

describe('a camera', () => {
  it('has a direction; the rest is as in the view in which the element just fits', () => {
    expect(readCameraView({ direction: [0, 0, 2] })).toEqual({ direction: [0, 0, 2], zoom: 1, pan: [0, 0, 0] })
    expect(refusal(() => readCameraView({ zoom: 2 }))).toBe('bad-argument: camera.direction has to be a list of 3.')
    expect(refusal(() => readCameraView({ direction: [0, 0, Number.NaN] }))).toMatch(/^bad-argument: camera.direction/)
    expect(refusal(() => readSeconds(-1))).toBe('bad-argument: seconds has to be a number from 0 to 3600.')
  })

  it('moves by the shorter way round, from the one to the other bit for bit', () => {
    const from = readCameraView({ direction: [-1, 0.1, 0], zoom: 0.5 })
    const to = readCameraView({ direction: [-3, -0.3, 0], zoom: 2, pan: [0, 0, 1] })
    expect(cameraBetween(from, to, 1)).toBe(to)
    const { direction, zoom, pan } = cameraBetween(from, to, 0.5)
    expect(direction[0]).toBeCloseTo(-1, 12)
    expect(direction[1]).toBeCloseTo(0, 12)
    expect([zoom, pan]).toEqual([1, [0, 0, 0.5]])
  })

  it('is told when it has turned, not when it comes to the same or only the element has changed', () => {
    const told: unknown[] = []
    const looking = new Looking({ tell: (...event: unknown[]) => void told.push(event) })
    const views = [1, 2, 3].map(zoom => readCameraView({ direction: [1, 0, 0], zoom }))
    const frame = (i: number) => looking.tell(() => ({ ...(views[i] as (typeof views)[0]) }), null)
    frame(0)
    frame(1)
    looking.hasTurned = true
    looking.tell(() => null, null)
    frame(0)
    expect(told).toEqual([])
    looking.hasTurned = true
    frame(2)
    frame(2)
    expect(told).toEqual([['hex-camera', views[2]]])
  })

  it('and so is a point, once', () => {
    const told: unknown[] = []
    const looking = new Looking({ tell: (...event: unknown[]) => void told.push(event) })
    const at = { point: [0, 0, 0], position: [1, 2, 3], jacdet: 0.5, exponent: 0 } as const
    const probe = { ...at, columns: [at.point, at.point, at.point], axisExponents: [0, 0, 0] } as const
    for (const each of [null, probe, { ...probe }, null, null]) looking.tell(() => null, each)
    expect(told).toEqual([
      ['hex-probe', at],
      ['hex-probe', null],
    ])
  })
})

describe('hidden faces', () => {
  it('are numbers from 0 to 5, all or none', () => {
    expect(readAttribute('hidden-faces', '5, 0', views)).toEqual([5, 0])
    expect(readAttribute('hidden-faces', 'all', views)).toHaveLength(6)
    expect(readAttribute('hidden-faces', '', views)).toEqual([])
    expect(() => readAttribute('hidden-faces', '6', views)).toThrow('“6” is none of 0, 1, 2, 3, 4, 5, all, none')
    expect(readAttribute('share', 'camera probe', views)).toEqual(['camera', 'probe'])
  })

  it('let the pointer through, but for one that the reader wants alone', () => {
    const cube = [0, 1].flatMap(z => [[0, 0, z] as const, [1, 0, z] as const, [1, 1, z] as const, [0, 1, z] as const])
    const ray = { origin: [0.25, 0.25, 5], direction: [0, 0, -1] } as const
    expect(hitFaces(cube, 'opaque', ray)?.face).toBe(5)
    expect(hitFaces(cube, 'opaque', ray, [5])?.face).toBe(4)
    expect(hitFaces(cube, 5, ray, [5])?.face).toBe(5)
    expect(drawnFaces('see-through', [0, 1, 2, 3])).toEqual([4, 5])
  })
})
