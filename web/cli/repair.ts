/** `hexlens repair`: a mesh in, the same mesh with points moved out; the exit status is that of `check` for what was written. */
import { type Reason, reasonsOf } from '../core/repair/held'
import { untangle } from '../core/repair/untangle'
import type { Untangled } from '../core/repair/untangling'
import { type CheckOptions, checkMesh, type ExitStatus, exitOf } from '../mesh/check'
import type { Mesh } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { Refusal } from '../model/result'
import { fittingOf } from '../outputs/columns'
import { writeHeldCertificates } from '../outputs/held-certificates'
import { MESH_FORMS } from '../outputs/meshes/list'
import type { MeshForm } from '../outputs/meshes/mesh-form'
import { MESH_ENDINGS, meshOutput } from '../outputs/meshes/mesh-output'
import { movedFile, whyNotInPlace } from '../outputs/moved-file'
import { withoutControls } from '../outputs/output'
import { type MeantOrder, type Repaired, repairLines } from '../outputs/repair-text'
import { textOutput } from '../outputs/text'
import { type CellClassifier, startCellClassifier } from './classify-cells'
import type { Engine } from './engine'
import { meantOrderOf } from './meant-order'
import { type OpenFile, openMeshFile, realPath } from './mesh-file'
import { isAboutMemory, meshIn } from './mesh-in'
import { ProgressLine } from './progress'
import { type RepairArguments, readRepairArguments } from './repair-arguments'
import { FileSink } from './sink'
import type { Streams } from './streams'

/** Worst cells that are listed. */
const WORST = 10

interface Work {
  readonly wanted: RepairArguments
  readonly engine: Engine
  readonly streams: Streams
  readonly progress: ProgressLine
  readonly cells: CellClassifier
}

/** Throws a Refusal for a wrong call, a mesh that cannot be read, and where nothing can be written. */
export async function repair(args: readonly string[], engine: Engine, streams: Streams): Promise<ExitStatus> {
  const wanted = readRepairArguments(args)
  const { input, output } = wanted
  if (input !== '-' && realPath(output) === realPath(input))
    throw new Refusal(`repair: ${output} is what is read, and stays as it is: name another file to write.`)
  const { certificates } = wanted
  if (certificates !== null && [input, output].some(path => path !== '-' && realPath(certificates) === realPath(path)))
    throw new Refusal(`repair: the certificates need a file of their own, not ${certificates}.`)
  const sink = new FileSink(output)
  const proofs = certificates === null ? null : new FileSink(certificates)
  const progress = new ProgressLine(streams.errors.isTTY ? streams.errors : null)
  const cells = await startCellClassifier(engine, ({ done, total }) =>
    progress.show(`${withoutControls(output)}: deciding`, done / total),
  )
  try {
    return await repaired({ wanted, engine, streams, progress, cells }, sink, proofs)
  } catch (error) {
    if (error instanceof RangeError && isAboutMemory(error))
      throw new Refusal(`${input} needs more memory than there is.`)
    throw error
  } finally {
    progress.clear()
    cells.close()
    sink.discard()
    proofs?.discard()
  }
}

async function repaired(work: Work, sink: FileSink, proofs: FileSink | null): Promise<ExitStatus> {
  const { wanted, engine, streams, progress } = work
  const { input, output, minRelative } = wanted
  const open = await openMeshFile(input, streams.input)
  try {
    const mesh = await meshOf(open, input, work)
    const meantOrder = await orderOf(mesh, work)
    const isReordered = meantOrder !== null && wanted.reorders
    const form = formFor(mesh, wanted, isReordered)
    const meant = meantOrder ? { ...mesh, cells: meantOrder.cells } : mesh
    const result = await untangled(meant, work)
    const written = isReordered ? meant : mesh
    let mostRounded = 0
    const fit = fittingOf(mesh.format, off => {
      mostRounded = Math.max(mostRounded, off)
    })
    const chunks = form
      ? await writtenAs(form, { ...written, points: result.points }, work)
      : movedFile(open.file, mesh, result.points, fit)
    for (const chunk of chunks) sink.write(chunk)
    sink.close()
    const check = await checkOfWritten(work, form)
    const exit = exitOf(check, wanted)
    const margin = minRelative ?? 0
    const reason = reasonsOf(await engine.repairCore(), meant, result, margin)
    const certificates = proofs && writtenCertificates(proofs, written, result, reason, work)
    const { format } = mesh
    progress.clear()
    for (const line of repairLines({
      result,
      meantOrder,
      isReordered,
      mostRounded,
      reason,
      margin,
      isBoundaryFixed: !wanted.slides && !wanted.freeBoundary,
      input,
      output,
      format,
      form: form?.name ?? null,
      certificates,
    }))
      await streams.output.write(`${line}\n`)
    const text = textOutput({ listsAll: false, minRelative, skipsDegenerate: false, isOneStep: false })
    for (const chunk of text.file({ file: output, exit, check })) await streams.output.write(chunk as string)
    return exit
  } finally {
    open.close()
  }
}

