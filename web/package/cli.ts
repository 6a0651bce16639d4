#!/usr/bin/env node
/** `npx hexlens`: the command line in one file, by Node. */
import workerSource from 'virtual:hexlens.batch-worker'
import { main } from '../cli/main'
import { fetchCore } from '../core/fetch-core'
import { batchInside } from './batch-inside'
import { coreInside } from './core-inside'
import { readingInside } from './reading-inside'

process.exitCode = await main(process.argv.slice(2), {
  core: () => fetchCore(coreInside),
  readingCore: readingInside,
  batchModule: batchInside,
  workerScript: async () => workerSource,
})
