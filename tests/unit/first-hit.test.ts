import { describe, expect, test } from 'vitest'
import { FaceBins } from '../../web/mesh-scene/face-bins'
import { firstHit } from '../../web/mesh-scene/ray'
import type { Vec3 } from '../../web/model/hexahedron'
import type { Ray } from '../../web/scene/space/camera'
import type { FaceList } from '../../web/survey/survey-jobs'
import { randomSource } from './random'

const seed = 20
const next = randomSource(seed)
const within = (least: number, greatest: number) => least + (greatest - least) * next()
const point = (size: number): Vec3 => [within(-size, size), within(-size, size), within(-size, size)]
const moved = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]

function listOf(faces: readonly (readonly Vec3[])[], cellMiddles: readonly Vec3[] | null): FaceList {
  const vertices = new Float32Array(20 * faces.length)
  for (const [face, corners] of faces.entries()) {
    const middle = [0, 1, 2].map(axis => corners.reduce((sum, corner) => sum + (corner[axis as 0] as number), 0) / 4)
    for (const [vertex, own] of [...corners, middle].entries()) vertices.set(own, 20 * face + 4 * vertex)
  }
  const middles = cellMiddles && Float32Array.from(cellMiddles.flatMap(middle => Array(5).fill(middle).flat()))
  const cells = Uint32Array.from(faces.keys())
  return { vertices, middles, cells, origin: [0, 0, 0], shown: faces.length, wanted: faces.length }
}

/** Faces of sizes from a thousandth to all of the space; every second one is flat along an axis. */
function randomFaces(count: number): Vec3[][] {
  return Array.from({ length: count }, () => {
    const size = 10 ** within(-3, 0)
    const about = point(1)
    const flat = Math.floor(6 * next())
    return [0, 1, 2, 3].map(
      () => moved(about, point(size)).with(flat % 3, flat < 3 ? about[flat as 0] : next()) as unknown as Vec3,
    )
  })
}

function binsOf(faces: FaceList, chunk: number): FaceBins[] {
  const bins: FaceBins[] = []
  for (let first = 0; first < faces.cells.length; first += chunk)
    bins.push(new FaceBins(faces, first, Math.min(chunk, faces.cells.length - first)))
  return bins
}

/** From outside and from within, some along an axis. */
function randomRay(i: number): Ray {
  const origin = point(i % 5 === 0 ? 1 : 4)
  if (i % 3 === 0)
    return { origin: point(1), direction: [0, 0, 0].with((i % 9) / 3, i % 2 ? 4 : -4) as unknown as Vec3 }
  const to = point(1)
  return { origin, direction: [to[0] - origin[0], to[1] - origin[1], to[2] - origin[2]] }
}

describe('the face that a ray meets first', () => {
  for (const size of [1, 0.5])
    test(`is the nearest of all, drawn in ${size} of its size: seed ${seed}`, () => {
      const faces = randomFaces(700)
      const list = listOf(faces, size === 1 ? null : faces.map(([corner]) => moved(corner as Vec3, point(0.5))))
      const bins = binsOf(list, 256)
      const all = { meet: (_: Ray, __: number, look: (face: number) => number) => void list.cells.forEach(look) }
      const hidden = Uint8Array.from(list.cells, () => (next() < 0.3 ? 1 : 0))
      let met = 0
      for (let i = 0; i < 900; ++i) {
        const ray = randomRay(i)
        const own =
          i % 2 ? null : Uint8Array.from({ length: 5 * hidden.length }, (_, at) => hidden[Math.floor(at / 5)] as number)
        const hit = firstHit({ faces: list, bins }, own, ray, size)
        expect(hit?.distance).toBe(firstHit({ faces: list, bins: [all] }, own, ray, size)?.distance)
        if (hit) met++
        if (hit && own) expect(hidden[hit.face]).toBe(0)
      }
      expect(met).toBeGreaterThan(300)
    })

  test('is looked for among few, whatever the order of the faces', () => {
    const side = 100
    const places = Array.from({ length: side * side }, (_, at) => ({ at, by: next() })).sort((a, b) => a.by - b.by)
    const faces = places.map(({ at }) => {
      const [x, y] = [at % side, Math.floor(at / side)]
      return [
        [x, y, 0],
        [x + 1, y, 0],
        [x + 1, y + 1, 0],
        [x, y + 1, 0],
      ] as Vec3[]
    })
    const list = listOf(faces, null)
    let looks = 0
    for (const bins of binsOf(list, list.cells.length))
      bins.meet({ origin: [40.3, 70.6, 9], direction: [0.1, 0, -1] }, Infinity, () => {
        looks++
        return Infinity
      })
    expect(looks).toBeGreaterThan(0)
    expect(looks).toBeLessThan(300)
  })
})
