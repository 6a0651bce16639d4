/** The steps of Algorithm 1 in words: one plain sentence each, and the few words of the list. */
import type { Report } from '../../core/report'
import { formatJacdet, formatNumber, formatPoint, fractionOf } from '../../model/decimal'
import type { Vec3 } from '../../model/hexahedron'
import type { ReferenceCube } from '../../model/state'
import { entityTitle } from '../../views/entity-name'
import { listed, say } from '../../words/say'
import type { TraceOptions, TraceStep } from './trace'

export interface TraceShown extends TraceOptions {
  readonly report: Report
  readonly cube: ReferenceCube
}

const AXES = ['ξ', 'η', 'ζ']

export function stepSentence(step: TraceStep, shown: TraceShown): string {
  const clause = step.kind === 'face' ? onFace(step, shown) : onEdge(step, shown)
  return say('{entity}: {clause}.', { entity: entityTitle(step), clause })
}

export function answerSentence({ after, stops }: TraceStep, shown: TraceShown): string {
  if (shown.query === 'minimum')
    return say('Done: the boundary minimum is {minimum}.', { minimum: jacdet(after, shown) })
  if (stops) return say('The query stops here: the element is invalid.')
  return say('Done. Every value is positive: the element is valid.')
}

/** A step's outcome, for the list. */
export function stepOutcome({ kind, outcome, value }: TraceStep, shown: TraceShown): string {
  if (value !== null) return jacdet(value, shown)
  if (outcome === 'bound') return say('skipped')
  return kind === 'edge' ? say('no vertex inside') : say('no point inside')
}

export function jacdet(value: number | null, { report, cube }: TraceShown): string {
  return value === null ? '' : formatJacdet(value, report.exponent, cube)
}

function onEdge(step: TraceStep, shown: TraceShown): string {
  switch (step.outcome) {
    case 'straight':
      return say('jacdet is linear along it, so its least value is at an end, a vertex already seen')
    case 'concave':
      return say('its parabola opens downwards, so its least value is at an end, a vertex already seen')
    case 'vertex-outside':
      return say(
        'its parabola opens upwards, but its vertex is not strictly inside, so its least value is at an end, a vertex already seen',
      )
    default:
      if (step.kind === 'vertex') return compared(step, shown)
      return say('its parabola opens upwards with its vertex inside, at {place}; {comparison}', {
        place: along(step.points[0]?.point),
        comparison: compared(step, shown),
      })
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
  const bound = jacdet(face.lowerBound, shown)
  const m = jacdet(step.before, shown)
  const isMinimum = shown.query === 'minimum'
  if (step.outcome === 'bound') {
    return isMinimum
      ? say('skipped, since its Bernstein bound {bound} is not below M\u00a0=\u00a0{m} and nothing on it is lower', {
          bound,
          m,
        })
      : say('skipped, since its Bernstein bound {bound} is positive and nothing on it is lower', { bound })
  }
  const outcome = found(step, face.roots.length, shown)
  if (shown.variant === 'roots') return outcome
  return isMinimum
    ? say('its Bernstein bound {bound} is below M\u00a0=\u00a0{m}; {outcome}', {
        bound,
        m,
        outcome,
      })
    : say('its Bernstein bound {bound} is not positive; {outcome}', { bound, outcome })
}

function found(step: TraceStep, rootCount: number, shown: TraceShown): string {
  const { outcome, points } = step
  const comparison = compared(step, shown)
  if (outcome === 'quartic-zero') return say('its quartic is identically zero, so the edges, already seen, suffice')
  if (outcome === 'no-root') return say('its quartic has no root in (0, 1), so nothing inside can be the minimum')
  if (outcome === 'no-root-kept')
    return rootCount === 1
      ? say('its quartic has one root in (0, 1), but there no parabola opens upwards with its vertex inside')
      : say('its quartic has {count} roots in (0, 1), but there no parabola opens upwards with its vertex inside', {
          count: rootCount,
        })
  if (points.length === 1)
    return say('its quartic gives one point, (ξ, η, ζ) = {point}; {comparison}', {
      point: formatPoint(points[0]?.point ?? [0, 0, 0]),
      comparison,
    })
  return say('its quartic gives {count} points with J\u00a0=\u00a0{values}; of the least, {comparison}', {
    count: points.length,
    values: listed(points.map(({ value }) => jacdet(value, shown))),
    comparison,
  })
}

function compared({ value, before }: TraceStep, shown: TraceShown): string {
  const [now, m] = [jacdet(value, shown), jacdet(before, shown)]
  if (value === null) return ''
  if (shown.query === 'validity')
    return value > 0
      ? say('J\u00a0=\u00a0{now} is positive', { now })
      : say('J\u00a0=\u00a0{now} is not positive', { now })
  if (before === null) return say('J\u00a0=\u00a0{now}, the first value, so M\u00a0=\u00a0{now}', { now })
  if (value < before && now === m)
    return say('J\u00a0=\u00a0{now} is below M in digits not shown, and M becomes that', { now })
  if (value < before) return say('J\u00a0=\u00a0{now} is below M\u00a0=\u00a0{m}, so M becomes {now}', { now, m })
  return value === before
    ? say('J\u00a0=\u00a0{now} is what M is already', { now })
    : say('J\u00a0=\u00a0{now} is not below M\u00a0=\u00a0{m}', { now, m })
}
