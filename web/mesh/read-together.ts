/** Files that were given together: those that others name, such as pieces of a .pvtu or what *INCLUDE names, are read as parts of these. */
import { type Mesh, MeshRefusal } from './mesh'
import { readMeshes } from './read-mesh'
import type { MeshFile, ReadOptions } from './source'

/** A refusal because of files that are named and not there. */
export class MissingFiles extends MeshRefusal {
  /** Names as the files write them. */
  readonly names: readonly string[]

  constructor(message: string, names: readonly string[]) {
    super(message)
    this.names = names
  }
}

export type TogetherOptions = Omit<ReadOptions, 'find' | 'step' | 'core'> & Partial<Pick<ReadOptions, 'core'>>

/** All meshes of the files. Throws a MeshRefusal for the first file that is refused and that no other names. */
export function readTogether(files: readonly MeshFile[], options: TogetherOptions): readonly Mesh[] {
  const named = new Set<MeshFile>()
  const results = new Map<MeshFile, readonly Mesh[] | MeshRefusal>()
  for (const [i, file] of inOrderOfReading(files).entries()) {
    if (named.has(file)) continue
    const missing: string[] = []
    const find = (name: string): MeshFile | null => {
      const found = files.find(other => other !== file && isNamed(other, name)) ?? null
      if (found) named.add(found)
      else missing.push(name)
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
    const result = named.has(file) ? [] : (results.get(file) ?? [])
    if (result instanceof MeshRefusal) throw result
    return result
  })
}

/** True if a file is the one that another names, with or without its folder. */
export function isNamed({ name }: { readonly name: string }, wanted: string): boolean {
  return name.toLowerCase() === lastOf(wanted)
}

function lastOf(path: string): string {
  return (path.split(/[\\/]/).at(-1) ?? '').toLowerCase()
}

/** Files that always name others first, so that these are not read twice. */
function inOrderOfReading(files: readonly MeshFile[]): MeshFile[] {
  const namesOthers = ({ name }: MeshFile) => /\.(pvtu|pvd)$/i.test(name)
  return [...files.filter(namesOthers), ...files.filter(file => !namesOthers(file))]
}
