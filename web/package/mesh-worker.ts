/** The worker that reads, for `<hex-lens>`, and in which a mesh is open, for `<hex-mesh>`: one file, since most of it is the same. */
import { serve } from '../core/workers'
import { type ReadingEngine, type ReadingJobs, readingJobs } from '../input/serve-reading'
import { Hdf5Loading } from '../mesh/hdf5-reader'
import { jobsOfLooking, type LookingJobs } from '../survey/looking-jobs'
import { batchInside } from './batch-inside'
import { coreInside } from './core-inside'
import { hdf5InWorker } from './hdf5-in-worker'
import { readingInside } from './reading-inside'

const engine: ReadingEngine = {
  core: coreInside,
  batchModule: batchInside,
  readingCore: readingInside,
  hdf5: new Hdf5Loading(hdf5InWorker),
}

serve<null, ReadingJobs & LookingJobs>('hexlens-mesh', () => ({
  ...readingJobs(engine),
  ...jobsOfLooking(engine),
}))
