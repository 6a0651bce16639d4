import { describe, expect, it } from 'vitest'
import { edgeVertices, faces, type Vec3, vertexReference } from '../../web/model/hexahedron'
import { DEFAULT_DIRECTION, SceneCamera } from '../../web/scene/space/camera'
import { elementPoint, facePoint } from '../../web/scene/space/patches'
import { Sight } from '../../web/scene/space/sight'
import { verticesInWorld, worldOf } from '../../web/scene/space/world'
import { randomSource } from './random'

const cube = vertexReference.flat()
/** The unit cube with vertex 6 pushed in, which is far behind the front face. */
const pushed = cube.map((value, i) => (i >= 18 && i < 21 ? 0.3 : value))

function cameraOn(points: readonly Vec3[], direction: Vec3 = DEFAULT_DIRECTION): SceneCamera {
  const camera = new SceneCamera()
  camera.resize(900, 700, { top: 60, right: 150, bottom: 70, left: 90 })
  camera.fit(points, direction)
  camera.enclose(points)
  return camera
}

function sightOf(
  vertices: readonly number[],
  direction?: Vec3,
  display: 'opaque' | 'see-through' | 'inside' | number = 'opaque',
) {
  const points = verticesInWorld(worldOf(vertices), vertices)
  const camera = cameraOn(points, direction)
  return { points, camera, sight: new Sight(points, camera, display) }
}

const hiddenVertices = (sight: Sight) =>
  [...vertexReference.keys()].filter(v => sight.hides(vertexReference[v] as Vec3))

type Triangle = readonly [Vec3, Vec3, Vec3]
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

/** The faces as many flat triangles. */
function trianglesOf(points: readonly Vec3[], pieces: number): Triangle[] {
  const triangles: Triangle[] = []
  for (const face of faces.keys())
    for (let i = 0; i < pieces; i++)
      for (let j = 0; j < pieces; j++) {
        const at = (k: number, l: number) => facePoint(points, face, (i + k) / pieces, (j + l) / pieces)
        triangles.push([at(0, 0), at(1, 0), at(0, 1)], [at(1, 0), at(1, 1), at(0, 1)])
      }
  return triangles
}

/** The distance to the nearest triangle, by Moeller and Trumbore, in lengths of the way; Infinity if it meets none. */
function nearestHit(triangles: readonly Triangle[], from: Vec3, way: Vec3): number {
  let nearest = Infinity
  for (const [a, b, c] of triangles) {
    const [ab, ac, offset] = [minus(b, a), minus(c, a), minus(from, a)]
    const p = cross(way, ac)
    const det = dot(ab, p)
    const u = dot(offset, p) / det
    if (!(u >= 0 && u <= 1)) continue
    const q = cross(offset, ab)
    const v = dot(way, q) / det
    const distance = dot(ac, q) / det
    if (v >= 0 && u + v <= 1 && distance > 0) nearest = Math.min(nearest, distance)
  }
  return nearest
}

/** What many triangles say of a mark: hidden or seen, also from a little beside it; null if that differs. */
function saidByTriangles(triangles: readonly Triangle[], camera: SceneCamera, mark: Vec3): boolean | null {
  const { x, y, z } = camera.three.position
  const [right, up] = camera.axes()
  const said = new Set<boolean>()
  for (const [i, j] of [
    [0, 0],
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const) {
    const aim = mark.map((value, k) => value + 0.015 * (i * (right[k] as number) + j * (up[k] as number)))
    const way = minus(aim as unknown as Vec3, [x, y, z])
    const distance = nearestHit(triangles, [x, y, z], way)
    const before = (1 - distance) * Math.hypot(...way)
    // Beside the mark its own face is met near it, more in front the more it slants.
    for (const margin of i === 0 && j === 0 ? [0.003, 0.015] : [0.05, 0.2]) said.add(before > margin)
  }
  return said.size === 1 ? said.has(true) : null
}

describe('what faces hide', () => {
  it('is vertex 6 of the cube, pushed in, and its neighbour behind it', () => {
    expect(hiddenVertices(sightOf(cube).sight)).toEqual([3])
    expect(hiddenVertices(sightOf(pushed).sight)).toEqual([3, 6])
    expect(hiddenVertices(sightOf(pushed, [1, 1, 1]).sight)).toEqual([0])
  })

  it('is nothing where one can look through the faces, and what one face alone hides', () => {
    for (const display of ['see-through', 'inside'] as const)
      expect(hiddenVertices(sightOf(pushed, undefined, display).sight)).toEqual([])
    expect(hiddenVertices(sightOf(pushed, undefined, 2).sight)).toEqual([3, 6])
    // Its own face bulges before vertex 3.
    expect(hiddenVertices(sightOf(pushed, undefined, 3).sight)).toEqual([3])
    expect(hiddenVertices(sightOf(cube, undefined, 3).sight)).toEqual([])
  })

  it('is nothing on the near side, however thin or collapsed the element', () => {
    const wedge = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 0, 0, 1, 0]
    const plate = cube.map((value, i) => (i % 3 === 2 ? value * 1e-9 : value))
    const point = Array<number>(24).fill(3)
    for (const vertices of [wedge, plate, point]) {
      const { sight, points, camera } = sightOf(vertices)
      const nearest = Math.min(...points.map(at => camera.depth(at)))
      const front = [...vertexReference.keys()].filter(v => camera.depth(points[v] as Vec3) < nearest + 1e-6)
      expect(front.filter(v => sight.hides(vertexReference[v] as Vec3))).toEqual([])
    }
    expect(hiddenVertices(sightOf(point).sight)).toEqual([])
  })

  it('is the same far from the origin, and at any size', () => {
    for (const [factor, offset] of [
      [1, 1e8],
      [1e-200, 0],
      [1e200, 0],
    ] as const) {
      const { sight } = sightOf(pushed.map(value => value * factor + offset))
      expect(hiddenVertices(sight)).toEqual([3, 6])
    }
  })

  it('is what many triangles in front of a mark hide, on random elements from all sides', () => {
    const random = randomSource(20261130)
    const counts = { hidden: 0, seen: 0, undecided: 0 }
    for (let n = 0; n < 42; n++) {
      const vertices = cube.map(value => value + (n % 3) * 0.4 * (random() - 0.5))
      // The last ones each have two vertices of an edge at the same position.
      const [kept, moved] = edgeVertices[n - 30] ?? [0, 0]
      vertices.splice(3 * moved, 3, ...vertices.slice(3 * kept, 3 * kept + 3))
      const direction: Vec3 = [random() - 0.5, random() - 0.5, random() - 0.5]
      const { sight, points, camera } = sightOf(vertices, direction)
      const triangles = trianglesOf(points, 20)
      const onEdge = edgeVertices.map(([a, b]) => {
        const share = random()
        return (vertexReference[a] as Vec3).map((x, k) => x + share * ((vertexReference[b]?.[k] as number) - x))
      }) as unknown as Vec3[]
      const onFace = faces.map(({ axis, side }) => [random(), random(), random()].with(axis, side)) as unknown as Vec3[]
      for (const point of [...vertexReference, ...onEdge, ...onFace]) {
        const said = saidByTriangles(triangles, camera, elementPoint(points, point))
        counts[said === null ? 'undecided' : said ? 'hidden' : 'seen']++
        if (said !== null) expect(sight.hides(point), `element ${n}, point ${point}`).toBe(said)
      }
    }
    expect(counts.hidden).toBeGreaterThan(150)
    expect(counts.seen).toBeGreaterThan(150)
    expect(counts.undecided).toBeLessThan(350)
  })
})
