/** Algorithm 1 step by step against the report it is derived from, on hard cases, presets and random elements. */
import { describe, expect, it } from 'vitest'
import type { Candidate, Report } from '../../web/core/report'
import { presets, presetVertices } from '../../web/model/presets'
import { type TraceOptions, type TraceStep, traceOf } from '../../web/panels/algorithm/trace'
import { cases, core, depthGuardCases, randomHexahedron, randomSource } from './core-fixtures'

const MINIMUM: TraceOptions = { query: 'minimum', variant: 'roots' }
const MINIMUM_B: TraceOptions = { query: 'minimum', variant: 'roots-b' }
const VALIDITY: TraceOptions = { query: 'validity', variant: 'roots' }
const VALIDITY_B: TraceOptions = { query: 'validity', variant: 'roots-b' }

function reportOf(vertices: readonly number[]): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

const random = randomSource(20261122)
const elements: readonly (readonly [string, Report])[] = [
  ...presets.map(preset => [preset.id, reportOf(presetVertices(preset, random))] as const),
  ...cases.map(({ name, vertices }) => [name, reportOf(vertices.flat())] as const),
  ...depthGuardCases.map(({ name, vertices }) => [name, reportOf(vertices.flat())] as const),
  ...Array.from({ length: 400 }, (_, n) => [`random ${n}`, reportOf(randomHexahedron(random, (n % 20) / 10))] as const),
]

const last = (steps: readonly TraceStep[]) => steps[steps.length - 1] as TraceStep
const pointsOf = (steps: readonly TraceStep[]) => steps.flatMap(({ points }) => points)
const inOrder = (candidates: readonly Candidate[]) => candidates.map(({ kind, id, value }) => `${kind} ${id} ${value}`)

describe('a minimum query', () => {
  it('ends with the boundary minimum of the report, with either variant', () => {
    for (const [name, report] of elements)
      for (const options of [MINIMUM, MINIMUM_B]) {
        const steps = traceOf(report, options)
        expect(steps.length, name).toBe(26)
        expect(last(steps).after, name).toBe(report.boundaryMinimum)
        expect(steps.some(({ stops }) => stops)).toBe(false)
      }
  })

  it('without bounds evaluates every candidate once, in the order of the report', () => {
    for (const [name, report] of elements)
      expect(inOrder(pointsOf(traceOf(report, MINIMUM))), name).toEqual(inOrder(report.candidates))
  })

  it('never skips the face that holds the minimum, and skips as the report says where doubles decide', () => {
    const decided = new Set<Report['decidedBy']>()
    for (const [name, report] of elements) {
      decided.add(report.decidedBy)
      for (const { id, outcome, before, after } of traceOf(report, MINIMUM_B).slice(20)) {
        const face = report.faces[id] as Report['faces'][number]
        if (report.decidedBy === 'filter') {
          expect(before, name).toBe(face.runningMinimum)
          expect(outcome === 'bound', name).toBe(face.skippedByMinimumRule)
        }
        if (outcome !== 'bound') continue
        expect(after).toBe(before)
        for (const candidate of report.candidates.filter(c => c.kind === 'face' && c.id === id))
          expect(candidate.value, name).toBeGreaterThanOrEqual(before as number)
      }
    }
    expect(decided).toEqual(new Set(['filter', 'exact']))
  })

  it('lowers M exactly where a value is below it, and never raises it', () => {
    for (const [name, report] of elements) {
      let before: number | null = null
      for (const step of traceOf(report, MINIMUM_B)) {
        expect(step.before, name).toBe(before)
        const isLower: boolean = step.value !== null && (before === null || step.value < before)
        expect(step.after, name).toBe(isLower ? step.value : before)
        before = step.after
      }
    }
  })
})

describe('a validity query', () => {
  it('stops at its first value that is not positive, and only for an invalid element', () => {
    for (const [name, report] of elements)
      for (const options of [VALIDITY, VALIDITY_B]) {
        const steps = traceOf(report, options)
        expect(last(steps).stops, name).toBe(!report.valid)
        const values = pointsOf(steps).map(({ value }) => value)
        expect(
          values.findIndex(value => value <= 0),
          name,
        ).toBe(report.valid ? -1 : values.length - 1)
        expect(steps.slice(0, -1).some(({ stops }) => stops)).toBe(false)
      }
  })

  it('skips only faces with a positive bound, and with Roots none', () => {
    for (const [, report] of elements) {
      for (const { kind, id, outcome } of traceOf(report, VALIDITY_B))
        if (kind === 'face') expect(outcome === 'bound').toBe(report.faces[id]?.skippedByValidityRule)
      expect(traceOf(report, VALIDITY).some(({ outcome }) => outcome === 'bound')).toBe(false)
    }
  })
})

it('says why an edge or a face has no candidate, by every reason there is', () => {
  const cube = reportOf([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1])
  expect(traceOf(cube, MINIMUM).map(({ outcome }) => outcome)).toEqual([
    ...Array(8).fill('evaluated'),
    ...Array(12).fill('straight'),
    ...Array(6).fill('quartic-zero'),
  ])
  const seen = new Set(elements.flatMap(([, report]) => traceOf(report, MINIMUM_B).map(({ outcome }) => outcome)))
  expect([...seen].sort()).toEqual(
    ['bound', 'concave', 'evaluated', 'no-root', 'no-root-kept', 'quartic-zero', 'straight', 'vertex-outside'].sort(),
  )
})
