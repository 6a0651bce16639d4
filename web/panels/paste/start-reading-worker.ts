/** Null where there is none to be had; one-file builds take web/package/no-reading-worker.ts in this file's place. */
export function startReadingWorker(): Worker | null {
  return new Worker(new URL('./reading-worker.ts', import.meta.url), { type: 'module' })
}
