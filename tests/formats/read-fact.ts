/** Reads the files of a fact. */
import { readFileSync } from 'node:fs'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import { joined } from '../../web/mesh/join-meshes'
import type { Mesh } from '../../web/mesh/mesh'
import { readMeshes, readTogether } from '../../web/mesh/read-mesh'
import { fileNamed, fileOfBytes, type MeshFile } from '../../web/mesh/source'
import type { Content, Given } from './fact'
import { readMade } from './made-mesh'

const hdf5 = await hdf5Files()

const MADE = 'meshes/made/'

function fileAt(path: string): MeshFile {
  const base = path.startsWith('hdf5/') ? '../unit/' : '../../../shared/'
  return fileOf(
    path.slice(path.lastIndexOf('/') + 1),
    new Uint8Array(readFileSync(new URL(base + path, import.meta.url))),
  )
}

function fileOf(name: string, content: Content): MeshFile {
  return fileOfBytes(name, typeof content === 'string' ? new TextEncoder().encode(content) : content)
}

/** Throws a MeshRefusal. */
export function readGiven(given: Given, step: number | 'last'): Mesh {
  if (typeof given === 'string') {
    const read = given.startsWith(MADE) ? readMade(given.slice(MADE.length)) : readMeshes(fileAt(given), { hdf5, step })
    return Array.isArray(read) ? oneOf(read) : (read as Mesh)
  }
  const files = Object.entries(given).map(([name, content]) => fileOf(name, content))
  const [first, ...others] = files as [MeshFile, ...MeshFile[]]
  if (step === 0) return oneOf(readTogether(files, { hdf5, onProgress: () => {}, throwIfCancelled: () => {} }))
  return oneOf(readMeshes(first, { hdf5, step, find: name => fileNamed(others, name, [first]) }))
}

function oneOf([first, ...others]: readonly Mesh[]): Mesh {
  if (!first) throw new Error('There is no mesh.')
  return joined([first, ...others])
}
