/** Batches in Node, on all cores; few cells are answered here at once, before a thread would have started. */
import { Worker } from 'node:worker_threads'
import { loadBatchCore } from '../core/batch/batch-core'
import { type Classifier, classifierOn, type Progress } from '../core/batch/classify'
import type { Wanted } from '../core/batch/lists'
import { defaultWorkers } from '../core/batch/start'
import { threadPort } from '../core/ports'
import type { ClassifyCells } from '../mesh/check'
import type { Engine } from './engine'

export interface CellClassifier {
  readonly classify: ClassifyCells
  /** Ends the threads. */
  close(): void
}

/** Cells: one piece of a pool. */
const FEW = 16_384

export async function startCellClassifier(
  { batchModule, workerScript }: Engine,
  onProgress: (progress: Progress) => void,
): Promise<CellClassifier> {
  const module = await batchModule()
  const core = await loadBatchCore(module)
  let classifier: Classifier | undefined

  async function onThreads(): Promise<Classifier> {
    const script = await workerScript()
    const spawn = () => threadPort(new Worker(script, { eval: true }))
    return classifierOn({ start: module, size: defaultWorkers(), spawn })
  }

  async function classify<W extends Wanted>(points: Float64Array, cells: Uint32Array, wanted: W) {
    if (cells.length / 8 <= FEW)
      return core.classify({ points: gathered(points, cells), cells: null, firstPoint: 0 }, wanted)
    classifier ??= await onThreads()
    const result = await classifier.classify(points, cells, { ...wanted, onProgress })
    if (!result.ok) throw new Error(result.error.message)
    return result.value
  }
  return { classify: classify as ClassifyCells, close: () => classifier?.close() }
}

/** 24 coordinates a cell: of the points of a large mesh few cells may use but a few. */
function gathered(points: Float64Array, cells: Uint32Array): Float64Array {
  const own = new Float64Array(3 * cells.length)
  for (let i = 0; i < cells.length; ++i)
    for (let axis = 0; axis < 3; ++axis) own[3 * i + axis] = points[3 * (cells[i] as number) + axis] as number
  return own
}
