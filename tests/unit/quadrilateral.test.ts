/** Quadrilaterals in the plane: their jacdet is affine, so the corners decide, as the core says of them drawn out. */
import { describe, expect, it } from 'vitest'
import { vertexOf } from '../../web/model/hexahedron'
import { below, imagePath, zeroLine } from '../../web/pages/lessons/plane/bands'
import {
  baseOf,
  columnsAt,
  cornerJacdets,
  cornerReference,
  drawnOut,
  jacdetAt,
  pointAt,
  preimages,
  type Quadrilateral,
  type Vec2,
} from '../../web/pages/lessons/plane/quadrilateral'
import { core, randomSource } from './core-fixtures'

const square = cornerReference

/** Corners in sixteenths: products and sums of these are exact. */
function quadrilaterals(seed: number, count: number): Quadrilateral[] {
  const random = randomSource(seed)
  const coordinate = () => Math.round(64 * random() - 32) / 16 + 0
  const corner = (): Vec2 => [coordinate(), coordinate()]
  return Array.from({ length: count }, () => [corner(), corner(), corner(), corner()])
}

function reportOf(quadrilateral: Quadrilateral) {
  const result = core.analyze(drawnOut(quadrilateral))
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

const grid = Array.from({ length: 81 }, (_, i): Vec2 => [(i % 9) / 8, Math.floor(i / 9) / 8])

describe('the map', () => {
  it('takes the corners of the square to the corners given', () => {
    for (const given of quadrilaterals(1, 50))
      for (const [i, corner] of square.entries()) expect(pointAt(given, corner)).toEqual(given[i])
  })

  it('has these columns, which differences agree with exactly: along a coordinate it is linear', () => {
    for (const given of quadrilaterals(2, 50))
      for (const point of [[0.25, 0.5] as const, [0.75, 0.125] as const]) {
        const [xi, eta] = columnsAt(given, point)
        const [from, right, up] = [
          point,
          [point[0] + 0.25, point[1]] as const,
          [point[0], point[1] + 0.25] as const,
        ].map(p => pointAt(given, p)) as [Vec2, Vec2, Vec2]
        expect(xi).toEqual([4 * (right[0] - from[0]), 4 * (right[1] - from[1])])
        expect(eta).toEqual([4 * (up[0] - from[0]), 4 * (up[1] - from[1])])
      }
  })

  it('is inverted: every point of the square is among the preimages of its image', () => {
    for (const given of [square, ...quadrilaterals(3, 200)])
      for (const point of grid) {
        // Near a fold the two preimages nearly coincide: rounding by e moves them by the root of e.
        if (Math.abs(jacdetAt(given, point)) < 1e-3) continue
        const found = preimages(given, pointAt(given, point))
        const distances = found.map(([xi, eta]) => Math.hypot(xi - point[0], eta - point[1]))
        expect(Math.min(...distances), JSON.stringify([given, point])).toBeLessThan(1e-6)
        const jacdets = found.map(p => jacdetAt(given, p))
        expect(jacdets).toEqual(jacdets.toSorted((a, b) => a - b))
      }
    expect(preimages(square, [1.5, 0.5])).toEqual([])
    expect(
      preimages(
        [
          [0, 0],
          [0, 0],
          [0, 0],
          [0, 0],
        ],
        [0, 0],
      ),
    ).toEqual([])
  })
})

describe('its jacdet', () => {
  it('is affine: each value is the corners’ by their weights', () => {
    for (const given of quadrilaterals(4, 200)) {
      const [j0, j1, j2, j3] = cornerJacdets(given) as [number, number, number, number]
      expect(j0 + j2).toBe(j1 + j3)
      for (const [xi, eta] of grid)
        expect(jacdetAt(given, [xi, eta]) === j0 + xi * (j1 - j0) + eta * (j3 - j0)).toBe(true)
    }
  })

  it('is that of the core on the quadrilateral drawn out, whose least and greatest values are at corners', () => {
    for (const given of quadrilaterals(5, 300)) {
      const jacdets = cornerJacdets(given)
      const { boundaryMinimum, boundaryMaximum, exponent, valid } = reportOf(given)
      expect(boundaryMinimum * 2 ** exponent).toBe(Math.min(...jacdets))
      expect(boundaryMaximum * 2 ** exponent).toBe(Math.max(...jacdets))
      expect(valid).toBe(Math.min(...jacdets) > 0)
    }
  })

  it('is at a corner twice the area of the triangle with its neighbours, and zero in line with them', () => {
    for (const x of [-0.5, 0.25, 0.5, 1.25]) {
      const given: Quadrilateral = [
        [0, 0],
        [1, 0],
        [x, 1 - x],
        [0, 1],
      ]
      expect(cornerJacdets(given)[2]).toBe(0)
    }
  })
})

it('drawn out and back is the same', () => {
  for (const given of quadrilaterals(6, 20)) {
    const vertices = drawnOut(given)
    expect(baseOf(vertices)).toEqual(given)
    for (let v = 0; v < 4; v++) expect(vertexOf(vertices, v + 4)).toEqual([...vertexOf(vertices, v).slice(0, 2), 1])
  }
})

describe('parts below a value', () => {
  const folded: Quadrilateral = [
    [0, 0],
    [1, 0],
    [0.25, 0.25],
    [0, 1],
  ]

  it('are where jacdet is at most a value: as much of the square as random points say, exactly at corners', () => {
    const random = randomSource(8)
    const points = Array.from({ length: 400 }, (): Vec2 => [random(), random()])
    for (const given of [square, folded, ...quadrilaterals(7, 60)]) {
      const jacdets = cornerJacdets(given)
      const [least, greatest] = [Math.min(...jacdets), Math.max(...jacdets)]
      expect(areaOf(below(given, greatest))).toBe(1)
      expect(below(given, least - 1)).toEqual([])
      for (const way of [0.25, 0.5, 0.75]) {
        const level = least + way * (greatest - least)
        const region = below(given, level)
        // Rounding of values of size 64 at most, and of a division.
        for (const point of region) expect(jacdetAt(given, point)).toBeLessThanOrEqual(level + 1e-12)
        const share = points.filter(point => jacdetAt(given, point) <= level).length / points.length
        // Five standard deviations of 400 points.
        if (least < greatest) expect(Math.abs(areaOf(region) - share)).toBeLessThan(0.125)
      }
    }
  })

  it('end at zero in a straight line, whose image is one curve through the images of its points', () => {
    const line = zeroLine(folded) as readonly [Vec2, Vec2]
    for (const end of line) expect(jacdetAt(folded, end)).toBeCloseTo(0, 12)
    const path = imagePath(folded, line, point => point)
    const [x0, y0, cx, cy, x1, y1] = (path.match(/-?[\d.]+/g) as string[]).map(Number) as [
      number,
      number,
      number,
      number,
      number,
      number,
    ]
    const [mx, my] = pointAt(folded, [(line[0][0] + line[1][0]) / 2, (line[0][1] + line[1][1]) / 2])
    expect((x0 + 2 * cx + x1) / 4).toBeCloseTo(mx, 1)
    expect((y0 + 2 * cy + y1) / 4).toBeCloseTo(my, 1)
    expect(zeroLine(square)).toBeNull()
    // Zero at a corner alone is no line.
    expect(
      zeroLine([
        [0, 0],
        [1, 0],
        [0.5, 0.5],
        [0, 1],
      ]),
    ).toBeNull()
  })
})

function areaOf(region: readonly Vec2[]): number {
  return region.reduce((sum, [x, y], i) => {
    const [nx, ny] = region[(i + 1) % region.length] as Vec2
    return sum + (x * ny - nx * y) / 2
  }, 0)
}
