/** The worker reads one input, decides its cells and hands all over. It is ended afterwards. */
import { seldom, serve } from '../core/workers'
import { checkMesh } from '../mesh/check'
import { notesBesideOrder } from '../mesh/check-notes'
import { countSentences, headline } from '../mesh/check-summary'
import { type CheckedColumns, columnsOf } from '../mesh/checked-cells'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { cellClassifier } from './classify-cells'
import type { PastedInput } from './pasted-input'
import { coreOf, meshOf, type ReadingEngine, refusalOf } from './read-input'
import type { ReadingProgress, ReadSummary } from './reading'

export type ReadingOutcome =
  | { readonly summary: ReadSummary; readonly columns: CheckedColumns }
  /** One sentence; `missing` are files that are named and were not given. */
  | { readonly refused: string; readonly missing: readonly string[] }

type Tell = (progress: ReadingProgress) => void

export type ReadingJobs = { read(input: PastedInput, tell: Tell): Promise<ReadingOutcome> }

export function serveReading(engine: ReadingEngine): void {
  serve<null, ReadingJobs>('hexlens-reading', () => ({
    read: (input, tell) => read(input, engine, tell).catch(refusalOf),
  }))
}

async function read(input: PastedInput, engine: ReadingEngine, tell: Tell): Promise<ReadingOutcome> {
  const mesh = await meshOf(input, engine, seldom(tell))
  const check = await checkOf(mesh, engine, seldom(tell))
  const summary = summaryOf(check)
  if (check.hexahedra > 0) return { summary, columns: columnsOf(check) }
  throw new MeshRefusal([`Read as ${summary.format}: no hexahedra of eight nodes.`, ...summary.sentences].join(' '))
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
