import { describe, expect, it } from 'vitest'
import { faces, type Vec3, vertexReference } from '../../web/model/hexahedron'
import { axisMoves, nextDisplay } from '../../web/scene/input/keyboard-input'
import { pickHandle, pickRadius } from '../../web/scene/input/picking'
import { VertexDrag } from '../../web/scene/input/vertex-drag'
import {
  FACE_QUADS,
  FACE_TILES,
  quadsPerTileFor,
  tilesOfFaces,
  writeIndices,
} from '../../web/scene/paint/faces-geometry'
import { DEFAULT_DIRECTION, SceneCamera } from '../../web/scene/space/camera'
import { addDecimal, gridStep, keyStep, lengthOf, roundingStep, roundTo } from '../../web/scene/space/decimal-step'
import { facePoint } from '../../web/scene/space/patches'
import { extentOf, toPhysical, toWorld, verticesInWorld, worldOf } from '../../web/scene/space/world'

const cube = vertexReference.flat()
const scaled = (factor: number, offset = 0) => cube.map(value => value * factor + offset)
const free = { axis: null, depth: false, snap: false } as const
const insets = { top: 50, right: 130, bottom: 70, left: 60 }

function cameraOn(vertices: readonly number[], width = 800, height = 600): SceneCamera {
  const camera = new SceneCamera()
  camera.resize(width, height, insets)
  camera.fit(verticesInWorld(worldOf(vertices), vertices), DEFAULT_DIRECTION)
  camera.enclose(verticesInWorld(worldOf(vertices), vertices))
  return camera
}

describe('world space', () => {
  it.each([1, 1e-300, 1e150, 1e307, 2 ** -1060])('fills [-1,1]^3 with a cube of side %d', side => {
    const vertices = scaled(side)
    for (const point of verticesInWorld(worldOf(vertices), vertices)) {
      for (const coordinate of point) expect(Math.abs(coordinate)).toBeCloseTo(1, 6)
    }
  })

  it('has room for the greatest doubles on both sides', () => {
    const vertices = cube.map(value => (value ? Number.MAX_VALUE : -Number.MAX_VALUE))
    for (const point of verticesInWorld(worldOf(vertices), vertices).flat()) expect(Math.abs(point)).toBeCloseTo(1)
    expect(extentOf(vertices)).toBe(Number.MAX_VALUE)
  })

  it('keeps a vertex far out of the picture finite, and in its direction', () => {
    for (const far of [1e30, 1e308, Number.MAX_VALUE]) {
      const [x, y, z] = toWorld(worldOf(cube), [far, -far, 0.5])
      expect(Number.isFinite(x) && x > 1e6).toBe(true)
      expect([y, z]).toEqual([-x, 0])
    }
  })

  it('takes eight equal points', () => {
    const world = worldOf(Array(24).fill(3))
    expect(toWorld(world, [3, 3, 4])).toEqual([0, 0, 1])
  })

  it('leads back to physical coordinates, never beyond the doubles', () => {
    const world = worldOf(scaled(10, 1e8))
    expect(toPhysical(world, toWorld(world, [1e8 + 3, 1e8, 1e8 + 10]))).toEqual([1e8 + 3, 1e8, 1e8 + 10])
    expect(toPhysical(worldOf(scaled(1e308)), [9, 0, 0])[0]).toBe(Number.MAX_VALUE)
  })
})

describe('the camera', () => {
  it.each([
    [800, 600],
    [390, 456],
    [1200, 400],
  ])('fits every vertex into what is free of %d x %d and touches its border', (width, height) => {
    const points = cameraOn(cube, width, height)
    const screen = verticesInWorld(worldOf(cube), cube).map(point => points.project(point))
    const gaps = screen.flatMap(({ x, y }) => [
      x - insets.left,
      width - insets.right - x,
      y - insets.top,
      height - insets.bottom - y,
    ])
    expect(Math.min(...gaps)).toBeGreaterThan(-1e-6)
    expect(Math.min(...gaps)).toBeLessThan(1e-6)
  })

  it('projects along its rays', () => {
    const camera = cameraOn(cube)
    const { origin, direction } = camera.ray(123, 456)
    const { x, y } = camera.project(origin.map((value, axis) => value + 3 * (direction[axis] as number)) as never)
    expect([x, y].map(Math.round)).toEqual([123, 456])
  })
})

