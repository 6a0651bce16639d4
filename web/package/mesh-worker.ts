/** The worker that reads, in one file. */
import { serveReading } from '../input/serve-reading'
import { batchInside } from './batch-inside'
import { coreInside } from './core-inside'
import { readingInside } from './reading-inside'

serveReading({ core: coreInside, batchModule: batchInside, readingCore: readingInside })
