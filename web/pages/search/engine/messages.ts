/** Messages between the page and a worker that searches. */
import type { Vertices } from '../../../model/hexahedron'
import type { Climbed } from './climb'
import type { Polished } from './polish'
import type { Query } from './query'
import type { Piece, PieceFinds } from './search-piece'

/** What comes of an element, by the request. */
export interface Improved {
  readonly polish: Polished
  readonly climb: Climbed
}

export type Request =
  | { readonly kind: 'start'; readonly module: WebAssembly.Module }
  /** The query of the pieces that follow. */
  | { readonly kind: 'query'; readonly query: Query }
  | { readonly kind: 'piece'; readonly piece: Piece }
  | { readonly kind: keyof Improved; readonly query: Query; readonly vertices: Vertices }

export type Reply =
  | { readonly kind: 'failed'; readonly message: string }
  | { readonly kind: 'result'; readonly result: PieceFinds }
  /** `better` on the way, `best` at the end. */
  | { readonly kind: 'better' | 'best'; readonly improved: Improved[keyof Improved] }

/** The part of a Worker that is used; Node's workers fit with a small adapter. */
export interface WorkerPort {
  postMessage(request: Request): void
  onmessage: ((event: { readonly data: Reply }) => void) | null
  onerror: ((event: { readonly message?: string }) => void) | null
  terminate(): void
}
