/** Untangling in a worker of its own, as the built page starts it. */
import { pagePort } from '../core/ports'
import type { UntangledCounts } from '../core/repair/untangling'
import { runAlone, type WorkerOptions } from '../core/workers'
import type {
  CertificatesWanted,
  HeldCertificates,
  PartUntangled,
  UntangleJobs,
  UntangleWanted,
} from './untangled-part'

/** The part's memory goes to the worker, which ends if the signal aborts; the promise rejects with the signal's reason then. */
export function startUntangling(
  wanted: UntangleWanted,
  onProgress: (soFar: UntangledCounts) => void,
  signal: AbortSignal,
): Promise<PartUntangled | { readonly refused: string }> {
  return runAlone<UntangleJobs, 'untangle'>(WORKER, { kind: 'untangle', given: wanted }, { signal, onProgress })
}

/** As `startUntangling`: the memory goes to the worker. */
export function startCertifying(
  wanted: CertificatesWanted,
  onProgress: (fraction: number) => void,
  signal: AbortSignal,
): Promise<HeldCertificates> {
  return runAlone<UntangleJobs, 'certify'>(WORKER, { kind: 'certify', given: wanted }, { signal, onProgress })
}

const WORKER: WorkerOptions = {
  name: 'The worker that untangles',
  spawn: () => {
    const worker = new Worker(new URL('./untangle-worker.ts', import.meta.url), { type: 'module' })
    return pagePort(worker)
  },
  start: null,
}
