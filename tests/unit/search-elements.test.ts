/** The elements of a search: laws of their numbers, symmetries, the filter against the core. */
import { describe, expect, it } from 'vitest'
import { hasCornerAtMost, setCorners, setOthers } from '../../web/core/filter/coefficients'
import { FALSE, filterOf, TRUE } from '../../web/core/filter/filter'
import { quantitiesOf } from '../../web/core/quantities'
import { isMet, parseCondition } from '../../web/model/condition'
import { NUMBERS } from '../../web/model/condition/names'
import { vertexReference } from '../../web/model/hexahedron'
import { type Distribution, refusalOf, sourceOf, startOf } from '../../web/pages/search/engine/distribution'
import { measured, parseMeasure } from '../../web/pages/search/engine/measure'
import { logarithm, randomOf } from '../../web/pages/search/engine/random'
import { complexityOf, complexityOfNumber } from '../../web/pages/search/engine/simplicity'
import { imageOf, orbitsOf, type SymmetryName, symmetries } from '../../web/pages/search/engine/symmetry'
import { searches } from '../../web/pages/search/searches'
import { core, entry, randomHexahedron, randomSource, unitCube } from './core-fixtures'

const free: Distribution = { law: { kind: 'normal', sigma: 0.3 }, grid: 'free', symmetry: 'none', moved: 8 }

function drawn(distribution: Distribution, count: number, seed = 1): number[][] {
  const elements = new Float64Array(24 * count)
  sourceOf(distribution, randomOf(seed, 0))(elements)
  return Array.from({ length: count }, (_, e) => [...elements.subarray(24 * e, 24 * e + 24)])
}

