/** The mesh in an open file, for commands: all its parts as one. */
import type { ReadingCore } from '../core/reading-interface'
import { type Hdf5Loading, LOADING } from '../mesh/hdf5-reader'
import { joined } from '../mesh/join-meshes'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import { readMeshes } from '../mesh/read-mesh'
import { shownFileName } from '../mesh/shown'
import { missingStep } from '../mesh/step-note'
import type { OpenFile } from './mesh-file'
import type { ProgressLine } from './progress'

export interface MeshReading {
  readonly format: string | null
  readonly step: number | 'last'
  readonly readingCore: ReadingCore | null
  readonly hdf5: Hdf5Loading
  readonly progress: ProgressLine
}

/** Throws a Refusal. */
export async function meshIn(
  { file, find }: OpenFile,
  name: string,
  { format, step, readingCore, hdf5, progress }: MeshReading,
): Promise<Mesh> {
  const onProgress = (fraction: number) => progress.show(`${name}: reading`, fraction)
  const options = { find, onProgress, step, core: readingCore, ...(format === null ? {} : { format }) }
  const meshes = await hdf5.reading(
    reader => readMeshes(file, { ...options, hdf5: reader }),
    () => progress.show(LOADING, 0),
  )
  const [first, ...others] = meshes
  if (!first) throw new MeshRefusal(`${name}: there is no mesh in it.`)
  // Formats without steps, and files of the others that have none, leave the step to their caller.
  const stepCount = Math.max(1, ...meshes.map(({ steps }) => steps.length))
  if (step !== 'last' && step >= stepCount)
    throw new MeshRefusal(`${shownFileName(file.name)}: ${missingStep(stepCount, step)}`)
  return joined([first, ...others])
}

/** True for the messages of engines that cannot have an array. */
export function isAboutMemory({ message }: RangeError): boolean {
  return /allocation failed|array length|memory/i.test(message)
}
