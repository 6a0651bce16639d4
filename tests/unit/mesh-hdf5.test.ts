/** Meshes in HDF5: files of tests/unit/hdf5, which make.py there has written, of ../shared/meshes/made, and damaged ones. */
import { readFileSync } from 'node:fs'
import { expect, test, vi } from 'vitest'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import { Hdf5Loading, Hdf5Needed } from '../../web/mesh/hdf5-reader'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile, type ReadOptions } from '../../web/mesh/source'
import { expectCells, linear, reportOf, sharedFile } from './mesh-expectations'

const hdf5 = await hdf5Files()

const bytesOf = (name: string) => new Uint8Array(readFileSync(new URL(`hdf5/${name}`, import.meta.url)))
const own = (name: string) => fileOfBytes(name, bytesOf(name))

function read(file: MeshFile, options: Partial<ReadOptions> = {}): Mesh {
  return readMeshes(file, { hdf5, ...options })[0] as Mesh
}

/** The least jacdet of each hexahedron, which is its volume where all are boxes. */
function minima(mesh: Mesh): number[] {
  return Array.from({ length: mesh.cells.length / 8 }, (_, cell) => reportOf(mesh, cell).minimum)
}

const blocksOf = ({ blocks }: Mesh) => blocks.map(({ name, cells }) => [name, Array.from(cells)])

test.each([
  ['gmsh.cgns', 'CGNS', 0],
  ['meshio.med', 'MED', 3],
  ['netcdf4.exo', 'Exodus II', 0],
  ['vtk.vtkhdf', 'VTKHDF', 3],
  ['meshio.hmf', 'HMF', 0],
])('%s of ../shared/meshes/made has the hexahedra of its manifest', (name, format, curved) => {
  const mesh = read(sharedFile(`meshes/made/${name}`))
  expect(mesh.format).toBe(format)
  expectCells(mesh, linear)
  expect(mesh.notTrilinear.corners.length / 8).toBe(curved)
})

test('CGNS: zones are blocks, lattices imply their cells, elements have their type in front', () => {
  const mesh = read(own('zones.cgns'))
  expect(blocksOf(mesh)).toEqual([
    ['lattice', [0, 1, 2, 3]],
    ['mixed', [4, 5]],
    ['mixed/some', [4]],
    ['mixed/plain', [5]],
  ])
  expect(minima(mesh)).toEqual([1, 2, 1, 2, 1, 2])
  expect(Object.fromEntries(mesh.other)).toEqual({ tetrahedron: 1 })
  expect(mesh.notTrilinear).toEqual({ corners: expect.objectContaining({ length: 8 }), straight: 1 })
  expect(mesh.notes).toContainEqual(expect.stringMatching(/^Coordinates are stored as Float32/))
})

test('MED: its own order of nodes, groups as blocks, ids', () => {
  const mesh = read(own('groups.med'))
  expect(blocksOf(mesh)).toEqual([['core', [0, 1, 2, 3, 4, 5, 6, 7]]])
  expect(minima(mesh)).toEqual(new Array(8).fill(0.125))
  expect(Array.from(mesh.ids as Float64Array)).toEqual([1, 2, 3, 4, 5, 6, 7, 8])
  expect(mesh.notes).toEqual([])
})

test('a format that is named is the one in the file, or refused', () => {
  const options = { hdf5, format: 'cgns' }
  expect(readMeshes(own('zones.cgns'), options)[0]?.format).toBe('CGNS')
  expect(() => readMeshes(own('groups.med'), options)).toThrow('groups.med: this is MED, not CGNS.')
})

test.each([
  ['classic.e', 'exodus ii', 'Exodus II'],
  ['netcdf4.exo', 'Exodus II', 'Exodus II'],
  ['netcdf4.exo', 'HDF5', 'Exodus II'],
  ['vtk.vtkhdf', 'VTKHDF', 'VTKHDF'],
  ['meshio.h5m', 'MOAB', 'MOAB'],
  ['meshio.hmf', 'HMF', 'HMF'],
  ['meshio.med', 'MED', 'MED'],
])('%s is read as what it is named: %s', (name, named, format) => {
  const file = sharedFile(`meshes/made/${name}`)
  expect(readMeshes(file, { hdf5, format: named })[0]?.format).toBe(format)
})

