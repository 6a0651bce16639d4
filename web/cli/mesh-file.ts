/** Files of Node as the readers of web/mesh see them: read by slices, on demand. */
import { closeSync, existsSync, fstatSync, openSync, readFileSync, readSync, realpathSync, statSync } from 'node:fs'
import { basename, dirname, join, resolve } from 'node:path'
import { type FindFile, fileOfBytes, type MeshFile } from '../mesh/source'
import { shown } from '../mesh/text-cursor'
import { Refusal } from '../model/result'
import { reasonOf, type Streams } from './streams'

/** Files that are open while a mesh is read. */
export interface OpenFile {
  readonly file: MeshFile
  /** Finds files beside it. */
  readonly find: FindFile
  close(): void
}

/** Throws a Refusal. */
export async function openMeshFile(path: string, input: Streams['input']): Promise<OpenFile> {
  if (path === '-') {
    const file = fileOfBytes('standard input', await bytesOf(input))
    return { file, find: filesBeside('.'), close: () => {} }
  }
  const own = fileInFolder(path)
  const { file, descriptor } = openPath(own)
  return {
    file,
    find: filesBeside(dirname(own)),
    close() {
      if (descriptor !== null) closeSync(descriptor)
    },
  }
}

/** Where links lead to; the path itself if nothing is there. */
export function realPath(path: string): string {
  try {
    return realpathSync(path)
  } catch {
    return path
  }
}

/** Files of meshes that are folders: OpenFOAM's case or polyMesh, Elmer's. */
const IN_FOLDERS = ['constant/polyMesh/faces', 'polyMesh/faces', 'faces', 'mesh.header'].flatMap(name => [
  name,
  `${name}.gz`,
])

/** The file that stands for a folder; the path itself where it is none. */
function fileInFolder(path: string): string {
  if (!statSync(path, { throwIfNoEntry: false })?.isDirectory()) return path
  return IN_FOLDERS.map(name => join(path, name)).find(existsSync) ?? path
}

interface OpenPath {
  readonly file: MeshFile
  /** Null if nothing has to stay open. */
  readonly descriptor: number | null
}

/** Finds files by their names, with either slash. */
function filesBeside(folder: string): FindFile {
  return name => {
    const spellings = [name, name.replaceAll('\\', '/')]
    const path = spellings.map(spelling => resolve(folder, spelling)).find(isThere)
    return path === undefined ? null : fileBeside(path)
  }
}

function isThere(path: string): boolean {
  return existsSync(path) && !statSync(path).isDirectory()
}

/** It is open only while it is read: there may be more files beside a mesh than a process can have open. */
function fileBeside(path: string): MeshFile {
  const { file, descriptor } = openPath(path)
  if (descriptor === null) return file
  closeSync(descriptor)
  return {
    ...file,
    read(from, to, into) {
      const again = openedAs(file.name, path)
      try {
        return slice(again, file.name, from, to, into)
      } finally {
        closeSync(again)
      }
    },
  }
}

function openedAs(name: string, path: string): number {
  try {
    return openSync(path, 'r')
  } catch (error) {
    throw new Refusal(`${name} cannot be read: ${reasonOf(error)}.`)
  }
}

function openPath(path: string): OpenPath {
  const name = shown(basename(path)).slice(1, -1)
  const descriptor = openedAs(name, path)
  try {
    const status = fstatSync(descriptor)
    // A pipe cannot be read from anywhere.
    if (!status.isFile()) {
      try {
        return { file: fileOfBytes(name, plain(readFileSync(descriptor))), descriptor: null }
      } finally {
        closeSync(descriptor)
      }
    }
    const read: MeshFile['read'] = (from, to, into) => slice(descriptor, name, from, to, into)
    return { file: { name, size: status.size, read }, descriptor }
  } catch (error) {
    throw error instanceof Refusal ? error : new Refusal(`${name} cannot be read: ${reasonOf(error)}.`)
  }
}

/** Node reads no more at once. */
const MOST_AT_ONCE = 2 ** 30

function slice(descriptor: number, name: string, from: number, to: number, into?: Uint8Array): Uint8Array {
  // New memory is not filled with zeros first.
  const bytes = into?.subarray(0, to - from) ?? plain(Buffer.allocUnsafeSlow(to - from))
  for (let done = 0; done < bytes.length; ) {
    const count = readSync(descriptor, bytes, done, Math.min(bytes.length - done, MOST_AT_ONCE), from + done)
    if (count === 0) throw new Refusal(`${name} has become shorter while it was read.`)
    done += count
  }
  return bytes
}

async function bytesOf(input: Streams['input']): Promise<Uint8Array> {
  const chunks: Buffer[] = []
  for await (const chunk of input) chunks.push(Buffer.from(chunk as Buffer))
  return plain(Buffer.concat(chunks))
}

/** Slices of a Buffer are no copies. */
function plain(buffer: Buffer): Uint8Array {
  return new Uint8Array(buffer.buffer, buffer.byteOffset, buffer.length)
}
