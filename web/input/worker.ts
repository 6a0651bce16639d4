/** The worker's script for the built page. */
import { batchFiles } from '../core/batch/batch-files'
import { coreFiles } from '../core/core-files'
import { readingFiles } from '../core/reading-files'
import { hdf5Files } from '../mesh/hdf5-files'
import { Hdf5Loading } from '../mesh/hdf5-reader'
import { serveReading } from './serve-reading'

serveReading({
  core: coreFiles,
  batchModule: batchFiles,
  readingCore: readingFiles,
  hdf5: new Hdf5Loading(hdf5Files),
})
