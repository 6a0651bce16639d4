/** Bytes in, meshes out: the one entry for all that is pasted, dropped, opened or named on the command line. */
import { formats } from './formats'
import { type Mesh, MeshRefusal } from './mesh'
import { withoutQuotation } from './quotation'
import type { MeshFile, MeshFormat, ReadOptions } from './source'
import { shown } from './text-cursor'

const HEAD = 65_536

/**
 * The meshes in a file: one, or several where a text holds several files. Throws a MeshRefusal, whose message is one sentence with the
 * file, the place and what was expected.
 */
export function readMeshes(file: MeshFile, options: Partial<ReadOptions> & { format?: string } = {}): readonly Mesh[] {
  const all: ReadOptions = {
    find: options.find ?? (() => null),
    onProgress: options.onProgress ?? (() => {}),
    throwIfCancelled: options.throwIfCancelled ?? (() => {}),
  }
  if (file.size === 0) throw new MeshRefusal(`${shownName(file)}: the file is empty.`)
  const plain = withoutQuotation(file)
  const meshes = formatOf(plain, options.format).read(plain, all)
  if (plain === file) return meshes
  return meshes.map(mesh => ({ ...mesh, coordinatePlaces: null }))
}

function formatOf(file: MeshFile, wanted: string | undefined): MeshFormat {
  if (wanted !== undefined) {
    const named = formats.find(({ name }) => name.toLowerCase() === wanted.toLowerCase())
    if (named) return named
    throw new MeshRefusal(`There is no format ${shown(wanted)}: ${formats.map(({ name }) => name).join(', ')}.`)
  }
  const head = file.read(0, Math.min(HEAD, file.size))
  const answers = formats.map(format => format.recognizes(head, file.name.toLowerCase()))
  const at = answers.includes('yes') ? answers.indexOf('yes') : answers.indexOf('maybe')
  if (at < 0) throw new MeshRefusal(`${shownName(file)}: this is in no format that is known here.`)
  return formats[at] as MeshFormat
}

function shownName(file: MeshFile): string {
  return shown(file.name).slice(1, -1)
}
