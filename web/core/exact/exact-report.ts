/** The report of an element on which doubles do not decide: verdict, candidates and minima from exact arithmetic. */
import type { Vec3 } from '../../model/hexahedron'
import type { Candidate, CheckId, FaceReport, Report, VolumeMinimum } from '../report'
import { check, type FilteredReport } from '../unpack'
import type { ExactBoundary, ExactCandidate } from './exact-minimum'

const KINDS: readonly Candidate['kind'][] = ['vertex', 'edge', 'face']

/** Powers of two that a normal double's leading digit can stand for. */
const NORMAL = { least: -1022, greatest: 1023 }
const LEAST_NORMAL = 2 ** NORMAL.least

/** Relative error of the exact values: they are enclosed to 2^-60 and then rounded. */
const VALUE_ERROR = 2 ** -52

/**
 * `report`, made from the exact coefficients rounded, with verdict, candidates and minima replaced by the exact ones;
 * `positionOf` maps a reference point into space. The common exponent changes only where the exact values ask for
 * another; should they span more than the doubles do, those too small become the least normal double of their sign.
 */
export function exactReport(
  report: FilteredReport,
  { sign, candidates, minimizer, skippedFaces }: ExactBoundary,
  positionOf: (point: Vec3) => Vec3,
): Report {
  const exponent = commonExponent(candidates, report.exponent)
  const inUnits = (candidate: ExactCandidate): Candidate => {
    const { kind, id, point } = candidate
    return { kind, id, point, position: positionOf(point), value: inUnitsOf(exponent, candidate) }
  }
  const least = inUnits(minimizer)
  const boundaryMinimumError = errorOf(least.value)
  const map = (value: number) => timesPowerOfTwo(value, report.exponent - exponent)
  const inNewUnits = mapped(report, map)
  // By their exact bound these are no lower than the minimum, whatever rounding says.
  const skipped = inNewUnits.candidates
    .filter(({ kind, id }) => kind === 'face' && skippedFaces.includes(id))
    .map(candidate => ({ ...candidate, value: Math.max(candidate.value, least.value) }))
  const leastOf = (...kinds: Candidate['kind'][]) =>
    Math.min(...candidates.filter(({ kind }) => kinds.includes(kind)).map(candidate => inUnitsOf(exponent, candidate)))
  const cornerMinimum = leastOf('vertex')
  const edgeMinimum = leastOf('vertex', 'edge')
  const exactChecks: Partial<Record<CheckId, number>> = { corners: cornerMinimum, edges: edgeMinimum }
  const onBoundary = {
    lower: least.value - boundaryMinimumError,
    upper: least.value + boundaryMinimumError,
    point: least.point,
    position: least.position,
  }
  return {
    ...inNewUnits,
    exponent,
    valid: sign > 0,
    decidedBy: 'exact',
    candidates: [...candidates.map(inUnits), ...skipped].sort(
      (a, b) => KINDS.indexOf(a.kind) - KINDS.indexOf(b.kind) || a.id - b.id,
    ),
    minimizer: least,
    boundaryMinimum: least.value,
    boundaryMinimumError,
    volumeMinimum: sign > 0 ? onBoundary : tighter(inNewUnits.volumeMinimum, onBoundary),
    cornerMinimum,
    edgeMinimum,
    checks: inNewUnits.checks.map(({ id, value }) => check(id, exactChecks[id] ?? value)),
  }
}

/** The bracket of the search inside, but for its upper end where the boundary reaches lower. */
function tighter(inside: VolumeMinimum, onBoundary: VolumeMinimum): VolumeMinimum {
  return onBoundary.upper <= inside.upper ? { ...onBoundary, lower: Math.min(inside.lower, onBoundary.lower) } : inside
}

/** A least normal double may stand for a smaller number, and a subnormal product may be rounded down. */
function errorOf(value: number): number {
  const error = VALUE_ERROR * Math.abs(value)
  if (Math.abs(value) === LEAST_NORMAL) return LEAST_NORMAL
  return error > 0 && error < LEAST_NORMAL ? error + Number.MIN_VALUE : error
}

function leadingPower({ mantissa, exponent }: ExactCandidate): number {
  return Math.floor(Math.log2(Math.abs(mantissa))) + exponent
}

function commonExponent(candidates: readonly ExactCandidate[], given: number): number {
  const powers = candidates.filter(({ mantissa }) => mantissa !== 0).map(leadingPower)
  if (powers.length === 0) return given
  const [least, greatest] = [Math.min(...powers), Math.max(...powers)]
  // One power to spare on each side for the rounding of the logarithm.
  const fits = (exponent: number) => least - exponent > NORMAL.least && greatest - exponent < NORMAL.greatest
  if (fits(given)) return given
  return Math.max(greatest - NORMAL.greatest + 1, (least + greatest) >> 1)
}

function inUnitsOf(unit: number, { mantissa, exponent }: ExactCandidate): number {
  const value = timesPowerOfTwo(mantissa, exponent - unit)
  return mantissa !== 0 && Math.abs(value) < LEAST_NORMAL ? Math.sign(mantissa) * LEAST_NORMAL : value
}

function timesPowerOfTwo(value: number, exponent: number): number {
  // In steps, so that no factor leaves the doubles; beyond 4000 the result is 0 or infinite either way.
  let rest = Math.max(-4000, Math.min(4000, exponent))
  let result = value
  for (; rest > 1000; rest -= 1000) result *= 2 ** 1000
  for (; rest < -1000; rest += 1000) result *= 2 ** -1000
  return result * 2 ** rest
}

/** The report with another number for every jacdet; where that is no longer exact, a bracket stays one. */
function mapped(report: FilteredReport, map: (jacdet: number) => number): FilteredReport {
  const mappedFace = (face: FaceReport): FaceReport => ({
    ...face,
    bernstein: face.bernstein.map(map),
    lowerBound: map(face.lowerBound),
    runningMinimum: map(face.runningMinimum),
    roots: face.roots.map(root => ({ ...root, a: map(root.a) })),
  })
  const outward = (value: number, step: number) => {
    const to = map(value)
    return value !== 0 && Math.abs(to) < LEAST_NORMAL ? to + step : to
  }
  const { volumeMinimum } = report
  return {
    ...report,
    boundaryMaximum: map(report.boundaryMaximum),
    maximizer: { ...report.maximizer, value: map(report.maximizer.value) },
    volumeMinimum: {
      ...volumeMinimum,
      lower: outward(volumeMinimum.lower, -Number.MIN_VALUE),
      upper: outward(volumeMinimum.upper, Number.MIN_VALUE),
    },
    checks: report.checks.map(({ id, value }) => check(id, id === 'corners-and-centre' ? value : map(value))),
    bernstein: report.bernstein.map(map),
    faces: report.faces.map(mappedFace),
    candidates: report.candidates.map(candidate => ({ ...candidate, value: map(candidate.value) })),
  }
}
