/** Searches in the browser: the wasm and the workers as the built page serves them. */
import { batchFiles } from '../../../core/batch/batch-files'
import type { WorkerPort } from './messages'
import type { SearchWorkers } from './search'

/** More workers than that wait for memory. */
const MOST_WORKERS = 16

let module: Promise<WebAssembly.Module> | undefined

/** Rejects when the wasm cannot be had or may not run; a later call asks again. */
export async function searchWorkers(): Promise<SearchWorkers> {
  module ??= batchFiles().catch(reason => {
    module = undefined
    throw reason
  })
  return { module: await module, count: Math.min(navigator.hardwareConcurrency, MOST_WORKERS), spawn }
}

function spawn(): WorkerPort {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }) as unknown as WorkerPort
}
