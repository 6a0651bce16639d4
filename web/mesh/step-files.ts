/** Files that hold one mesh at several times, one of them all or each its own; told from those that hold its parts. */
import { orderOfNumbers } from './file-numbers'
import { collectionSteps, pieceNames } from './formats/vtu-sources'
import { joined } from './join-meshes'
import { type Mesh, MeshRefusal } from './mesh'
import { MissingFiles, namesOthers, readMeshes, readTogether, type TogetherOptions } from './read-mesh'
import { shown, shownFileName } from './shown'
import { fileNamed, type MeshFile, pathOf, type ReadOptions } from './source'
import { shownTime } from './step-answers'

export interface StepFiles {
  /** What was decided, for people: "7 files are taken as 7 steps of one mesh, in the order of their numbers." */
  readonly sentences: readonly string[]
  /** True if each step has files of its own, which could be parts of one mesh as well. */
  readonly areFiles: boolean
  readonly steps: readonly StepFile[]
  /** The first step, where it had to be read to decide. */
  readonly first: Mesh | null
}

export interface StepFile {
  /** The name of its file, safe to show. */
  readonly name: string
  /** As the file that lists the steps has it; null where it is in the step's own file, if anywhere. */
  readonly time: string | null
  /** Throws a MeshRefusal. */
  read(options: TogetherOptions): Mesh
}

/**
 * A .pvd says what the steps are. Without one, files are steps if their names differ only in a number and the first and the last
 * have the same cells: the others are compared when they are read. Null where the files are parts of one mesh, or refused.
 */
export function stepFilesOf(files: readonly MeshFile[], options: TogetherOptions): StepFiles | null {
  const collections = files.filter(isCollection)
  const [collection, ...others] = collections
  if (collection) return others.length > 0 ? null : ofCollection(collection, files, options)
  return ofNumbers(files, options)
}

/** The steps that the files have together of which `mesh` is the first, as read from them; null where it is the only one. */
export function stepsWithin(mesh: Mesh, files: readonly MeshFile[]): StepFiles | null {
  const { length } = mesh.steps
  if (length < 2 || mesh.isSteady) return null
  const name = shownFileName((files.find(namesOthers) ?? files[0])?.name ?? '')
  return {
    sentences: [`${name} has ${length} time steps of one mesh.`],
    areFiles: false,
    steps: mesh.steps.map((time, step) => ({
      name,
      time: shownTime(time),
      read: options => joinedMesh(readTogether(files, { ...options, step }), name),
    })),
    first: mesh,
  }
}

export function isCollection({ name }: { readonly name: string }): boolean {
  return /\.pvd$/i.test(name)
}

function ofCollection(file: MeshFile, files: readonly MeshFile[], options: TogetherOptions): StepFiles | null {
  const steps = collectionSteps(file, scanning(options))
  if (steps === null || steps.length < 2) return null
  const name = shownFileName(file.name)
  refuseNamesakes(
    file,
    steps.flatMap(step => step.files),
    files,
  )
  const { missing, named } = lookedUp(file, steps, files, options)
  const isWhole = missing.map(names => names.length === 0)
  if (!isWhole.includes(true)) return null
  const left = files.filter(other => other !== file && !named.has(other))
  return {
    sentences: [
      `${name} has ${steps.length} time steps of one mesh.`,
      ...missingSentence(missing),
      ...leftSentence(left, name),
    ],
    areFiles: true,
    steps: steps.map(({ time }, step) => ({
      name,
      time: shownTime(time),
      read: own => meshOf(file, files, { ...own, step }).mesh,
    })),
    first: null,
  }
}

/** Two names of a list may not be of one file here: it would stand for both. */
function refuseNamesakes(list: MeshFile, names: readonly string[], files: readonly MeshFile[]): void {
  const known = new Map<MeshFile, string>()
  for (const name of names) {
    const path = name
      .split(/[\\/]/)
      .filter(part => part !== '.')
      .join('/')
    const found = fileNamed(files, name, [list])
    if (found === null) continue
    const other = known.get(found) ?? path
    if (other !== path)
      throw new MeshRefusal(
        `${shownFileName(list.name)}: it names ${shown(other)} and ${shown(path)}, and ${shown(pathOf(found))} here could be either: drop the folder that holds both, or give them different names.`,
      )
    known.set(found, path)
  }
}

/** For each step: which names are of no file here, those of a .pvtu's pieces among them; and all files that are named. */
function lookedUp(
  list: MeshFile,
  steps: readonly { readonly files: readonly string[] }[],
  files: readonly MeshFile[],
  options: TogetherOptions,
): { readonly missing: readonly (readonly string[])[]; readonly named: ReadonlySet<MeshFile> } {
  const named = new Set<MeshFile>()
  const missingOf = (from: MeshFile, names: readonly string[], isPieces: boolean): readonly string[] =>
    names.flatMap(name => {
      const found = fileNamed(files, name, [from])
      if (!found) return [name]
      named.add(found)
      return isPieces ? [] : missingOf(found, pieceNames(found, scanning(options)), true)
    })
  return { missing: steps.map(step => missingOf(list, step.files, false)), named }
}