describe('picking', () => {
  const at = (x: number, y: number, depth = 1) => ({ x, y, depth })

  it('takes the nearest handle in reach', () => {
    expect(pickHandle([at(0, 0), at(10, 0), at(30, 0)], { x: 8, y: 0 }, 12)).toBe(1)
    expect(pickHandle([at(0, 0)], { x: 12.1, y: 0 }, 12)).toBeNull()
    expect(pickHandle([], { x: 0, y: 0 }, 12)).toBeNull()
  })

  it('takes the front one of handles in one place, and none behind the eye', () => {
    expect(pickHandle([at(5, 5, 4), at(5, 5, 3), at(5.2, 5, 2)], { x: 5, y: 5 }, 12)).toBe(2)
    expect(pickHandle([at(5, 5, -1), at(9, 5, 3)], { x: 5, y: 5 }, 12)).toBe(1)
  })

  it('takes the selected one of vertices that coincide', () => {
    const places = [at(5, 5, 3), at(5, 5, 3), at(5, 5, 3)]
    expect(pickHandle(places, { x: 5, y: 5 }, 12)).toBe(0)
    expect(pickHandle(places, { x: 5, y: 5 }, 12, 2)).toBe(2)
    expect(pickHandle([at(5, 5, 2), ...places], { x: 5, y: 5 }, 12, 2)).toBe(0)
  })

  it('reaches farther for a finger', () => {
    expect(pickRadius('touch')).toBe(22)
    expect(pickRadius('mouse')).toBe(12)
    expect(pickRadius('pen')).toBe(12)
  })
})

describe('decimal steps', () => {
  it('round to the double that the decimal names', () => {
    expect(roundTo(0.30000000000000004, { digits: 1, exponent: -1 })).toBe(0.3)
    expect(roundTo(0.62, { digits: 25, exponent: -2 })).toBe(0.5)
    expect(Object.is(roundTo(-0.01, { digits: 1, exponent: -1 }), 0)).toBe(true)
    expect(roundTo(123456789.123456, { digits: 1, exponent: -12 })).toBe(123456789.123456)
    expect(addDecimal(0.1, 0.2)).toBe(0.3)
    expect(addDecimal(Number.MAX_VALUE, Number.MAX_VALUE)).toBe(Number.MAX_VALUE)
  })

  it('follow the size of a pixel and of the element', () => {
    expect(lengthOf(roundingStep(0.0042))).toBe(0.001)
    expect(lengthOf(roundingStep(0))).toBeGreaterThan(0)
    expect(lengthOf(keyStep(1))).toBe(0.01)
    expect([0.99, 1, 2, 4, 9].map(extent => lengthOf(gridStep(extent)))).toEqual([0.025, 0.1, 0.1, 0.25, 0.25])
  })
})

describe('dragging', () => {
  const drag = (keys: Parameters<VertexDrag['moveTo']>[2], dx: number, dy: number, vertices = cube, vertex = 6) => {
    const camera = cameraOn(vertices)
    const world = worldOf(vertices)
    const position = vertices.slice(3 * vertex, 3 * vertex + 3) as unknown as Vec3
    const { x, y } = camera.project(toWorld(world, position))
    const to = new VertexDrag({ camera, world, position, extent: extentOf(vertices), x: x + 5, y: y - 3 }).moveTo(
      x + 5 + dx,
      y - 3 + dy,
      keys,
    )
    const seen = camera.project(toWorld(world, to))
    const depths = [position, to].map(point => camera.depth(toWorld(world, point))) as [number, number]
    return { to, moved: [seen.x - x, seen.y - y] as const, depths }
  }

  it('keeps the grabbed point under the pointer, at the same depth', () => {
    const { moved, depths } = drag(free, 70, -40)
    expect(moved[0]).toBeCloseTo(70, 0)
    expect(moved[1]).toBeCloseTo(-40, 0)
    expect(depths[1]).toBeCloseTo(depths[0], 2)
  })

  it('gives numbers with no more digits than a pixel can tell', () => {
    for (const value of drag(free, 71, -43).to) expect(value).toBe(Number(value.toFixed(3)))
  })

  it.each([0, 1, 2] as const)('held to axis %d leaves the other coordinates as they were, to the last bit', axis => {
    const vertices = cube.map(value => value / 3)
    const { to } = drag({ ...free, axis }, 60, -60, vertices)
    for (const other of [0, 1, 2].filter(k => k !== axis)) expect(to[other]).toBe(1 / 3)
    expect(to[axis]).not.toBe(1 / 3)
  })

  it('in depth moves along the line of sight, up being away', () => {
    const { moved, depths } = drag({ ...free, depth: true }, 0, -100)
    expect(moved[0]).toBeCloseTo(0, 0)
    expect(moved[1]).toBeCloseTo(0, 0)
    expect(depths[1]).toBeGreaterThan(depths[0])
  })

  it('snaps to multiples of the grid', () => {
    for (const value of drag({ ...free, snap: true }, 60, 80).to) expect(value).toBe(Number(value.toFixed(1)))
  })

  it.each([1e-300, 1e150])('works at size %d', size => {
    const { to, moved } = drag(free, 50, 20, scaled(size))
    expect(moved[0]).toBeCloseTo(50, 0)
    for (const value of to) expect(Number.isFinite(value)).toBe(true)
  })
})

