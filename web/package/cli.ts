#!/usr/bin/env node
/** `npx hexlens`: the command line in one file, by Node. */
import workerSource from 'virtual:hexlens.batch-worker'
import vectors from 'virtual:hexlens-batch.wasm.deflated'
import scalar from 'virtual:hexlens-scalar.wasm.deflated'
import { main } from '../cli/main'
import { compiledOf } from '../core/batch/start'
import { fetchCore } from '../core/fetch-core'
import { coreInside } from './core-inside'
import { inflated } from './inflate'

process.exitCode = await main(process.argv.slice(2), {
  core: () => fetchCore(coreInside),
  batchModule: () => compiledOf({ vectors: () => inflated(vectors), scalar: () => inflated(scalar) }),
  workerScript: async () => workerSource,
})