test.each([
  ['gmsh.cgns', 'Exodus II', 'gmsh.cgns: this is CGNS, not Exodus II.'],
  ['netcdf4.exo', 'Fluent', 'netcdf4.exo: this is Exodus II, not Fluent.'],
  ['gmsh.m', 'Exodus II', 'gmsh.m: this is no netCDF file, and Exodus II is in such files.'],
])('%s is not %s', (name, named, sentence) => {
  expect(() => readMeshes(sharedFile(`meshes/made/${name}`), { hdf5, format: named })).toThrow(sentence)
})

test('MOAB: nodes by their numbers', () => {
  const mesh = read(own('elements.h5m'))
  expect(minima(mesh)).toEqual([1, 2])
  expect(Array.from(mesh.ids as Float64Array)).toEqual([13, 14])
})

test('Exodus in netCDF-4: packed, big-endian, in one coord, with names of blocks and times', () => {
  const mesh = read(own('named.exo'))
  expect(minima(mesh)).toEqual([1, 2])
  expect(blocksOf(mesh)).toEqual([['core', [0, 1]]])
  expect(mesh.steps).toEqual(['0.5', '1.5'])
})

test('VTKHDF: parts, collections, time steps', () => {
  const parts = read(own('parts.vtkhdf'))
  expect(minima(parts)).toEqual([1, 2, 3])
  expect(blocksOf(parts)).toEqual([
    ['MaterialIds 0', [0, 2]],
    ['MaterialIds 1', [1]],
  ])
  const collection = read(own('collection.vtkhdf'))
  expect(minima(collection)).toEqual([1, 2, 3])
  expect(blocksOf(collection).slice(2)).toEqual([
    ['left', [0, 1]],
    ['right', [2]],
  ])
  const steps = [0, 1, 2, 'last' as const].map(step => read(own('steps.vtkhdf'), { step }))
  expect(steps.map(minima)).toEqual([[1, 2], [1.5, 3, 3], [4], [4]])
  expect(steps[1]?.steps).toEqual(['0', '0.5', '1'])
  expect(steps[1]?.notes).toEqual(['Time step 2 of 3 was read: “0.5”.'])
  expect(blocksOf(steps[1] as Mesh)).toEqual([
    ['MaterialIds 0', [0, 2]],
    ['MaterialIds 1', [1]],
  ])
  expect(() => read(own('steps.vtkhdf'), { step: 3 })).toThrow(
    'steps.vtkhdf: it has 3 time steps, and step 4 was asked for.',
  )
})

test('the numbers of a dataset by its path, as XDMF names it', () => {
  const numbers = hdf5.numbers(own('bare.h5'), '/numbers')
  expect(numbers).toMatchObject({ shape: [8, 3], isFloat32: false })
  expect(numbers).toHaveProperty('values.23', 23)
  expect(hdf5.numbers(own('bare.h5'), '/packed')).toBe(
    'bare.h5: “/packed” is packed by the filter “lzf”, which is not read.',
  )
  expect(hdf5.numbers(own('bare.h5'), '/a/numbers')).toBe('bare.h5: it has no dataset “/a/numbers”.')
})

test('a file is read in parts, the numbers that are wanted alone', () => {
  const bytes = bytesOf('zones.cgns')
  const large = 3 * 2 ** 30
  let most = 0
  const file: MeshFile = {
    name: 'large.cgns',
    size: large,
    read(from, to) {
      most = Math.max(most, to - from)
      const part = new Uint8Array(to - from)
      if (from < bytes.length) part.set(bytes.subarray(from, to))
      return part
    },
  }
  expect(minima(read(file))).toEqual([1, 2, 1, 2, 1, 2])
  expect(most).toBeLessThan(2 ** 20)
})

