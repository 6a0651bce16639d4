/** The worker reads one input, decides its cells and hands all over. It is ended afterwards. */
import type { ReadingCore } from '../core/reading-interface'
import type { Core } from '../core/report'
import { type CoreSources, startCore } from '../core/start-core'
import { seldom, serve } from '../core/workers'
import { checkMesh } from '../mesh/check'
import { notesBesideOrder } from '../mesh/check-notes'
import { countSentences, headline } from '../mesh/check-summary'
import { type CheckedColumns, columnsOf } from '../mesh/checked-cells'
import type { Hdf5Loading } from '../mesh/hdf5-reader'
import { joined } from '../mesh/join-meshes'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { MissingFiles, readTogether } from '../mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../mesh/source'
import { cellClassifier } from './classify-cells'
import { type Beforehand, type FileAtHand, fileAtHand } from './file-at-hand'
import { meshFileOf } from './file-reading'
import type { PastedInput } from './pasted-input'
import type { ReadingProgress, ReadSummary } from './reading'

export type ReadingOutcome = { readonly summary: ReadSummary; readonly columns: CheckedColumns } | Refused

export interface Refused {
  /** One sentence. */
  readonly refused: string
  /** Files that are named and were not given. */
  readonly missing: readonly string[]
}

type Tell = (progress: ReadingProgress) => void

export const LOADING_BEGINS: ReadingProgress = { step: 'loading', fraction: 0 }

/** Tells now and then, but at once that something is loaded. */
export function toldSeldom(tell: Tell): Tell {
  const others = seldom(tell)
  return progress => (progress.step === 'loading' ? tell(progress) : others(progress))
}

export type ReadingJobs = { read(input: PastedInput, tell: Tell): Promise<ReadingOutcome> }

/** The wasm that reads and decides. */
export interface ReadingEngine {
  readonly core: CoreSources
  /** Null where there is none; readers then do without. */
  readonly readingCore: () => Promise<ReadingCore | null>
  readonly batchModule: () => Promise<WebAssembly.Module>
  readonly hdf5: Hdf5Loading
}

export function serveReading(engine: ReadingEngine): void {
  serve<null, ReadingJobs>('hexlens-reading', () => readingJobs(engine))
}

export function readingJobs(engine: ReadingEngine): ReadingJobs {
  return { read: (input, tell) => read(input, engine, tell).catch(refusalOf) }
}

async function read(input: PastedInput, engine: ReadingEngine, tell: Tell): Promise<ReadingOutcome> {
  const mesh = await meshOf(input, engine, toldSeldom(tell))
  const check = await checkOf(mesh, engine, seldom(tell))
  const summary = summaryOf(check)
  if (check.hexahedra > 0) return { summary, columns: columnsOf(check) }
  throw new MeshRefusal([`Read as ${summary.format}: no hexahedra of eight nodes.`, ...summary.sentences].join(' '))
}

export function filesOf(input: PastedInput): MeshFile[] {
  if ('files' in input)
    return input.files.map((file, i) => ({ ...meshFileOf(file), path: input.paths?.[i] ?? file.name }))
  return [fileOfBytes('The text', new TextEncoder().encode(input.text))]
}

/** One file is read beforehand; several may be more than there is memory for. */
async function filesAtHand(
  input: PastedInput,
  onProgress: (fraction: number) => void,
  core: ReadingCore | null,
  beforehand?: Beforehand,
): Promise<MeshFile[]> {
  const [first, ...others] = 'files' in input ? input.files : []
  return first && others.length === 0 ? [await fileAtHand(first, onProgress, core, beforehand)] : filesOf(input)
}

/** One mesh of all that was given. Throws a MeshRefusal, or what the engine throws. */
export async function meshOf(
  input: PastedInput,
  { readingCore, hdf5 }: ReadingEngine,
  tell: Tell,
  beforehand?: Beforehand,
): Promise<Mesh> {
  const core = await readingCore()
  const onProgress = (fraction: number) => tell({ step: 'reading', fraction })
  const files = await filesAtHand(input, onProgress, core, beforehand)
  const [first, ...others] = await hdf5.reading(
    reader => readTogether(files, { onProgress, throwIfCancelled: () => {}, core, hdf5: reader }),
    () => tell(LOADING_BEGINS),
  )
  for (const file of files) if ('close' in file) (file as FileAtHand).close()
  if (!first) throw new MeshRefusal('There is no mesh in it.')
  return joined([first, ...others])
}

export function coreOf({ core }: ReadingEngine): Promise<Core> {
  return startCore(core).catch(reason => {
    throw new MeshRefusal(`Nothing was decided: the core did not start (${reason.message}).`)
  })
}

async function checkOf(mesh: Mesh, engine: ReadingEngine, tell: Tell): Promise<MeshCheck> {
  const core = await coreOf(engine)
  const onProgress = (done: number, total: number) => tell({ step: 'deciding', fraction: done / total })
  const classify = cellClassifier(core, engine.batchModule, onProgress)
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

/** Whatever went wrong, in a sentence. */
export function refusalOf(reason: unknown): Refused {
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
