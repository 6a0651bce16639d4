/** Verdicts of a mesh's cells where it is read: few by the core, many by the core for batches, where that starts. */
import { type BatchCore, type BatchOptions, loadBatchCore, NOTHING_COUNTED } from '../core/batch/batch-core'
import { type Answers, answersOf, emptyLists, STATUSES, type Wanted } from '../core/batch/lists'
import type { Core, Report } from '../core/report'
import { CHECKS, CLASSES } from '../core/unpack'
import { CORNERS, VTK } from '../mesh/accepted-invalid'
import type { ClassifyCells } from '../mesh/check'
import { countsIn } from '../mesh/counts-in'
import { verticesOf } from '../mesh/vertices-of'

/** Cells that the core answers sooner than the core for batches would have started. */
const FEW = 64

/** `onProgress` is called now and then with how many cells are done. */
export function cellClassifier(
  core: Core,
  batchModule: () => Promise<WebAssembly.Module>,
  onProgress: (done: number, total: number) => void,
): ClassifyCells {
  let batch: Promise<BatchCore | null> | undefined
  const classify = async (points: Float64Array, cells: Uint32Array, wanted: Wanted) => {
    const total = cells.length / 8
    const options = { onProgress: (done: number) => onProgress(done, total) }
    if (total > FEW) batch ??= batchModule().then(loadBatchCore, () => null)
    const batchCore = total > FEW ? await batch : null
    const worst = wanted.worst ? { few: wanted.worst, limit: Infinity } : null
    if (batchCore) return batchCore.classify({ points, cells, firstPoint: 0 }, wanted, { ...options, worst })
    return oneByOne(core, { points, cells }, wanted, options)
  }
  return classify as ClassifyCells
}

/** The way where WebAssembly is forbidden, too: the core may be its twin. */
function oneByOne(
  core: Core,
  mesh: { readonly points: Float64Array; readonly cells: Uint32Array },
  wanted: Wanted,
  { onProgress }: Required<Pick<BatchOptions, 'onProgress'>>,
) {
  const count = mesh.cells.length / 8
  const answers = answersOf(emptyLists(count, wanted))
  let [validCount, unansweredCount, exactCount] = [0, 0, 0]
  let firstUnanswered: number | null = null
  for (let cell = 0; cell < count; ++cell) {
    const result = core.analyze(verticesOf(mesh, cell))
    if (result.ok) {
      put(answers, cell, result.value)
      if (result.value.valid) validCount++
      if (result.value.decidedBy === 'exact') exactCount++
    } else {
      putUnanswered(answers, cell)
      firstUnanswered ??= cell
      unansweredCount++
    }
    if (cell % 256 === 255) onProgress(cell)
  }
  const invalidCount = count - validCount - unansweredCount
  const counts = { validCount, invalidCount, unansweredCount, firstUnanswered, exactCount }
  return { ...answers, ...NOTHING_COUNTED, ...countsIn(answers), ...counts, candidates: null }
}

function put(
  { valid, minima, relativeMinima, volumes, classes, acceptedBy, exact, ...hints }: Answers,
  cell: number,
  report: Report,
) {
  valid[cell] = Number(report.valid)
  if (relativeMinima) relativeMinima[cell] = report.relativeMinimum ?? Number.NaN
  if (classes) classes[cell] = CLASSES.indexOf(report.class)
  if (exact) exact[cell] = Number(report.decidedBy === 'exact')
  if (minima) {
    minima.values[cell] = report.boundaryMinimum
    if (minima.minimizers.length > 0) minima.minimizers.set(report.minimizer.point, 3 * cell)
    minima.cornerMinima[cell] = report.cornerMinimum
    minima.exponents[cell] = report.exponent
  }
  if (volumes) {
    volumes.values[cell] = report.volume
    volumes.exponents[cell] = report.volumeExponent
  }
  const accepting = report.checks.reduce((mask, { id, passes }) => mask | (Number(passes) << CHECKS.indexOf(id)), 0)
  if (acceptedBy) acceptedBy[cell] = accepting
  const { coincident, acceptedInvalid } = hints
  if (coincident) coincident[cell] = Number(report.coincident.length > 0)
  if (acceptedInvalid) acceptedInvalid[cell] = report.valid ? 0 : accepting & (CORNERS | VTK)
}

function putUnanswered({ minima, relativeMinima, volumes, statuses }: Answers, cell: number): void {
  if (relativeMinima) relativeMinima[cell] = Number.NaN
  if (statuses) statuses[cell] = STATUSES.indexOf('not-finite')
  minima?.values.fill(Number.NaN, cell, cell + 1)
  minima?.minimizers.fill(Number.NaN, 3 * cell, 3 * cell + 3)
  minima?.cornerMinima.fill(Number.NaN, cell, cell + 1)
  volumes?.values.fill(Number.NaN, cell, cell + 1)
}
