/** The worker that reads, as the built page serves it. */
import { pagePort } from '../core/ports'
import type { WorkerPort } from '../core/workers'

export function startReadingWorker(): WorkerPort {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  return pagePort(worker)
}
