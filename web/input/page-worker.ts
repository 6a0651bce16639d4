/** The script of the worker that reads, for the built page: the wasm lies beside it. */
import { batchModule } from '../core/batch/module'
import { coreFiles } from '../core/core-files'
import { answerRequests } from './reading-worker'

answerRequests({ core: coreFiles, batchModule })
