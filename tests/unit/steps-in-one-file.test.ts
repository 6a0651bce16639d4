/** Time steps that one file has: files that steps/make.py has written with netCDF4, meshio and VTK. */
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { Displacements } from '../../web/mesh/formats/exodus-displacements'
import type { Variable } from '../../web/mesh/formats/netcdf-variables'
import { hdf5Files } from '../../web/mesh/hdf5-files'
import type { Mesh } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { stepsWithin } from '../../web/mesh/step-files'

const hdf5 = await hdf5Files()

function bytesOf(name: string): Uint8Array {
  return new Uint8Array(readFileSync(new URL(`steps/${name}`, import.meta.url)))
}

const own = (name: string) => fileOfBytes(name, bytesOf(name))

function read(file: MeshFile, step: number | 'last' = 0): Mesh {
  return readMeshes(file, { hdf5, step })[0] as Mesh
}

/** The bytes with each of some texts as another of that length, once. */
function changed(name: string, texts: Readonly<Record<string, string>>): MeshFile {
  const bytes = bytesOf(name)
  let text = Buffer.from(bytes).toString('latin1')
  for (const [from, to] of Object.entries(texts)) {
    if (from.length !== to.length || text.split(from).length !== 2)
      throw new Error(`${from} stands not once in ${name}.`)
    text = text.replace(from, () => to)
  }
  return fileOfBytes(name, new Uint8Array(Buffer.from(text, 'latin1')))
}

const NO_NUMBERS: Variable = {
  shape: [],
  isFloat32: false,
  floatsFrom: null,
  text: () => null,
  numbers: () => {},
  indices: () => null,
  strings: () => [],
}

const cornerOf = ({ points, cells }: Mesh) =>
  Array.from(points.subarray(3 * (cells[14] as number), 3 * (cells[14] as number) + 3))
const PLACES = [1, 0.8, 0.6, 0.3]
const STEP = (at: number) => `Time step ${at + 1} of 4 was read: “${[0, 0.25, 0.5, 1][at]}”.`
const added = (names: string) =>
  `The displacements ${names} are added to the coordinates; each sum is rounded to a double.`

test.each([
  ['classic.e', [added('disp_x, disp_y, disp_z')]],
  ['together.e', [added('DISPLX, DISPLY, DISPLZ')]],
  [
    'netcdf4.exo',
    [
      added('displacement_x, displacement_y, displacement_z'),
      'Displacements are stored as Float32: that can move one by up to 1.5e-8.',
    ],
  ],
  ['moving.xmf', []],
  ['moving.vtkhdf', ['Coordinates are stored as Float32: that can move one by up to 1.2e-7.']],
])('%s: each step has coordinates of its own', (name, notes) => {
  for (const [step, place] of PLACES.entries()) {
    const mesh = read(own(name), step)
    expect(mesh.steps).toEqual(['0', '0.25', '0.5', '1'])
    // Half a unit in the last place of a float32 below 2.
    for (const coordinate of cornerOf(mesh).map((x, axis) => x - place - (axis === 0 ? 1 : 0)))
      expect(Math.abs(coordinate)).toBeLessThanOrEqual(2 ** -24)
    if (step === 2) expect(mesh.notes).toEqual([STEP(step), ...notes])
  }
  expect(cornerOf(read(own(name), 'last'))).toEqual(cornerOf(read(own(name), 3)))
  expect(() => read(own(name), 4)).toThrow(`${name}: it has 4 time steps, and step 5 was asked for.`)
})

test.each([
  ['results.e', 'The mesh is the same at all 4 time steps of the file. It has no displacements.'],
  ['results.xdmf', 'The mesh is the same at all 4 time steps of the file.'],
])('%s: steps with other results alone are one mesh', (name, note) => {
  const mesh = read(own(name), 2)
  expect([mesh.isSteady, mesh.steps.length, mesh.notes, cornerOf(mesh)]).toEqual([true, 4, [note], [2, 1, 1]])
  expect(stepsWithin(mesh, [own(name)])).toBe(null)
  expect(() => read(own(name), 4)).toThrow('it has 4 time steps, and step 5 was asked for.')
})

test('displacements that are not there for all nodes are refused, and a part of them is none', () => {
  expect(() => read(changed('classic.e', { vals_nod_var3: 'vals_nod_varX' }))).toThrow(
    'classic.e: “disp_y” is result 3, and there is no vals_nod_var3.',
  )
  expect(read(changed('classic.e', { disp_y: 'disp_w' })).isSteady).toBe(true)
  expect(read(changed('classic.e', { disp_y: 'disp_Y' })).isSteady).toBe(true)
  const shaped = (...shape: readonly number[]) => ({ ...NO_NUMBERS, shape })
  const names = { ...NO_NUMBERS, strings: () => ['disx', 'disy', 'disz'] }
  const variables = (results: Variable) => ({
    names: [],
    variable: (name: string) => (name === 'name_nod_var' ? names : name === 'vals_nod_var' ? results : null),
  })
  const refuse = (what: string): never => {
    throw new Error(what)
  }
  const time = { step: 1, count: 2 }
  Displacements.of(variables(shaped(2, 3, 8)), time, refuse)?.expect(8)
  expect(() => Displacements.of(variables(shaped(1, 3, 8)), time, refuse)?.expect(8)).toThrow(
    'the results “disx” have the shape 1 x 3 x 8; 2 x 3 x 8 was expected.',
  )
})

test('the steps of a file are named after it, with their times', () => {
  const file = own('moving.xmf')
  const steps = stepsWithin(read(file), [fileOfBytes('a.h5', new Uint8Array(1)), file])
  expect(steps?.sentences).toEqual(['moving.xmf has 4 time steps of one mesh.'])
  expect(steps?.steps.map(({ name, time }) => [name, time])).toEqual(
    ['0', '0.25', '0.5', '1'].map(time => ['moving.xmf', time]),
  )
})

test('XDMF: times as a first one and a distance, or not said', () => {
  const text = new TextDecoder().decode(bytesOf('moving.xmf')).replace(/ *<Time [^>]*>\n/g, '')
  const withTime = (time: string) => {
    const from = 'CollectionType="Temporal">'
    return fileOfBytes('a.xmf', new TextEncoder().encode(text.replace(from, `${from}${time}`)))
  }
  const slab = '<Time TimeType="HyperSlab"><DataItem Dimensions="3" NumberType="Float">2 0.5 4</DataItem></Time>'
  expect(read(withTime(slab)).steps).toEqual(['2', '2.5', '3', '3.5'])
  const untold = read(withTime(''), 1)
  expect([untold.steps, untold.notes]).toEqual([['', '', '', ''], ['Time step 2 of 4 was read.']])
  expect(stepsWithin(untold, [own('moving.xmf')])?.steps.map(({ time }) => time)).toEqual([null, null, null, null])
})
