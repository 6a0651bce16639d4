/** Untangling in a worker of its own, as the built page starts it. */
import { pagePort } from '../core/ports'
import type { UntangledCounts } from '../core/repair/untangling'
import { runAlone } from '../core/workers'
import type { PartUntangled, UntangleJobs, UntangleWanted } from './untangled-part'

/** The part's memory goes to the worker, which ends if the signal aborts; the promise rejects with the signal's reason then. */
export function startUntangling(
  wanted: UntangleWanted,
  onProgress: (soFar: UntangledCounts) => void,
  signal: AbortSignal,
): Promise<PartUntangled | { readonly refused: string }> {
  const spawn = () => {
    const worker = new Worker(new URL('./untangle-worker.ts', import.meta.url), { type: 'module' })
    return pagePort(worker, 'its script was not loaded, or a policy of the page forbids it.')
  }
  return runAlone<UntangleJobs, 'untangle'>(
    { name: 'The worker that untangles', spawn, start: null },
    { kind: 'untangle', given: wanted },
    { signal, onProgress },
  )
}
