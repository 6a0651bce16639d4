/** Reports' numbers for conditions: exact signs, and numbers of any size. */
import { describe, expect, it } from 'vitest'
import { claims, numbers, quantitiesOf, shownNumber } from '../../web/core/quantities'
import type { Report } from '../../web/core/report'
import { isMet, parseCondition, truthOf } from '../../web/model/condition'
import type { Enclosure } from '../../web/model/condition/enclosure'
import { CLAIMS, NUMBERS } from '../../web/model/condition/names'
import type { Vertices } from '../../web/model/hexahedron'
import { isAtMost } from '../../web/model/rational'
import {
  cases,
  caseVertices,
  core,
  depthGuardCases,
  entry,
  randomHexahedron,
  randomSource,
  unitCube,
} from './core-fixtures'
import { ofDecimal } from './fractions'

function reportOf(vertices: Vertices): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function truth(text: string, vertices: Vertices, start: Vertices = vertices): boolean | null {
  const result = parseCondition(text)
  if (!result.ok) throw new Error(result.error.message)
  const quantities = quantitiesOf(reportOf(vertices), start)
  const answer = truthOf(result.value, quantities)
  expect(isMet(result.value, quantities)).toBe(answer === true)
  return answer
}

const scaled = (vertices: Vertices, factor: number): Vertices => vertices.map(x => x * factor)
function overlap(a: Enclosure, b: Enclosure): boolean {
  return isAtMost(a.lower, b.upper) && isAtMost(b.lower, a.upper)
}

it('every name is described in words, and no other', () => {
  expect(Object.keys(claims)).toEqual([...CLAIMS])
  expect(Object.keys(numbers)).toEqual([...NUMBERS])
  for (const { name, sentence } of [...Object.values(claims), ...Object.values(numbers)]) {
    expect(name).not.toBe('')
    expect(sentence).toMatch(/^[A-Za-z].*\.$/)
  }
})

describe('on every case of the vectors', () => {
  it('what doubles say encloses what exact arithmetic says', () => {
    const random = randomSource(7)
    const drawn = Array.from({ length: 40 }, (_, n) => randomHexahedron(random, n / 20))
    let enclosed = 0
    for (const vertices of [...cases.map(({ name }) => caseVertices(name)), ...drawn]) {
      const report = reportOf(vertices)
      for (const name of NUMBERS) {
        const [rough, exact] = [numbers[name].roughly(report, unitCube), numbers[name].exactly(report, unitCube)]
        expect(isAtMost(exact.lower, exact.upper)).toBe(true)
        if (!rough) continue
        ++enclosed
        expect(overlap(rough, exact), `${name} of ${vertices}`).toBe(true)
      }
    }
    expect(enclosed).toBeGreaterThan(1000)
  })

  it('the signs are those of exact arithmetic', () => {
    for (const given of cases) {
      const vertices = caseVertices(given.name)
      const { sign, corner_min, edge_min, valid } = given.answer
      expect(truth(`boundary_min ${signText(sign)} 0`, vertices), given.name).toBe(true)
      expect(truth(`corner_min ${signText(signOf(corner_min))} 0`, vertices), given.name).toBe(true)
      expect(truth(`edge_min ${signText(signOf(edge_min))} 0`, vertices), given.name).toBe(true)
      expect(truth('valid', vertices), given.name).toBe(valid)
      for (const name of NUMBERS.filter(name => name !== 'volume_min'))
        expect(truth(`${name} > 0 or ${name} <= 0`, vertices), `${name} of ${given.name}`).toBe(true)
    }
  })
})

function signText(sign: number): string {
  return entry(['<', '=', '>'], sign + 1)
}

function signOf(decimal: string): number {
  const { numerator } = ofDecimal(decimal)
  return numerator < 0n ? -1 : numerator > 0n ? 1 : 0
}

describe('of the unit cube', () => {
  it.each(NUMBERS.filter(name => !['moved', 'twist'].includes(name) && !name.startsWith('gauss')))(
    '%s is 1, exactly',
    name => {
      const { value, exponent } = shownNumber(name, reportOf(unitCube), unitCube)
      expect([value, exponent]).toEqual([1, 0])
      if (name !== 'scaled_jacobian') expect(truth(`${name} = 1`, unitCube)).toBe(true)
    },
  )

  it.each(NUMBERS.filter(name => !['moved', 'twist', 'scaled_jacobian'].includes(name)))(
    '%s grows with the cube of the size, far outside the doubles too',
    name => {
      for (const power of [-300, 300]) {
        const large = scaled(unitCube, 10 ** power)
        expect(truth(`${name} > 0`, large)).toBe(true)
        expect(
          truth(`${name} ${power > 0 ? '>' : '<'} 1e${1.1 * power}`, scaled(unitCube, 2 ** (power > 0 ? 400 : -400))),
        ).toBe(true)
      }
    },
  )
})

it('twist is an angle whose size does not matter, exactly known where nothing is turned or half a turn', () => {
  expect(truth('twist = 0', unitCube)).toBe(true)
  expect(truth('twist = 0', scaled(unitCube, 1e-300))).toBe(true)
  const half = unitCube.map((x, i) => (i < 12 || i % 3 === 2 ? x : 1 - x))
  expect(truth('twist = 180', half)).toBe(true)
  const quarter = unitCube.map((x, i, all) =>
    i < 12 || i % 3 === 2 ? x : i % 3 === 0 ? -(all[i + 1] ?? 0) : (all[i - 1] ?? 0),
  )
  expect(truth('89.999999999 < twist < 90.000000001', quarter)).toBe(true)
})

it('moved counts vertices that differ from the start, and zero has no sign', () => {
  const moved = unitCube.with(4, 2).with(5, 3).with(21, 0.5).with(0, -0)
  expect(truth('moved = 2', moved, unitCube)).toBe(true)
  expect(truth('moved = 0', unitCube.with(0, -0), unitCube)).toBe(true)
})

it('a subdivision that gives up rejects valid elements', () => {
  for (const { vertices } of depthGuardCases.slice(0, 5))
    expect(truth('valid and subdivision <= 0', vertices.flat())).toBe(true)
})

it('the volume minimum is below that of the boundary only where it is', () => {
  const random = randomSource(3)
  let gaps = 0
  for (let n = 0; n < 200; ++n) {
    const vertices = randomHexahedron(random, 0.6)
    const { valid, boundaryMinimum, volumeMinimum, minimizer } = reportOf(vertices)
    const isLower = truth('volume_min < boundary_min', vertices)
    if (valid) expect(isLower).not.toBe(true)
    if (isLower) expect(volumeMinimum.upper).toBeLessThan(boundaryMinimum)
    if (isLower) ++gaps
    if (valid && minimizer.kind !== 'face') expect(truth('volume_min = boundary_min', vertices)).toBe(true)
  }
  expect(gaps).toBeGreaterThan(0)
})
