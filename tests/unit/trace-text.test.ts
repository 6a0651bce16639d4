/** The steps of Algorithm 1 in words, and M as a staircase. */
import { describe, expect, it } from 'vitest'
import { presets, presetVertices } from '../../web/model/presets'
import { minimumPlot } from '../../web/panels/algorithm/minimum-plot'
import { answerSentence, stepOutcome, stepSentence, type TraceShown } from '../../web/panels/algorithm/step-text'
import { type TraceOptions, traceOf } from '../../web/panels/algorithm/trace'
import { core, unitCube } from './core-fixtures'

function shownOf(vertices: readonly number[], options: TraceOptions): TraceShown {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return { ...options, report: result.value, cube: 'unit' }
}

function sentences(vertices: readonly number[], options: TraceOptions): string[] {
  const shown = shownOf(vertices, options)
  return traceOf(shown.report, shown).map(step => stepSentence(step, shown).replaceAll('\u00a0', ' '))
}

const preset = (id: string) => presetVertices(presets.find(each => each.id === id) ?? presets[0])

describe('the sentences', () => {
  it('follow a minimum query through vertices, edges and faces', () => {
    const all = sentences(preset('looks-fine'), { query: 'minimum', variant: 'roots-b' })
    expect(all[0]).toBe('Vertex 0: J = 1/8, the first value, so M = 1/8.')
    expect(all[1]).toBe('Vertex 1: J = 3/16 is not below M = 1/8.')
    expect(all[2]).toBe('Vertex 2: J = 1/8 is what M is already.')
    expect(all[8]).toMatch(
      /^Edge 0–1: its parabola opens (up|down)wards, .*so its least value is at an end, a vertex already seen\.$/,
    )
    expect(all[14]).toBe(
      'Edge 6–7: its parabola opens upwards with its vertex inside, at ξ = 0.40909; J = −0.010653 is below M = 3/64, so M becomes −0.010653.',
    )
    expect(all[15]).toMatch(/J = −0\.010653 is below M in digits not shown, and M becomes that\.$/)
    expect(all[22]).toBe(
      'Face −η: skipped, since its Bernstein bound 7/64 is not below M = −0.010653 and nothing on it is lower.',
    )
    expect(all[25]).toMatch(
      /^Face \+ζ: its Bernstein bound −.* is below M = −0\.010653; its quartic gives one point, \(ξ, η, ζ\) = \(.*, 1\); J = −0\.0063862 is not below M = −0\.010653\.$/,
    )
  })

  it('of a validity query speak of signs and end with its answer', () => {
    const valid: TraceOptions = { query: 'validity', variant: 'roots-b' }
    const all = sentences(unitCube, valid)
    expect(all[3]).toBe('Vertex 3: J = 1 is positive.')
    expect(all[8]).toBe('Edge 0–1: jacdet is linear along it, so its least value is at an end, a vertex already seen.')
    expect(all[20]).toBe('Face −ξ: skipped, since its Bernstein bound 1 is positive and nothing on it is lower.')
    expect(sentences(unitCube, { query: 'validity', variant: 'roots' })[20]).toBe(
      'Face −ξ: its quartic is identically zero, so the edges, already seen, suffice.',
    )
    const shown = shownOf(preset('face-negative'), valid)
    const steps = traceOf(shown.report, shown)
    const last = steps.at(-1)
    expect(last && stepSentence(last, shown)).toMatch(/^Face −ζ: its Bernstein bound −.* is not positive; its quartic/)
    expect(last && answerSentence(last, shown)).toBe('The query stops here: the element is invalid.')
  })

  it('never leave a number or a name out, for any preset, query and variant', () => {
    for (const each of presets)
      for (const query of ['minimum', 'validity'] as const)
        for (const variant of ['roots', 'roots-b'] as const) {
          const shown = shownOf(
            presetVertices(each, () => 0.3),
            { query, variant },
          )
          for (const step of traceOf(shown.report, shown)) {
            const text = `${stepSentence(step, shown)} ${answerSentence(step, shown)} ${stepOutcome(step, shown)}`
            expect(text).toMatch(/^(Vertex \d|Edge \d–\d|Face [−+][ξηζ]): \S/)
            expect(text).not.toMatch(/undefined|null|NaN|= [,;.]| {2}|Infinity/)
          }
        }
  })
})

describe('the staircase', () => {
  const box = { width: 260, height: 40 }

  it('falls from top to bottom, with a mark on each tread', () => {
    const shown = shownOf(preset('looks-fine'), { query: 'minimum', variant: 'roots' })
    const { path, marks, zero } = minimumPlot(traceOf(shown.report, shown), 26, box)
    expect(path).toMatch(/^M0 0H10/)
    expect(path).toMatch(/H260$/)
    expect(marks.map(({ x }) => x)).toEqual(Array.from({ length: 26 }, (_, i) => 10 * i + 5))
    expect(marks.every(({ y }, i) => i === 0 || y >= (marks[i - 1]?.y ?? 0))).toBe(true)
    expect([marks[0]?.y, marks[25]?.y]).toEqual([0, 40])
    expect(zero).toBeGreaterThan(0)
    expect(zero).toBeLessThan(40)
  })

  it('is level where M is, and stays inside the box for any size', () => {
    const level = shownOf(unitCube, { query: 'minimum', variant: 'roots' })
    expect(minimumPlot(traceOf(level.report, level), 26, box).marks.every(({ y }) => y === 20)).toBe(true)
    for (const scale of [2 ** 341, 2 ** -350]) {
      const shown = shownOf(
        preset('looks-fine').map(x => x * scale),
        { query: 'minimum', variant: 'roots' },
      )
      const { marks } = minimumPlot(traceOf(shown.report, shown), 26, box)
      expect([marks[0]?.y, marks[25]?.y]).toEqual([0, 40])
    }
  })
})
