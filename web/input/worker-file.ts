/** The worker that reads, as the built page serves it. */
import type { ReadingWorker } from './read-input'

export const readingWorkerFile: ReadingWorker = {
  start: async () => new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }),
  blocked: 'its script was not loaded, or a policy of the page forbids it',
}
