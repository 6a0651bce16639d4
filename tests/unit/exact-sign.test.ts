/** The exact decision against proofs of another kind: witnesses and subdivision in exact integers. */
import { describe, expect, it } from 'vitest'
import { exactFace, exactJacdet } from '../../web/core/exact/exact-jacdet'
import { exactBoundary } from '../../web/core/exact/exact-minimum'
import { exactBoundarySign } from '../../web/core/exact/exact-sign'
import {
  type Polynomial,
  product,
  refined,
  refinedTo,
  rootsInUnitInterval,
  signAt,
  signAtRoot,
  squareFree,
} from '../../web/core/exact/integer-polynomial'
import { cases, caseVertices, core, depthGuardCases, entry, randomHexahedron, randomSource } from './core-fixtures'
import { exactJacdet as jacdetAt } from './exact'

/** n t - k: the factor with the root k/n. */
const factor = (n: number, k: number): Polynomial => [BigInt(-k), BigInt(n)]
const times = (...factors: Polynomial[]) => factors.reduce(product, [1n])

describe('roots in (0,1)', () => {
  it('are as many as there are, multiple ones once, those at 0 and 1 not at all', () => {
    const random = randomSource(21)
    for (let n = 0; n < 300; ++n) {
      const denominators = Array.from({ length: 5 }, () => 2 + Math.floor(random() * 30))
      const chosen = denominators.map(d => [d, Math.floor(random() * (2 * d)) - (d >> 1)] as const)
      const p = times(...chosen.map(([d, k]) => factor(d, k)), [2n, 0n, 1n])
      const inside = new Set(chosen.filter(([d, k]) => k > 0 && k < d).map(([d, k]) => k / d))
      const simple = squareFree(p)
      const roots = rootsInUnitInterval(simple)
      expect(roots.length).toBe(inside.size)
      const found = roots.map(root => {
        let place = root
        for (let i = 0; i < 60; ++i) place = refined(simple, place)
        return Number(place.high.numerator) / 2 ** place.high.shift
      })
      for (const [i, root] of [...inside].sort((a, b) => a - b).entries())
        expect(Math.abs(entry(found, i) - root)).toBeLessThan(2 ** -50)
    }
  })

  it('are told from neighbours however near, and from the same number', () => {
    const near = 2n ** 200n
    const p = times([-near, 3n * near], [-near - 1n, 3n * near])
    const roots = rootsInUnitInterval(p)
    expect(roots.length).toBe(2)
    const [first, second] = [entry(roots, 0), entry(roots, 1)]
    expect(signAtRoot([-1n, 3n], p, first)).toBe(0)
    expect(signAtRoot([-1n, 3n], p, second)).toBe(1)
    expect(signAtRoot([1n, -2n], p, first)).toBe(1)
  })

  it('are told from neighbours nearer than a stack is deep', () => {
    const near = 2n ** 12000n
    expect(rootsInUnitInterval(times([-1n, near], [-2n, near])).length).toBe(2)
  })

  it('are refined to any width, each in its own interval', () => {
    const random = randomSource(24)
    for (let n = 0; n < 100; ++n) {
      const [k, m, j] = [1 + Math.floor(random() * 40), 1 + Math.floor(random() * 40), 1 + Math.floor(random() * 300)]
      const p = squareFree(times([BigInt(-k), 0n, 1681n], [BigInt(-m), 0n, 0n, 3n << BigInt(j)], [-1n, 3n]))
      const roots = rootsInUnitInterval(p)
      for (const [i, root] of roots.entries()) {
        const { low, high } = refinedTo(p, root, 1000)
        const ends = [low, high].map(({ numerator, shift }) => numerator << BigInt(8192 - shift)) as [bigint, bigint]
        expect(ends[1] - ends[0] <= 1n << 7192n).toBe(true)
        if (ends[0] === ends[1]) expect(signAt(p, low)).toBe(0)
        else expect(signAt(p, low) * signAt(p, high)).toBe(-1)
        const before = [root.low, root.high].map(({ numerator, shift }) => numerator << BigInt(8192 - shift))
        expect(ends[0] >= entry(before, 0) && ends[1] <= entry(before, 1)).toBe(true)
        const next = roots[i + 1]
        if (next) expect(ends[1] <= next.low.numerator << BigInt(8192 - next.low.shift)).toBe(true)
      }
    }
  })
})

describe('the exact cases', () => {
  for (const { name, vertices, answer } of cases)
    it(`${name}: sign, value and place`, () => {
      const { sign, candidates, minimizer } = exactBoundary(vertices.flat())
      expect(sign).toBe(answer.sign)
      expect(Math.sign(minimizer.mantissa)).toBe(answer.sign)
      expect(candidates.every(({ mantissa }) => Math.sign(mantissa) >= answer.sign)).toBe(true)
      const [digits = '0', power = '0'] = answer.boundary_min.toLowerCase().split('e')
      const logarithm = Math.log10(Math.abs(Number(digits))) + Number(power)
      if (answer.sign !== 0)
        expect(Math.log10(Math.abs(minimizer.mantissa)) + minimizer.exponent * Math.log10(2)).toBeCloseTo(logarithm, 9)
      if (minimizer.exponent === 0) {
        const exact = Number(answer.boundary_min)
        expect(Math.abs(minimizer.mantissa - exact)).toBeLessThanOrEqual(2 ** -52 * Math.abs(exact))
      }
    })

  it('and the valid elements that a depth guard rejects', () => {
    for (const { vertices } of depthGuardCases) expect(exactBoundarySign(vertices.flat())).toBe(1)
  })
})

