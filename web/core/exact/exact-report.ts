/** The report of an element on which doubles do not decide: verdict, candidates and minima from exact arithmetic. */
import type { Vec3 } from '../../model/hexahedron'
import { timesPowerOfTwo } from '../power-of-two'
import type { Candidate, Check, FaceReport, Report, VolumeMinimum } from '../report'
import { check, type FilteredReport } from '../unpack'
import { exactChecks, type ScaledNumber } from './exact-checks'
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
  { sign, jacdet, candidates, minimizer, skippedFaces }: ExactBoundary,
  positionOf: (point: Vec3) => Vec3,
): Report {
  const exponent = commonExponent(candidates, report)
  const inUnits = (candidate: ExactCandidate): Candidate => {
    const { kind, id, point } = candidate
    return { kind, id, point, position: positionOf(point), value: inUnitsOf(exponent, candidate) }
  }
  const least = inUnits(minimizer)
  const boundaryMinimumError = errorOf(least.value)
  const inNewUnits = mapped(report, report.exponent - exponent)
  // By their exact bound these are no lower than the minimum, whatever rounding says.
  const skipped = inNewUnits.candidates
    .filter(({ kind, id }) => kind === 'face' && skippedFaces.includes(id))
    .map(candidate => ({ ...candidate, value: Math.max(candidate.value, least.value) }))
  const leastOf = (...kinds: Candidate['kind'][]) =>
    Math.min(...candidates.filter(({ kind }) => kinds.includes(kind)).map(candidate => inUnitsOf(exponent, candidate)))
  const cornerMinimum = leastOf('vertex')
  const edgeMinimum = leastOf('vertex', 'edge')
  const { jacdets, scaledJacobian } = exactChecks(jacdet)
  const checkValue = ({ id, value }: Check): number => {
    const number = jacdets[id]
    if (number) return inUnitsOf(exponent, number)
    if (id === 'corners') return cornerMinimum
    if (id === 'edges') return edgeMinimum
    // By Verdict's rules a length may be zero; else its number is this.
    if (id === 'corners-and-centre') return value === report.scaledJacobian ? scaledJacobian : value
    return sign > 0 ? value : Math.min(value, 0) // subdivision and tangents go by bounds, and accept nothing that is invalid
  }
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
    scaledJacobian,
    checks: inNewUnits.checks.map(given => check(given.id, checkValue(given))),
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

function leadingPower({ mantissa, exponent }: ScaledNumber): number {
  return Math.floor(Math.log2(Math.abs(mantissa))) + exponent
}

/** A root's a and the bracket's ends are at most 4 times the largest coefficient, and rounding. */
const MARGIN_BITS = 4

/** In which all of the candidates are normal doubles, if there is one; if there is none, no number of the report is too large. */
function commonExponent(candidates: readonly ExactCandidate[], { bernstein, exponent }: FilteredReport): number {
  const powers = candidates.filter(({ mantissa }) => mantissa !== 0).map(leadingPower)
  if (powers.length === 0) return exponent
  const largest = leadingPower({ mantissa: Math.max(...bernstein.map(Math.abs)), exponent }) + MARGIN_BITS
  const [least, greatest] = [Math.min(...powers), Math.max(...powers, largest)]
  // One power to spare on each side for the rounding of the logarithm.
  const fits = (given: number) => least - given > NORMAL.least && greatest - given < NORMAL.greatest
  if (fits(exponent)) return exponent
  return Math.max(greatest - NORMAL.greatest + 1, (least + greatest) >> 1)
}

function inUnitsOf(unit: number, { mantissa, exponent }: ScaledNumber): number {
  return inNormalRange(timesPowerOfTwo(mantissa, exponent - unit), mantissa)
}

/** What became too small is the least normal double of its sign. */
function inNormalRange(value: number, before: number): number {
  return before !== 0 && Math.abs(value) < LEAST_NORMAL ? Math.sign(before) * LEAST_NORMAL : value
}

/** The report in units of another power of two; a bracket stays one. */
function mapped(report: FilteredReport, exponent: number): FilteredReport {
  const map = (value: number) => inNormalRange(timesPowerOfTwo(value, exponent), value)
  const mappedFace = (face: FaceReport): FaceReport => ({
    ...face,
    bernstein: face.bernstein.map(map),
    lowerBound: map(face.lowerBound),
    runningMinimum: map(face.runningMinimum),
    roots: face.roots.map(root => ({ ...root, a: map(root.a) })),
  })
  const { volumeMinimum } = report
  const [lower, upper] = [map(volumeMinimum.lower), map(volumeMinimum.upper)]
  return {
    ...report,
    boundaryMaximum: map(report.boundaryMaximum),
    maximizer: { ...report.maximizer, value: map(report.maximizer.value) },
    volumeMinimum: {
      ...volumeMinimum,
      lower: lower === LEAST_NORMAL ? 0 : lower,
      upper: upper === -LEAST_NORMAL ? 0 : upper,
    },
    checks: report.checks.map(({ id, value }) => check(id, id === 'corners-and-centre' ? value : map(value))),
    bernstein: report.bernstein.map(map),
    faces: report.faces.map(mappedFace),
    candidates: report.candidates.map(candidate => ({ ...candidate, value: map(candidate.value) })),
  }
}