function missingSentence(missing: readonly (readonly string[])[]): string[] {
  const lacking = missing.filter(names => names.length > 0)
  const [first] = lacking.flat()
  if (first === undefined) return []
  return [`${lacking.length} of them ${lacking.length === 1 ? 'lacks' : 'lack'} files, first ${shown(first)}.`]
}

function leftSentence(left: readonly MeshFile[], name: string): string[] {
  const [first] = left
  if (!first) return []
  const names = `first ${shown(first.name)}`
  return [
    left.length === 1
      ? `${shown(first.name)} is not named in ${name} and was left out.`
      : `${left.length} files are not named in ${name} and were left out, ${names}.`,
  ]
}

function ofNumbers(files: readonly MeshFile[], options: TogetherOptions): StepFiles | null {
  if (files.length < 2) return null
  const pieces = new Set(
    files.flatMap(file => pieceNames(file, scanning(options)).map(piece => fileNamed(files, piece, [file]))),
  )
  const heads = files.filter(file => !pieces.has(file))
  const order = orderOfNumbers(heads.map(pathOf))
  if (order === null) return null
  const ordered = order.map(index => heads[index] as MeshFile)
  const ends = [0, ordered.length - 1].map((step, i) => {
    const onProgress = (part: number) => options.onProgress((i + part) / 2)
    return meshOf(ordered[step] as MeshFile, files, { ...options, onProgress, step: 0 })
  })
  const [first, last] = ends as [StepMesh, StepMesh]
  const areApart = ends.every(({ found }) => !ordered.some(file => found.has(file)))
  if (!areApart || first.mesh.cells.length === 0 || !haveSameCells(first.mesh, last.mesh)) return null
  const areNamesakes = new Set(ordered.map(({ name }) => name)).size < ordered.length
  const others = files.length === ordered.length ? '' : ` with ${files.length - ordered.length} pieces`
  return {
    sentences: [
      `${ordered.length} files${others} are taken as ${ordered.length} steps of one mesh, in the order of their numbers.`,
    ],
    areFiles: true,
    steps: ordered.map(file => ({
      name: shownFileName(areNamesakes ? pathOf(file) : file.name),
      time: null,
      read: own => meshOf(file, files, { ...own, step: 0 }).mesh,
    })),
    first: first.mesh,
  }
}

/** A mesh without the places of its points. */
export type Topology = Pick<Mesh, 'cells' | 'notTrilinear' | 'other'> & { readonly points: { readonly length: number } }

/** True if two meshes differ in nothing but in where their points are, and in names. */
export function haveSameCells(a: Topology, b: Topology): boolean {
  return (
    a.points.length === b.points.length &&
    areEqual(a.cells, b.cells) &&
    areEqual(a.notTrilinear.corners, b.notTrilinear.corners) &&
    a.other.size === b.other.size &&
    [...a.other].every(([type, count]) => b.other.get(type) === count)
  )
}

export function areEqual(a: Uint32Array, b: Uint32Array): boolean {
  if (a === b) return true
  if (a.length !== b.length) return false
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false
  return true
}

interface StepMesh {
  readonly mesh: Mesh
  /** Files that the file named. */
  readonly found: ReadonlySet<MeshFile>
}

function meshOf(
  file: MeshFile,
  files: readonly MeshFile[],
  options: TogetherOptions & { readonly step: number },
): StepMesh {
  const found = new Set<MeshFile>()
  const missing: string[] = []
  const find = (name: string): MeshFile | null => {
    // What a file names is beside it: the last that was found is the one that is being read.
    const others = files.filter(candidate => candidate !== file)
    const other = fileNamed(others, name, [...[...found].reverse(), file])
    if (other) found.add(other)
    else missing.push(name)
    return other
  }
  try {
    return { mesh: joinedMesh(readMeshes(file, { ...options, find }), shownFileName(file.name)), found }
  } catch (error) {
    if (missing.length > 0 && error instanceof MeshRefusal) throw new MissingFiles(error.message, missing)
    throw error
  }
}

function joinedMesh([first, ...others]: readonly Mesh[], name: string): Mesh {
  if (!first) throw new MeshRefusal(`${name}: there is no mesh in it.`)
  return joined([first, ...others])
}

function scanning(options: TogetherOptions): ReadOptions {
  return { ...options, core: options.core ?? null, hdf5: options.hdf5 ?? null, find: () => null, step: 0 }
}
