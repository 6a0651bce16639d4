import { describe, expect, it } from 'vitest'
import type { Candidate, Report } from '../../web/core/report'
import { faces, type Vec3, vertexReference } from '../../web/model/hexahedron'
import { hitFaces, pointUnder, referenceOf } from '../../web/scene/input/face-hit'
import { nextCandidate } from '../../web/scene/input/probe-input'
import { DEFAULT_DIRECTION, type Ray, SceneCamera } from '../../web/scene/space/camera'
import { facePoint, patchPoint, sectionCorners } from '../../web/scene/space/patches'
import { bernsteinRoots } from '../../web/scene/space/sight'
import { verticesInWorld, worldOf } from '../../web/scene/space/world'

const cube = vertexReference
const twisted: readonly Vec3[] = [
  [0, 1, 0],
  [1, 1, -0.4],
  [1, 1.4, 0.3],
  [-0.2, 1.9, -0.2],
  [-0.1, 0.1, 1.2],
  [1.4, -0.1, 1],
  [1, 1, 0.8],
  [-0.2, 1.3, 1],
]

function rayTo(origin: Vec3, to: Vec3): Ray {
  const way = to.map((x, k) => x - (origin[k] as number))
  const length = Math.hypot(...way)
  return { origin, direction: way.map(x => x / length) as unknown as Vec3 }
}

/** Random numbers, even enough, and the same in every run. */
function* randoms(seed: number): Generator<number, never> {
  for (let x = seed; ; ) {
    x = (Math.imul(x, 1664525) + 1013904223) >>> 0
    yield x / 2 ** 32
  }
}

describe('a line of sight', () => {
  it('meets the near side of a cube at the very point', () => {
    const hit = hitFaces(cube, 'opaque', rayTo([5, 0.25, 0.75], [0, 0.25, 0.75]))
    expect(hit).toMatchObject({ face: 1, s: 0.25, t: 0.75, distance: 4 })
    expect(hit && referenceOf(hit)).toEqual([1, 0.25, 0.75])
    expect(hitFaces(cube, 0, rayTo([5, 0.25, 0.75], [0, 0.25, 0.75]))).toMatchObject({ face: 0, distance: 5 })
    expect(hitFaces(cube, 2, rayTo([5, 0.25, 0.75], [0, 0.25, 0.75]))).toBeNull()
  })

  it('meets nothing beside the element, nor behind the eye', () => {
    expect(hitFaces(cube, 'opaque', rayTo([5, 1.25, 0.75], [0, 1.25, 0.75]))).toBeNull()
    expect(hitFaces(cube, 'opaque', rayTo([5, 0.25, 0.75], [6, 0.25, 0.75]))).toBeNull()
  })

  it('through any point of any face meets that point or one before it', () => {
    const random = randoms(20261122)
    const next = () => random.next().value
    for (let n = 0; n < 3000; n++) {
      const face = n % faces.length
      const [s, t] = [next(), next()]
      const eye: Vec3 = [12 * next() - 6, 12 * next() - 6, 12 * next() - 6]
      const point = facePoint(twisted, face, s, t)
      const ray = rayTo(eye, point)
      const distance = Math.hypot(...point.map((x, k) => x - (eye[k] as number)))
      const hit = hitFaces(twisted, 'opaque', ray)
      const alone = hitFaces(twisted, face, ray)
      const seed = `case ${n}`
      expect(hit?.distance, seed).toBeLessThan(distance + 1e-7)
      expect(alone?.distance, seed).toBeLessThan(distance + 1e-7)
      for (const found of [hit, alone]) {
        if (!found) continue
        const there = facePoint(twisted, found.face, found.s, found.t)
        const onRay = ray.origin.map((x, k) => x + (ray.direction[k] as number) * found.distance)
        expect(Math.hypot(...there.map((x, k) => x - (onRay[k] as number))), seed).toBeLessThan(1e-6)
      }
    }
  })

  it('does not slip through an edge or a vertex', () => {
    const eye: Vec3 = [4.3, -5.1, 3.7]
    for (let n = 0; n <= 1000; n++) {
      const on = n / 1000
      expect(hitFaces(cube, 'opaque', rayTo(eye, [1, on, 1]))).not.toBeNull()
      expect(hitFaces(twisted, 'opaque', rayTo(eye, facePoint(twisted, 1, 1, on)))).not.toBeNull()
    }
  })

  it('meets a saddle that it goes through twice at the nearer point', () => {
    const saddle = cube.map((point, v): Vec3 => (v === 5 || v === 7 ? [point[0], point[1], 1.5] : point))
    // z = 1 + s (1 - s) along the diagonal.
    const hit = hitFaces(saddle, 5, rayTo([-4, -4, 1.16], [0, 0, 1.16]))
    expect(hit?.s).toBeCloseTo(0.2, 12)
    expect(hit?.t).toBeCloseTo(0.2, 12)
  })

  it('takes a collapsed element: of faces in one place the first, of eight equal points none', () => {
    const flat = cube.map(([x, y]): Vec3 => [x, y, 0])
    expect(hitFaces(flat, 'opaque', rayTo([0.3, 0.6, 4], [0.3, 0.6, 0]))).toMatchObject({ face: 4 })
    const point = Array<Vec3>(8).fill([0, 0, 0])
    expect(() => hitFaces(point, 'opaque', rayTo([0, 0, 4], [0, 0, 0]))).not.toThrow()
    expect(hitFaces(point, 'opaque', rayTo([0, 0, 4], [1, 1, 0]))).toBeNull()
  })
})

