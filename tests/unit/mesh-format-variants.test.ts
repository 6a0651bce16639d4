/** What other programs write, where a format has more than one way. */
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { verticesOf } from './mesh-expectations'
import { exodusOf } from './other-formats'

type Content = string | Uint8Array
const fileOf = (name: string, content: Content): MeshFile =>
  fileOfBytes(name, typeof content === 'string' ? new TextEncoder().encode(content) : content)

function readAll(files: Readonly<Record<string, Content>>): readonly Mesh[] {
  return Object.entries(files).flatMap(([name, content]) => readMeshes(fileOf(name, content)))
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

const CUBE = ['0 0 0', '1 0 0', '1 1 0', '0 1 0', '0 0 1', '1 0 1', '1 1 1', '0 1 1']

/** Little-endian numbers and texts. */
function bytesOf(...parts: readonly (readonly ['u16' | 'u32' | 'f64', ...number[]] | string)[]): Uint8Array {
  const lists = parts.map(part => {
    if (typeof part === 'string') return Buffer.from(part)
    const [type, ...values] = part as ['u16' | 'u32' | 'f64', ...number[]]
    const list = { u16: Uint16Array, u32: Uint32Array, f64: Float64Array }[type].from(values)
    return Buffer.from(list.buffer)
  })
  return new Uint8Array(Buffer.concat(lists))
}

describe('FLAC3D in bytes', () => {
  const points = CUBE.flatMap((point, i) => [
    ['u32', 3 * i + 2] as const,
    ['f64', ...point.split(' ').map(Number)] as const,
  ])
  // A corner, the three beside it, xy, yz, xz, and the one across.
  const brick = [0, 1, 3, 4, 2, 7, 5, 6].map(v => 3 * v + 2)
  const grid = (zone: readonly number[], version = 3) =>
    bytesOf(
      ['u32', 1375135718, version, 8],
      ...points,
      ['u32', 2, ...zone, 9, 4, 2, 5, 8, 14, 1],
      ['u16', 4],
      'rock',
      ['u16', 7],
      'Default',
      ['u32', 2, 5, 9, 1, 1, 4, 2, 5, 8, 11, 0],
    )
  const name = 'a.f3grid'

  test('zones, their groups and faces', () => {
    const [mesh] = readAll({ [name]: grid([5, 8, ...brick]) }) as [Mesh]
    expect(verticesOf(mesh, 0)).toEqual(CUBE.join(' ').split(' ').map(Number))
    expect([Array.from(mesh.ids as Float64Array), Object.fromEntries(mesh.other)]).toEqual([[5], { tetrahedron: 1 }])
    expect(mesh.blocks.map(block => [block.name, ...block.cells])).toEqual([['rock', 0]])
  })

  test.each<readonly [Uint8Array, RegExp]>([
    [grid([5, 8, ...brick], 4), /^a\.f3grid, byte 8: the version is 4; 3 is read\.$/],
    [grid([5, 9, ...brick, 2]), /: zone 5 has 9 gridpoints; 4 to 8 were expected\.$/],
    [grid([5, 8, ...brick.with(3, 99)]), /: zone 5 names node 99, which is not defined\.$/],
    [grid([5, 8, ...brick]).subarray(0, 300), /bytes of .* were expected, the file ends after/],
  ])('is refused, %#', (bytes, sentence) => {
    expect(refusal({ [name]: bytes })).toMatch(sentence)
  })
})

test('UGRID: records of meshio, with wrong lengths', () => {
  const bytes = bytesOf(
    ['u32', 56, 8, 0, 0, 0, 0, 0, 1, 56, 300],
    ['f64', ...CUBE.join(' ').split(' ').map(Number)],
    ['u32', 1, 2, 3, 4, 5, 6, 7, 8, 300],
  )
  const [mesh] = readAll({ 'a.lr8.ugrid': bytes }) as [Mesh]
  expect(mesh.cells.length).toBe(8)
  expect(mesh.notes).toEqual(['The lengths of its records are wrong, as meshio writes them; they were passed over.'])
  const other = bytes.slice()
  other[32] = 57
  expect(refusal({ 'a.lr8.ugrid': other })).toMatch(/the record ends elsewhere than its length says/)
})

test('Radioss: a brick whose last four nodes are 0 or blank is a tetrahedron', () => {
  const columns = (width: number, ...words: readonly unknown[]) =>
    words.map(word => String(word).padStart(width)).join('')
  const nodes = CUBE.map((point, i) => columns(10, i + 1) + columns(20, ...point.split(' ')))
  const bricks = [
    columns(10, 7, 1, 2, 3, 4, 5, 6, 7, 8),
    columns(10, 8, 1, 2, 3, 5, 0, 0, 0, 0),
    columns(10, 9, 1, 2, 3, 5),
  ]
  const [mesh] = readAll({ 'a.rad': ['/BEGIN', '/NODE', ...nodes, '/BRICK/3', ...bricks, '/END', ''].join('\n') }) as [
    Mesh,
  ]
  expect([mesh.cells.length, mesh.other]).toEqual([8, new Map([['tetrahedron', 2]])])
  const half = columns(10, 9, 1, 2, 3, 5, 0, 0, 0, 6)
  expect(refusal({ 'a.rad': ['/BEGIN', '/NODE', ...nodes, '/BRICK/3', half, '/END', ''].join('\n') })).toContain(
    'node 0',
  )
})

test('Medit: Hexaedra, as some spell it', () => {
  const text = `MeshVersionFormatted 2\nDimension 3\nVertices\n8\n${CUBE.join(' 0\n')} 0\nHexaedra\n1\n1 2 3 4 5 6 7 8 0\nEnd\n`
  const [mesh] = readAll({ 'a.mesh': text }) as [Mesh]
  expect(Array.from(mesh.cells)).toEqual([0, 1, 2, 3, 4, 5, 6, 7])
})

test('Radioss: bricks of 20 nodes on lines of eight, or of ten', () => {
  const columns = (...numbers: readonly number[]) => numbers.map(number => String(number).padStart(10)).join('')
  const nodes = Array.from({ length: 20 }, (_, i) => i + 1)
  const lines = CUBE.concat(CUBE, CUBE.slice(0, 4)).map(
    (point, i) =>
      columns(i + 1) +
      point
        .split(' ')
        .map(value => value.padStart(20))
        .join(''),
  )
  for (const width of [8, 10]) {
    const rows = [
      columns(7, ...nodes.slice(0, 8)),
      columns(...nodes.slice(8, 8 + width)),
      columns(...nodes.slice(8 + width)),
    ]
    const text = ['/BEGIN', '/NODE', ...lines, '/BRIC20/3', ...rows, '/END', ''].join('\n')
    const [mesh] = readAll({ 'a.rad': text }) as [Mesh]
    expect(Array.from(mesh.notTrilinear.corners)).toEqual([0, 1, 2, 3, 4, 5, 6, 7])
  }
})

test('OVM: comments stand between lines', () => {
  const text = new TextDecoder().decode(readFileSync(new URL('../../../shared/meshes/made/hand.ovm', import.meta.url)))
  const [plain] = readAll({ 'a.ovm': text }) as [Mesh]
  const lines = text.split('\n').map((line, i) => (i === 0 || line === '' ? line : `# ${line}\n${line}`))
  const [commented] = readAll({ 'a.ovm': lines.join('\n') }) as [Mesh]
  expect(commented.cells).toEqual(plain.cells)
})

test('Gmsh’s MATLAB: quadrilaterals of eight nodes are no hexahedra', () => {
  const text = `msh.POS = [\n${CUBE.map(point => `${point};`).join('\n')}\n];\nmsh.QUADS8 =[\n 1 2 3 4 5 6 7 8 1\n];\nmsh.HEXAS =[\n 1 2 3 4 5 6 7 8 1\n];\n`
  const [mesh] = readAll({ 'a.m': text }) as [Mesh]
  expect(mesh.cells.length).toBe(8)
})

test('what is said of a file beside has a name that is safe to show', () => {
  const item = '<DataItem Dimensions="8 3" Format="HDF">a\u202e.h5:/x</DataItem>'
  const grid = `<Grid><Topology TopologyType="Hexahedron"><DataItem Dimensions="1 8" Format="HDF">a.h5:/x</DataItem></Topology><Geometry>${item}</Geometry></Grid>`
  const hdf5 = {
    isWhole: true,
    read: () => [],
    numbers: ({ name }: MeshFile) => `${name}: no.`,
  }
  const find = () => fileOf('a\u202e.h5', 'no')
  expect(() => readMeshes(fileOf('a.xdmf', `<Xdmf><Domain>${grid}</Domain></Xdmf>`), { find, hdf5 })).toThrow(
    'a.h5: no.',
  )
})

describe('Code_Aster', () => {
  const mail = (names: readonly string[], element: string, rest = '') =>
    `COOR_3D\n${CUBE.map((point, i) => `${names[i]} ${point}`).join('\n')}\nFINSF\nHEXA8\n${element} ${names.join(' ')}\nFINSF\n${rest}FIN\n`
  const read = (text: string) => readAll({ 'a.mail': text })[0] as Mesh
  const numbered = CUBE.map((_, i) => `N${i + 1}`)

  test.each<readonly string[][]>([
    [numbered],
    [CUBE.map((_, i) => `NO${String(7 * i).padStart(6, '0')}`)],
    [['A', 'B', 'C', 'D', '1', '22', 'N7X', `N${'9'.repeat(20)}`]],
    [CUBE.map((_, i) => `${'long'.repeat(9)}${'ABCDEFGH'[i]}${i}`)],
  ])('names %j', names => {
    const mesh = read(mail(names, 'M007', `GROUP_MA NOM = core\nM007 % M8\nFINSF\n`))
    expect(verticesOf(mesh, 0)).toEqual(CUBE.join(' ').split(' ').map(Number))
    expect([mesh.ids, mesh.blocks.map(({ name, cells }) => [name, ...cells])]).toEqual([['M007'], [['core', 0]]])
  })

  test('names, comments and commas across the chunks in which they are read', () => {
    const comments = `% ${'x'.repeat(700)}\n`.repeat(4000)
    const names = numbered.join(`\n${comments}`)
    const text = mail(numbered, 'M1').replace(numbered.join(' '), () => `${names},`)
    expect(read(text).cells).toEqual(Uint32Array.of(0, 1, 2, 3, 4, 5, 6, 7))
  })

  test.each<readonly [string, RegExp]>([
    [mail(numbered.with(7, 'N1'), 'M1'), /: node “N1” is defined twice\.$/],
    [
      mail(numbered, 'M1').replace('M1 N1', 'M1 N11'),
      /^a\.mail, line 12: element “M1” names node “N11”, which is not defined\.$/,
    ],
    [mail(numbered, 'M1').replace('N7 N8\nFINSF\nF', 'N7\nFINSF\nF'), /: element “M1” has 7 nodes; HEXA8 has 8\.$/],
    [mail(numbered, 'M1', `HEXA8\nM1 ${numbered.join(' ')}\nFINSF\n`), /: element “M1” is defined twice\.$/],
    [mail(numbered, 'M1').replace(/FINSF\nFIN\n$/, ''), /: the file ends where FINSF was expected\.$/],
  ])('is refused, %#', (text, sentence) => {
    expect(refusal({ 'a.mail': text })).toMatch(sentence)
  })
})

test('Exodus: a node that is not there is told of, in whatever numbers', () => {
  const bytes = exodusOf(5)
  const whole = Buffer.from(bytes)
  // The nodes of the first cell are 1, 2, 7, 6, 26, 27, 32, 31: their bytes stand once.
  const begin = whole.indexOf(Buffer.from([0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 7, 0, 0, 0, 6, 0, 0, 0, 26]))
  for (const node of [0, -1, 126, 2 ** 31 - 1, -(2 ** 31)]) {
    const changed = Buffer.from(bytes)
    changed.writeInt32BE(node, begin + 8)
    expect(refusal({ 'a.e': new Uint8Array(changed) })).toMatch(
      new RegExp(`element \\d+ in connect1 names node ${node}; the nodes are 1 to 125\\.$`),
    )
  }
})
