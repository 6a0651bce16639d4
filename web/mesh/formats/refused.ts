/** Files that are recognized and not read, each with a sentence on what it is and what converts it. */
import { MeshRefusal } from '../mesh'
import { headText } from '../snippet-text'
import type { MeshFormat } from '../source'
import { shown } from '../text-cursor'
import type { Known } from './refused-marks'
import { refusedMeshes } from './refused-meshes'
import { refusedOthers } from './refused-others'

const HEAD = 65_536

const known: readonly Known[] = [...refusedMeshes, ...refusedOthers]

/** Names that files of other formats do not have. */
const NAMES_OF_VTK = /\.(vtu|pvtu|pvd|vtk)$/

export const refused: MeshFormat = {
  name: 'not read yet',
  recognizes: (head, name) => (knownOf(headText(head), name) === null ? 'no' : 'yes'),
  read(file) {
    const name = file.name.toLowerCase()
    const head = headText(file.read(0, Math.min(HEAD, file.size)))
    const { what, instead } = knownOf(head, name) as Known
    const [, claimed] = NAMES_OF_VTK.exec(name) ?? []
    const isNot = claimed === undefined ? '' : `no ${claimed.toUpperCase()} but `
    throw new MeshRefusal(
      `${shown(file.name).slice(1, -1)}: this is ${isNot}${what}. Hexlens does not read it${what.startsWith('an image') ? '' : ' yet'}; ${instead}.`,
    )
  },
}

function knownOf(head: string, name: string): Known | null {
  return known.find(({ is }) => is(head, name)) ?? null
}
