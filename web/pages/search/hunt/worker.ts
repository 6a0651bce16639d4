/** A worker that searches: instances of the core of its own, one piece after another, or one element polished. */
import { loadBatchCore } from '../../../core/batch/batch-core'
import { type CoreExports, coreOf } from '../../../core/core'
import { type Cores, type Haul, hunterOf, type Piece } from './hunt'
import type { Answer, Request } from './messages'
import { polish } from './polish'
import { type Quest, type ReadQuest, readQuest } from './quest'

interface Scope {
  onmessage: ((event: { readonly data: Request }) => void) | null
  postMessage(answer: Answer): void
}

const scope = globalThis as unknown as Scope

let cores: Promise<Cores> | undefined
let hunt: Promise<(piece: Piece) => Haul> | undefined

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
    case 'quest':
      hunt = ready().then(cores => hunterOf(checked(request.quest), cores))
      return
    case 'hunt':
      if (!hunt) throw new Error('The worker was sent hunting without a quest.')
      return scope.postMessage({ kind: 'haul', haul: (await hunt)(request.piece) })
    case 'polish': {
      const polished = polish(checked(request.quest), request.vertices, await ready(), simpler =>
        scope.postMessage({ kind: 'simpler', polished: simpler }),
      )
      return scope.postMessage({ kind: 'polished', polished })
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

function checked(quest: Quest): ReadQuest {
  const result = readQuest(quest)
  if (!result.ok) throw new Error(result.errors.map(({ message }) => message).join(' '))
  return result.value
}
