/** Bytes in, meshes out: the one entry for all that is pasted, dropped, opened or named on the command line, together or one by one. */
import { foamCaseOf } from './foam-case'
import { formats } from './formats'
import { namedFor } from './formats/hdf5'
import { link } from './formats/link'
import { picture } from './formats/picture'
import { refused } from './formats/refused'
import { gunzipped, gunzippedHead, isGzip } from './gzip'
import { type Mesh, MeshRefusal } from './mesh'
import { missingEnd } from './missing-end'
import { fencedBlocks, withoutQuotation } from './quotation'
import { shownFileName } from './shown'
import { utf16Of } from './snippet-text'
import { type FileList, fileNamed, type MeshFile, type MeshFormat, type ReadOptions } from './source'
import { shown } from './text-cursor'

const HEAD = 65_536

/** A refusal because of files that are named and not there. */
export class MissingFiles extends MeshRefusal {
  /** Names as the files write them. */
  readonly names: readonly string[]

  constructor(message: string, names: readonly string[]) {
    super(message)
    this.names = names
  }
}

export type TogetherOptions = Omit<ReadOptions, 'find' | 'step' | 'core' | 'hdf5'> &
  Partial<Pick<ReadOptions, 'step' | 'core' | 'hdf5'>>

/** All meshes of the files. Throws a MeshRefusal for the first file that is refused and that no other names. */
export function readTogether(files: readonly MeshFile[], options: TogetherOptions): readonly Mesh[] {
  const foamCase = foamCaseOf(files)
  if (foamCase === null) return readEach(files, options)
  const { note } = foamCase
  const meshes = readEach(foamCase.files, options)
  return note === null ? meshes : meshes.map((mesh, i) => (i === 0 ? { ...mesh, notes: [...mesh.notes, note] } : mesh))
}

function readEach(files: readonly MeshFile[], options: TogetherOptions): readonly Mesh[] {
  const parts = new Set<MeshFile>()
  const results = new Map<MeshFile, readonly Mesh[] | MeshRefusal>()
  for (const [i, file] of inOrderOfReading(files).entries()) {
    if (parts.has(file)) continue
    const missing: string[] = []
    // What a file names is beside it: the last that was found is the one that is being read.
    const chain: MeshFile[] = []
    const find = (name: string): MeshFile | null => {
      const others = files.filter(other => other !== file)
      const found = fileNamed(others, name, [...chain, file])
      if (found) {
        parts.add(found)
        chain.unshift(found)
      } else missing.push(name)
      return found
    }
    const onProgress = (part: number) => options.onProgress((i + part) / files.length)
    try {
      results.set(file, readMeshes(file, { ...options, find, onProgress }))
    } catch (error) {
      if (!(error instanceof MeshRefusal)) throw error
      results.set(file, missing.length > 0 ? new MissingFiles(error.message, missing) : error)
    }
  }
  return files.flatMap(file => {
    const result = parts.has(file) ? [] : (results.get(file) ?? [])
    if (result instanceof MeshRefusal) throw result
    return result
  })
}

/** True for files that always name others, by their names. */
export function namesOthers({ name }: MeshFile): boolean {
  return /\.(?:pvtu|pvd|xdmf|xmf)$/i.test(name)
}

/** Files that always name others first, so that these are not read twice. */
function inOrderOfReading(files: readonly MeshFile[]): MeshFile[] {
  return [...files.filter(namesOthers), ...files.filter(file => !namesOthers(file))]
}

/**
 * The meshes in a file, gzipped or not: one, or several where a text holds several files. Throws a MeshRefusal, whose message is one sentence with the
 * file, the place and what was expected.
 */
export function readMeshes(file: MeshFile, options: Partial<ReadOptions> & { format?: string } = {}): readonly Mesh[] {
  const all: ReadOptions = {
    find(name) {
      const found = options.find?.(name) ?? null
      return found && named(found)
    },
    step: options.step ?? 0,
    onProgress: options.onProgress ?? (() => {}),
    throwIfCancelled: options.throwIfCancelled ?? (() => {}),
    core: options.core ?? null,
    hdf5: options.hdf5 ?? null,
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
    const plainHead = headOf(plain)
    const format = wanted === null ? formatOf(plainHead, name) : namedFor(plainHead, wanted)
    const read = format.read(plain, all)
    const note = missingEnd(plain)
    const meshes = note === null ? read : read.map(mesh => ({ ...mesh, notes: [...mesh.notes, note] }))
    if (plain === here) return meshes
    const areBytesKept = !isPacked && utf16Of(head) === null
    return meshes.map(mesh => (areBytesKept ? withTruePlaces(mesh) : { ...mesh, coordinatePlaces: null }))
  } catch (error) {
    // The engine's own error where an array is too large for it.
    if (!(error instanceof RangeError)) throw error
    throw new MeshRefusal(`${here.name}: reading it needs more memory than there is here (${error.message}).`)
  }
}

/** Long lists of numbers that lie in the file; none where that is not known, or where the file will be refused. */
export function listsIn(file: MeshFile): readonly FileList[] {
  const head = headOf(file)
  const format = formats.find(({ recognizes }) => recognizes(head, '') === 'yes')
  try {
    return format?.listsIn?.(readLittle(file)) ?? []
  } catch (error) {
    if (error instanceof MeshRefusal) return []
    throw error
  }
}

/** Bytes that are read for hints; what takes more is read as it comes. */
const LITTLE = 16 * 1024 * 1024

function readLittle(file: MeshFile): MeshFile {
  let left = LITTLE
  return {
    ...file,
    read(from, to, into) {
      left -= to - from
      if (left < 0) throw new MeshRefusal(`${file.name}: where its lists lie is known too late.`)
      return file.read(from, to, into)
    },
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
  return {
    name: shownFileName(file.name),
    size: file.size,
    read: (from, to, into) => file.read(from, to, into),
    lowHalves: (from, count) => file.lowHalves?.(from, count) ?? null,
    unpacked: from => file.unpacked?.(from) ?? null,
  }
}

function headOf(file: MeshFile): Uint8Array {
  return file.read(0, Math.min(HEAD, file.size))
}

/** Not among the names that people may give: no formats of meshes. */
const UNNAMED: readonly MeshFormat[] = [picture, link, refused]

function formatNamed(wanted: string): MeshFormat {
  const read = formats.filter(format => !UNNAMED.includes(format))
  const found = read.find(({ name }) => name.toLowerCase() === wanted.toLowerCase())
  if (found) return found
  throw new MeshRefusal(`There is no format ${shown(wanted)}: ${read.map(({ name }) => name).join(', ')}.`)
}

function formatOf(head: Uint8Array, fileName: string): MeshFormat {
  let possible: MeshFormat | null = null
  for (const format of formats) {
    const answer = format.recognizes(head, fileName.toLowerCase())
    if (answer === 'yes') return format
    if (answer === 'maybe') possible ??= format
  }
  if (possible) return possible
  throw new MeshRefusal(`${shown(fileName).slice(1, -1)}: this is in no format that is known here.`)
}
