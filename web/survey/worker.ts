/** The worker's script for the built page. */
import { batchFiles } from '../core/batch/batch-files'
import { coreFiles } from '../core/core-files'
import { readingFiles } from '../core/reading-files'
import { meeting } from './meeting'
import { serveSurvey } from './serve-survey'
import { writing } from './writing'

serveSurvey({ core: coreFiles, batchModule: batchFiles, readingCore: readingFiles, meeting, writing })