test('without the reader the file asks for it; it is loaded once, and again after a crash', async () => {
  expect(() => readMeshes(own('parts.vtkhdf'))).toThrow(Hdf5Needed)
  const load = vi.fn(hdf5Files)
  const onLoad = vi.fn()
  const loading = new Hdf5Loading(load)
  for (const file of ['parts.vtkhdf', 'zones.cgns'])
    await loading.reading(reader => readMeshes(own(file), { hdf5: reader }), onLoad)
  expect([load.mock.calls.length, onLoad.mock.calls.length]).toEqual([1, 1])
  const whole = sharedFile('meshes/made/vtk.vtkhdf')
  const shortened: MeshFile = {
    ...whole,
    read(from, to) {
      if (from > 0) throw new MeshRefusal('It has become shorter.')
      return whole.read(from, to)
    },
  }
  const reading = loading.reading(reader => readMeshes(shortened, { hdf5: reader }), onLoad)
  await expect(reading).rejects.toThrow('It has become shorter.')
  await loading.reading(reader => readMeshes(own('parts.vtkhdf'), { hdf5: reader }), onLoad)
  expect(load).toHaveBeenCalledTimes(2)
  const failing = new Hdf5Loading(() => Promise.reject(new Error('no line')))
  const refused = failing.reading(reader => readMeshes(own('parts.vtkhdf'), { hdf5: reader }), onLoad)
  await expect(refused).rejects.toThrow('The reader of HDF5 files was not loaded (no line).')
})

/** The bytes of a file with a run of them replaced wherever it stands. */
function withBytes(name: string, before: readonly number[] | string, after: readonly number[] | string): MeshFile {
  const codes = (run: readonly number[] | string) =>
    typeof run === 'string' ? Array.from(run, character => character.charCodeAt(0)) : run
  const bytes = bytesOf(name)
  const [from, to] = [codes(before), codes(after)]
  let count = 0
  for (let at = 0; at + from.length <= bytes.length; ++at)
    if (from.every((byte, i) => bytes[at + i] === byte)) {
      bytes.set(to, at)
      count++
    }
  if (count === 0) throw new Error(`${name} has no such bytes.`)
  return fileOfBytes(name, bytes)
}

/** A number of 64 bits, little-endian. */
const long = (value: number) => Array.from(new Uint8Array(new BigInt64Array([BigInt(value)]).buffer))

test.each<[string, MeshFile, string | RegExp]>([
  [
    'a file that is cut',
    fileOfBytes('a.med', bytesOf('groups.med').subarray(0, 9000)),
    /^a\.med: it cannot be read as HDF5: it is cut off: of 11189 bytes it has 9000\.$/,
  ],
  [
    'a mark alone',
    fileOfBytes('a.h5', bytesOf('groups.med').subarray(0, 8)),
    /^a\.h5: it cannot be read as HDF5: .*\.$/,
  ],
  ['no mesh', own('bare.h5'), /^bare\.h5: this is an HDF5 file with no mesh of a known kind\. .*\.$/],
  [
    'a name in a table with a checksum',
    withBytes('groups.med', 'MAI', 'MAX'),
    /^groups\.med: .* cannot be read as HDF5: incorrect metadata checksum after all read attempts\.$/,
  ],
  [
    'a node beyond the last',
    withBytes('parts.vtkhdf', [...long(4), ...long(3)], [...long(4), ...long(99)]),
    /cell 0 names point 99 as its vertex 3; the points are 0 to 11\.$/,
  ],
  [
    'a node below the first',
    withBytes('parts.vtkhdf', [...long(4), ...long(3)], [...long(4), ...long(-3)]),
    'parts.vtkhdf: number 3 of “/VTKHDF/Connectivity” is -3; a whole number from 0 on was expected.',
  ],
  [
    'a type of element that is none',
    withBytes('zones.cgns', [17, 0, 0, 0, 1, 0, 0, 0], [99, 0, 0, 0, 1, 0, 0, 0]),
    'zones.cgns: element 5 of “/Base/mixed/some” has type 99, which CGNS does not have.',
  ],
])('%s is refused with a sentence', (_, file, sentence) => {
  expect(() => read(file)).toThrow(MeshRefusal)
  expect(() => read(file)).toThrow(sentence)
})
