/**
 * Messages between the caller's thread and a worker for batches: pieces, and blocks of memory for the answers, which may be those the
 * pieces lie in. Both come back. All memory is transferred, none is copied, and what comes back is filled again.
 */
import type { Counts, Piece } from './batch-core'
import type { Wanted } from './lists'

export type Request =
  | { readonly kind: 'start'; readonly module: WebAssembly.Module }
  | { readonly kind: 'classify'; readonly piece: Piece; readonly block: ArrayBuffer; readonly wanted: Wanted }

export type Reply =
  /** The answer to `start`. The worker holds the Web Lock of this name as long as it lives; null where there are no such locks. */
  | { readonly kind: 'started'; readonly lock: string | null }
  /** The worker is of no more use. */
  | { readonly kind: 'failed'; readonly message: string }
  /** Cells of the piece at hand that are done: sent now and then where they take long. */
  | { readonly kind: 'progress'; readonly done: number }
  /** The answers lie at the beginning of the block: listsIn. */
  | { readonly kind: 'classified'; readonly counts: Counts; readonly piece: Piece; readonly block: ArrayBuffer }

/** All memory of a message. */
export function memoryOf({ piece, block }: { readonly piece: Piece; readonly block: ArrayBuffer }): ArrayBuffer[] {
  const { points, cells } = piece
  return [...new Set([block, points.buffer as ArrayBuffer, ...(cells ? [cells.buffer as ArrayBuffer] : [])])]
}

/** A worker of a page or of Node: ports.ts. */
export interface WorkerPort {
  postMessage(request: Request, transfer: ArrayBuffer[]): void
  onmessage: ((event: { readonly data: Reply }) => void) | null
  /** Called, with the reason as a clause, when the worker cannot be started or has ended without having been told to. */
  onbroken: ((reason: string) => void) | null
  terminate(): void
}
