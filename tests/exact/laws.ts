/** Questions to C about a hexahedron, in every way there is, against the oracle and a proof. */
import type { PieceResult } from '../../web/core/batch/batch-core'
import { certify } from '../../web/core/exact/certificate'
import type { Report } from '../../web/core/report'
import type { Vertices } from '../../web/model/hexahedron'
import { scaledDouble } from '../../web/model/rational'
import { oracleOf } from '../oracle/exact-boundary'
import { flawOf } from '../property/certificate-check'
import { core } from '../unit/core-fixtures'
import { batchCores } from '../unit/node-workers'

export interface Asked {
  readonly report: Report
  readonly valid: boolean
  /** The boundary minimum by Algorithm 1: its exponent is its own. */
  readonly value: number
  readonly exponent: number
}

export function asked(vertices: Vertices): Asked {
  const analyzed = core.analyze(vertices)
  const decided = core.isValid(vertices)
  const minimum = core.boundaryMinimum(vertices, 'roots-b')
  if (!analyzed.ok || !decided.ok || !minimum.ok) throw new Error('The core refuses it.')
  const { minimizer, exponent } = minimum.value
  return { report: analyzed.value, valid: decided.value, value: minimizer.value, exponent }
}

/** Throws where C is not as exact arithmetic is. */
export function expectAsOracle(vertices: Vertices): Report {
  const { report, valid, value, exponent } = asked(vertices)
  const { exponent: unit, boundaryMinimum, boundaryMinimumError, decidedBy } = report
  const oracle = oracleOf(vertices)
  const verdicts = { oracle: oracle.valid, query: valid, report: report.valid, minimum: value > 0 }
  if (new Set(Object.values(verdicts)).size > 1) throw new Error(`The verdicts are ${JSON.stringify(verdicts)}.`)
  const inReport = { value: boundaryMinimum, exponent: unit, error: scaledDouble(boundaryMinimumError, unit) }
  const alone = { value, exponent, error: scaledDouble(Math.abs(value), exponent - EXACT_BITS) }
  const mistake = oracle.mistakeIn(inReport) ?? (decidedBy === 'exact' ? oracle.mistakeIn(alone) : null)
  if (mistake) throw new Error(mistake)
  return report
}

/** A number from integers is off by at most 2^-52 of itself. */
const EXACT_BITS = 52

/** Throws where the verdict is not proved. */
export function expectProved(vertices: Vertices, { valid }: Report): void {
  const certificate = certify(vertices)
  const flaw = flawOf(certificate, vertices)
  if (flaw) throw new Error(`The proof is wrong: ${flaw}.`)
  if (certificate.valid !== valid) throw new Error(`The proof says ${certificate.valid}, the core ${valid}.`)
}

/** Verdicts of many, the same with vectors and without. */
export function classified(points: Float64Array): Uint8Array {
  const piece = { points, cells: null, firstPoint: 0 }
  const [{ valid, unansweredCount }, scalar] = [batchCores.vectors, batchCores.scalar].map(batchCore =>
    batchCore.classify(piece, {}),
  ) as [PieceResult, PieceResult]
  if (unansweredCount + scalar.unansweredCount > 0) throw new Error('A cell is unanswered.')
  const other = valid.findIndex((one, cell) => one !== scalar.valid[cell])
  if (other >= 0) throw new Error(`Cell ${other} is ${valid[other]} with vectors and ${scalar.valid[other]} without.`)
  return valid
}
