/** The mesh of ../shared/meshes/made, which was written in many formats: what of it is in an answer to one of its files. */
import { readdirSync, readFileSync } from 'node:fs'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import type { Mesh } from '../../web/mesh/mesh'
import { MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes, readTogether } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'

const shared = new URL('../../../shared/meshes/', import.meta.url)
export const made = new URL('made/', shared)

const hdf5 = await hdf5Files()

export interface MadeFile {
  /** The file that is given to a program. */
  readonly path: string
  /** Cells that were written, by type. */
  readonly counts: Readonly<Record<string, number>>
}

const TYPES: Readonly<Record<string, string>> = {
  tetra: 'tetrahedron',
  quad: 'quadrilateral',
  hexahedron20: 'hexahedron of 20 nodes',
  lagrange2: 'Lagrange hexahedron',
  eblock: 'hexahedron',
}
/** What stands for a folder. */
const FOLDERS: Readonly<Record<string, string>> = {
  pvtu: 'pvtu/mesh.pvtu',
  'foam/constant/polyMesh': 'foam/constant/polyMesh/faces',
}

const manifest = JSON.parse(readFileSync(new URL('manifest.json', made), 'utf8')) as {
  files: readonly { readonly file: string; readonly counts: Readonly<Record<string, number>> }[]
}

export const madeFiles: readonly MadeFile[] = manifest.files
  .map(({ file, counts }) => ({
    path: FOLDERS[file] ?? file,
    counts: Object.fromEntries(Object.entries(counts).map(([type, count]) => [TYPES[type] ?? type, count])),
  }))
  .sort((a, b) => (a.path < b.path ? -1 : 1))

/** What a program finds in a file: null if it has no reader for it. */
export type Answer =
  | { readonly refused: string }
  | {
      readonly counts: Readonly<Record<string, number>>
      /** 24 coordinates each. */
      readonly hexahedra: readonly (readonly (number | null)[])[]
    }
  | null

export function sharedFile(path: string): MeshFile {
  return fileOfBytes(path.slice(path.lastIndexOf('/') + 1), new Uint8Array(readFileSync(new URL(path, shared))))
}

/** The file and what lies beside it, as Hexlens reads them. */
export function readMade(path: string): Mesh {
  const folder = path.slice(0, path.lastIndexOf('/') + 1)
  const beside = new Map(
    readdirSync(new URL(folder, made), { withFileTypes: true })
      .filter(entry => entry.isFile())
      .map(({ name }) => [name, `made/${folder}${name}`]),
  )
  const find = (name: string) => {
    const found = beside.get(name)
    return found === undefined ? null : sharedFile(found)
  }
  return readMeshes(sharedFile(`made/${path}`), { find, hdf5 })[0] as Mesh
}

export function readHere(files: readonly MeshFile[]): readonly Mesh[] {
  return readTogether(files, { hdf5, onProgress: () => {}, throwIfCancelled: () => {} })
}

export function answerOf(path: string): Answer {
  try {
    const mesh = readMade(path)
    const hexahedra = cornersOf(mesh, mesh.cells)
    const counts = Object.fromEntries([
      ['hexahedron', hexahedra.length],
      ['hexahedron of more nodes', mesh.notTrilinear.corners.length / 8],
      ...mesh.other,
    ])
    return { counts, hexahedra }
  } catch (error) {
    if (error instanceof MeshRefusal) return { refused: error.message }
    throw error
  }
}

export function cornersOf({ points }: Mesh, cells: Uint32Array): number[][] {
  return Array.from({ length: cells.length / 8 }, (_, cell) =>
    [...cells.subarray(8 * cell, 8 * cell + 8)].flatMap(point => [...points.subarray(3 * point, 3 * point + 3)]),
  )
}

/** How the hexahedra of an answer stand to those of the mesh that was made: each is the first of these that holds. */
const STANDINGS = ['exact', 'rounded', 'reordered', 'moved', 'other'] as const
export type Standing = (typeof STANDINGS)[number]
/** The thinnest of these elements is 2^-10 thick and the others have halves, quarters and eighths: this rounds the digits that text loses. */
const GRAIN = 2 ** 6

const ways: Readonly<Record<Exclude<Standing, 'other'>, (corners: readonly number[]) => string>> = {
  exact: corners => corners.map(x => x + 0).join(),
  moved: corners => fromLeast(corners).join(),
  rounded: corners => corners.map(onGrain).join(),
  reordered: corners =>
    Array.from({ length: 8 }, (_, v) =>
      corners
        .slice(3 * v, 3 * v + 3)
        .map(onGrain)
        .join(),
    )
      .sort()
      .join(),
}

function onGrain(x: number): number {
  return Math.floor(x * GRAIN + 0.5) / GRAIN
}

function fromLeast(corners: readonly number[]): number[] {
  const least = [0, 1, 2].map(axis => Math.min(...corners.filter((_, i) => i % 3 === axis)))
  return corners.map((x, i) => x - (least[i % 3] as number))
}

/** All that is in `vtk-raw-none.vtu`: the fifteen hexahedra and a voxel. */
const original = (() => {
  const mesh = readMade('vtk-raw-none.vtu')
  const all = cornersOf(mesh, mesh.cells)
  const of = (way: (corners: readonly number[]) => string): ReadonlySet<string> => new Set(all.map(way))
  return { exact: of(ways.exact), moved: of(ways.moved), rounded: of(ways.rounded), reordered: of(ways.reordered) }
})()

export function standingsOf(hexahedra: readonly (readonly (number | null)[])[]): Partial<Record<Standing, number>> {
  const standings: Partial<Record<Standing, number>> = {}
  for (const cell of hexahedra) {
    const corners = cell.map(x => x ?? Number.NaN)
    const standing = STANDINGS.find(name => name === 'other' || original[name].has(ways[name](corners))) ?? 'other'
    standings[standing] = (standings[standing] ?? 0) + 1
  }
  return standings
}
