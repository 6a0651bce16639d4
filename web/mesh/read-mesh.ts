/** Bytes in, meshes out: the one entry for all that is pasted, dropped, opened or named on the command line. */
import { formats } from './formats'
import { gunzipped, gunzippedHead, isGzip } from './gzip'
import { type Mesh, MeshRefusal } from './mesh'
import { withoutQuotation } from './quotation'
import type { MeshFile, MeshFormat, ReadOptions } from './source'
import { shown } from './text-cursor'

const HEAD = 65_536

/**
 * The meshes in a file, gzipped or not: one, or several where a text holds several files. Throws a MeshRefusal, whose message is one sentence with the
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
  const format = formatOf(plain, options.format)
  try {
    const meshes = format.read(named(isGzip(headOf(plain, 3)) ? gunzipped(plain) : plain), all)
    return plain === file ? meshes : meshes.map(mesh => ({ ...mesh, coordinatePlaces: null }))
  } catch (error) {
    // The engine's own error where an array is too large for it.
    if (!(error instanceof RangeError)) throw error
    throw new MeshRefusal(`${shownName(file)}: reading it needs more memory than there is here (${error.message}).`)
  }
}

/** The file with the name under which people are told of it. */
function named(file: MeshFile): MeshFile {
  return { name: shownName(file), size: file.size, read: (from, to) => file.read(from, to) }
}

function headOf(file: MeshFile, size = HEAD): Uint8Array {
  return file.read(0, Math.min(size, file.size))
}

function formatOf(file: MeshFile, wanted: string | undefined): MeshFormat {
  if (wanted !== undefined) {
    const named = formats.find(({ name }) => name.toLowerCase() === wanted.toLowerCase())
    if (named) return named
    throw new MeshRefusal(`There is no format ${shown(wanted)}: ${formats.map(({ name }) => name).join(', ')}.`)
  }
  const packed = headOf(file)
  const isPacked = isGzip(packed)
  const head = isPacked ? gunzippedHead(file, HEAD) : packed
  const name = file.name.toLowerCase()
  const answers = formats.map(format => format.recognizes(head, isPacked ? name.replace(/\.gz$/, '') : name))
  const at = answers.includes('yes') ? answers.indexOf('yes') : answers.indexOf('maybe')
  if (at < 0) throw new MeshRefusal(`${shownName(file)}: this is in no format that is known here.`)
  return formats[at] as MeshFormat
}

function shownName(file: MeshFile): string {
  return shown(file.name).slice(1, -1)
}
