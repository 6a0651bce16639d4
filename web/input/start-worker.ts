/** The worker as the built page serves it; the package's scripts take web/package/mesh-worker-beside.ts in its place. */

/** Rejects where there is none to be had. */
export async function startWorker(): Promise<Worker> {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
}

/** What may be wrong where its script does not load. */
export const blocked = 'its script was not loaded, or a policy of the page forbids it'
