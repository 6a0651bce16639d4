/** Batches in the browser: the wasm and the workers as the built page serves them. */
import type { Result } from '../report'
import { batchFiles } from './batch-files'
import { type Classification, type Classifier, type ClassifyOptions, classifierOn } from './classify'
import type { WorkerPort } from './messages'
import { Pool } from './pool'
import { pagePort } from './ports'
import { defaultWorkers } from './start'

/** Rejects when the wasm cannot be had or may not run. */
export async function startClassifier(workers = defaultWorkers()): Promise<Classifier> {
  return classifierOn(new Pool(await batchFiles(), workers, spawn))
}

let shared: Promise<Classifier> | undefined

/** See Classifier; all callers of the page share the workers. */
export async function classify<W extends ClassifyOptions>(
  points: Float64Array,
  cells: Uint32Array | null,
  options?: W,
): Promise<Result<Classification<W>>> {
  shared ??= startClassifier().catch(reason => {
    shared = undefined
    throw reason
  })
  return (await shared).classify(points, cells, options)
}

function spawn(): WorkerPort {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  return pagePort(worker, 'its script was not loaded.')
}
