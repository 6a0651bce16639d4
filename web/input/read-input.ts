/** In a worker: what was pasted, dropped or opened becomes one mesh, or a sentence that says why not. */
import type { ReadingCore } from '../core/reading-interface'
import type { Core } from '../core/report'
import { type CoreSources, startCore } from '../core/start-core'
import { joined } from '../mesh/join-meshes'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import { MissingFiles, readTogether } from '../mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../mesh/source'
import { meshFileOf } from './file-reading'
import type { PastedInput } from './pasted-input'
import type { ReadingProgress } from './reading'

/** The wasm that reads and decides. */
export interface ReadingEngine {
  readonly core: CoreSources
  /** Null where there is none; readers then do without. */
  readonly readingCore: () => Promise<ReadingCore | null>
  readonly batchModule: () => Promise<WebAssembly.Module>
}

/** Throws a MeshRefusal, or what the engine throws. */
export async function meshOf(
  input: PastedInput,
  { readingCore }: ReadingEngine,
  tell: (progress: ReadingProgress) => void,
): Promise<Mesh> {
  const core = await readingCore()
  const onProgress = (fraction: number) => tell({ step: 'reading', fraction })
  const [first, ...others] = readTogether(filesOf(input), { onProgress, throwIfCancelled: () => {}, core })
  if (!first) throw new MeshRefusal('There is no mesh in it.')
  return joined([first, ...others])
}

function filesOf(input: PastedInput): MeshFile[] {
  if ('files' in input) return input.files.map(meshFileOf)
  return [fileOfBytes('The text', new TextEncoder().encode(input.text))]
}

export function coreOf({ core }: ReadingEngine): Promise<Core> {
  return startCore(core).catch(reason => {
    throw new MeshRefusal(`Nothing was decided: the core did not start (${reason.message}).`)
  })
}

export function refusalOf(reason: unknown): { readonly refused: string; readonly missing: readonly string[] } {
  const missing = reason instanceof MissingFiles ? reason.names : []
  return { refused: sentenceOf(reason), missing }
}

function sentenceOf(reason: unknown): string {
  if (reason instanceof MeshRefusal) return reason.message
  const why = reason instanceof Error ? reason.message : String(reason)
  if (reason instanceof DOMException) return `It could not be opened: ${why}`
  if (reason instanceof RangeError) return `Reading it needs more memory than there is here (${why}).`
  return `Reading it failed, which is a fault of Hexlens (${why}).`
}
