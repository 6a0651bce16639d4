/** The worker that reads, for `<hex-lens>`, and in which a mesh is open, for `<hex-mesh>`: one file, since most of it is the same. */
import { serve } from '../core/workers'
import { type ReadingEngine, type ReadingJobs, readingJobs } from '../input/serve-reading'
import { jobsOfLooking, type LookingJobs } from '../survey/looking-jobs'
import { batchInside } from './batch-inside'
import { coreInside } from './core-inside'
import { readingInside } from './reading-inside'

const engine: ReadingEngine = { core: coreInside, batchModule: batchInside, readingCore: readingInside }

serve<null, ReadingJobs & LookingJobs>('hexlens-mesh', () => ({
  ...readingJobs(engine),
  ...jobsOfLooking(engine),
}))
