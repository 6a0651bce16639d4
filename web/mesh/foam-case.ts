/** An OpenFOAM case that was given as a folder: its mesh among all its other files. */
import { MESH_FILES } from './formats/openfoam'
import { shown } from './shown'
import { type MeshFile, pathOf } from './source'

export interface FoamCase {
  /** Files of its mesh, or of several in regions, and all that lies in no case. */
  readonly files: readonly MeshFile[]
  /** What is not read, for people; null where that is nothing. */
  readonly note: string | null
}

const MESH_NAMES: ReadonlySet<string> = new Set(MESH_FILES.flatMap(name => [name, `${name}.gz`]))
/** Where a case has its mesh, its regions, its parts where it was decomposed, and meshes of later times. */
const PLACE =
  /^(?:(?<root>.*?)\/)??(?<part>processors?\d[^/]*\/)?(?:constant|(?<time>\d+(?:\.\d+)?(?:e-?\d+)?))(?:\/[^/]+)?\/polyMesh$/i
/** Names of files in a note. */
const MOST_NAMED = 3

/** Null where no folder of a mesh is among the files. */
export function foamCaseOf(files: readonly MeshFile[]): FoamCase | null {
  const folders = files.map(file => folderOf(pathOf(file)))
  const meshes = new Set(
    folders.filter((folder, i) => isPolyMesh(folder) && /^faces(?:\.gz)?$/.test(files[i]?.name ?? '')),
  )
  if (meshes.size === 0) return null
  const roots = new Set([...meshes].map(rootOf))
  const rootOfFile = (file: MeshFile) => [...roots].find(root => pathOf(file).startsWith(`${root}/`))
  const originals = new Set([...meshes].filter(folder => !isCopy(folder)).map(rootOf))
  const isRead = (folder: string) => meshes.has(folder) && !(isCopy(folder) && originals.has(rootOf(folder)))
  const areRead = files.map(
    (file, i) => rootOfFile(file) === undefined || (isRead(folders[i] as string) && MESH_NAMES.has(file.name)),
  )
  const others = files.flatMap((file, i) =>
    areRead[i] ? [] : [pathOf(file).slice((rootOfFile(file)?.length ?? -1) + 1)],
  )
  return { files: files.filter((_, i) => areRead[i]), note: others.length === 0 ? null : noteOf(others) }
}

function noteOf(paths: readonly string[]): string {
  const named = paths.slice(0, MOST_NAMED).map(shown)
  const more = paths.length - named.length
  if (more > 0) named.push(`${more} more`)
  const last = named.pop()
  const list = named.length === 0 ? last : `${named.join(', ')} and ${last}`
  return `Of the OpenFOAM case the mesh is read; ${paths.length === 1 ? 'one file is' : `${paths.length} files are`} no part of it: ${list}.`
}

function folderOf(path: string): string {
  return path.slice(0, Math.max(0, path.lastIndexOf('/')))
}

function isPolyMesh(folder: string): boolean {
  return /(?:^|\/)polyMesh$/.test(folder)
}

/** The folder of the case that a polyMesh is in; the outermost that was given, where that is inside of the case. */
function rootOf(polyMesh: string): string {
  const parts = polyMesh.split('/')
  const { root = parts.slice(0, -1).join('/') } = PLACE.exec(polyMesh)?.groups ?? {}
  return root === '' ? (parts[0] as string) : root
}

/** True for parts of a mesh, and for what became of it. */
function isCopy(polyMesh: string): boolean {
  const { part, time } = PLACE.exec(polyMesh)?.groups ?? {}
  return part !== undefined || time !== undefined
}
