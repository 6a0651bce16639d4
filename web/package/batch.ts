/**
 * `hexlens/batch`: verdicts, boundary minima and more of many elements on workers, in a page or in Node. The workers' script and the wasm are
 * inside, as text, so that bundlers have nothing to find and no file has to lie beside.
 *
 *     const classifier = await startClassifier()
 *     const result = await classifier.classify(points, cells, { minima: true })   // { ok: true, value } or { ok: false, error }
 *     classifier.close()
 */

import workerSource from 'virtual:hexlens.batch-worker'
import { type Classifier, classifierOn } from '../core/batch/classify'
import { defaultWorkers } from '../core/batch/start'
import { pagePort, threadPort } from '../core/ports'
import { scriptAddress } from '../core/script-address'
import type { WorkerPort } from '../core/workers'
import { batchInside } from './batch-inside'

export type { Counts } from '../core/batch/batch-core'
export type {
  CellChunk,
  Classification,
  Classifier,
  ClassifyOptions,
  Progress,
  StreamOptions,
} from '../core/batch/classify'
export { type Answers, type CellStatus, type Minima, STATUSES, type Volumes, type Wanted } from '../core/batch/lists'
export type { CheckId, CoreError, CoreErrorCode, ElementClass, Result } from '../core/report'
export { CHECKS, CLASSES } from '../core/unpack'

declare global {
  /** Types that are missing without those of a DOM, as in Node. */
  namespace WebAssembly {
    interface Module {}
  }
}

export interface ClassifierOptions {
  /** The most workers; by default one for each core, at most 16. They start when needed. */
  readonly workers?: number
  /**
   * The address of a copy of `hexlens/dist/hexlens.batch-worker.js`: for pages whose
   * Content-Security-Policy forbids workers from blob: addresses. In Node a file: URL or an
   * absolute path.
   */
  readonly workerUrl?: string | URL
}

/** Rejects, with a sentence, where WebAssembly may not run. */
export async function startClassifier({
  workers = defaultWorkers(),
  workerUrl,
}: ClassifierOptions = {}): Promise<Classifier> {
  return classifierOn({ start: await batchInside(), size: workers, spawn: () => spawn(workerUrl) })
}

/** Node's module is asked for by name when it is needed: bundlers for browsers would stumble over an import. */
function spawn(workerUrl: string | URL | undefined): WorkerPort {
  if (typeof Worker === 'function') return pageWorker(workerUrl)
  const { Worker: Thread } = process.getBuiltinModule('node:worker_threads')
  return threadPort(workerUrl === undefined ? new Thread(workerSource, { eval: true }) : new Thread(workerUrl))
}

let blobUrl: string | undefined

function pageWorker(workerUrl: string | URL | undefined): WorkerPort {
  if (workerUrl !== undefined)
    return pagePort(
      new Worker(scriptAddress(workerUrl), { type: 'module' }),
      `its script was not loaded from ${workerUrl}`,
    )
  blobUrl ??= URL.createObjectURL(new Blob([workerSource], { type: 'text/javascript' }))
  try {
    return pagePort(new Worker(scriptAddress(blobUrl), { type: 'module' }), BLOCKED)
  } catch (reason) {
    throw new Error(BLOCKED, { cause: reason })
  }
}

const BLOCKED =
  'its script was not loaded. If a Content-Security-Policy forbids workers from blob: addresses, give startClassifier the workerUrl of a copy of hexlens.batch-worker.js.'
