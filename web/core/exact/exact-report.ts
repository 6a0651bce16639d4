/** The report of an element on which doubles do not decide: verdict and candidates from exact arithmetic. */
import type { Vec3 } from '../../model/hexahedron'
import type { Candidate, FaceReport, Report } from '../report'
import { type ExactCandidate, exactBoundary } from './exact-minimum'

const KINDS: readonly Candidate['kind'][] = ['vertex', 'edge', 'face']

/** Powers of two that a normal double's leading digit can stand for. */
const NORMAL = { least: -1022, greatest: 1023 }

/**
 * `report` with its verdict, candidates and minima replaced by the exact ones; `positionOf` maps a reference point into
 * space. What else it holds stays as doubles computed it, or is zero
 * where jacdet is zero on the whole boundary. The common exponent changes only where the exact values ask for
 * another; should they span more than the doubles do, those too small become the least normal double of their sign.
 */
export function exactReport(report: Report, positionOf: (point: Vec3) => Vec3): Report {
  const { sign, isCollapsed, candidates, minimizer, skippedFaces } = exactBoundary(report.vertices)
  const exponent = commonExponent(candidates, report.exponent)
  const inUnits = (candidate: ExactCandidate): Candidate => {
    const { kind, id, point } = candidate
    return { kind, id, point, position: positionOf(point), value: inUnitsOf(exponent, candidate) }
  }
  const least = inUnits(minimizer)
  const map = isCollapsed ? () => 0 : (value: number) => timesPowerOfTwo(value, report.exponent - exponent)
  // By their exact bound these are no lower than the minimum, whatever rounding says.
  const skipped = report.candidates
    .filter(({ kind, id }) => kind === 'face' && skippedFaces.includes(id))
    .map(candidate => ({ ...candidate, value: Math.max(map(candidate.value), least.value) }))
  const leastOf = (...kinds: Candidate['kind'][]) =>
    Math.min(...candidates.filter(({ kind }) => kinds.includes(kind)).map(candidate => inUnitsOf(exponent, candidate)))
  return {
    ...mapped(report, map),
    exponent,
    valid: sign > 0,
    decidedBy: 'exact',
    candidates: [...candidates.map(inUnits), ...skipped].sort(
      (a, b) => KINDS.indexOf(a.kind) - KINDS.indexOf(b.kind) || a.id - b.id,
    ),
    minimizer: least,
    boundaryMinimum: least.value,
    cornerMinimum: leastOf('vertex'),
    edgeMinimum: leastOf('vertex', 'edge'),
  }
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
  return mantissa !== 0 && Math.abs(value) < 2 ** NORMAL.least ? Math.sign(mantissa) * 2 ** NORMAL.least : value
}

function timesPowerOfTwo(value: number, exponent: number): number {
  // In steps, so that no factor leaves the doubles; beyond 4000 the result is 0 or infinite either way.
  let rest = Math.max(-4000, Math.min(4000, exponent))
  let result = value
  for (; rest > 1000; rest -= 1000) result *= 2 ** 1000
  for (; rest < -1000; rest += 1000) result *= 2 ** -1000
  return result * 2 ** rest
}

/** The report with another number for every jacdet that exact arithmetic does not replace. */
function mapped(report: Report, map: (jacdet: number) => number): Report {
  const mappedFace = (face: FaceReport): FaceReport => ({
    ...face,
    bernstein: face.bernstein.map(map),
    lowerBound: map(face.lowerBound),
    runningMinimum: map(face.runningMinimum),
    roots: face.roots.map(root => ({ ...root, a: map(root.a) })),
  })
  return {
    ...report,
    boundaryMaximum: map(report.boundaryMaximum),
    maximizer: { ...report.maximizer, value: map(report.maximizer.value) },
    bernstein: report.bernstein.map(map),
    faces: report.faces.map(mappedFace),
  }
}
