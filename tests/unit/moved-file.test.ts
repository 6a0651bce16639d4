/** Moved points in the file that a mesh was read from: it reads back as the moved mesh, and all its other bytes are as they were. */
import { readdirSync, readFileSync } from 'node:fs'
import { basename } from 'node:path'
import { describe, expect, it, test } from 'vitest'
import { Hdf5Needed } from '../../web/mesh/hdf5-reader'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { fittingOf } from '../../web/outputs/columns'
import { asStored, movedFile, whyNotInPlace } from '../../web/outputs/moved-file'
import { randomSource } from './core-fixtures'
import { exodusOf, TEXTS, ugridOfBytes } from './other-formats'

const shared = new URL('../../../shared/meshes/', import.meta.url)
const inFolder = (folder: string) =>
  readdirSync(new URL(folder, shared), { withFileTypes: true })
    .filter(entry => entry.isFile() && !/\.(json|diff|m|h5|pvtu)$/.test(entry.name))
    .map(({ name }) => new URL(`${folder}${name}`, shared))

const files: readonly MeshFile[] = [
  ...[...inFolder('made/'), ...inFolder('real/')].map(url =>
    fileOfBytes(basename(url.pathname), new Uint8Array(readFileSync(url))),
  ),
  ...Object.entries(TEXTS).map(([name, text]) => fileOfBytes(name, new TextEncoder().encode(text))),
  ...([1, 2, 5] as const).map(version => fileOfBytes(`netcdf-${version}.e`, exodusOf(version))),
  fileOfBytes('a.b8.ugrid', ugridOfBytes(false, false, 8, 4)),
  fileOfBytes('a.lr8.ugrid', ugridOfBytes(true, true, 8, 4)),
]

/** Null for a file of several meshes, or one that another reader has. */
function meshIn(file: MeshFile): Mesh | null {
  try {
    const [mesh, ...others] = readMeshes(file)
    return mesh && others.length === 0 ? mesh : null
  } catch (error) {
    if (error instanceof MeshRefusal || error instanceof Hdf5Needed) return null
    throw error
  }
}

const known = files.flatMap(file => {
  const mesh = meshIn(file)
  return mesh && mesh.points.length > 0 ? [{ file, mesh }] : []
})
const inPlace = known.filter(({ mesh }) => whyNotInPlace(mesh) === null)

function written(file: MeshFile, mesh: Mesh, moved: Float64Array): Uint8Array {
  return new Uint8Array(Buffer.concat([...movedFile(file, mesh, moved)]))
}

/** Null where columns are too narrow, which is refused, never cut. */
function writtenIfFits(file: MeshFile, mesh: Mesh, moved: Float64Array): Uint8Array | null {
  try {
    return written(file, mesh, moved)
  } catch (error) {
    expect(['Nastran', 'Ansys', 'LS-DYNA', 'UNV', 'Radioss']).toContain(mesh.format)
    expect((error as Error).message).toMatch(
      /has fields of fixed columns, and \S+ is longer than \S+, which stands there\.$/,
    )
    return null
  }
}

const bytesOf = (file: MeshFile) => file.read(0, file.size)

test('the formats whose files keep their other bytes', () => {
  expect([...new Set(inPlace.map(({ mesh }) => mesh.format))].sort()).toEqual(
    expect.arrayContaining(['VTU', 'VTK', 'Abaqus', 'Gmsh', 'Exodus II', 'Medit', 'Nastran', 'UGRID']),
  )
  const names = inPlace.map(({ file }) => file.name)
  expect(names).toEqual(
    expect.arrayContaining([
      ...['vtk-raw-none.vtu', 'vtk-raw-none-f32.vtu', 'vtk-raw-none-big.vtu', 'vtk-ascii.vtu'],
      ...['vtk-legacy51-bin.vtk', 'vtk-legacy42-ascii.vtk', 'gmsh.inp', 'classic.e'],
      ...['gmsh-1-ascii.msh', 'gmsh-4.1-ascii.msh', 'gmsh-2.2-bin.msh', 'gmsh-4.1-bin.msh'],
    ]),
  )
})

