import { describe, expect, it } from 'vitest'
import { loadCore } from '../../web/core/core'
import type { Report } from '../../web/core/report'
import { edgeVertices, faces, type Vec3, vertexReference } from '../../web/model/hexahedron'
import { isAtMost, productOf, scaledDouble } from '../../web/model/rational'
import {
  cases,
  caseVertices,
  core,
  depthGuardCases,
  entry,
  numbersIn,
  randomHexahedron,
  randomSource,
  unitCube,
  wasmBytes,
} from './core-fixtures'
import { difference, ofDecimal, size } from './fractions'

function analyzed(vertices: readonly number[]): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

describe('the module', () => {
  it('imports nothing and exports the memory and a handful of functions', () => {
    const module = new WebAssembly.Module(wasmBytes)
    expect(WebAssembly.Module.imports(module)).toEqual([])
    expect(
      WebAssembly.Module.exports(module)
        .map(({ name }) => name)
        .filter(name => !name.startsWith('__') && !name.startsWith('stack') && !name.startsWith('emscripten'))
        .sort(),
    ).toEqual(
      [
        '_initialize',
        'analyze',
        'boundary_minimum',
        'input_address',
        'input_length',
        'decide',
        'jacobian_at',
        'memory',
        'output_address',
        'output_length',
      ].sort(),
    )
  })

  it('is refused when its bytes are not wasm', async () => {
    await expect(loadCore(new Uint8Array([1, 2, 3]))).rejects.toThrow()
  })
})

describe('the exact cases', () => {
  for (const { name, vertices, answer } of cases)
    it(`${name} has its minima to 1e-14 of its scale, and the boundary minimum within its error`, () => {
      const report = analyzed(vertices.flat())
      const within = productOf(ofDecimal(answer.scale), scaledDouble(1e-14, 0))
      const off = (value: number, exact: string) =>
        size(difference(scaledDouble(value, report.exponent), ofDecimal(exact)))
      expect(isAtMost(off(report.boundaryMinimum, answer.boundary_min), within)).toBe(true)
      expect(isAtMost(off(report.cornerMinimum, answer.corner_min), within)).toBe(true)
      expect(isAtMost(off(report.edgeMinimum, answer.edge_min), within)).toBe(true)
      const error = scaledDouble(report.boundaryMinimumError, report.exponent)
      // The answers have 40 digits.
      const lastDigit = productOf(size(ofDecimal(answer.boundary_min)), scaledDouble(1e-39, 0))
      expect(isAtMost(difference(off(report.boundaryMinimum, answer.boundary_min), lastDigit), error)).toBe(true)
      expect(isAtMost(error, productOf(ofDecimal(answer.scale), scaledDouble(5.8e-13, 0)))).toBe(true)
    })

  for (const { name, vertices, answer } of cases)
    it(`${name} has its volume minimum in a bracket of at most 1e-10 of its scale`, () => {
      const { volumeMinimum, exponent } = analyzed(vertices.flat())
      const [lower, upper] = [scaledDouble(volumeMinimum.lower, exponent), scaledDouble(volumeMinimum.upper, exponent)]
      expect(isAtMost(lower, ofDecimal(answer.volume_min.upper))).toBe(true)
      expect(isAtMost(ofDecimal(answer.volume_min.lower), upper)).toBe(true)
      expect(isAtMost(difference(upper, lower), productOf(ofDecimal(answer.scale), scaledDouble(1e-10, 0)))).toBe(true)
    })

  for (const { name, vertices, answer } of cases)
    it(`${name} has the exact verdict, and a minimum of the exact sign`, () => {
      const report = analyzed(vertices.flat())
      expect(report.valid).toBe(answer.valid)
      expect(Math.sign(report.boundaryMinimum)).toBe(answer.sign)
      expect(core.isValid(vertices.flat())).toEqual({ ok: true, value: answer.valid })
      expect(Math.min(...report.candidates.map(({ value }) => value))).toBe(report.boundaryMinimum)
    })

  it('take both ways: error bounds and exact arithmetic', () => {
    const ways = cases.map(({ vertices }) => analyzed(vertices.flat()).decidedBy)
    expect(Math.min(...(['filter', 'exact'] as const).map(way => ways.filter(w => w === way).length))).toBeGreaterThan(
      30,
    )
  })

  it('include the valid elements that a depth guard rejects', () => {
    for (const { vertices } of depthGuardCases) {
      const { valid, checks } = analyzed(vertices.flat())
      expect([valid, checks.find(({ id }) => id === 'subdivision')?.passes]).toEqual([true, false])
    }
  })
})

