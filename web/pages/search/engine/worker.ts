/** A worker that searches: instances of the core of its own, one piece after another, or one element polished or climbed from. */
import { loadBatchCore } from '../../../core/batch/batch-core'
import { type CoreExports, coreOf } from '../../../core/core'
import { climb } from './climb'
import type { Reply, Request } from './messages'
import { polish } from './polish'
import { type ParsedQuery, parseQuery, type Query } from './query'
import { type Cores, type Piece, type PieceFinds, pieceSearcherOf } from './search-piece'

interface Scope {
  onmessage: ((event: { readonly data: Request }) => void) | null
  postMessage(reply: Reply): void
}

const scope = globalThis as unknown as Scope

let cores: Promise<Cores> | undefined
let searchPiece: Promise<(piece: Piece) => PieceFinds> | undefined

scope.onmessage = ({ data }) => {
  answer(data).catch(reason =>
    scope.postMessage({ kind: 'failed', message: reason instanceof Error ? reason.message : String(reason) }),
  )
}

async function answer(request: Request): Promise<void> {
  switch (request.kind) {
    case 'start':
      cores = started(request.module)
      return
    case 'query':
      searchPiece = ready().then(cores => pieceSearcherOf(checked(request.query), cores))
      return
    case 'piece':
      if (!searchPiece) throw new Error('The worker was sent a piece without a query.')
      return scope.postMessage({ kind: 'result', result: (await searchPiece)(request.piece) })
    case 'polish':
    case 'climb': {
      const improve = { polish, climb }[request.kind]
      const best = improve(checked(request.query), request.vertices, await ready(), improved =>
        scope.postMessage({ kind: 'better', improved }),
      )
      return scope.postMessage({ kind: 'best', improved: best })
    }
  }
}

/** The module for batches has all that the single one has; each core has an instance and with it memory of its own. */
async function started(module: WebAssembly.Module): Promise<Cores> {
  const instance = await WebAssembly.instantiate(module, {})
  return { batch: await loadBatchCore(module), core: coreOf(instance.exports as unknown as CoreExports) }
}

async function ready(): Promise<Cores> {
  if (!cores) throw new Error('The worker was asked before it was started.')
  return cores
}

function checked(query: Query): ParsedQuery {
  const result = parseQuery(query)
  if (!result.ok) throw new Error(result.error.map(({ message }) => message).join(' '))
  return result.value
}
