import { describe, expect, it } from 'vitest'
import type { JacobianReport } from '../../web/core/report'
import { edgeVertices, faces, type Vec3, type Vertices, vertexReference } from '../../web/model/hexahedron'
import { boxCorners, facesSeen, SIDE } from '../../web/scene/overlay/volume-box'
import { SceneCamera } from '../../web/scene/space/camera'
import { worldOf } from '../../web/scene/space/world'
import { cases, core, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { exactJacdet } from './exact'

const SEED = 20270117

function jacobianAt(vertices: Vertices, point: Vec3): JacobianReport {
  const result = core.jacobian(vertices, point)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function cornersOf(vertices: Vertices, point: Vec3): readonly Vec3[] {
  return boxCorners(jacobianAt(vertices, point), worldOf(vertices))
}

function way([from, to]: readonly [Vec3, Vec3]): Vec3 {
  return [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

function signedVolume(corners: readonly Vec3[]): number {
  const [u, v, w] = [1, 3, 4].map(k => way([corners[0], corners[k]] as [Vec3, Vec3])) as [Vec3, Vec3, Vec3]
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])
}

function* randomProbes(count: number) {
  const random = randomSource(SEED)
  for (let n = 0; n < count; n++) {
    const vertices = randomHexahedron(random, n % 2 === 0 ? 0.15 : 0.6)
    const point: [number, number, number] = [random(), random(), random()]
    // Mostly on a face, as pointed at.
    if (n % 4 > 0) point[n % 3] = n % 8 < 4 ? 0 : 1
    yield { vertices, point: point as Vec3, name: `seed ${SEED}, number ${n}` }
  }
}

describe('the volume box', () => {
  // u is 2^-53. In world space nothing is larger than 2, and columns are at most 2 long on each axis. A corner is a sum of three numbers
  // of at most 1/2 with up to 13 roundings each, and one of at most 1, so it is off by less than 2^5 u. The sides, at most SIDE 2 sqrt(3) < 1
  // long, are off by 2^6 u, and their determinant by less than 6 * 3 of those.
  const BOUND = 18 * 2 ** (6 - 53)

  it('has the signed volume SIDE^3 jacdet', () => {
    let negative = 0
    for (const { vertices, point, name } of randomProbes(2000)) {
      const { jacdet, exponent } = jacobianAt(vertices, point)
      expect(exponent).toBe(0)
      const volume = signedVolume(cornersOf(vertices, point))
      expect(Math.abs(volume - (SIDE ** 3 * jacdet) / worldOf(vertices).size ** 3), name).toBeLessThan(BOUND)
      if (jacdet < 0) negative++
    }
    expect(negative).toBeGreaterThan(100)
  })

  it('of the cube itself is a cube of that side, inside, around the point and on its faces', () => {
    const world = worldOf(unitCube)
    for (const { point, name } of randomProbes(200)) {
      const corners = cornersOf(unitCube, point).map(corner =>
        corner.map((x, axis) => x * world.size + (world.centre[axis] as number)),
      )
      vertexReference.forEach((reference, v) => {
        reference.forEach((end, axis) => {
          const expected = (point[axis] as number) * (1 - SIDE) + SIDE * end
          expect(corners[v]?.[axis], name).toBeCloseTo(expected, 14)
        })
      })
    }
  })

  it('has no side longer than a quarter of the longest edge', () => {
    for (const { vertices, point, name } of randomProbes(200)) {
      const longest = (points: readonly Vec3[]) =>
        Math.max(...edgeVertices.map(edge => Math.hypot(...way(edge.map(v => points[v]) as [Vec3, Vec3]))))
      const edge = longest(vertexReference.map((_, v) => vertices.slice(3 * v, 3 * v + 3) as unknown as Vec3))
      const side = longest(cornersOf(vertices, point)) * worldOf(vertices).size
      expect(side, name).toBeLessThanOrEqual((edge / 4) * (1 + 1e-12))
    }
  })

  it('is the same for elements of any size', () => {
    const vertices = [0, 1, 0, 1, 1, -4, 1, 4, -3, -2, -1, -2, -4, 1, 4, 4, -1, 4, 4, 1, 3, -2, 3, 1]
    const point: Vec3 = [0, 0.25, 0.5]
    const corners = cornersOf(vertices, point)
    for (const power of [-1000, -600, -1, 700, 1020]) {
      const scaled = vertices.map(x => x * 2 ** (power / 2) * 2 ** (power / 2))
      cornersOf(scaled, point).forEach((corner, v) => {
        corner.forEach((x, axis) => {
          expect(x, `2^${power}`).toBeCloseTo(corners[v]?.[axis] as number, 9)
        })
      })
    }
  })

  it('is a point where all columns vanish', () => {
    const corners = cornersOf(Array(24).fill(3), [1, 0.5, 0])
    expect(new Set(corners.map(String)).size).toBe(1)
  })
})

describe('a face of the box', () => {
  it('is seen from outside, or of a box inside out from inside, where its corners say so in space', () => {
    const camera = new SceneCamera()
    camera.resize(800, 600, { top: 0, right: 0, bottom: 0, left: 0 })
    const { x, y, z } = camera.three.position
    const eye: Vec3 = [x, y, z]
    let insideOut = 0
    for (const { vertices, point, name } of randomProbes(500)) {
      const corners = cornersOf(vertices, point)
      const { jacdet } = jacobianAt(vertices, point)
      const seen = facesSeen(
        corners.map(corner => camera.project(corner)),
        jacdet < 0,
      )
      const middle = corners.reduce<Vec3>(
        (sum, c) => [sum[0] + c[0] / 8, sum[1] + c[1] / 8, sum[2] + c[2] / 8],
        [0, 0, 0],
      )
      faces.forEach((face, f) => {
        const [a, b, c] = face.vertices.map(v => corners[v]) as [Vec3, Vec3, Vec3]
        // The eye is on the other side of the face than the middle, if their tetrahedra over it turn differently.
        const [s, t] = [way([a, b]), way([a, c])]
        const side = (p: Vec3) => {
          const w = way([a, p])
          return (
            w[0] * (s[1] * t[2] - s[2] * t[1]) + w[1] * (s[2] * t[0] - s[0] * t[2]) + w[2] * (s[0] * t[1] - s[1] * t[0])
          )
        }
        const isClear = Math.abs(side(eye)) > 1e-9 && Math.abs(side(middle)) > 1e-9
        if (isClear) expect(seen.includes(face), `${name}, face ${f}`).toBe(side(eye) < 0 !== side(middle) < 0)
      })
      if (jacdet < 0) insideOut++
    }
    expect(insideOut).toBeGreaterThan(50)
  })
})

describe('jacdet at a point', () => {
  const signAt = (vertices: Vertices, point: Vec3) =>
    Number(exactJacdet(vertices, point) > 0n) - Number(exactJacdet(vertices, point) < 0n)

  it('has the exact sign where doubles cancel', () => {
    const random = randomSource(SEED)
    let zero = 0
    let wrongInDoubles = 0
    for (let n = 0; n < 400; n++) {
      // The cube squeezed into a plane by thirds, which leaves rounding alone, or nothing.
      const [a, b] = [random(), n % 2 === 0 ? 1 / 3 : random()]
      const vertices = vertexReference.flatMap(([x, y, z]) => [x + a * z, y + b * z, (x + a * z) * b + (y + b * z) / 3])
      const point: Vec3 = [random(), random(), n % 3 === 0 ? 1 : random()]
      const { jacdet, columns } = jacobianAt(vertices, point)
      const sign = signAt(vertices, point)
      expect(Math.sign(jacdet), `seed ${SEED}, number ${n}`).toBe(sign)
      if (sign === 0) zero++
      const inDoubles = signedVolume([[0, 0, 0], columns[0], [0, 0, 0], columns[1], columns[2]])
      if (Math.sign(inDoubles) !== sign) wrongInDoubles++
    }
    expect(wrongInDoubles).toBeGreaterThan(20)
    expect(zero).toBeLessThan(400)
  })

  it('has the exact sign at the vertices and in the middle of the hardest elements', () => {
    for (const { name, vertices } of cases)
      for (const point of [...vertexReference, [0.5, 0.5, 0.5], [0.5, 0, 0.25]] as Vec3[])
        expect(Math.sign(jacobianAt(vertices.flat(), point).jacdet) + 0, `${name} at ${point}`).toBe(
          signAt(vertices.flat(), point),
        )
  })
})
