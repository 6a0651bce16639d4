/** What passes between the page and a worker for batches. Lists are transferred, not copied. */
import type { Piece, PieceResult } from './batch-core'

export type Request =
  | { readonly kind: 'start'; readonly module: WebAssembly.Module }
  | { readonly kind: 'classify'; readonly piece: Piece; readonly wantsMinima: boolean }

export type Answer =
  | { readonly kind: 'failed'; readonly message: string }
  /** So many cells of the piece at hand are done: sent now and then where exact arithmetic takes long. */
  | { readonly kind: 'progress'; readonly done: number }
  /** The coordinates' memory comes back to be filled again. */
  | { readonly kind: 'classified'; readonly result: PieceResult; readonly points: Float64Array }

/** The part of a Worker that is used; Node's workers fit with a small adapter. */
export interface WorkerPort {
  postMessage(request: Request, transfer: ArrayBuffer[]): void
  onmessage: ((event: { readonly data: Answer }) => void) | null
  onerror: ((event: { readonly message?: string }) => void) | null
  terminate(): void
}