async function meshOf(
  open: OpenFile,
  path: string,
  { wanted, engine, progress }: Work,
  { format, step }: Pick<RepairArguments, 'format' | 'step'> = wanted,
): Promise<Mesh> {
  const readingCore = await engine.readingCore()
  return meshIn(open, withoutControls(path), { format, step, readingCore, hdf5: engine.hdf5, progress })
}

async function orderOf(mesh: Mesh, work: Work): Promise<MeantOrder | null> {
  const { engine, cells } = work
  const [core, repairCore] = await Promise.all([engine.core(), engine.repairCore()])
  return meantOrderOf(await checkOf(mesh, work), { core, repairCore, classify: cells.classify })
}

/** Null if the file is written as it was but for coordinates, else how its hexahedra are. Throws a Refusal if neither is meant and possible. */
function formFor(mesh: Mesh, { input, output }: RepairArguments, isReordered: boolean): MeshForm | null {
  const ending = endingOf(output)
  const form = MESH_FORMS.find(({ id }) => id === ending) ?? null
  const why = isReordered ? `In this file (${mesh.format}) the order of nodes cannot be replaced.` : whyNotInPlace(mesh)
  const isSameFormat = ending === endingOf(input) || form?.name.split(' ')[0] === mesh.format
  if (why === null && (form === null || isSameFormat)) return null
  if (form === null)
    throw new Refusal(`repair: ${why} Name a file that ends in one of ${MESH_ENDINGS} to write the hexahedra so.`)
  return form
}

function endingOf(path: string): string | undefined {
  return /\.([^./\\]+)$/.exec(path)?.[1]?.toLowerCase()
}

async function untangled(mesh: Mesh, { wanted, engine, progress }: Work): Promise<Untangled> {
  const { minRelative, slides, freeBoundary } = wanted
  const name = withoutControls(wanted.input)
  const options = { margin: minRelative ?? 0, slides, boundaryDistance: freeBoundary ?? 0 }
  const result = await untangle(await engine.repairCore(), mesh, options, ({ belowBefore, belowAfter }) =>
    progress.show(`${name}: repairing`, 1 - belowAfter / Math.max(belowBefore, 1)),
  )
  if (result.ok) return result.value
  const at = mesh.points.findIndex(x => !Number.isFinite(x))
  const which = result.error.code === 'not-finite' ? ` It is one of point ${Math.floor(at / 3)}, counted from 0.` : ''
  throw new Refusal(`${name}: ${result.error.message}${which}`)
}

async function writtenAs(form: MeshForm, mesh: Mesh, work: Work): Promise<Iterable<string | Uint8Array>> {
  const { errors } = work.streams
  const output = meshOutput(form, sentence => errors.write(`hexlens: ${sentence}\n`))
  const check = await checkOf(mesh, work, output.lists)
  return output.file({ file: work.wanted.output, exit: exitOf(check, work.wanted), check })
}

/** Their file, and how many are in it. */
function writtenCertificates(
  sink: FileSink,
  { ids, cells }: Mesh,
  { heldPoints }: Untangled,
  reason: (held: number) => Reason,
  { wanted, progress }: Work,
): NonNullable<Repaired['certificates']> {
  const file = wanted.certificates as string
  function* reasons() {
    for (const held of heldPoints.keys()) {
      progress.show(`${withoutControls(file)}: proving`, held / heldPoints.length)
      const own = reason(held)
      // The cell may be listed in another order than it is repaired in.
      const first = own.cells[0] as number
      yield { ...own, vertex: cells.subarray(8 * first, 8 * first + 8).indexOf(own.point) }
    }
  }
  const named = { indexOf: (point: number) => point, nameOf: (cell: number) => String(ids?.[cell] ?? cell) }
  const count = writeHeldCertificates(reasons(), named, text => sink.write(text))
  sink.close()
  return { file, count }
}

/** What was written is read again: a file may have no room for all digits of the points. */
async function checkOfWritten(work: Work, form: MeshForm | null): Promise<MeshCheck> {
  const { wanted, streams } = work
  const open = await openMeshFile(wanted.output, streams.input)
  try {
    const reading = form ? { format: null, step: 0 } : wanted
    return await checkOf(await meshOf(open, wanted.output, work, reading), work)
  } finally {
    open.close()
  }
}

async function checkOf(mesh: Mesh, { wanted, engine, cells }: Work, lists: CheckOptions['lists'] = {}) {
  const { minRelative } = wanted
  const means = { classify: cells.classify, core: await engine.core() }
  return checkMesh(mesh, means, { worst: WORST, minRelative, skipsDegenerate: false, lists })
}
