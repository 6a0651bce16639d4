/** What passes between the page and a worker that searches. */
import type { Vertices } from '../../../model/hexahedron'
import type { Haul, Piece } from './hunt'
import type { Polished } from './polish'
import type { Quest } from './quest'

export type Request =
  | { readonly kind: 'start'; readonly module: WebAssembly.Module }
  /** The quest of the pieces that follow. */
  | { readonly kind: 'quest'; readonly quest: Quest }
  | { readonly kind: 'hunt'; readonly piece: Piece }
  | { readonly kind: 'polish'; readonly quest: Quest; readonly vertices: Vertices }

export type Answer =
  | { readonly kind: 'failed'; readonly message: string }
  | { readonly kind: 'haul'; readonly haul: Haul }
  /** On the way, and at the end. */
  | { readonly kind: 'simpler' | 'polished'; readonly polished: Polished }

/** The part of a Worker that is used; Node's workers fit with a small adapter. */
export interface WorkerPort {
  postMessage(request: Request): void
  onmessage: ((event: { readonly data: Answer }) => void) | null
  onerror: ((event: { readonly message?: string }) => void) | null
  terminate(): void
}