describe('exact arithmetic', () => {
  it('gives a collapsed element zeros, not their rounding errors', () => {
    const random = randomSource(12)
    const flat = Array.from({ length: 8 }, () => [random(), random()]).flatMap(([x = 0, y = 0]) => [
      x,
      y,
      0.3 * x + 0.7 * y,
    ])
    const exactlyFlat = flat.map((x, i) => (i % 3 === 2 ? 0.25 : x))
    const report = analyzed(exactlyFlat)
    expect([report.valid, report.decidedBy, report.boundaryMinimum, report.boundaryMaximum]).toEqual([
      false,
      'exact',
      0,
      0,
    ])
    expect(report.faces.flatMap(({ bernstein }) => bernstein).every(value => value === 0)).toBe(true)
    expect(analyzed(flat).decidedBy).toBe('exact')
  })

  it('tells apart two elements that differ in one bit', () => {
    for (const family of ['touch_corner', 'touch_edge', 'touch_face'])
      for (const [suffix, sign] of [
        ['zero', 0],
        ['plus_ulp', 1],
        ['minus_ulp', -1],
      ] as const) {
        const report = analyzed(caseVertices(`pub/${family}/0_${suffix}`))
        expect([report.decidedBy, Math.sign(report.boundaryMinimum)]).toEqual(['exact', sign])
      }
  })

  it('takes over where all coefficients are lost digits beside the permanents, though the verdict is plain', () => {
    const rotated = unitCube.map((_, i) => {
      const [x = 0, y = 0, z = 0] = unitCube.slice(i - (i % 3), i - (i % 3) + 3)
      const slab = [x + 0.3 * z, y + 0.1 * x, 1e-6 * (z + 0.2 * x * y)]
      const rows = [
        [0.36, 0.48, -0.8],
        [-0.8, 0.6, 0],
        [0.48, 0.64, 0.6],
      ]
      return entry(rows, i % 3).reduce((sum, factor, axis) => sum + factor * entry(slab, axis), 0)
    })
    const { valid, decidedBy, boundaryMinimum, boundaryMinimumError } = analyzed(rotated)
    expect([valid, decidedBy]).toEqual([true, 'exact'])
    expect(boundaryMinimumError).toBe(2 ** -52 * boundaryMinimum)
  })

  it('hands on finite numbers only, whatever the sizes of candidates and coefficients', () => {
    const smallCandidates = [
      [0, 0, 0],
      [0, 0, 0],
      [-4.873450554588645e199, 0, 1e-250],
      [-1e-151, 0, 0],
      [0, 0, 0],
      [0, 0, 1],
      [-4.873450554588645e199, 0, 0],
      [0, -1e50, 0],
    ]
    const largeRoot = [
      [1.5e-323, 1, 1e308],
      [-1.5e-323, -0.6696855161165507, -9.525520246525004e307],
      [1, 0.5562711601352925, 7.872258471058548e307],
      [-3.5e-323, 0, 5e-324],
      [-4e-323, -1, 0],
      [-2.5e-323, -0.48308060889961624, 0],
      [0, 0, -1],
      [-1e308, 1e308, 3e-323],
    ]
    for (const points of [smallCandidates, largeRoot]) {
      const report = analyzed(points.flat())
      expect([report.valid, report.decidedBy]).toEqual([false, 'exact'])
      expect(numbersIn(report).filter(value => !Number.isFinite(value))).toEqual([])
    }
  })

  it('gives the other checks their exact signs', () => {
    // Twisted by half a turn: the columns of DF nearly vanish at the centre.
    const twisted = [
      [0.6495061094571206, -0.0928094441951775, 0.2636820449823176],
      [0.04861880939397495, -0.6193254988231254, -0.3377456704098504],
      [-0.6495061094571206, 0.0928094441951775, -0.2636820449823176],
      [-0.04861880939397495, 0.6193254988231254, 0.3377456704098504],
      [-0.2602041054782377, 0.5571850111141727, -1.0591688660841427],
      [0.34068319458490787, 1.0837010657421207, -0.4577411506919748],
      [1.0388081134360037, 0.37156612272381795, -0.5318047761195074],
      [0.437920813372858, -0.15494993190413003, -1.1332324915116754],
    ]
    const { valid, decidedBy, checks, scaledJacobian } = analyzed(twisted.flat())
    expect([valid, decidedBy]).toEqual([true, 'exact'])
    const passing = checks.filter(({ passes }) => passes).map(({ id }) => id)
    expect(passing).toEqual(expect.arrayContaining(['corners', 'corners-and-centre', 'gauss-2', 'gauss-3', 'edges']))
    // At the centre it is 0.91984; the corners have less.
    expect(scaledJacobian).toBeCloseTo(0.57, 1)
    // Verdict takes a column as short as that for zero.
    expect(checks.find(({ id }) => id === 'corners-and-centre')?.value).toBe(1e30)
  })

  it('keeps a minimum of 1 beside values of 1e600', () => {
    const { valid, boundaryMinimum, exponent } = analyzed(caseVertices('pub/mixed/some_1e300_0'))
    expect([valid, Math.log2(boundaryMinimum) + exponent]).toEqual([true, 0])
  })
})

