/** A worker that searches: instances of the core of its own, and one piece after another, or one element polished or climbed from. */
import { loadBatchCore } from '../../../core/batch/batch-core'
import { type CoreExports, coreOf } from '../../../core/core'
import { serve } from '../../../core/workers'
import type { Vertices } from '../../../model/hexahedron'
import { type Climbed, climb } from './climb'
import { type Polished, polish } from './polish'
import { parseQuery, type Query } from './query'
import { type Piece, type PieceFinds, pieceSearcherOf } from './search-piece'

export interface SearchStart {
  /** hexlens-batch.wasm or hexlens-scalar.wasm, compiled: it has all that hexlens.wasm has. */
  readonly module: WebAssembly.Module
  readonly query: Query
}

export type SearchJobs = {
  search(piece: Piece): PieceFinds
  polish(vertices: Vertices, onStep: (simpler: Polished) => void): Polished
  climb(vertices: Vertices, onProgress: (best: Climbed) => void): Climbed
}

serve<SearchStart, SearchJobs>('hexlens-search', async ({ module, query }) => {
  const parsed = parseQuery(query)
  if (!parsed.ok) throw new Error(parsed.error.map(({ message }) => message).join(' '))
  // Each core has an instance and with it memory of its own.
  const instance = await WebAssembly.instantiate(module, {})
  const cores = { batch: await loadBatchCore(module), core: coreOf(instance.exports as unknown as CoreExports) }
  return {
    search: pieceSearcherOf(parsed.value, cores),
    polish: (vertices, onStep) => polish(parsed.value, vertices, cores, onStep),
    climb: (vertices, onProgress) => climb(parsed.value, vertices, cores, onProgress),
  }
})
