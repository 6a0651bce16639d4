/** What batches run with, inside one file. */
import workerSource from 'virtual:hexlens.batch-worker'
import vectors from 'virtual:hexlens-batch.wasm.deflated'
import scalar from 'virtual:hexlens-scalar.wasm.deflated'
import { compiledOf } from '../core/batch/start'
import { inflated } from './inflate'

export function batchModule(): Promise<WebAssembly.Module> {
  return compiledOf({ vectors: () => inflated(vectors), scalar: () => inflated(scalar) })
}

export async function workerScript(): Promise<string> {
  return workerSource
}
