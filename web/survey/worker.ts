/** The worker's script for the built page. */
import { batchFiles } from '../core/batch/batch-files'
import { coreFiles } from '../core/core-files'
import { pagePort } from '../core/ports'
import { readingFiles } from '../core/reading-files'
import type { WorkerPort } from '../core/workers'
import { hdf5Files } from '../mesh/hdf5-files'
import { Hdf5Loading } from '../mesh/hdf5-reader'
import { serveSurvey } from './serve-survey'

function helper(): WorkerPort {
  return pagePort(new Worker(new URL('./helper.ts', import.meta.url), { type: 'module' }))
}

let readingCore: ReturnType<typeof readingFiles> | null = null

serveSurvey({
  core: coreFiles,
  batchModule: batchFiles,
  readingCore() {
    readingCore ??= readingFiles()
    return readingCore
  },
  hdf5: new Hdf5Loading(hdf5Files),
  helper,
})
