/** Searches in the browser: the wasm and the workers as the built page serves them. */
import { batchFiles } from '../../../core/batch/batch-files'
import { defaultWorkers } from '../../../core/batch/start'
import { pagePort } from '../../../core/ports'
import type { WorkerPort } from '../../../core/workers'
import type { SearchWorkers } from './search'

let module: Promise<WebAssembly.Module> | undefined

/** Rejects when the wasm cannot be had or may not run; a later call asks again. */
export async function searchWorkers(): Promise<SearchWorkers> {
  module ??= batchFiles().catch(reason => {
    module = undefined
    throw reason
  })
  return { module: await module, count: defaultWorkers(), spawn }
}

function spawn(): WorkerPort {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  return pagePort(worker, 'its script was not loaded.')
}