describe('the keyboard', () => {
  it('gives right, up and depth an axis each, whatever the view', () => {
    const camera = new SceneCamera()
    for (let turn = 0; turn < 40; turn++) {
      camera.three.position.set(Math.cos(turn) * 4, Math.sin(turn) * 4, Math.sin(turn * 1.7) * 6)
      camera.three.lookAt(0, 0, 0)
      camera.three.updateMatrixWorld()
      const moves = axisMoves(camera.axes())
      expect(moves.map(move => move.axis).sort()).toEqual([0, 1, 2])
    }
  })

  it('in the default view moves right along x, up along z, nearer against y', () => {
    expect(axisMoves(cameraOn(cube).axes())).toEqual([
      { axis: 0, sign: 1 },
      { axis: 2, sign: 1 },
      { axis: 1, sign: -1 },
    ])
  })

  it('goes through the faces one by one and back to all', () => {
    expect(nextDisplay('opaque', 1)).toBe(0)
    expect(nextDisplay(5, 1)).toBe('opaque')
    expect(nextDisplay('see-through', -1)).toBe(5)
    expect(nextDisplay(0, -1)).toBe('opaque')
  })
})

describe('the faces’ grid', () => {
  const side = FACE_QUADS + 1
  const indicesOf = (order: readonly number[], quadsPerTile: number) => {
    const indices = new Uint16Array(faces.length * FACE_QUADS ** 2 * 6)
    return indices.subarray(0, writeIndices(indices, tilesOfFaces(order), quadsPerTile))
  }

  it.each([1, 2, 4])('covers each face once, in the order asked for, %i quads along a tile', quadsPerTile => {
    const order = [4, 2, 0, 1, 5, 3]
    const indices = indicesOf(order, quadsPerTile)
    const quads = FACE_TILES * quadsPerTile
    expect(indices).toHaveLength(faces.length * quads ** 2 * 6)
    const perFace = indices.length / faces.length
    order.forEach((face, place) => {
      const [found, areas, triangles] = [new Set<number>(), new Set<number>(), new Set<string>()]
      for (let i = place * perFace; i < (place + 1) * perFace; i += 3) {
        const [a, b, c] = [...indices.subarray(i, i + 3)].map(index => {
          found.add(Math.floor(index / side ** 2))
          return [Math.floor((index % side ** 2) / side), index % side]
        }) as [[number, number], [number, number], [number, number]]
        areas.add((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        triangles.add(String([a, b, c]))
      }
      expect([...found]).toEqual([face])
      expect([...areas]).toEqual([(FACE_QUADS / quads) ** 2])
      expect(triangles.size).toBe(perFace / 3)
    })
  })

  it('is as fine as the twist asks for: an eighth of a pixel off at most, until it is at its finest', () => {
    for (const twist of [0, 1, 10, 32, 33, 100, 128, 129, 500]) {
      const quads = FACE_TILES * quadsPerTileFor(twist)
      expect(twist / (4 * quads ** 2)).toBeLessThanOrEqual(1 / 8)
      if (quads > FACE_TILES) expect(twist / quads ** 2).toBeGreaterThan(1 / 8)
    }
    expect(quadsPerTileFor(1e6) * FACE_TILES).toBe(FACE_QUADS)
  })

  it('has the corners of a face at its vertices', () => {
    faces.forEach((face, id) => {
      const corners = [
        [0, 0],
        [1, 0],
        [0, 1],
        [1, 1],
      ].map(([s, t]) => facePoint(vertexReference, id, s as number, t as number))
      expect(corners).toEqual(face.vertices.map(vertex => vertexReference[vertex]))
    })
  })
})
