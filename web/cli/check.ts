/** `hexlens check`: meshes in, verdicts out, file by file; the exit status is the gravest. */
import type { ReadingCore } from '../core/reading-interface'
import type { Core } from '../core/report'
import { checkMesh, type ExitStatus, exitOf, gravestExit } from '../mesh/check'
import type { Hdf5Loading } from '../mesh/hdf5-reader'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import type { ReadOptions } from '../mesh/source'
import { Refusal } from '../model/result'
import { csvOutput } from '../outputs/csv'
import { htmlOutput } from '../outputs/html'
import { idsOutput } from '../outputs/ids'
import { jsonOutput } from '../outputs/json'
import { junitOutput } from '../outputs/junit'
import { meshOutput } from '../outputs/meshes/mesh-output'
import { type FileResult, type Output, withoutControls } from '../outputs/output'
import { textOutput } from '../outputs/text'
import { checkAllSteps } from './all-steps'
import { type CheckArguments, readCheckArguments } from './check-arguments'
import { type CellClassifier, startCellClassifier } from './classify-cells'
import type { Engine } from './engine'
import { openMeshFile, realPath } from './mesh-file'
import { isAboutMemory, meshIn } from './mesh-in'
import { ProgressLine } from './progress'
import { FileSink } from './sink'
import { Buffered, type Streams } from './streams'

/** Worst cells that are listed unless --worst says how many. */
const WORST = 10

/** Throws a Refusal for a wrong call, and where something cannot be written. */
export async function check(args: readonly string[], engine: Engine, streams: Streams): Promise<ExitStatus> {
  const wanted = readCheckArguments(args)
  refuseOverwriting(wanted)
  const progress = new ProgressLine(streams.errors.isTTY ? streams.errors : null)
  const say = (sentence: string) => {
    progress.clear()
    streams.errors.write(`hexlens: ${sentence}\n`)
  }
  const outputs = outputsOf(wanted, streams, say)
  const exits: ExitStatus[] = []
  let current = ''
  const [core, readingCore] = await Promise.all([engine.core(), engine.readingCore()])
  const cells = await startCellClassifier(engine, ({ done, total }) =>
    progress.show(`${current}: deciding`, done / total),
  )
  try {
    for (const file of wanted.files) {
      current = withoutControls(file)
      const lists = Object.assign({}, ...outputs.map(({ output }) => output.lists))
      const result = await resultOf(file, {
        wanted,
        lists,
        core,
        readingCore,
        hdf5: engine.hdf5,
        cells,
        streams,
        progress,
      })
      exits.push(result.exit)
      progress.clear()
      if ('error' in result && wanted.ids !== null) say(result.error)
      for (const { output, write } of outputs) for (const chunk of output.file(result)) await write(chunk)
    }
    const exit = gravestExit(exits)
    for (const { output, write, close } of outputs) {
      for (const chunk of output.end(exit)) await write(chunk)
      await close()
    }
    return exit
  } finally {
    progress.clear()
    cells.close()
    for (const { discard } of outputs) discard()
  }
}

interface Work {
  readonly wanted: CheckArguments
  readonly lists: Output['lists']
  readonly core: Core
  readonly readingCore: ReadingCore | null
  readonly hdf5: Hdf5Loading
  readonly cells: CellClassifier
  readonly streams: Streams
  readonly progress: ProgressLine
}

async function resultOf(file: string, work: Work): Promise<FileResult> {
  const { wanted } = work
  try {
    if (wanted.step === 'all') {
      const read = (step: number) => meshOf(file, step, work)
      const own = { ...work, wanted: { ...wanted, worst: wanted.worst || WORST } }
      const { check, ...others } = await checkAllSteps({
        read,
        check: mesh => checkOf(mesh, own),
        allowsUnchecked: wanted.allowsUnchecked,
      })
      const worst = check.worst.subarray(0, wanted.worst ?? WORST)
      return { file, ...others, check: { ...check, worst } }
    }
    const check = await checkOf(await meshOf(file, wanted.step, work), work)
    return { file, exit: exitOf(check, wanted), check }
  } catch (error) {
    if (error instanceof Refusal) return { file, exit: 2, error: withoutControls(error.message) }
    if (error instanceof RangeError && isAboutMemory(error))
      return { file, exit: 2, error: `${withoutControls(file)} needs more memory than there is.` }
    throw error
  }
}

async function meshOf(
  path: string,
  step: ReadOptions['step'],
  { wanted, readingCore, hdf5, streams, progress }: Work,
): Promise<Mesh> {
  const open = await openMeshFile(path, streams.input)
  try {
    const { format } = wanted
    return await meshIn(open, withoutControls(path), { format, step, readingCore, hdf5, progress })
  } finally {
    open.close()
  }
}

function checkOf(mesh: Mesh, { wanted, lists, core, cells }: Work): Promise<MeshCheck> {
  const { worst, minRelative, skipsDegenerate } = wanted
  return checkMesh(
    mesh,
    { classify: cells.classify, core },
    { worst: worst ?? WORST, minRelative, skipsDegenerate, lists },
  )
}

interface OpenOutput {
  readonly output: Output
  write(chunk: string | Uint8Array): unknown
  close(): unknown
  /** Instead of `close`: nothing is left behind. */
  discard(): void
}

/** The last goes to standard output. */
function outputsOf(wanted: CheckArguments, streams: Streams, say: (sentence: string) => void): OpenOutput[] {
  const { csv, junit, annotate, html, ids, json, files, worst } = wanted
  const printed = new Buffered(streams.output)
  const main = json
    ? jsonOutput()
    : ids !== null
      ? idsOutput(ids, files.length, say)
      : textOutput({ ...wanted, listsAll: worst !== null, isOneStep: wanted.step !== 'all' })
  return [
    ...(csv === null ? [] : [toFile(csvOutput(), csv)]),
    ...(junit === null ? [] : [toFile(junitOutput(wanted), junit)]),
    ...(annotate === null ? [] : [toFile(meshOutput(annotate.form, say), annotate.path)]),
    ...(html === null ? [] : [toFile(htmlOutput({ ...wanted, fileCount: files.length }), html)]),
    {
      output: main,
      write: chunk => printed.write(chunk as string),
      close: () => printed.flush(),
      discard: () => {},
    },
  ]
}

function toFile(output: Output, path: string): OpenOutput {
  const sink = new FileSink(path)
  return {
    output,
    write: chunk => sink.write(chunk),
    close: () => sink.close(),
    discard: () => sink.discard(),
  }
}

/** A file that is read, or written for another purpose. */
function refuseOverwriting({ files, csv, junit, annotate, html }: CheckArguments): void {
  const taken = new Map(files.filter(file => file !== '-').map(file => [realPath(file), `${file}, which is read`]))
  for (const [option, path] of Object.entries({
    '--csv': csv,
    '--junit': junit,
    '--annotate': annotate?.path ?? null,
    '--html': html,
  })) {
    if (path === null) continue
    const other = taken.get(realPath(path))
    if (other !== undefined) throw new Refusal(`check: ${option} would overwrite ${other}.`)
    taken.set(realPath(path), `${path}, which is written`)
  }
}
