/** `--json`: docs/check.schema.json. Written cell by cell, for there may be millions. */
import type { MeshCheck } from '../mesh/mesh-check'
import type { StepAnswer } from '../mesh/step-answers'
import { jsonNumber } from './json-number'
import { jsonText } from './json-text'
import type { CheckedSteps, Output } from './output'

export function jsonOutput(): Output {
  let count = 0
  return {
    lists: {},
    *file(result) {
      yield count++ === 0 ? '{"files":[\n' : ',\n'
      if ('error' in result) yield jsonText({ file: result.file, error: result.error })
      else yield* fileJson(result.file, result.check, result.steps ?? null)
    },
    *end(exit) {
      yield count === 0 ? '{"files":[' : '\n'
      yield `],"exit":${exit}}\n`
    },
  }
}

function* fileJson(file: string, check: MeshCheck, steps: CheckedSteps | null): Generator<string> {
  const head = jsonText({
    file,
    format: check.mesh.format,
    hexahedra: check.hexahedra,
    valid: check.valid,
    invalid: check.invalid,
    unanswered: check.unanswered,
    degenerate: check.degenerate,
    below: check.below,
    not_trilinear: { count: check.notTrilinear.count, valid_by_corners: check.notTrilinear.validByCorners },
    other: Object.fromEntries(check.mesh.other),
    notes: check.notes,
    ...(steps === null ? {} : { step: steps.shown + 1, steps: steps.answers.map(stepJson) }),
  })
  yield `${head.slice(0, -1)},"worst":[`
  for (const [i, cell] of check.worst.entries()) yield `${i === 0 ? '\n' : ',\n'}${jsonText(cellJson(check, cell))}`
  yield ']}'
}

function stepJson({ step, time, counts, least }: StepAnswer): object {
  return { step: step + 1, time, ...counts, relative_min: least !== null && Number.isFinite(least) ? least : null }
}

function cellJson(check: MeshCheck, cell: number): object {
  const name = { id: check.idOf(cell), index: cell, block: check.blockOf(cell) }
  const answer = check.answerTo(cell)
  if ('why' in answer) return { ...name, ...UNANSWERED, error: answer.why }
  const { report } = answer
  const { minimizer } = report
  return {
    ...name,
    valid: report.valid,
    class: report.class,
    coincident: report.coincident,
    shape: report.shape,
    boundary_min: jsonNumber(report.boundaryMinimum, report.exponent),
    relative_min: report.relativeMinimum,
    volume: jsonNumber(report.volume, report.volumeExponent),
    minimizer: { kind: minimizer.kind, id: minimizer.id, point: minimizer.point },
    decided_by: report.decidedBy,
    accepted_by: report.checks.filter(({ passes }) => passes).map(({ id }) => id),
  }
}

const UNANSWERED = {
  valid: null,
  class: null,
  coincident: [],
  shape: null,
  boundary_min: null,
  relative_min: null,
  volume: null,
  minimizer: null,
  decided_by: null,
  accepted_by: [],
}