describe('roots of a quadratic in Bernstein form', () => {
  it.each([
    [[-1, 0, 1], [0.5]],
    [
      [0, 1, 0],
      [0, 1],
    ],
    [
      [3, -5, 3],
      [0.25, 0.75],
    ],
    [[1, -1e-9, -1e9], [3.16227766e-5]],
    [[1, 1, 1], []],
    [[0, 0, 0], []],
  ] as const)('%o vanishes at %o', ([c0, c1, c2], expected) => {
    const within = bernsteinRoots(c0, c1, c2)
      .filter(root => root >= 0 && root <= 1)
      .sort((a, b) => a - b)
    expect(within).toHaveLength(expected.length)
    within.forEach((root, i) => {
      expect(root).toBeCloseTo(expected[i] as number, 8)
    })
  })
})

describe('what a pointer points at', () => {
  const camera = new SceneCamera()
  camera.resize(800, 600, { top: 0, right: 0, bottom: 0, left: 0 })
  const vertices = verticesInWorld(worldOf(cube.flat()), cube.flat())
  camera.fit(vertices, DEFAULT_DIRECTION)
  camera.enclose(vertices)
  const handles = vertices.map(point => camera.project(point))
  const drawn = {
    camera,
    vertices,
    handles,
    state: { faceDisplay: 'opaque', section: { axis: 2, value: 0.5 }, selectedVertex: 0 } as const,
  }

  it('is a vertex where its handle is, else a face, to the thousandths that a pixel can tell', () => {
    handles.forEach(({ x, y }, v) => {
      expect(pointUnder(drawn, x + 5, y - 5)).toEqual(vertexReference[v])
    })
    const { x, y } = camera.project(facePoint(vertices, 2, 0.3141592, 0.7182818))
    const [xi = 0, eta, zeta = 0] = pointUnder(drawn, x, y) ?? []
    expect([xi, eta, zeta]).toEqual([0.314, 0, 0.718])
    expect(pointUnder(drawn, 5, 5)).toBeNull()
  })
})

describe('what a pointer points at where the inside is shown', () => {
  const camera = new SceneCamera()
  camera.resize(800, 600, { top: 0, right: 0, bottom: 0, left: 0 })
  const vertices = verticesInWorld(worldOf(twisted.flat()), twisted.flat())
  camera.fit(vertices, DEFAULT_DIRECTION)
  camera.enclose(vertices)
  const handles = vertices.map(point => camera.project(point))

  it('is a point of the section, through the faces before it', () => {
    for (const axis of [0, 1, 2] as const) {
      const section = { axis, value: 0.375 }
      const state = { faceDisplay: 'inside', section, selectedVertex: 0 } as const
      const corners = sectionCorners(vertices, section)
      const { x, y } = camera.project(patchPoint(corners, 0.3, 0.6))
      const point = pointUnder({ camera, vertices, handles, state }, x, y) as Vec3
      expect(point[axis]).toBe(0.375)
      const again = camera.project(patchPoint(corners, ...(point.toSpliced(axis, 1) as unknown as [number, number])))
      expect(Math.hypot(again.x - x, again.y - y)).toBeLessThan(1)
      expect(pointUnder({ camera, vertices, handles, state }, 5, 5)).toBeNull()
    }
  })
})

describe('going through the candidates', () => {
  const at = (id: number, point: Vec3) => ({ kind: 'vertex', id, point, position: point, value: id }) as Candidate
  const candidates = vertexReference.map((point, v) => at(v, point))
  const report = { candidates: [...candidates, at(9, [0, 0, 0])], minimizer: candidates[3] } as unknown as Report

  it('begins with the minimizer, visits each point once, and begins again', () => {
    const visited: number[] = []
    let probe: Vec3 | null = [0.5, 0.5, 0.5]
    for (let n = 0; n < 9; n++) {
      const next: Candidate = nextCandidate(report, probe)
      visited.push(next.id)
      probe = next.point
    }
    expect(visited).toEqual([3, 0, 1, 2, 4, 5, 6, 7, 3])
  })
})
