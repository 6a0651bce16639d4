import { describe, expect, it } from 'vitest'
import { axesOn, gradientInside, pointOn, sectionBernstein, valueInside } from '../../web/core/section'
import { type Surface, zeroSurface } from '../../web/core/zero-surface'
import { type Axis, faces, type Vec3 } from '../../web/model/hexahedron'
import { presets, presetVertices } from '../../web/model/presets'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'

function reportOf(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function presetReport(id: string) {
  const preset = presets.find(candidate => candidate.id === id)
  if (!preset) throw new Error(`There is no preset ${id}.`)
  return reportOf(presetVertices(preset))
}

const random = randomSource(20260701)
const awkward = Array.from({ length: 20 }, () => reportOf(randomHexahedron(random, 0.5)))
const axes: readonly Axis[] = [0, 1, 2]

function largest(bernstein: readonly number[]): number {
  return Math.max(...bernstein.map(Math.abs))
}

describe('a section', () => {
  it('at 0 and 1 has the coefficients of the face there', () => {
    for (const { bernstein, faces: reports } of awkward) {
      for (const { axis, side } of faces) {
        const face = reports[2 * axis + side]
        const section = sectionBernstein(bernstein, axis, side)
        section.forEach((value, k) => {
          expect(value).toBeCloseTo(face?.bernstein[k] as number, 12)
        })
      }
    }
  })

  it('has the values of the element, and its points lie on it', () => {
    for (const { bernstein, vertices } of awkward) {
      for (const axis of axes) {
        const [value, s, t] = [random(), random(), random()]
        const point = pointOn(axis, value, s, t)
        expect(axesOn(axis).map(a => point[a])).toEqual([s, t])
        expect(point[axis]).toBe(value)
        const probe = core.jacobian(vertices, point)
        const jacdet = probe.ok ? probe.value.jacdet : Number.NaN
        expect(Math.abs(valueInside(bernstein, point) - jacdet)).toBeLessThan(1e-13 * largest(bernstein))
        const nine = sectionBernstein(bernstein, axis, value)
        const basis = (x: number) => [(1 - x) ** 2, 2 * x * (1 - x), x ** 2]
        const sum = nine.reduce(
          (total, b, k) => total + b * (basis(s)[Math.floor(k / 3)] as number) * (basis(t)[k % 3] as number),
          0,
        )
        expect(Math.abs(sum - jacdet)).toBeLessThan(1e-13 * largest(bernstein))
      }
    }
  })
})

describe('the gradient of jacdet', () => {
  it('is the slope of its values, which a central difference gives exactly but for rounding', () => {
    for (const { bernstein } of awkward) {
      const point = [0, 1, 2].map(() => 0.1 + 0.8 * random()) as unknown as Vec3
      // Along an axis jacdet is a parabola, whose central differences are its slopes.
      const along = axes.map(axis => {
        const beside = (way: number) => valueInside(bernstein, point.with(axis, point[axis] + way) as unknown as Vec3)
        return (beside(2 ** -4) - beside(-(2 ** -4))) / 2 ** -3
      })
      gradientInside(bernstein, point).forEach((slope, axis) => {
        expect(Math.abs(slope - (along[axis] as number))).toBeLessThan(1e-12 * largest(bernstein))
      })
    }
  })
})

function pointOf({ points }: Surface, vertex: number): Vec3 {
  return [points[3 * vertex] as number, points[3 * vertex + 1] as number, points[3 * vertex + 2] as number]
}

/** Edges that belong to one triangle only. */
function openEdges({ triangles }: Surface): (readonly [number, number])[] {
  const open = new Map<string, readonly [number, number]>()
  for (let i = 0; i < triangles.length; i += 3) {
    for (const [from, to] of [
      [0, 1],
      [1, 2],
      [2, 0],
    ] as const) {
      const edge = [triangles[i + from] as number, triangles[i + to] as number] as const
      const opposite = `${edge[1]} ${edge[0]}`
      if (!open.delete(opposite)) open.set(edge.join(' '), edge)
    }
  }
  return [...open.values()]
}

describe('the surface jacdet = 0', () => {
  it('lies in the cube, its vertices on the zero', () => {
    const surfaces = awkward.map(({ bernstein }) => ({ bernstein, surface: zeroSurface(bernstein, 10) }))
    expect(surfaces.filter(({ surface }) => surface.triangles.length > 0).length).toBeGreaterThan(10)
    for (const { bernstein, surface } of surfaces) {
      expect(surface.points.every(x => x >= 0 && x <= 1)).toBe(true)
      for (let v = 0; 3 * v < surface.points.length; v++) {
        expect(Math.abs(valueInside(bernstein, pointOf(surface, v)))).toBeLessThan(1e-4 * largest(bernstein))
      }
    }
  })

  it('has the positive side in front', () => {
    for (const { bernstein } of awkward) {
      const surface = zeroSurface(bernstein, 12)
      let [right, wrong] = [0, 0]
      for (let i = 0; i < surface.triangles.length; i += 3) {
        const [p, q, r] = [0, 1, 2].map(k => pointOf(surface, surface.triangles[i + k] as number)) as [Vec3, Vec3, Vec3]
        const u = q.map((x, a) => x - (p[a] as number)) as unknown as Vec3
        const v = r.map((x, a) => x - (p[a] as number)) as unknown as Vec3
        const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]] as const
        const length = Math.hypot(...normal)
        const middle = p.map((x, a) => (x + (q[a] as number) + (r[a] as number)) / 3)
        const beside = (way: number) =>
          valueInside(
            bernstein,
            middle.map((x, a) => x + (way * 1e-3 * (normal[a] as number)) / length) as unknown as Vec3,
          )
        if (beside(1) > beside(-1)) right += length
        else wrong += length
      }
      expect(wrong).toBeLessThanOrEqual(0.01 * right)
    }
  })

  it('is open at the faces of the cube only', () => {
    for (const { bernstein } of awkward) {
      const surface = zeroSurface(bernstein, 9)
      for (const edge of openEdges(surface)) {
        const ends = edge.map(v => pointOf(surface, v))
        const shared = [0, 1, 2].some(a =>
          [0, 1].some(side => ends.every(end => Math.abs((end[a] as number) - side) < 1e-9)),
        )
        expect(shared).toBe(true)
      }
    }
  })

  it('is closed around the centre for the paper’s counterexample', () => {
    const { bernstein, volumeMinimum } = presetReport('non-strict')
    expect(volumeMinimum.upper).toBeLessThan(-0.249)
    const surface = zeroSurface(bernstein, 12)
    expect(surface.triangles.length).toBeGreaterThan(300)
    expect(openEdges(surface)).toEqual([])
    expect(valueInside(bernstein, [0.5, 0.5, 0.5])).toBeCloseTo(-0.25, 12)
  })

  it('is not there for elements of one sign, nor for collapsed ones', () => {
    for (const vertices of [unitCube, unitCube.map((x, i) => (i % 3 === 0 ? -x : x)), unitCube.map(() => 1)]) {
      expect(zeroSurface(reportOf(vertices).bernstein, 8).triangles).toHaveLength(0)
    }
  })
})
