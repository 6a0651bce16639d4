/** Reads one mutation and says what is wrong with what comes out. */

import { readFileSync } from 'node:fs'
import { gunzipSync } from 'node:zlib'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import { MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type Hdf5Reader, type MeshFile } from '../../web/mesh/source'
import { allocations } from './allocations'
import { corpus, fileBeside } from './corpus'
import { type Mutation, mutationOf } from './mutations'
import { faultOfMesh, faultOfSentence } from './well-formed'

export interface Reading {
  readonly number: number
  readonly mutation: Mutation
  readonly outcome: 'mesh' | 'sentence'
  /** The fault in a sentence, null if there is none. */
  readonly fault: string | null
  readonly milliseconds: number
  /** How many times its size, or 4 kB for a small one, was read of the file. */
  readonly timesRead: number
}

const MOST_MILLISECONDS = 2000
/** Recognizing, quotation, headers and body, and sections that are gone back to. */
const MOST_TIMES_READ = 16
/** A slow reading is tried again: memory may have been cleaned up in that time. */
const TRIES = 3
const MEGABYTE = 1024 * 1024

let hdf5: Hdf5Reader | null = null

/** Loads the reader of HDF5 files, another one if a file has crashed it. */
export async function loadHdf5(): Promise<void> {
  if (!hdf5?.isWhole) hdf5 = await hdf5Files()
}

export function reading(seed: number, number: number): Reading {
  const mutation = mutationOf(seed, number)
  let result = once(mutation)
  for (let left = TRIES - 1; left > 0 && result.milliseconds > MOST_MILLISECONDS; --left) {
    const again = once(mutation)
    if (again.milliseconds < result.milliseconds) result = again
  }
  if (result.timesRead > MOST_TIMES_READ) result = { ...result, fault: `it is read ${result.timesRead} times over` }
  if (result.fault !== null || result.milliseconds <= MOST_MILLISECONDS) return result
  return { ...result, fault: `it takes ${Math.round(result.milliseconds)} ms` }
}

function once(mutation: Mutation): Reading {
  return { number: mutation.number, mutation, ...ended(mutation.name, mutation.bytes, mutation) }
}

export type Ended = Pick<Reading, 'outcome' | 'fault' | 'milliseconds' | 'timesRead'>

/** How reading these bytes ends, which are those of a file at `path`. */
export function ended(
  name: string,
  bytes: Uint8Array,
  { path, step }: Pick<Mutation, 'path' | 'step'> = { path: name, step: 0 },
): Ended {
  let read = 0
  const file: MeshFile = {
    name,
    size: bytes.length,
    read(from, to) {
      if (!(from >= 0 && from <= to && to <= bytes.length)) throw new Error(`read(${from}, ${to}) of ${bytes.length}`)
      read += to - from
      return bytes.slice(from, to)
    },
  }
  const head = corpus.find(other => other.path === path)?.readBy ?? null
  const first = corpus.find(other => other.path === head)
  let beside = 0
  const find = (wanted: string): MeshFile | null => {
    const found = fileBeside(path, wanted)
    if (found === null) return null
    if (found.path === path && head !== null) return file
    beside += found.bytes.length
    return { name: found.name, size: found.bytes.length, read: (from, to) => found.bytes.slice(from, to) }
  }
  allocations.largest = 0
  allocations.sum = 0
  const start = millisecondsOfThread()
  let outcome: Reading['outcome'] = 'mesh'
  let fault: string | null = null
  let made = 0
  let milliseconds = 0
  try {
    const meshes = readMeshes(first ? fileOfBytes(first.name, first.bytes) : file, { find, hdf5, step })
    milliseconds = millisecondsOfThread() - start
    if (meshes.length === 0) fault = 'no mesh and no sentence'
    for (const mesh of meshes) {
      made += mesh.points.byteLength + mesh.cells.byteLength + mesh.notTrilinear.corners.byteLength
      fault ??= faultOfMesh(mesh, first?.bytes ?? bytes)
    }
  } catch (error) {
    milliseconds = millisecondsOfThread() - start
    outcome = 'sentence'
    if (!(error instanceof MeshRefusal)) fault = (error as Error).stack ?? String(error)
    else {
      const problem = faultOfSentence(error.message)
      if (problem !== null) fault = `“${error.message}”: ${problem}`
      else if (!namesFile(error.message, name)) fault = `“${error.message}”: the file is not named`
    }
  }
  const size = Math.max(bytes.length + beside, unpackedSize(bytes))
  // A packed file may have as much again as it states.
  const allowed = 64 * MEGABYTE + (bytes[0] === 0x1f ? 32 : 8) * size + made
  if (allocations.largest > allowed)
    fault ??= `it allocates ${allocations.largest} bytes at once, ${allowed} are allowed`
  if (allocations.sum > 4 * allowed) fault ??= `it allocates ${allocations.sum} bytes, ${4 * allowed} are allowed`
  return { outcome, fault, milliseconds, timesRead: read / Math.max(bytes.length, 4096) }
}

/** On the processor, where Linux says it: a busy machine slows no file down. Elsewhere by the clock. */
function millisecondsOfThread(): number {
  try {
    return Number(readFileSync('/proc/thread-self/schedstat', 'utf8').split(' ')[0]) / 1e6
  } catch {
    return performance.now()
  }
}

function namesFile(message: string, name: string): boolean {
  const plain = name.replace(/[\p{Cc}\p{Cf}\u2028\u2029]/gu, '').replace(/\.gz$/i, '')
  return message.includes(plain.slice(0, 30)) || corpus.some(other => message.startsWith(other.name))
}

function unpackedSize(bytes: Uint8Array): number {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return 0
  try {
    return gunzipSync(bytes, { maxOutputLength: 256 * MEGABYTE }).length
  } catch {
    return 0
  }
}