describe.each(inPlace.map(({ file, mesh }) => [file.name, file, mesh] as const))('%s', (_, file, mesh) => {
  const next = randomSource(23)
  const { points } = mesh
  const some = [0, points.length - 1, ...Array.from({ length: 4 }, () => Math.floor(next() * points.length))]

  it('reads back as the moved mesh', () => {
    const moved = points.slice()
    for (const i of some) moved[i] = (points[i] as number) + next() / 7
    // The whole of a point, and what prints as a whole number.
    moved.set([2, -3, 0.5], 3)
    const bytes = writtenIfFits(file, mesh, moved)
    if (bytes === null) return
    const again = readMeshes(fileOfBytes(file.name, bytes))[0] as Mesh
    expect(again.points).toEqual(asStored(mesh, moved))
    expect([again.cells, again.ids, again.blocks.length]).toEqual([mesh.cells, mesh.ids, mesh.blocks.length])
  })

  it('one coordinate is one place in the file', () => {
    const before = bytesOf(file)
    for (const i of some.slice(0, 3)) {
      const moved = points.slice()
      moved[i] = 0.25
      const after = writtenIfFits(file, mesh, moved)
      if (after === null) continue
      const [from, end] = commonParts(before, after)
      // What is between is a number of the file: no longer than one is.
      expect(before.length - end - from).toBeLessThan(33)
      expect(after.length - end - from).toBeLessThan(33)
    }
    expect(written(file, mesh, points.slice())).toEqual(before)
  })
})

const inColumns = inPlace.filter(({ mesh }) => fittingOf(mesh.format, () => {}) !== null)

test('formats with fields of fixed columns', () => {
  expect([...new Set(inColumns.map(({ mesh }) => mesh.format))].sort()).toEqual([
    'Ansys',
    'LS-DYNA',
    'Nastran',
    'Radioss',
    'UNV',
  ])
})

test.each(inColumns.map(({ file, mesh }) => [file.name, file, mesh] as const))(
  '%s: numbers are rounded into their fields, and nothing else changes',
  (_, file, mesh) => {
    const next = randomSource(29)
    const values = [
      () => (mesh.points[Math.floor(next() * mesh.points.length)] as number) + next() / 7,
      () => (next() - 0.5) * 10 ** Math.floor(20 * next() - 10),
      () => Math.round(next()),
    ]
    const moved = mesh.points.map((own, i) => (i % 7 < 3 ? (values[i % 3] as () => number)() : own))
    let most = 0
    const fitting = fittingOf(mesh.format, off => {
      most = Math.max(most, off)
    })
    const bytes = new Uint8Array(Buffer.concat([...movedFile(file, mesh, moved, fitting)]))
    const again = readMeshes(fileOfBytes(file.name, bytes))[0] as Mesh
    expect([again.cells, again.ids, again.other]).toEqual([mesh.cells, mesh.ids, mesh.other])
    const off = again.points.map((x, i) => Math.abs(x - (moved[i] as number)))
    expect(Math.max(...off)).toBe(most)
    for (const [i, own] of off.entries()) {
      if (Object.is(moved[i], mesh.points[i])) expect(own).toBe(0)
      // Eight characters have a sign, a point, a sign and two digits of an exponent, and three digits.
      expect(own).toBeLessThanOrEqual(0.005 * Math.abs(moved[i] as number))
    }
  },
)

/** Lengths of the common beginning, and of the common end beside it. */
function commonParts(a: Uint8Array, b: Uint8Array): [number, number] {
  const most = Math.min(a.length, b.length)
  let from = 0
  while (from < most && a[from] === b[from]) from++
  let end = 0
  while (end < most - from && a[a.length - 1 - end] === b[b.length - 1 - end]) end++
  return [from, end]
}

test('packed coordinates, and a file that has changed, are refused', () => {
  const packed = known.find(({ file }) => file.name === 'vtk-raw-zlib.vtu')
  expect(packed && whyNotInPlace(packed.mesh)).toMatch(/^In this file \(VTU\) the coordinates are packed/)
  const { file, mesh } = inPlace.find(({ file: { name } }) => name === 'gmsh.inp') as (typeof inPlace)[number]
  const moved = mesh.points.slice()
  moved[0] = 7
  const other = fileOfBytes(file.name, bytesOf(file).fill(49))
  expect(() => [...movedFile(other, mesh, moved)]).toThrow('The file is another one than when it was read')
})

test('single precision: no infinities', () => {
  const { file, mesh } = inPlace.find(
    ({ file: { name } }) => name === 'vtk-raw-none-f32.vtu',
  ) as (typeof inPlace)[number]
  const moved = mesh.points.slice()
  moved[0] = 1e300
  expect(() => [...movedFile(file, mesh, moved)]).toThrow('single precision, in which there is no 1e+300')
})
