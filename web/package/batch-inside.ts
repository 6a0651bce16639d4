/** The core for batches inside one file. */
import vectors from 'virtual:hexlens-batch.wasm.deflated'
import scalar from 'virtual:hexlens-scalar.wasm.deflated'
import { compiledOf } from '../core/batch/start'
import { inflated } from './inflate'

export function batchInside(): Promise<WebAssembly.Module> {
  return compiledOf({ vectors: () => inflated(vectors), scalar: () => inflated(scalar) })
}
