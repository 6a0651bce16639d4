/** Bytes in, meshes out: the one entry for all that is pasted, dropped, opened or named on the command line. */
import { formats } from './formats'
import { refused } from './formats/refused'
import { gunzipped, gunzippedHead, isGzip } from './gzip'
import { type Mesh, MeshRefusal } from './mesh'
import { fencedBlocks, withoutQuotation } from './quotation'
import { shownFileName } from './shown'
import { utf16Of } from './snippet-text'
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
    step: options.step ?? 0,
    onProgress: options.onProgress ?? (() => {}),
    throwIfCancelled: options.throwIfCancelled ?? (() => {}),
    core: options.core ?? null,
  }
  const here = named(file)
  if (here.size === 0) throw new MeshRefusal(`${here.name}: the file is empty.`)
  const wanted = options.format === undefined ? null : formatNamed(options.format)
  const head = headOf(here)
  const isPacked = isGzip(head)
  const name = isPacked ? here.name.replace(/\.gz$/i, '') : here.name
  // Nothing is inflated that no format wants.
  if (isPacked && wanted === null) formatOf(gunzippedHead(here, HEAD), name)
  try {
    const whole = isPacked ? gunzipped(here) : here
    const several = wanted === null ? meshesInFences(whole, all) : []
    if (several.length > 0) return several
    const plain = withoutQuotation(whole)
    const format = wanted ?? formatOf(headOf(plain), name)
    const meshes = format.read(plain, all)
    if (plain === here) return meshes
    const areBytesKept = !isPacked && utf16Of(head) === null
    return meshes.map(mesh => (areBytesKept ? withTruePlaces(mesh) : { ...mesh, coordinatePlaces: null }))
  } catch (error) {
    // The engine's own error where an array is too large for it.
    if (!(error instanceof RangeError)) throw error
    throw new MeshRefusal(`${here.name}: reading it needs more memory than there is here (${error.message}).`)
  }
}

/** Meshes of fences with files of different formats; else none: the text is read as one. */
function meshesInFences(file: MeshFile, options: ReadOptions): Mesh[] {
  const known = fencedBlocks(file).flatMap(({ file: block, text }) => {
    const format = formats.find(({ recognizes }) => recognizes(text.subarray(0, HEAD), '') === 'yes')
    return format === undefined || format === refused ? [] : [{ block, format }]
  })
  if (new Set(known.map(({ format }) => format)).size < 2) return []
  return known
    .flatMap(({ block, format }) => format.read(block, options))
    .map(mesh => ({ ...mesh, coordinatePlaces: null }))
}

/** Drops the places of a run in a quoted text: marks stand between its coordinates. */
function withTruePlaces(mesh: Mesh): Mesh {
  return mesh.coordinatePlaces?.kind === 'tokens' ? mesh : { ...mesh, coordinatePlaces: null }
}

/** The file with the name under which people are told of it. */
function named(file: MeshFile): MeshFile {
  return { name: shownFileName(file.name), size: file.size, read: (from, to, into) => file.read(from, to, into) }
}

function headOf(file: MeshFile): Uint8Array {
  return file.read(0, Math.min(HEAD, file.size))
}

function formatNamed(wanted: string): MeshFormat {
  const found = formats.find(({ name }) => name.toLowerCase() === wanted.toLowerCase())
  if (found) return found
  throw new MeshRefusal(`There is no format ${shown(wanted)}: ${formats.map(({ name }) => name).join(', ')}.`)
}

function formatOf(head: Uint8Array, fileName: string): MeshFormat {
  const answers = formats.map(format => format.recognizes(head, fileName.toLowerCase()))
  const at = answers.includes('yes') ? answers.indexOf('yes') : answers.indexOf('maybe')
  if (at < 0) throw new MeshRefusal(`${shown(fileName).slice(1, -1)}: this is in no format that is known here.`)
  return formats[at] as MeshFormat
}
