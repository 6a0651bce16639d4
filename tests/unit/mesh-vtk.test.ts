import { readdirSync, readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import type { Mesh } from '../../web/mesh/mesh'
import { MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { core } from './core-fixtures'
import { processorTime } from './processor-time'

const shared = new URL('../../../shared/', import.meta.url)
const madeFolder = new URL('meshes/made/', shared)
const pathOf = (folder: URL, name: string) => new URL(name, folder)

interface Expected {
  readonly name: string
  readonly valid: boolean
  readonly min_lower: number
  readonly min_upper: number
}
interface MadeFile {
  readonly file: string
  readonly format: string
  readonly variant: string
  readonly counts: Readonly<Record<string, number>>
  readonly coordinates_exact: boolean
}
interface Paste {
  readonly file: string
  readonly hexahedra: number
  readonly invalid: number
  readonly expect: readonly (readonly [string, readonly number[]])[] | null
}
const manifest = JSON.parse(readFileSync(pathOf(madeFolder, 'manifest.json'), 'utf8')) as {
  linear: Expected[]
  quadratic: Expected[]
  files: MadeFile[]
}

function opened(folder: URL, name: string): MeshFile {
  return fileOfBytes(name, new Uint8Array(readFileSync(pathOf(folder, name))))
}

function read(folder: URL, name: string): readonly Mesh[] {
  const beside = new URL('.', pathOf(folder, name))
  return readMeshes(opened(folder, name), {
    find: wanted => (readdirSync(beside).includes(wanted) ? opened(beside, wanted) : null),
  })
}

function only(meshes: readonly Mesh[]): Mesh {
  expect(meshes.length).toBe(1)
  return meshes[0] as Mesh
}

function refusalOf(run: () => unknown): string {
  try {
    run()
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
  return 'was read'
}

function verticesOf(mesh: Mesh, cells: Uint32Array, cell: number): number[] {
  return Array.from(cells.subarray(8 * cell, 8 * cell + 8)).flatMap(point => [
    ...mesh.points.subarray(3 * point, 3 * point + 3),
  ])
}

function answerOf(mesh: Mesh, cells: Uint32Array, cell: number): { valid: boolean; minimum: number } {
  const report = core.analyze(verticesOf(mesh, cells, cell))
  if (!report.ok) throw new Error(report.error.message)
  return { valid: report.value.valid, minimum: report.value.boundaryMinimum * 2 ** report.value.exponent }
}

function countInvalid(mesh: Mesh, cells = mesh.cells): number {
  let invalid = 0
  for (let cell = 0; cell < cells.length / 8; ++cell) if (!answerOf(mesh, cells, cell).valid) invalid++
  return invalid
}

function expectAnswers(mesh: Mesh, cells: Uint32Array, expected: readonly Expected[], isExact: boolean): void {
  const slack = (value: number) => (isExact ? 1e-9 : 1e-3 * Math.max(Math.abs(value), 1e-3))
  expected.forEach(({ name, valid, min_lower, min_upper }, cell) => {
    const answer = answerOf(mesh, cells, cell)
    expect(answer.valid, name).toBe(valid)
    expect(answer.minimum, name).toBeGreaterThanOrEqual(min_lower - slack(min_lower))
    expect(answer.minimum, name).toBeLessThanOrEqual(min_upper + slack(min_upper))
  })
}

const OTHER_NAMES: Readonly<Record<string, string>> = {
  tetra: 'tetrahedron',
  wedge: 'wedge',
  pyramid: 'pyramid',
  quad: 'quadrilateral',
  polyhedron: 'polyhedron',
}

/** The numbers of cells as the manifest names them. */
function expectCounts(mesh: Mesh, counts: Readonly<Record<string, number>>): void {
  expect(mesh.cells.length / 8).toBe((counts.hexahedron ?? 0) + (counts.voxel ?? 0))
  expect(mesh.notTrilinear.corners.length / 8).toBe((counts.hexahedron20 ?? 0) + (counts.lagrange2 ?? 0))
  const others = Object.entries(counts).flatMap(([name, count]) =>
    name in OTHER_NAMES ? [[OTHER_NAMES[name], count]] : [],
  )
  expect(Object.fromEntries(mesh.other)).toEqual(Object.fromEntries(others))
}

const ours = manifest.files.filter(({ format }) => ['vtu', 'vtk'].includes(format))
const special = ['vtk-polyhedra-ascii.vtu', 'vtk-lagrange2.vtu']

describe('made by other writers', () => {
  test.each(ours.filter(({ file }) => !special.includes(file)))('$file: $variant', made => {
    const mesh = only(read(madeFolder, made.file))
    expectCounts(mesh, made.counts)
    expectAnswers(mesh, mesh.cells, manifest.linear, made.coordinates_exact)
    if (made.counts.voxel) expect(answerOf(mesh, mesh.cells, 15)).toEqual({ valid: true, minimum: 1 })
    if (made.counts.hexahedron20) {
      expectAnswers(mesh, mesh.notTrilinear.corners, manifest.quadratic, made.coordinates_exact)
      expect(mesh.notTrilinear.straight).toBe(2)
    }
    expect([mesh.isOrderStated, mesh.isCutOff]).toEqual([true, false])
  })

  test('coordinates are where they are said to be', () => {
    for (const name of ['vtk-raw-none.vtu', 'vtk-raw-none-big.vtu', 'vtk-raw-none-f32.vtu', 'vtk-legacy51-bin.vtk']) {
      const mesh = only(read(madeFolder, name))
      const places = mesh.coordinatePlaces
      if (places?.kind !== 'block') throw new Error(`${name}: no block`)
      const bytes = readFileSync(pathOf(madeFolder, name))
      const view = new DataView(bytes.buffer, bytes.byteOffset + places.from)
      const values = Array.from(mesh.points, (_, i) =>
        places.type === 'float64'
          ? view.getFloat64(8 * i, places.isLittleEndian)
          : view.getFloat32(4 * i, places.isLittleEndian),
      )
      expect(values).toEqual([...mesh.points])
    }
  })

  test('coordinates in text are the run that is said', () => {
    const names = [
      'vtk-ascii.vtu',
      'meshio-ascii.vtu',
      'vtk-legacy42-ascii.vtk',
      'vtk-legacy51-ascii.vtk',
      'gmsh-ascii.vtk',
    ]
    for (const name of names) {
      const mesh = only(read(madeFolder, name))
      const places = mesh.coordinatePlaces
      if (places?.kind !== 'run') throw new Error(`${name}: no run`)
      const text = readFileSync(pathOf(madeFolder, name), 'latin1').slice(places.from, places.to)
      expect(text.trim().split(/\s+/).map(Number), name).toEqual([...mesh.points])
    }
  })

  test('polyhedra with hexahedral faces are polyhedra', () => {
    const mesh = only(read(madeFolder, 'vtk-polyhedra-ascii.vtu'))
    expectCounts(mesh, { polyhedron: 2, hexahedron: 1 })
    expectAnswers(mesh, mesh.cells, manifest.linear.slice(1, 2), true)
  })

  test('Lagrange cells are not trilinear, even where their nodes lie as if they were', () => {
    const mesh = only(read(madeFolder, 'vtk-lagrange2.vtu'))
    expectCounts(mesh, { lagrange2: 3 })
    const [first, second, , , fifth] = manifest.linear as [Expected, Expected, Expected, Expected, Expected]
    expectAnswers(mesh, mesh.notTrilinear.corners, [first, second, fifth], true)
    expect(mesh.notTrilinear.straight).toBe(3)
  })

  test('a .pvtu has the cells of all its pieces, and asks by name for one that is missing', () => {
    const folder = pathOf(madeFolder, 'pvtu/')
    const mesh = only(read(folder, 'mesh.pvtu'))
    expectCounts(mesh, { hexahedron: 45 })
    for (const first of [0, 15, 30]) expectAnswers(mesh, mesh.cells.subarray(8 * first), manifest.linear, true)
    expect(mesh.blocks.map(({ name, cells }) => [name, cells[0], cells.length])).toEqual([
      ['mesh_0.vtu', 0, 15],
      ['mesh_1.vtu', 15, 15],
      ['mesh_2.vtu', 30, 15],
    ])
    const refusal = refusalOf(() => readMeshes(opened(folder, 'mesh.pvtu'), { find: () => null }))
    expect(refusal).toMatch(/needs .mesh_0\.vtu., .mesh_1\.vtu., .mesh_2\.vtu. beside it/)
  })
})

describe('published', () => {
  const folder = pathOf(shared, 'meshes/real/')
  test('matrix_fiber_rand.vtk', () => {
    const mesh = only(read(folder, 'matrix_fiber_rand.vtk'))
    const minima = Array.from({ length: 603 }, (_, cell) => answerOf(mesh, mesh.cells, cell).minimum)
    expect([mesh.cells.length / 8, countInvalid(mesh)]).toEqual([603, 97])
    expect(Math.min(...minima)).toBeCloseTo(-0.000188078, 8)
    expect(mesh.notes).toEqual(['Coordinates are printed with at most 7 digits: that can move one by up to 5e-7.'])
  })

  test('fichera-mixed-p2.vtk', () => {
    const mesh = only(read(folder, 'fichera-mixed-p2.vtk'))
    expect([mesh.cells.length, mesh.notTrilinear.corners.length / 8]).toEqual([0, 3])
    expect(Object.fromEntries(mesh.other)).toEqual({ tetrahedron: 5, wedge: 6 })
    expect(countInvalid(mesh, mesh.notTrilinear.corners)).toBe(0)
  })
})

describe('malformed', () => {
  const folder = pathOf(shared, 'meshes/malformed/')
  test.each([
    ['truncated-half-vtu-raw.vtu', /cut off/],
    ['truncated-half-vtu-zlib.vtu', /cut off/],
    ['truncated-half-vtk-bin.vtk', /cut off/],
    ['truncated-tail-vtk-bin.vtk', /cut off/],
    ['truncated-tail-vtk-ascii.vtk', /line 107: the file is cut off: it ends where type 14 of 25 was expected/],
    ['truncated-tail-gz.vtu.gz', /cut off/],
    ['empty.vtu', /is empty/],
    ['not-a-mesh.vtu', /is no VTU/],
    ['index-too-big.vtu', /cell 0 names point 8 as its vertex 7; the points are 0 to 7/],
    ['index-negative.vtu', /line 2: .-1. in .connectivity. stands where an index/],
    ['index-fraction.vtu', /line 2: .* in .connectivity. stands where an index/],
    ['too-many-points.vtu', /more than the 21 numbers that are declared/],
    ['count-negative.vtu', /NumberOfPoints is .-8., where a count was expected/],
    ['count-text.vtu', /NumberOfPoints is .eight., where a count was expected/],
    ['offsets-decreasing.vtu', /offset of cell 1 is 8, less than 16/],
    ['types-missing.vtu', /.types. has 0 numbers; 1 were expected/],
    ['word-among-numbers.vtu', /line 2: .zero. in .Points. stands where a number was expected/],
    ['comma-decimal.vtu', /line 2: .1,0. in .Points. stands where a number was expected/],
    ['xml-entity-bomb.vtu', /a document type or an entity is not read/],
    ['text-in-appended.vtu', /.Points. says that it has \d+ bytes; 24 numbers of type Float64 have 192/],
    ['offset-outside.vtu', /.Points. lies at byte \d+, the file ends at byte/],
    ['bomb-lies.vtu', /.Points. holds more than the 192 bytes that are declared/],
    ['blocks-huge.vtu', /.Points. says that it has/],
    ['vtk-count-huge.vtk', /line 14: .CELLS. stands where coordinate 25 of 2999999999997 was expected/],
    ['vtk-types-fewer.vtk', /CELL_TYPES/],
  ])('%s', (name, sentence) => {
    const started = processorTime()
    const refusal = refusalOf(() => read(folder, name))
    expect(refusal).toMatch(sentence)
    expect(refusal).toContain(name.replace(/\.gz$/, ''))
    expect(processorTime() - started).toBeLessThan(2000)
  })

  test('what is not finite stays in the points', () => {
    const infinite = only(read(folder, 'inf.vtu'))
    expect(infinite.points.includes(Infinity)).toBe(true)
    expect(infinite.cells.length).toBe(8)
    const unused = only(read(folder, 'nan-unused.vtu'))
    expect(countInvalid(unused)).toBe(0)
  })

  test('no cells are no error', () => {
    expect(only(read(folder, 'vtk-one-point.vtk')).cells.length).toBe(0)
  })

  test('a voxel whose nodes are in the order of a hexahedron has no certain order', () => {
    const mesh = only(read(folder, 'vtk-type11-as-hex.vtk'))
    expect(mesh.isOrderStated).toBe(false)
    expect(mesh.notes[0]).toMatch(/1 of the voxels \(type 11\) is no box along the axes/)
  })
})

describe('pasted', () => {
  const folder = pathOf(shared, 'pastes/')
  const pastes = (JSON.parse(readFileSync(pathOf(folder, 'expected.json'), 'utf8')) as Paste[]).filter(({ file }) =>
    /\.(?:vtu|vtk)$/.test(file),
  )
  test.each(pastes)('$file', ({ file, hexahedra, invalid, expect: elements }) => {
    const meshes = read(folder, file)
    const vertices = meshes.flatMap(mesh =>
      Array.from({ length: mesh.cells.length / 8 }, (_, cell) => verticesOf(mesh, mesh.cells, cell)),
    )
    expect(vertices.length).toBe(hexahedra)
    expect(meshes.reduce((sum, mesh) => sum + countInvalid(mesh), 0)).toBe(invalid)
    if (elements !== null) expect(vertices).toEqual(elements.map(([, numbers]) => numbers))
    for (const mesh of meshes) expect([mesh.isOrderStated, mesh.isCutOff]).toEqual([true, false])
  })

  test('where a text leaves something out, it is said', () => {
    const { notes } = only(read(folder, '82-vtk-elided.vtk'))
    expect(notes).toEqual([
      'The text leaves something out: 232 of the declared points are not there or not whole; the others were read.',
    ])
  })
})
