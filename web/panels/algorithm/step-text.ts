/** The steps of Algorithm 1 in words: one plain sentence each, and the few words of the list. */
import type { Report } from '../../core/report'
import { formatJacdet, formatNumber, formatPoint, fractionOf } from '../../model/decimal'
import type { Vec3 } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { entityTitle, listed } from '../../views/entity-name'
import type { TraceOptions, TraceStep } from './trace'

export interface TraceShown extends TraceOptions {
  readonly report: Report
  readonly cube: ReferenceCube
}

const AXES = ['ξ', 'η', 'ζ']

export function stepSentence(step: TraceStep, shown: TraceShown): string {
  return `${entityTitle(step)}: ${step.kind === 'face' ? onFace(step, shown) : onEdge(step, shown)}.`
}

export function answerSentence({ after, stops }: TraceStep, shown: TraceShown): string {
  if (shown.query === 'minimum') return `Done: the boundary minimum is ${jacdet(after, shown)}.`
  if (stops) return 'The query stops here: the element is invalid.'
  return 'Done. Every value is positive: the element is valid.'
}

/** A step's outcome, for the list. */
export function stepOutcome({ kind, outcome, value }: TraceStep, shown: TraceShown): string {
  if (value !== null) return jacdet(value, shown)
  if (outcome === 'bound') return 'skipped'
  return kind === 'edge' ? 'no vertex inside' : 'no point inside'
}

export function jacdet(value: number | null, { report, cube }: TraceShown): string {
  return value === null ? '' : formatJacdet(value, report.exponent, cube)
}

function onEdge(step: TraceStep, shown: TraceShown): string {
  const atEnd = 'so its least value is at an end, a vertex already seen'
  switch (step.outcome) {
    case 'straight':
      return `jacdet is linear along it, ${atEnd}`
    case 'concave':
      return `its parabola opens downwards, ${atEnd}`
    case 'vertex-outside':
      return `its parabola opens upwards, but its vertex is not strictly inside, ${atEnd}`
    default:
      if (step.kind === 'vertex') return compared(step, shown)
      return `its parabola opens upwards with its vertex inside, at ${along(step.points[0]?.point)}; ${compared(step, shown)}`
  }
}

/** "η = 0.5909": the one coordinate that is inside. */
function along(point: Vec3 = [0, 0, 0]): string {
  const axis = point.findIndex(x => x > 0 && x < 1)
  const value = point[axis] ?? 0
  return `${AXES[axis]} = ${fractionOf(value) ?? formatNumber(value)}`
}

function onFace(step: TraceStep, shown: TraceShown): string {
  const face = shown.report.faces[step.id] as Report['faces'][number]
  const bound = `Bernstein bound ${jacdet(face.lowerBound, shown)}`
  if (step.outcome === 'bound') {
    return shown.query === 'minimum'
      ? `skipped, since its ${bound} is not below M\u00a0=\u00a0${jacdet(step.before, shown)} and nothing on it is lower`
      : `skipped, since its ${bound} is positive and nothing on it is lower`
  }
  return `${solving(step, bound, shown)}${found(step, face.roots.length, shown)}`
}

/** Why the quartic is solved. */
function solving({ before }: TraceStep, bound: string, shown: TraceShown): string {
  if (shown.variant === 'roots') return 'its quartic '
  const fails = shown.query === 'minimum' ? `below M\u00a0=\u00a0${jacdet(before, shown)}` : 'not positive'
  return `its ${bound} is ${fails}, so its quartic is solved; it `
}

function found(step: TraceStep, rootCount: number, shown: TraceShown): string {
  const { outcome, points } = step
  const roots = rootCount === 1 ? 'one root' : `${rootCount} roots`
  if (outcome === 'quartic-zero') return 'is identically zero, so the edges, already seen, suffice'
  if (outcome === 'no-root') return 'has no root in (0, 1), so nothing inside can be the minimum'
  if (outcome === 'no-root-kept')
    return `has ${roots} in (0, 1), but there no parabola opens upwards with its vertex inside`
  if (points.length === 1)
    return `gives one point, (ξ, η, ζ) = ${formatPoint(points[0]?.point ?? [0, 0, 0])}; ${compared(step, shown)}`
  const values = listed(points.map(({ value }) => jacdet(value, shown)))
  return `gives ${points.length} points with J\u00a0=\u00a0${values}; of the least, ${compared(step, shown)}`
}

function compared({ value, before }: TraceStep, shown: TraceShown): string {
  const [now, m] = [jacdet(value, shown), jacdet(before, shown)]
  if (value === null) return ''
  if (shown.query === 'validity') return `J\u00a0=\u00a0${now} is ${value > 0 ? 'positive' : 'not positive'}`
  if (before === null) return `J\u00a0=\u00a0${now}, the first value, so M\u00a0=\u00a0${now}`
  if (value < before && now === m) return `J\u00a0=\u00a0${now} is below M in digits not shown, and M becomes that`
  if (value < before) return `J\u00a0=\u00a0${now} is below M\u00a0=\u00a0${m}, so M becomes ${now}`
  return value === before
    ? `J\u00a0=\u00a0${now} is what M is already`
    : `J\u00a0=\u00a0${now} is not below M\u00a0=\u00a0${m}`
}
