/** A worker for batches, in a browser or in Node. */
import { serve } from '../workers'
import { type BatchJobs, startBatchJobs } from './batch-jobs'

serve<WebAssembly.Module, BatchJobs>('hexlens-batch', async module => (await startBatchJobs(module)).jobs)
