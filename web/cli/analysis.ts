/** The output of `analyze` for one element: its report in numbers, or why there is none. */
import type { Check, Core } from '../core/report'
import { jsonNumber } from '../outputs/json-number'
import type { NamedHexahedron } from './read-hexahedra'

export function analysis(core: Core, { name, vertices }: NamedHexahedron): object {
  const result = core.analyze(vertices)
  if (!result.ok) return { name, error: result.error.message }
  const report = result.value
  const { minimizer, volumeMinimum } = report
  const jacdet = (value: number) => jsonNumber(value, report.exponent)
  return {
    name,
    valid: report.valid,
    class: report.class,
    coincident: report.coincident,
    shape: report.shape,
    boundary_min: jacdet(report.boundaryMinimum),
    boundary_min_error: jacdet(report.boundaryMinimumError),
    minimizer: { kind: minimizer.kind, id: minimizer.id, point: minimizer.point },
    corner_min: jacdet(report.cornerMinimum),
    edge_min: jacdet(report.edgeMinimum),
    volume_min: [jacdet(volumeMinimum.lower), jacdet(volumeMinimum.upper)],
    volume_minimizer: volumeMinimum.point,
    volume: jsonNumber(report.volume, report.volumeExponent),
    relative_min: report.relativeMinimum,
    decided_by: report.decidedBy,
    checks: Object.fromEntries(report.checks.map(check => [check.id, checkJson(check, jacdet)])),
  }
}

/** A scaled Jacobian is a number as it is; the others are jacdets. */
function checkJson({ id, value, passes }: Check, jacdet: (value: number) => number | string): object {
  return { value: id === 'corners-and-centre' ? value : jacdet(value), passes }
}
