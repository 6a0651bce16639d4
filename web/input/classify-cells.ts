/** Verdicts of a mesh's cells where it is read: few by the core, many by the core for batches, where that starts. */
import { type BatchCore, type BatchOptions, loadBatchCore } from '../core/batch/batch-core'
import { type Answers, answersOf, emptyLists, STATUSES, type Wanted } from '../core/batch/lists'
import type { Core } from '../core/report'
import { CLASSES } from '../core/unpack'
import type { ClassifyCells } from '../mesh/check'
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
    if (batchCore) return batchCore.classify({ points, cells, firstPoint: 0 }, wanted, options)
    return oneByOne(core, { points, cells }, options)
  }
  return classify as ClassifyCells
}

const ALL = { relativeMinima: true, classes: true, statuses: true } as const

/** The way where WebAssembly is forbidden, too: the core may be its twin. */
function oneByOne(
  core: Core,
  mesh: { readonly points: Float64Array; readonly cells: Uint32Array },
  { onProgress }: Required<Pick<BatchOptions, 'onProgress'>>,
) {
  const count = mesh.cells.length / 8
  const answers = answersOf(emptyLists(count, ALL)) as Answers<typeof ALL>
  let [validCount, unansweredCount] = [0, 0]
  let firstUnanswered: number | null = null
  for (let cell = 0; cell < count; ++cell) {
    const result = core.analyze(verticesOf(mesh, cell))
    if (result.ok) {
      const { valid, relativeMinimum, class: itsClass } = result.value
      answers.valid[cell] = Number(valid)
      answers.relativeMinima[cell] = relativeMinimum ?? Number.NaN
      answers.classes[cell] = CLASSES.indexOf(itsClass)
      if (valid) validCount++
    } else {
      answers.relativeMinima[cell] = Number.NaN
      answers.statuses[cell] = STATUSES.indexOf('not-finite')
      firstUnanswered ??= cell
      unansweredCount++
    }
    if (cell % 256 === 255) onProgress(cell)
  }
  const invalidCount = count - validCount - unansweredCount
  return { ...answers, validCount, invalidCount, unansweredCount, firstUnanswered, exactCount: 0 }
}
