/** The worker that reads as the built page serves it. */
import type { StartedWorker } from './read-input'

export function startPageWorker(): StartedWorker {
  return {
    worker: new Worker(new URL('./page-worker.ts', import.meta.url), { type: 'module' }),
    blocked: 'its script was not loaded, or a policy of the page forbids it',
  }
}
