/** The worker's script for the built page. */
import { batchFiles } from '../core/batch/batch-files'
import { coreFiles } from '../core/core-files'
import { readingFiles } from '../core/reading-files'
import { serveReading } from './serve-reading'

serveReading({ core: coreFiles, batchModule: batchFiles, readingCore: readingFiles })