describe('a report', () => {
  it('agrees with the tables of the topology', () => {
    const vertices = randomHexahedron(randomSource(7), 0.4)
    const report = analyzed(vertices)
    const at = ([i, j, k]: Vec3) => report.bernstein[18 * i + 6 * j + 2 * k]
    for (const [v, reference] of vertexReference.entries()) {
      expect(report.candidates[v]).toMatchObject({ kind: 'vertex', id: v, point: reference })
      expect(report.candidates[v]?.value).toBe(at(reference))
      expect(report.candidates[v]?.position).toEqual(vertices.slice(3 * v, 3 * v + 3))
    }
    for (const { id, bernstein } of report.faces) {
      const corners = entry(faces, id).vertices.map(v => at(entry(vertexReference, v)))
      expect([bernstein[0], bernstein[6], bernstein[2], bernstein[8]]).toEqual(corners)
    }
  })

  it('places every candidate on what it names', () => {
    const random = randomSource(8)
    for (let n = 0; n < 500; ++n)
      for (const { kind, id, point } of analyzed(randomHexahedron(random, 0.6)).candidates) {
        if (kind === 'edge') {
          const [from, to] = entry(edgeVertices, id).map(v => entry(vertexReference, v)) as [Vec3, Vec3]
          for (const axis of [0, 1, 2] as const)
            if (from[axis] === to[axis]) expect(point[axis]).toBe(from[axis])
            else expect([from[axis], to[axis], point[axis] > 0 && point[axis] < 1]).toEqual([0, 1, true])
        }
        if (kind === 'face') {
          const face = entry(faces, id)
          expect(point[face.axis]).toBe(face.side)
          for (const axis of [face.s, face.t]) expect(point[axis] > 0 && point[axis] < 1).toBe(true)
        }
      }
  })

  it('keeps one candidate for every root that was kept, and says why the others were dropped', () => {
    const random = randomSource(9)
    const fates = { kept: 0, 'a-not-positive': 0, 's-outside': 0 }
    for (let n = 0; n < 500; ++n) {
      const report = analyzed(randomHexahedron(random, 0.6))
      for (const face of report.faces) {
        const candidates = report.candidates.filter(({ kind, id }) => kind === 'face' && id === face.id)
        expect(candidates.length).toBe(face.roots.filter(({ fate }) => fate === 'kept').length)
        for (const { a, s, fate } of face.roots) {
          ++fates[fate]
          expect(s === null).toBe(fate === 'a-not-positive')
          expect(a > 0).toBe(fate !== 'a-not-positive')
          if (fate === 's-outside') expect(s !== null && s > 0 && s < 1).toBe(false)
        }
      }
    }
    expect(Math.min(...Object.values(fates))).toBeGreaterThan(50)
  })

  it('is its own copy: a later call changes nothing in it', () => {
    const report = analyzed(unitCube)
    const before = JSON.stringify(report)
    analyzed(randomHexahedron(randomSource(1), 1))
    expect(JSON.stringify(report)).toBe(before)
  })

  it('is had for typed arrays, too', () => {
    expect(core.analyze(Float64Array.from(unitCube) as unknown as number[])).toEqual(core.analyze(unitCube))
  })

  it('agrees with the two variants and the validity query', () => {
    const random = randomSource(10)
    for (let n = 0; n < 2000; ++n) {
      const vertices = randomHexahedron(random, 0.1 + (n % 20) / 10)
      const report = analyzed(vertices)
      const minimum = { ok: true, value: { minimizer: report.minimizer, exponent: 0 } }
      expect(core.boundaryMinimum(vertices, 'roots')).toEqual(minimum)
      expect(core.boundaryMinimum(vertices, 'roots-b')).toEqual(minimum)
      expect(core.isValid(vertices)).toEqual({ ok: true, value: report.valid })
    }
  })

  it('hands on jacdets outside the doubles as number and exponent', () => {
    for (const size of [2 ** -400, 2 ** 400]) {
      const report = analyzed(unitCube.map(x => x * size))
      expect(report.valid).toBe(true)
      expect(report.boundaryMinimum > 0 && Number.isFinite(report.boundaryMinimum)).toBe(true)
      expect(Math.log2(report.boundaryMinimum) + report.exponent).toBe(3 * Math.log2(size))
    }
  })
})

