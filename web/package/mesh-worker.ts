/** The script of the worker that reads, for the package: the wasm is inside. */
import vectors from 'virtual:hexlens-batch.wasm.deflated'
import scalar from 'virtual:hexlens-scalar.wasm.deflated'
import { compiledOf } from '../core/batch/start'
import { answerRequests } from '../input/reading-worker'
import { coreInside } from './core-inside'
import { inflated } from './inflate'

answerRequests({
  core: coreInside,
  batchModule: () => compiledOf({ vectors: () => inflated(vectors), scalar: () => inflated(scalar) }),
})
