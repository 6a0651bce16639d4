import { describe, expect, it } from 'vitest'
import { presets, presetVertices } from '../../web/model/presets'
import { elementAt, tauOf } from '../../web/model/way'
import { type Morph, morphOf } from '../../web/panels/morph/morph-answer'
import { core, randomHexahedron, randomSource, unitCube } from './core-fixtures'

function preset(id: string) {
  const found = presets.find(candidate => candidate.id === id)
  if (!found) throw new Error(`There is no preset ${id}.`)
  return presetVertices(found)
}

function isValid(vertices: readonly number[]): boolean {
  const result = core.isValid(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function expectNeighbours({ a, b, crossings }: Morph): void {
  for (const { validTau, invalidTau } of crossings) {
    expect([validTau, invalidTau].map(tau => isValid(elementAt(a, b, tau)))).toEqual([true, false])
    const middle = (validTau + invalidTau) / 2
    expect([validTau, invalidTau]).toContain(middle)
  }
}

describe('an element on the way', () => {
  it('is the one or the other at the ends, bit for bit, and keeps what both have', () => {
    const a = unitCube.with(0, -0).with(5, 0.1)
    const b = unitCube.with(0, 3).with(5, 0.1).with(7, 0.3)
    expect([elementAt(a, b, 0), elementAt(a, b, 1)]).toEqual([a, b])
    for (const tau of [0.1, 1 / 3, 0.7]) expect(elementAt(a, b, tau)[5]).toBe(0.1)
    expect(elementAt(a, b, 0.5)[7]).toBe((a[7] as number) + 0.5 * (0.3 - (a[7] as number)))
  })

  it('is finite between the largest doubles', () => {
    const huge = unitCube.map(x => (2 * x - 1) * Number.MAX_VALUE)
    const turned = huge.map(x => -x)
    for (const tau of [0.25, 0.5, 0.75]) expect(elementAt(huge, turned, tau).every(Number.isFinite)).toBe(true)
  })

  it('is found again, and what lies beside the way is not', () => {
    const a = unitCube
    const b = preset('looks-fine')
    for (const tau of [0, 0.125, 0.6180339887498949, 1]) {
      expect(tauOf(a, b, elementAt(a, b, tau), tau)).toBe(tau)
      const found = tauOf(a, b, elementAt(a, b, tau), 0.3)
      if (found !== null) expect(elementAt(a, b, found)).toEqual(elementAt(a, b, tau))
    }
    expect(tauOf(a, b, elementAt(a, b, 0.5).with(3, 9), 0.5)).toBeNull()
    expect(tauOf(a, a, a, 0.5)).toBe(0.5)
  })
})

describe('the way between two elements', () => {
  it('has neighbouring doubles on both sides of each change of the verdict', () => {
    const morph = morphOf(core, unitCube, preset('looks-fine'))
    expect(morph.crossings).toHaveLength(1)
    expectNeighbours(morph)
    const random = randomSource(20260702)
    for (let n = 0; n < 8; n++) {
      const other = morphOf(core, randomHexahedron(random, 0.2), randomHexahedron(random, 0.5))
      expectNeighbours(other)
      const [first, last] = [other.samples[0], other.samples.at(-1)]
      expect(other.crossings.length % 2 === 1).toBe(first?.valid !== last?.valid)
    }
  })

  it('is crossed where arithmetic says: a top that goes down through the bottom', () => {
    // The top goes from z = 1 to z = -1, so jacdet is 1 - 2 tau everywhere.
    const { crossings } = morphOf(
      core,
      unitCube,
      unitCube.map((x, i) => (i % 3 === 2 && i >= 12 ? -x : x)),
    )
    expect(crossings).toEqual([{ validTau: 0.49999999999999994, invalidTau: 0.5 }])
  })

  it('sees a dip between two samples, too', () => {
    // A box whose width and height pass through zero at 32.3/64 and 32.7/64: of negative volume in between only.
    const box = (tau: number) => {
      const [width, height] = [tau - 32.3 / 64, tau - 32.7 / 64]
      return unitCube.map((x, i) => x * ([width, 1, height][i % 3] as number))
    }
    const morph = morphOf(core, box(0), box(1))
    expectNeighbours(morph)
    expect(morph.crossings.map(({ invalidTau }) => Math.round(invalidTau * 6400))).toEqual([3230, 3270])
  })

  it('is sampled in order from 0 to 1, and the same again', () => {
    const [a, b] = [unitCube, preset('edge-negative')]
    const morph = morphOf(core, a, b)
    const taus = morph.samples.map(({ tau }) => tau)
    expect(taus).toEqual(taus.toSorted((x, y) => x - y))
    expect(new Set(taus).size).toBe(taus.length)
    expect([taus[0], taus.at(-1), taus.length >= 65]).toEqual([0, 1, true])
    expect(morphOf(core, a, b)).toEqual(morph)
  })

  it('from an element to itself is flat', () => {
    const { samples, crossings } = morphOf(core, unitCube, unitCube)
    expect(new Set(samples.map(({ minimum }) => minimum))).toEqual(new Set([1]))
    expect(crossings).toEqual([])
  })
})