describe('the Jacobian at a point', () => {
  it('has the columns of DF', () => {
    const sheared = unitCube.map((x, i) => (i % 3 === 0 ? 2 * x + entry(unitCube, i + 1) : x))
    const result = core.jacobian(sheared, [0.25, 0.5, 0.75])
    expect(result).toEqual({
      ok: true,
      value: {
        point: [0.25, 0.5, 0.75],
        position: [1, 0.5, 0.75],
        columns: [
          [2, 0, 0],
          [1, 1, 0],
          [0, 0, 1],
        ],
        axisExponents: [0, 0, 0],
        jacdet: 2,
        exponent: 0,
      },
    })
  })

  it('is -1/4 at the centre of the paper’s counterexample, where the boundary has 0', () => {
    const vertices = caseVertices('pub/nonstrict/paper')
    expect(core.jacobian(vertices, [0.5, 0.5, 0.5])).toMatchObject({ ok: true, value: { jacdet: -0.25 } })
    expect(analyzed(vertices).boundaryMinimum).toBe(0)
  })
})

describe('a refusal', () => {
  it('names the coordinate that is not finite', () => {
    const vertices = unitCube.with(19, Number.NaN)
    for (const result of [
      core.analyze(vertices),
      core.isValid(vertices),
      core.boundaryMinimum(vertices, 'roots'),
      core.jacobian(vertices, [0, 0, 0]),
    ])
      expect(result).toEqual({
        ok: false,
        error: { code: 'not-finite', message: 'Vertex 6 y is not a finite number.' },
      })
  })

  it('counts', () => {
    expect(core.analyze(unitCube.slice(1))).toMatchObject({ ok: false, error: { code: 'wrong-count' } })
    expect(core.analyze([])).toMatchObject({ ok: false, error: { code: 'wrong-count' } })
  })

  it('keeps reference points inside the cube', () => {
    expect(core.jacobian(unitCube, [0, 1.5, 0])).toMatchObject({ ok: false, error: { code: 'outside-cube' } })
    expect(core.jacobian(unitCube, [0, Number.NaN, 0])).toMatchObject({ ok: false, error: { code: 'not-finite' } })
  })
})
