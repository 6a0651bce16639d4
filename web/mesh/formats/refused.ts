/** Files that are recognized and not read, each with a sentence on what it is and what converts it. */
import { MeshRefusal } from '../mesh'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat } from '../source'
import { shown } from '../text-cursor'
import { HDF5, type Known } from './refused-marks'
import { hdf5, refusedMeshes } from './refused-meshes'
import { refusedOthers } from './refused-others'

/** Bytes of an HDF5 file in which the names of its groups are looked for. */
const HDF5_HEAD = 1024 * 1024

const known: readonly Known[] = [...refusedMeshes, ...refusedOthers]

/** Names that files of other formats do not have. */
const NAMES_OF_VTK = /\.(vtu|pvtu|pvd|vtk)$/

export const refused: MeshFormat = {
  name: 'not read yet',
  recognizes: (head, name) => (knownOf(headText(head), name) === null ? 'no' : 'yes'),
  read(file) {
    const name = file.name.toLowerCase()
    const head = headOf(file, 65_536)
    const found = head.startsWith(HDF5) ? hdf5Of(file, name) : knownOf(head, name)
    const { what, instead } = found as Known
    const [, claimed] = NAMES_OF_VTK.exec(name) ?? []
    const isNot = claimed === undefined ? '' : `no ${claimed.toUpperCase()} but `
    throw new MeshRefusal(
      `${shown(file.name).slice(1, -1)}: this is ${isNot}${what}. Hexlens does not read it${what.startsWith('an image') ? '' : ' yet'}; ${instead}.`,
    )
  },
}

function headOf(file: MeshFile, most: number): string {
  return headText(file.read(0, Math.min(most, file.size)))
}

function knownOf(head: string, name: string): Known | null {
  if (head.startsWith(HDF5)) return hdf5.at(-1) as Known
  return known.find(({ is }) => is(head, name)) ?? null
}

function hdf5Of(file: MeshFile, name: string): Known {
  const head = headOf(file, HDF5_HEAD)
  return hdf5.find(({ is }) => is(head, name)) as Known
}
