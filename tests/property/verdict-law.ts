/**
 * The law that verdicts are certain: isValid, the report and the certificate agree, and the certificate passes the independent
 * check. What was met is counted, so that a test can say that it has seen what it was made for.
 */
import fc from 'fast-check'
import { expect } from 'vitest'
import { type Certificate, certify } from '../../web/core/exact/certificate'
import type { CandidateKind, Report } from '../../web/core/report'
import type { Vertices } from '../../web/model/hexahedron'
import { isWhole } from '../exact/scale'
import { core } from '../unit/core-fixtures'
import { borderCrossing, CROSSING_SIZE, hexahedraOf, type Mover } from './border'
import { flawOf } from './certificate-check'
import type { Reason } from './integer-jacdet'
import { holdsFor, replayed } from './replay'

export interface Tally {
  total: number
  valid: number
  invalid: number
  /** Decided by exact arithmetic. */
  exact: number
  minimizers: Record<CandidateKind, number>
  reasons: Record<Reason, number>
}

export function emptyTally(): Tally {
  return {
    total: 0,
    valid: 0,
    invalid: 0,
    exact: 0,
    minimizers: { vertex: 0, edge: 0, face: 0 },
    reasons: { b: 0, '2a+b': 0, D: 0, middle: 0 },
  }
}

export function analyzed(vertices: Vertices): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** Throws where the law does not hold. */
export function holdsVerdictLaw(vertices: Vertices, tally: Tally): void {
  const { report, certificate } = holdsFor(vertices, () => lawful(vertices))
  ++tally.total
  ++tally[report.valid ? 'valid' : 'invalid']
  ++tally.minimizers[report.minimizer.kind]
  if (report.decidedBy === 'exact') ++tally.exact
  if (certificate.valid) for (const { by } of certificate.faces.flat()) ++tally.reasons[by]
}

function lawful(vertices: Vertices): { report: Report; certificate: Certificate } {
  const certificate = certify(vertices)
  const flaw = flawOf(certificate, vertices)
  if (flaw) throw new Error(`The certificate is wrong: ${flaw}.`)
  const verdict = core.isValid(vertices)
  if (!verdict.ok) throw new Error(verdict.error.message)
  const report = analyzed(vertices)
  const said = { certificate: certificate.valid, isValid: verdict.value, report: report.valid }
  if (new Set(Object.values(said)).size > 1) throw new Error(`The verdicts are ${JSON.stringify(said)}.`)
  const { boundaryMinimum } = report
  if (boundaryMinimum > 0 !== report.valid) throw new Error(`The minimum ${boundaryMinimum} contradicts the verdict.`)
  return { report, certificate }
}

/** `npm run test:exact` draws all of more than 100,000 hexahedra, `npm test` a fifth. */
export function drawn(count: number): number {
  return isWhole ? count : count / 5
}

/** The two files' crossings, in whole more than 50,000 hexahedra; those of a whole segment take longer. */
export const CROSSINGS = { segments: drawn(1300), moves: drawn(1900) }

/** Against hanging only: half a minute where nothing else runs. */
export const TIMEOUT = 600_000

/** The law at the border, with as much of every kind as makes it one. */
export function expectVerdictLawAtBorder(crossings: number, ...movers: readonly Mover[]): void {
  const tally = emptyTally()
  fc.assert(
    fc.property(borderCrossing(...movers), crossing => {
      for (const vertices of hexahedraOf(crossing)) holdsVerdictLaw(vertices, tally)
    }),
    replayed(crossings),
  )
  expect(tally.total).toBeGreaterThanOrEqual(crossings * CROSSING_SIZE)
  expect(Math.min(tally.valid, tally.invalid)).toBeGreaterThan(0.4 * tally.total)
  expect(tally.exact).toBeGreaterThan(0.5 * tally.total)
  expect(Math.min(...Object.values(tally.minimizers))).toBeGreaterThan(0.002 * tally.total)
  expect(Math.min(tally.reasons.D, tally.reasons.middle)).toBeGreaterThan(0.1 * tally.total)
}
