/** Formats of the second list: one mesh in all of them, with wasm and without, what else they may have, and what is refused. */
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { loadReadingCore } from '../../web/core/reading-core'
import type { ReadingCore } from '../../web/core/reading-interface'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes, readTogether } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { readShared, verticesOf } from './mesh-expectations'
import { cellIds, cells, ELMER, exodusOf, FOAM, FOAM_BINARY, points, TEXTS, ugridOfBytes } from './other-formats'

const core = await loadReadingCore(readFileSync(new URL('../../build/hexlens-reading.wasm', import.meta.url)))
const WAYS: readonly (ReadingCore | null)[] = [core, null]

type Content = string | Uint8Array
const fileOf = (name: string, content: Content): MeshFile =>
  fileOfBytes(name, typeof content === 'string' ? new TextEncoder().encode(content) : content)

function readAll(files: Readonly<Record<string, Content>>, way: ReadingCore | null = null): readonly Mesh[] {
  const options = { onProgress: () => {}, throwIfCancelled: () => {}, core: way }
  return readTogether(
    Object.entries(files).map(([name, content]) => fileOf(name, content)),
    options,
  )
}

function refusal(files: Readonly<Record<string, Content>>): string {
  try {
    readAll(files)
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
  return 'read'
}

const expected = cells.map(cell => cell.flatMap(point => points[point] as number[]))

/** The same cells with the same coordinates, rounded to so many digits or, for 0, to 24 bits; up to the order of eight points that only faces give. */
function expectSame(
  meshes: readonly Mesh[],
  ids: readonly (number | string)[] | null,
  digits = 17,
  byFaces = false,
): Mesh {
  expect(meshes.length).toBe(1)
  const [mesh] = meshes as [Mesh]
  const sorted = (all: readonly number[]) =>
    byFaces ? Array.from({ length: 8 }, (_, v) => all.slice(3 * v, 3 * v + 3).join()).sort() : all
  const rounded = (all: readonly number[]) =>
    digits === 17 ? all : all.map(digits === 0 ? Math.fround : value => Number(value.toPrecision(digits)))
  expect(cells.map((_, cell) => sorted(rounded(verticesOf(mesh, cell))))).toEqual(
    expected.map(all => sorted(rounded(all))),
  )
  if (ids !== null) expect([...(mesh.ids ?? [])]).toEqual(ids)
  return mesh
}

const counted = cells.map((_, i) => i)
const countedFromOne = counted.map(i => i + 1)

describe.each(WAYS)('one mesh of 64 hexahedra, %#', way => {
  test.each<[string, readonly (number | string)[], string | null, number]>([
    ['a.su2', counted, null, 17],
    ['a.f3grid', cellIds, 'hard rock', 17],
    ['a.dato', cellIds, 'body', 17],
    ['a.rad', cellIds, 'engine block', 13],
    ['a.mail', cellIds.map(id => `M${id}`), 'LEFT', 17],
    ['a.feb', cellIds, 'Part1', 17],
    ['a.ugrid', countedFromOne, null, 17],
    ['fluent.msh', countedFromOne, 'air', 17],
  ])('%s', (name, ids, block, digits) => {
    const mesh = expectSame(readAll({ [name]: TEXTS[name] as string }, way), ids, digits, name === 'fluent.msh')
    expect(mesh.blocks.map(one => one.name)).toEqual(block === null ? [] : [block])
    const { coordinatePlaces: places } = mesh
    if (name === 'a.ugrid') expect(places?.kind).toBe('run')
    else {
      const at = 3 * (mesh.points.length / 3 - 1)
      const from = places?.kind === 'tokens' ? (places.from[at] as number) : 0
      const length = places?.kind === 'tokens' ? (places.lengths[at] as number) : 0
      expect(Number(TEXTS[name]?.slice(from, from + length))).toBe(mesh.points[at])
    }
  })

  test('Elmer', () => {
    const mesh = expectSame(readAll(ELMER, way), cellIds)
    expect(mesh.blocks.map(one => one.name)).toEqual(['steel'])
  })

  test.each([
    ['text', FOAM],
    ['bytes', FOAM_BINARY],
  ])('OpenFOAM, %s', (_, files) => {
    const mesh = expectSame(readAll(files, way), counted, 17, true)
    expect(mesh.blocks.map(one => [one.name, ...one.cells])).toEqual([['rotor', 0, 2, 5]])
  })

  test.each([1, 2, 5] as const)('Exodus II, netCDF version %s', version => {
    const mesh = expectSame(readAll({ 'a.e': exodusOf(version) }, way), cellIds)
    expect(mesh.blocks.map(one => one.name)).toEqual(['engine'])
    expect(mesh.steps).toEqual(['0', '0.5'])
  })
})

test.each([
  ['a.b8.ugrid', false, false, 8, 4],
  ['a.lb8.ugrid', true, false, 8, 4],
  ['a.lb4.ugrid', true, false, 4, 4],
  ['a.r8.ugrid', false, true, 8, 4],
  ['a.lr8.ugrid', true, true, 8, 4],
  ['a.lb8l.ugrid', true, false, 8, 8],
  ['without-a-name', false, false, 8, 8],
] as const)('UGRID in bytes, %s', (name, isLittle, hasRecords, floatBytes, intBytes) => {
  const bytes = ugridOfBytes(isLittle, hasRecords, floatBytes, intBytes)
  expectSame(readAll({ [name]: bytes }), countedFromOne, floatBytes === 4 ? 0 : 17)
})

test('OpenFOAM’s files of ../shared, whichever is read first', () => {
  const files = Object.fromEntries(
    ['owner', 'points', 'neighbour', 'faces', 'boundary'].map(name => [
      name,
      new Uint8Array(
        readFileSync(new URL(`../../../shared/meshes/made/foam/constant/polyMesh/${name}`, import.meta.url)),
      ),
    ]),
  )
  expect(readAll(files).map(({ cells: own }) => own.length)).toEqual([32])
})

test('Exodus II of ../shared: ids, blocks and other elements', () => {
  const mesh = readShared('meshes/made/classic.e')
  expect([...(mesh.ids ?? [])].slice(0, 3)).toEqual([7, 17, 27])
  expect(Object.fromEntries(mesh.other)).toEqual({ tetrahedron: 2, wedge: 1, pyramid: 1 })
})

const CUBE = '0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1'
const GRID = `<Grid Name="mesh"><Topology TopologyType="Hexahedron"><DataItem Dimensions="1 8" NumberType="Int">0 1 2 3 4 5 6 7</DataItem></Topology><Geometry GeometryType="XYZ"><DataItem Dimensions="8 3">${CUBE}</DataItem></Geometry></Grid>`
const document = (grids: string) =>
  `<?xml version="1.0"?>\n<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>\n<Xdmf Version="3.0"><Domain>${grids}</Domain></Xdmf>`

describe('XDMF', () => {
  test('steps that include the mesh which stands beside them', () => {
    const include = (path: string, time: string) =>
      `<Grid><xi:include xpointer="xpointer(${path}/*[self::Topology or self::Geometry])"/><Time Value="${time}"/></Grid>`
    const steps = `<Grid GridType="Collection" CollectionType="Temporal">${include('//Grid[@Name=&quot;mesh&quot;]', '0.5')}${include('/Xdmf/Domain/Grid[1]', '2')}</Grid>`
    const file = fileOf('a.xdmf', document(GRID + steps))
    const [mesh] = readMeshes(file, { step: 'last' }) as [Mesh]
    expect(mesh.cells.length / 8).toBe(1)
    expect(mesh.steps).toEqual(['0.5', '2'])
    expect(() => readMeshes(file, { step: 2 })).toThrow(/it has 2 time steps, and step 3 was asked for/)
  })

  test('mixed cells, a lattice, and points of three lists', () => {
    const mixed = `<Grid><Topology TopologyType="Mixed" NumberOfElements="3"><DataItem Dimensions="20" NumberType="Int">9 0 1 2 3 4 5 6 7 2 2 0 1 16 1 3 0 1 2 1 0</DataItem></Topology><Geometry GeometryType="X_Y_Z">${[
      0, 1, 2,
    ]
      .map(
        axis =>
          `<DataItem Dimensions="8">${CUBE.split(' ')
            .filter((_, i) => i % 3 === axis)
            .join(' ')}</DataItem>`,
      )
      .join('')}</Geometry></Grid>`
    const lattice =
      '<Grid><Topology TopologyType="3DCoRectMesh" Dimensions="2 3 4"/><Geometry GeometryType="ORIGIN_DXDYDZ"><DataItem Dimensions="3">0 0 0</DataItem><DataItem Dimensions="3">3 2 1</DataItem></Geometry></Grid>'
    expect(refusal({ 'a.xdmf': document(mixed) })).toMatch(/DataItem” has more than the 20 numbers/)
    const [mesh] = readAll({ 'a.xdmf': document(mixed.replace('"20"', '"19"').replace(' 1 0<', '<') + lattice) }) as [
      Mesh,
    ]
    expect(mesh.cells.length / 8).toBe(7)
    expect(Object.fromEntries(mesh.other)).toEqual({ line: 1, polyhedron: 1 })
    expect([...mesh.points].slice(-3)).toEqual([3, 4, 3])
  })

  test('numbers in the bytes of a file beside', () => {
    const item = '<DataItem Dimensions="8 3" Format="Binary" Precision="8" Endian="Little" Seek="8">a.bin</DataItem>'
    const text = document(GRID.replace(/<DataItem Dimensions="8 3">.*?<\/DataItem>/, item))
    const bytes = new Uint8Array(Float64Array.from([7, ...CUBE.split(' ').map(Number)]).buffer)
    const [mesh] = readAll({ 'a.xdmf': text, 'a.bin': bytes }) as [Mesh]
    expect(verticesOf(mesh, 0)).toEqual(CUBE.split(' ').map(Number))
    expect(refusal({ 'a.xdmf': text, 'a.bin': bytes.subarray(0, 100) })).toMatch(
      /“a\.bin” has 100 bytes; numbers up to byte 200/,
    )
    expect(refusal({ 'a.xdmf': text })).toMatch(/it needs “a\.bin” beside it/)
  })

  test('a document type that defines something is refused', () => {
    expect(refusal({ 'a.xdmf': document(GRID).replace('[]', '[<!ENTITY a "b">]') })).toMatch(
      /a document type or an entity/,
    )
  })
})

test('Kratos: the parts of the model are blocks, coordinates have places', () => {
  const nodes = Array.from(
    { length: 8 },
    (_, v) =>
      ` ${v + 1} ${CUBE.split(' ')
        .slice(3 * v, 3 * v + 3)
        .join('  ')} // a node\n`,
  )
  const file = `Begin Nodes\n${nodes.join('')}End Nodes\nBegin Elements Element3D8N\n 17 0 1 2 3 4 5 6 7 8\nEnd Elements\nBegin SubModelPart solid\n Begin SubModelPartNodes\n  1\n End SubModelPartNodes\n Begin SubModelPart inner\n  Begin SubModelPartElements\n  17\n  End SubModelPartElements\n End SubModelPart\nEnd SubModelPart\n`
  const [mesh] = readAll({ 'a.mdpa': file }) as [Mesh]
  expect(mesh.blocks.map(one => [one.name, ...one.cells])).toEqual([
    ['Element3D8N', 0],
    ['inner', 0],
  ])
  const places = mesh.coordinatePlaces
  const from = places?.kind === 'tokens' ? [...places.from] : []
  expect(from.map(at => Number(file[at]))).toEqual(CUBE.split(' ').map(Number))
})

const text = (name: string) => TEXTS[name] as string

const NCDUMP = readFileSync(new URL('../../../shared/pastes/60-ncdump-exodus.cdl', import.meta.url), 'utf8')

test.each<[string, Readonly<Record<string, Content>>, RegExp]>([
  [
    'SU2, a point that is not there',
    { 'a.su2': text('a.su2').replace(/^12 \d+/m, '12 999') },
    /^a\.su2, line 4: element 0 names node 999, which is not defined\.$/,
  ],
  [
    'SU2, too few points',
    { 'a.su2': text('a.su2').replace('NPOIN= 125', 'NPOIN= 126') },
    /126 points are declared, and 125 are there/,
  ],
  [
    'FLAC3D, a gridpoint twice',
    { 'a.f3grid': text('a.f3grid').replace(/^(G .*\n)/m, '$1$1') },
    /^a\.f3grid.*: node \d+ is defined twice\.$/,
  ],
  [
    'PERMAS, a line that is cut',
    { 'a.dato': text('a.dato').replace(/^(\$COOR\n\d+ \S+).*$/m, '$1') },
    /^a\.dato, line 71: the line ends where a coordinate was expected\.$/,
  ],
  [
    'Radioss, no number',
    { 'a.rad': text('a.rad').replace(/^(\/NODE\n {7}...) {2}/m, '$1 x') },
    /^a\.rad, line \d+: “x.*” is not a coordinate\.$/,
  ],
  [
    'Radioss, another file',
    { 'a.rad': text('a.rad').replace('/NODE', '#include nodes.rad\n/NODE') },
    /^a\.rad, line \d+: it includes “nodes\.rad”/,
  ],
  [
    'Radioss, nodes that are moved afterwards',
    { 'a.rad': text('a.rad').replace(/^\/NODE/m, '/TRANSFORM/TRA/1\n/NODE') },
    /^a\.rad, line \d+: \/TRANSFORM is not read here: write the nodes where they are in the end\.$/,
  ],
  [
    'Code_Aster, a node that is not there',
    { 'a.mail': text('a.mail').replace(/^( M\d+ N\d+ N)\d+/m, '$1999') },
    /^a\.mail, line \d+: element “M\d+” names node “N999”, which is not defined\.$/,
  ],
  [
    'FEBio, an old version',
    { 'a.feb': text('a.feb').replace('2.5', '1.2') },
    /the version is “1\.2”; versions 2 to 4 are read/,
  ],
  ['FEBio, a cut file', { 'a.feb': text('a.feb').slice(0, 6000) }, /^a\.feb.*cut off/],
  [
    'ncdump, a node that is infinite',
    { 'a.cdl': NCDUMP.replace('1, 2, 3', '1, -inf, 3') },
    /^a\.cdl.*: element 1 names what is no whole number; the nodes are 1 to 8\.$/,
  ],
  [
    'ncdump, a gap among the ids',
    { 'a.cdl': NCDUMP.replace('connect1 =', 'elem_num_map = _ ;\n connect1 =') },
    /^a\.cdl.*: the numbers of its elements are no whole numbers\.$/,
  ],
  [
    'UGRID, a cut file',
    { 'a.ugrid': text('a.ugrid').slice(0, -40) },
    /^a\.ugrid, line \d+: the file ends among the points of hexahedra\.$/,
  ],
  [
    'Fluent, a face of nothing',
    { 'a.msh': text('fluent.msh').replace(/\n(\w+) (\w+ \w+ \w+ \w+ \w+\n)/, '\n0 $2') },
    /^a\.msh, line \d+: a face names node 0; nodes count from 1\.$/,
  ],
  [
    'Elmer, a wrong count',
    { ...ELMER, 'mesh.elements': '1 1 808 1 2 3\n' },
    /^mesh\.elements, line 1: element 1 of type 808 has 3 nodes\.$/,
  ],
  [
    'OpenFOAM, a cut list',
    { ...FOAM, owner: (FOAM.owner as string).slice(0, -60) },
    /^owner, line \d+: \d+ of 240 owners are there; the file ends there\.$/,
  ],
  [
    'OpenFOAM, files of two meshes',
    { ...FOAM, owner: (FOAM.owner as string).replace('constant', '0.5') },
    /they are files of two meshes\.$/,
  ],
  [
    'Exodus II, a cut file',
    { 'a.e': exodusOf(1).subarray(0, 3000) },
    /^a\.e, byte \d+: “\w+” needs \d+ bytes from here on, and the file ends at byte 3000\.$/,
  ],
  [
    'netCDF of another kind',
    { 'a.nc': new Uint8Array([67, 68, 70, 1, ...new Uint8Array(28)]) },
    /it is no Exodus file/,
  ],
])('refused: %s', (_, files, sentence) => {
  expect(refusal(files)).toMatch(sentence)
})
