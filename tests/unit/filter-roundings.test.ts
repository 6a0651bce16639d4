/** The filter's intervals hold what roundings make of numbers: near equality it leaves open what doubles get wrong. */
import { describe, expect, test } from 'vitest'
import { FALSE, filterOf, TRUE, type Truth } from '../../web/core/filter/filter'
import { quantitiesOf } from '../../web/core/quantities'
import { type Condition, isMet, parseCondition } from '../../web/model/condition'
import type { NumberNode } from '../../web/model/condition/parse'
import { measured, parseMeasure } from '../../web/pages/search/engine/measure'
import { core, randomSource, unitCube } from './core-fixtures'

const seed = 2020
const random = randomSource(seed)

function conditionOf(text: string): Condition {
  const result = parseCondition(text)
  if (!result.ok) throw new Error(`${text}: ${result.error.message}`)
  return result.value
}

function measureOf(text: string): NumberNode {
  const result = parseMeasure(text)
  if (!result.ok) throw new Error(`${text}: ${result.error.message}`)
  return result.value
}

function analyzed(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** Neither answer of the filter is another one than exact arithmetic's. */
function expectCertain(text: string, vertices: readonly number[]): void {
  const condition = conditionOf(text)
  const report = analyzed(vertices)
  const truth = answerOf(text, vertices)
  const met = isMet(condition, quantitiesOf(report, unitCube))
  if (truth === FALSE) expect(met, `${text}: ${vertices}`).toBe(false)
  if (truth === TRUE) expect(met, `${text}: ${vertices}`).toBe(true)
}

function answerOf(text: string, vertices: readonly number[]): Truth {
  const filter = filterOf(conditionOf(text), measureOf('volume'), unitCube, core)
  return filter.judge(Float64Array.from(vertices), 0, analyzed(vertices).valid)
}

const COMPARISONS = ['<', '<=', '>', '>=', '=', '!='] as const

describe(`seed ${seed}`, () => {
  test('sums, products and quotients that are equal are found so, whatever doubles make of them', () => {
    for (let n = 0; n < 60; ++n) {
      const [a, b, c, k] = [1, 2, 3, 4].map(() => 1 + Math.floor(9 * random())) as [number, number, number, number]
      const box = unitCube.map((x, i) => x * ([a, b, c][i % 3] as number))
      const volume = a * b * c
      const tenths = (value: number) => `${Math.floor(value / 10)}.${value % 10}`
      for (const sign of COMPARISONS) {
        expectCertain(`corner_min * 0.${k} ${sign} ${tenths(volume * k)}`, box)
        expectCertain(`volume / 10 ${sign} ${tenths(volume)}`, box)
        expectCertain(`centre + 0.${k} - 0.1 ${sign} corner_min + 0.${k} - 1 / 10`, box)
        expectCertain(`volume / ${k} * ${k} ${sign} ${volume}`, box)
      }
    }
  })

  test('each operation is as far off as it rounds', () => {
    for (let n = 0; n < 40; ++n) {
      const box = unitCube.map((x, i) => x * (900 + ((n + i) % 3) + Math.floor(400 * random()) / 4))
      const corner = analyzed(box).cornerMinimum
      const skew = unitCube.map(x => 6 * x + Math.floor(9 * random()))
      const { volume, volumeExponent } = analyzed(skew)
      const large = 2 ** 50
      const cases: readonly (readonly [text: string, value: number, vertices: readonly number[]])[] = [
        ['corner_min * corner_min', corner * corner, box],
        [`corner_min * ${2 ** 40} + 0.0009765625`, corner * 2 ** 40 + 2 ** -10, box],
        [`corner_min * ${2 ** 40} - 0.0009765625`, corner * 2 ** 40 - 2 ** -10, box],
        [`corner_min * ${2 ** 50} / 3`, (corner * 2 ** 50) / 3, box],
        [`volume * ${large}`, volume * 2 ** volumeExponent * large, skew],
      ]
      for (const [text, value, vertices] of cases)
        for (const sign of COMPARISONS) expectCertain(`${text} ${sign} ${BigInt(value)}`, vertices)
    }
  })

  test('what does not round is decided at once', () => {
    const box = unitCube.map((x, i) => x * ([3, 5, 0.75][i % 3] as number))
    const all = ['boundary_min / volume < 1', 'volume <= 11.25', 'corner_min * 4 - 45 >= 0', 'centre / 15 > 0.75']
    expect(all.map(text => answerOf(text, box))).toEqual([FALSE, TRUE, TRUE, FALSE])
  })

  test('minima on edges and volumes of integers are beside their own doubles', () => {
    let dips = 0
    for (let n = 0; n < 150; ++n) {
      const element = unitCube.map(x => 6 * x + Math.floor(9 * random()))
      const report = analyzed(element)
      if (report.edgeMinimum < report.cornerMinimum) dips++
      const volume = report.volume * 2 ** report.volumeExponent
      for (const sign of COMPARISONS) {
        expectCertain(`edge_min ${sign} ${report.edgeMinimum}`, element)
        expectCertain(`volume ${sign} ${volume}`, element)
      }
    }
    expect(dips).toBeGreaterThan(20)
  })

  test('a measure is at most its bound', () => {
    const texts = [
      'moved / 49',
      '1 / moved',
      'volume / centre',
      '3 / volume',
      '-1 / volume / 7',
      'corner_min / 3 / centre',
      'scaled_jacobian',
    ]
    const measures = texts.map(text => ({ text, measure: measureOf(text) }))
    const everything = conditionOf('moved >= 0 and (volume > 0 or volume <= 0)')
    for (let n = 0; n < 400; ++n) {
      const element =
        n % 2 ? turnedCube() : unitCube.map((x, i) => (i < 3 * (n % 9) ? 5 * x + Math.floor(3 * random()) : x))
      const report = analyzed(element)
      for (const { text, measure } of measures) {
        const filter = filterOf(everything, measure, unitCube, core)
        filter.judge(Float64Array.from(element), 0, report.valid)
        expect(filter.measureAtMost(), `${text}: ${element}`).toBeGreaterThanOrEqual(
          measured(measure, report, unitCube),
        )
      }
    }
  })
})

/** A cube of any size, turned: its scaled Jacobian is 1. */
function turnedCube(): number[] {
  const size = 10 ** (4 * random() - 2)
  const angles = [1, 2, 3].map(() => 2 * Math.PI * random())
  return Array.from({ length: 8 }, (_, v) => {
    let point = unitCube.slice(3 * v, 3 * v + 3).map(x => size * x)
    for (const [axis, angle] of angles.entries()) {
      const [i, j] = [(axis + 1) % 3, (axis + 2) % 3]
      const [x, y] = [point[i] as number, point[j] as number]
      point = point
        .with(i, Math.cos(angle) * x - Math.sin(angle) * y)
        .with(j, Math.sin(angle) * x + Math.cos(angle) * y)
    }
    return point
  }).flat()
}