/** Nine Bernstein coefficients, times 16, of the four quarters of a face. */
function quarters(beta: readonly bigint[]): bigint[][] {
  const halves = (q: readonly bigint[]) => {
    const [a, b, c] = q as [bigint, bigint, bigint]
    return [
      [4n * a, 2n * (a + b), a + 2n * b + c],
      [a + 2n * b + c, 2n * (b + c), 4n * c],
    ]
  }
  const transposed = (m: readonly bigint[]) => [0, 3, 6, 1, 4, 7, 2, 5, 8].map(i => entry(m, i))
  const split = (m: readonly bigint[]) => {
    const rows = [0, 3, 6].map(i => halves(m.slice(i, i + 3)))
    return [0, 1].map(half => rows.flatMap(row => entry(row, half)))
  }
  return split(beta).flatMap(half => split(transposed(half)))
}

/** Ends on a face that is strictly positive; proves nothing else. */
function isProvedPositive(beta: readonly bigint[], depth = 0): boolean {
  if (beta.every(coefficient => coefficient > 0n)) return true
  return depth < 40 && quarters(beta).every(quarter => isProvedPositive(quarter, depth + 1))
}

describe('the exact sign', () => {
  it('is borne out on both sides of the border, to the last bit', () => {
    const random = randomSource(22)
    let pairs = 0
    while (pairs < 60) {
      const [a, b] = [randomHexahedron(random, 0.2), randomHexahedron(random, 0.6)]
      const between = (t: number) => a.map((x, i) => x + t * (entry(b, i) - x))
      if (exactBoundarySign(a) !== 1 || exactBoundarySign(b) === 1) continue
      let [low, high] = [0, 1]
      for (;;) {
        const middle = low + (high - low) / 2
        if (middle === low || middle === high) break
        if (exactBoundarySign(between(middle)) === 1) low = middle
        else high = middle
      }
      ++pairs
      const valid = between(low)
      for (let face = 0; face < 6; ++face) expect(isProvedPositive(exactFace(exactJacdet(valid), face))).toBe(true)
      const invalid = exactBoundary(between(high))
      expect(invalid.sign).toBeLessThanOrEqual(0)
      if (invalid.minimizer.kind === 'vertex') expect(jacdetAt(between(high), invalid.minimizer.point) <= 0n).toBe(true)
      expect(exactBoundary(valid).minimizer.mantissa).toBeGreaterThan(0)
    }
  })

  it('is what the filter says wherever the filter says anything', () => {
    const random = randomSource(24)
    const makers = [
      () => randomHexahedron(random, 0.3),
      () => randomHexahedron(random, 0.4).map(x => Math.round(4 * x) / 4),
      () => randomHexahedron(random, 0.5).map(Math.round),
      () => {
        const family = entry(['corner', 'edge', 'face'], Math.floor(3 * random()))
        const moved = Math.floor(24 * random())
        const bits = Math.floor(5 * random()) - 2
        return caseVertices(`pub/touch_${family}/0_zero`).map((x, i) => (i === moved ? x * (1 + bits * 2 ** -52) : x))
      },
    ]
    const ways = { filter: 0, exact: 0 }
    for (let n = 0; n < 4000; ++n) {
      const hexahedron = entry(makers, n % makers.length)()
      const result = core.analyze(hexahedron)
      if (!result.ok) throw new Error(result.error.message)
      const { valid, decidedBy, boundaryMinimum } = result.value
      const sign = exactBoundarySign(hexahedron)
      expect([valid, Math.sign(boundaryMinimum)], hexahedron.join()).toEqual([sign > 0, sign])
      ++ways[decidedBy]
    }
    expect(Math.min(ways.filter, ways.exact)).toBeGreaterThan(200)
  })

  it('is negative only with a negative value at its minimizer', () => {
    const random = randomSource(23)
    for (let n = 0; n < 200; ++n) {
      const hexahedron = randomHexahedron(random, 0.5).map(x => Math.round(x * 64) / 64)
      const { sign, minimizer } = exactBoundary(hexahedron)
      const point = minimizer.point.map(x => Math.round(x * 2 ** 50) / 2 ** 50) as [number, number, number]
      if (sign < 0 && minimizer.mantissa < -1e-9) expect(jacdetAt(hexahedron, point) < 0n).toBe(true)
      if (sign > 0) expect(jacdetAt(hexahedron, point) > 0n).toBe(true)
    }
  })
})
