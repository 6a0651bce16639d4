/** The worker reads one input, decides its cells and hands all over. It is ended afterwards. */
import type { ReadingCore } from '../core/reading-interface'
import { type CoreSources, startCore } from '../core/start-core'
import { heldLock } from '../core/worker-lock'
import { checkMesh } from '../mesh/check'
import { notesBesideOrder } from '../mesh/check-notes'
import { countSentences, headline } from '../mesh/check-summary'
import { columnsOf, memoryOf } from '../mesh/checked-columns'
import { joined } from '../mesh/join-meshes'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { MissingFiles, readTogether } from '../mesh/read-together'
import { fileOfBytes, type MeshFile } from '../mesh/source'
import { cellClassifier } from './classify-cells'
import { meshFileOf } from './file-reading'
import type { ReadingReply, ReadingRequest, ReadingStep, ReadSummary } from './messages'

interface Scope {
  onmessage: ((event: { readonly data: ReadingRequest }) => void) | null
  postMessage(reply: ReadingReply, transfer?: ArrayBuffer[]): void
}

const scope = globalThis as unknown as Scope

/** Milliseconds. */
const PROGRESS_INTERVAL = 100

/** The wasm that reads and decides. */
export interface ReadingEngine {
  readonly core: CoreSources
  /** Null where there is none; readers then do without. */
  readonly readingCore: () => Promise<ReadingCore | null>
  readonly batchModule: () => Promise<WebAssembly.Module>
}

export function serveReading(engine: ReadingEngine): void {
  // A page is told of the worker's end by a lock, which is held before anything is read.
  const started = heldLock('hexlens-reading').then(lock => scope.postMessage({ kind: 'started', lock }))
  scope.onmessage = ({ data }) => {
    started.then(() => answer(data, engine)).catch(reason => scope.postMessage(refusalOf(reason)))
  }
}

async function answer(request: ReadingRequest, engine: ReadingEngine): Promise<void> {
  const check = await checkOf(meshOf(filesOf(request), await engine.readingCore()), engine)
  if (check.hexahedra === 0) {
    const { format, sentences } = summaryOf(check)
    throw new MeshRefusal([`Read as ${format}: no hexahedra of eight nodes.`, ...sentences].join(' '))
  }
  const columns = columnsOf(check)
  scope.postMessage({ kind: 'read', summary: summaryOf(check), columns }, memoryOf(columns))
}

function filesOf(request: ReadingRequest): MeshFile[] {
  if ('files' in request) return request.files.map(meshFileOf)
  return [fileOfBytes('The text', new TextEncoder().encode(request.text))]
}

function meshOf(files: readonly MeshFile[], core: ReadingCore | null): Mesh {
  const meshes = readTogether(files, { onProgress: progressOf('reading'), throwIfCancelled: () => {}, core })
  const [first, ...others] = meshes
  if (!first) throw new MeshRefusal('There is no mesh in it.')
  return joined([first, ...others])
}

async function checkOf(mesh: Mesh, { core: sources, batchModule }: ReadingEngine): Promise<MeshCheck> {
  const core = await startCore(sources).catch(reason => {
    throw new MeshRefusal(`Nothing was decided: the core did not start (${reason.message}).`)
  })
  const onProgress = progressOf('deciding')
  const classify = cellClassifier(core, batchModule, (done, total) => onProgress(done / total))
  return checkMesh(mesh, { classify, core }, { worst: Infinity, minRelative: null, skipsDegenerate: false })
}

/** One element's order stands beside the verdict, which has the button. */
function summaryOf(check: MeshCheck): ReadSummary {
  const { mesh, hexahedra, notes } = check
  const options = { skipsDegenerate: false }
  return {
    format: mesh.format,
    headline: headline(check, options),
    sentences: [
      ...countSentences(check, options),
      ...(hexahedra === 1 ? [...mesh.notes, ...notesBesideOrder(check)] : notes),
    ],
  }
}

function progressOf(step: ReadingStep): (fraction: number) => void {
  let shown = performance.now()
  return fraction => {
    const now = performance.now()
    if (now - shown < PROGRESS_INTERVAL) return
    shown = now
    scope.postMessage({ kind: 'progress', step, fraction })
  }
}

function refusalOf(reason: unknown): ReadingReply {
  const missing = reason instanceof MissingFiles ? reason.names : []
  if (reason instanceof MeshRefusal) return { kind: 'refused', message: reason.message, missing }
  const why = reason instanceof Error ? reason.message : String(reason)
  if (reason instanceof DOMException) return { kind: 'refused', message: `It could not be opened: ${why}`, missing }
  if (reason instanceof RangeError)
    return { kind: 'refused', message: `Reading it needs more memory than there is here (${why}).`, missing }
  return { kind: 'refused', message: `Reading it failed, which is a fault of Hexlens (${why}).`, missing }
}
