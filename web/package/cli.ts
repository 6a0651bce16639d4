#!/usr/bin/env node
/** `npx hexlens`: the command line in one file, by Node. */
import workerSource from 'virtual:hexlens.batch-worker'
import { main } from '../cli/main'
import { fetchCore } from '../core/fetch-core'
import { Hdf5Loading } from '../mesh/hdf5-reader'
import { batchInside } from './batch-inside'
import { coreInside } from './core-inside'
import { loadHdf5 } from './hdf5-module'
import { readingInside } from './reading-inside'
import { repairInside } from './repair-inside'

process.exitCode = await main(process.argv.slice(2), {
  core: () => fetchCore(coreInside),
  readingCore: readingInside,
  batchModule: batchInside,
  repairCore: repairInside,
  hdf5: new Hdf5Loading(loadHdf5),
  workerScript: async () => workerSource,
})
