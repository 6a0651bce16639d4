/** The worker's script for the built page. */
import { batchFiles } from '../core/batch/batch-files'
import { coreFiles } from '../core/core-files'
import { readingFiles } from '../core/reading-files'
import { serveSurvey } from './serve-survey'

serveSurvey({ core: coreFiles, batchModule: batchFiles, readingCore: readingFiles })