function analyzed(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** The share is within five deviations of the law for so many independent draws. */
function expectShare(count: number, total: number, probability: number): void {
  const deviation = Math.sqrt(total * probability * (1 - probability))
  expect(Math.abs(count - total * probability)).toBeLessThan(5 * deviation)
}

describe('random numbers', () => {
  it('follow their laws, in every bit and far out', () => {
    const count = 100_000
    const [units, normals] = [new Float64Array(count), new Float64Array(count)]
    const random = randomOf(20260801, 7)
    random.units(units)
    random.normals(normals)
    for (let bit = 1; bit <= 20; ++bit)
      expectShare(units.filter(x => Math.floor(x * 2 ** bit) % 2 === 1).length, count, 0.5)
    expect(units.every(x => x >= 0 && x < 1)).toBe(true)
    // 2 (1 - Phi(x)), and beyond 3.4426 it is the tail's own method.
    const beyond = { 0.5: 0.6170751, 1: 0.3173105, 2: 0.0455003, 3: 0.0026998, 3.5: 0.00046526, 4: 0.00006334 }
    for (const [x, probability] of Object.entries(beyond))
      for (const sign of [1, -1])
        expectShare(normals.filter(value => sign * value > Number(x)).length, count, probability / 2)
    const mean = normals.reduce((a, b) => a + b, 0) / count
    const variance = normals.reduce((a, b) => a + b * b, 0) / count
    expect(Math.abs(mean)).toBeLessThan(5 / Math.sqrt(count))
    expect(Math.abs(variance - 1)).toBeLessThan(5 * Math.sqrt(2 / count))
  })

  it('differ from seed to seed and from stream to stream, and come again', () => {
    const first = (seed: number, stream: number) => randomOf(seed, stream).unit()
    const pairs = [0, 1, 2, 2 ** 31, 2 ** 32 - 1].flatMap(a => [0, 1, 2, 77].map(b => [a, b] as const))
    expect(new Set(pairs.map(([a, b]) => first(a, b))).size).toBe(pairs.length)
    expect(first(5, 6)).toBe(first(5, 6))
  })

  it('have a logarithm', () => {
    for (const x of [1, 0.5, 1 - 2 ** -33, 1 + 2 ** -40, Math.SQRT2, 2 ** -66, 0.3, 5e-9, 123.456])
      expect(Math.abs(logarithm(x) - Math.log(x))).toBeLessThan(1e-13 * Math.abs(Math.log(x)) + 1e-15)
  })
})

describe('elements', () => {
  it.each(Object.keys(symmetries) as SymmetryName[])('with the symmetry %s are their own images, bit for bit', name => {
    const symmetry = symmetries[name]
    const cases: Distribution[] = [
      { ...free, symmetry: name },
      { ...free, symmetry: name, grid: 'quarters' },
      { law: { kind: 'box', least: -3, greatest: 2 }, grid: 'integers', symmetry: name, moved: 8 },
      { ...free, symmetry: name, moved: 6 },
    ]
    for (const distribution of cases) {
      const [low, high] = [startOf(distribution)[0] as number, startOf(distribution)[18] as number]
      const imageVertex = (v: number) => {
        const image = imageOf(symmetry, entry(vertexReference, v), 1)
        return vertexReference.findIndex(point => point.every((x, r) => x === image[r]))
      }
      for (const vertices of drawn(distribution, 50))
        for (let v = 0; v < 8; ++v) {
          const point = vertices.slice(3 * v, 3 * v + 3) as [number, number, number]
          const w = imageVertex(v)
          expect(imageOf(symmetry, point, low + high)).toEqual(vertices.slice(3 * w, 3 * w + 3))
        }
    }
    const orbits = orbitsOf(symmetry)
    expect(orbits.flat().toSorted()).toEqual([0, 1, 2, 3, 4, 5, 6, 7])
  })

  it('lie about the unit cube as sigma says', () => {
    const sample = drawn(free, 4000)
    const moves = sample.flatMap(vertices => vertices.map((x, i) => x - entry(unitCube, i)))
    const variance = moves.reduce((a, b) => a + b * b, 0) / moves.length
    expect(Math.abs(variance / 0.09 - 1)).toBeLessThan(5 * Math.sqrt(2 / moves.length))
    expect(moves.every(x => Number.isInteger(x * 2 ** 32))).toBe(true)
  })

  it('fill a box evenly, its ends too, and keep to their grid', () => {
    const box = { ...free, law: { kind: 'box', least: -1.1, greatest: 2.3 } } as const
    const integers = drawn({ ...box, grid: 'integers' }, 2000).flat()
    for (const value of [-1, 0, 1, 2]) expectShare(integers.filter(x => x === value).length, integers.length, 1 / 4)
    const quarters = drawn({ ...box, grid: 'quarters' }, 500).flat()
    expect(new Set(quarters)).toEqual(new Set(Array.from({ length: 14 }, (_, i) => -1 + i / 4)))
    const any = drawn(box, 500).flat()
    expect(any.every(x => x >= -1.1 && x <= 2.3)).toBe(true)
    expectShare(any.filter(x => x < 0.6).length, any.length, 0.5)
    expect([...integers, ...quarters].some(x => Object.is(x, -0))).toBe(false)
  })

  it('move as many vertices as asked for', () => {
    const movedIn = (vertices: readonly number[]) =>
      [0, 1, 2, 3, 4, 5, 6, 7].filter(v => [0, 1, 2].some(r => vertices[3 * v + r] !== unitCube[3 * v + r]))
    const two = drawn({ ...free, moved: 2 }, 2000).map(movedIn)
    expect(two.every(({ length }) => length === 2)).toBe(true)
    for (let v = 0; v < 8; ++v) expectShare(two.filter(moved => moved.includes(v)).length, two.length, 1 / 4)
    const third = drawn({ ...free, symmetry: 'third-turn', moved: 3 }, 300).map(movedIn)
    expect(new Set(third.map(({ length }) => length))).toEqual(new Set([2, 3]))
  })

  it.each([
    [{ law: { kind: 'normal', sigma: 0 } }, 'Sigma needs a number above 0'],
    [{ law: { kind: 'normal', sigma: Number.NaN } }, 'Sigma needs a number above 0'],
    [{ law: { kind: 'normal', sigma: 1e9 } }, 'at most 100'],
    [{ law: { kind: 'box', least: 2, greatest: 1 } }, 'its least number below its greatest'],
    [{ law: { kind: 'box', least: Number.NaN, greatest: 1 } }, 'two numbers from −1000 to 1000'],
    [{ law: { kind: 'box', least: 0.2, greatest: 1.9 }, grid: 'integers' }, 'at least two integers in it'],
    [{ moved: 9 }, 'from 1 to 8'],
    [{ moved: 3, symmetry: 'quarter-turn' }, '4 vertices move together'],
  ] as const)('%j are refused in a sentence', (change, sentence) => {
    expect(refusalOf({ ...free, ...change })).toContain(sentence)
    expect(refusalOf(free)).toBeNull()
  })
})

describe('the filter', () => {
  it('computes the coefficients of the core', () => {
    const random = randomSource(20260802)
    const bernstein = new Float64Array(27)
    for (let n = 0; n < 200; ++n) {
      const vertices = randomHexahedron(random, 0.01 * n)
      const report = analyzed(vertices)
      const list = new Float64Array(vertices)
      setCorners(bernstein, list, 0)
      setOthers(bernstein)
      const size = Math.max(...report.bernstein.map(Math.abs))
      for (const [i, value] of report.bernstein.entries())
        expect(Math.abs(entry([...bernstein], i) - value)).toBeLessThan(1e-14 * size)
      for (const most of [report.cornerMinimum - 1e-9, report.cornerMinimum + 1e-9])
        expect(hasCornerAtMost(list, 0, most)).toBe(report.cornerMinimum <= most)
    }
  })

  it('holds no element back that meets the condition, and says yes only to those that do', () => {
    const conditions = [
      ...searches.map(({ property }) => property),
      'valid and volume < 1',
      'not valid and gauss2_min > 0 and scaled_jacobian >= 0.2',
      'moved <= 4 and corner_min = 1',
      'boundary_min = 0 or centre < 0',
      '1/2 < boundary_min / boundary_max',
      'bernstein_min * 2 <= -volume and not edge_min > gauss3_min',
      'subdivision > 0',
      'boundary_min != 0 and edge_min != corner_min',
      '0 < -boundary_min < boundary_max - volume_min',
      ...NUMBERS.flatMap(name => [`${name} > 0`, `not ${name} > 1/3`]),
    ]
    const elements = [
      ...[0.1, 0.3, 0.5, 1].flatMap(sigma => drawn({ ...free, law: { kind: 'normal', sigma } }, 80)),
      ...drawn({ ...free, grid: 'quarters', symmetry: 'quarter-turn-mirrored' }, 60),
      ...drawn({ ...free, law: { kind: 'normal', sigma: 1 }, grid: 'integers', moved: 2 }, 60),
    ]
    const reports = elements.map(analyzed)
    const counts = { held: 0, sure: 0, met: 0 }
    for (const [n, text] of conditions.entries()) {
      const condition = parseCondition(text)
      const measure = parseMeasure(entry(['boundary_min', '-volume / 3 + edge_min', 'centre * corner_min'], n % 3))
      if (!condition.ok || !measure.ok) throw new Error(`${text} was refused.`)
      const filter = filterOf(condition.value, measure.value, unitCube, core)
      for (const [e, vertices] of elements.entries()) {
        const report = entry(reports, e)
        const met = isMet(condition.value, quantitiesOf(report, unitCube))
        const truth = filter.judge(new Float64Array(vertices), 0, report.valid)
        if (met) expect(truth, `${text}: ${vertices}`).not.toBe(FALSE)
        if (truth === TRUE) expect(met, `${text}: ${vertices}`).toBe(true)
        if (met && !(report.valid ? filter.mayBe.valid : filter.mayBe.invalid)) throw new Error(text)
        if (met && report.cornerMinimum <= 0) expect(filter.mayBe.withoutPositiveCorners, text).toBe(true)
        expect(filter.measureAtMost()).toBeGreaterThanOrEqual(measured(measure.value, report, unitCube))
        counts.held += truth === FALSE ? 1 : 0
        counts.sure += truth === TRUE ? 1 : 0
        counts.met += met ? 1 : 0
      }
    }
    const total = conditions.length * elements.length
    expect(counts.held).toBeGreaterThan(total / 3)
    expect(counts.sure).toBeGreaterThan(counts.met / 4)
    expect(counts.met).toBeGreaterThan(200)
  })

  it('drops at sight what a corner forbids', () => {
    const mayBe = (text: string) => {
      const condition = parseCondition(text)
      const measure = parseMeasure('centre')
      if (!condition.ok || !measure.ok) throw new Error(text)
      return filterOf(condition.value, measure.value, unitCube, core).mayBe
    }
    const none = { valid: false, invalid: true, withoutPositiveCorners: false }
    for (const { id, property } of searches)
      expect(mayBe(property), id).toEqual(
        id === 'depth-guard'
          ? { ...none, valid: true, invalid: false }
          : { ...none, withoutPositiveCorners: id === 'gap' },
      )
  })
})

it('a measure is one number, and says where it is not', () => {
  const refusal = (text: string) => {
    const result = parseMeasure(text)
    return result.ok ? null : result.error
  }
  expect(refusal('-boundary_min / (2 * boundary_max)')).toBeNull()
  expect(refusal(' ')).toEqual({ message: 'Write a number here, such as corner_min.', at: 0 })
  expect(refusal('centre > 0')).toEqual({ message: 'Write one number here, not a comparison.', at: 0 })
  expect(refusal('centre > 0 and volume')?.message).toContain('one number')
  expect(refusal('valid')?.message).toContain('true or false')
  expect(refusal('centre +')).toMatchObject({ at: 8 })
  expect(refusal('center')).toMatchObject({ at: 0 })
})

it('less to write down is more beautiful', () => {
  const ascending = [0, 1, -1, 2, 3, 0.5, -0.5, 0.1, 0.25, 0.75, 0.12, 0.125, 1 / 3]
  const complexities = ascending.map(complexityOfNumber)
  expect(complexities).toEqual(complexities.toSorted((a, b) => a - b))
  const moved = unitCube.with(0, 0.5)
  expect(complexityOf(unitCube, unitCube)).toBeLessThan(complexityOf(moved, unitCube))
  expect(complexityOf(moved, unitCube)).toBeLessThan(complexityOf(moved.with(3, 0.5), unitCube))
  expect(complexityOf(moved.with(1, 0.5), unitCube)).toBeLessThan(complexityOf(moved.with(4, 0.5), unitCube))
})
