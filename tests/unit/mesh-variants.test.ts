/** Rarer ways in which texts have points and cells, each with one hexahedron whose vertices are all different. */
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { loadReadingCore } from '../../web/core/reading-core'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { textFile, verticesOf } from './mesh-expectations'

const core = await loadReadingCore(readFileSync(new URL('../../build/hexlens-reading.wasm', import.meta.url)))

const POINTS = [
  [0.5, 0.25, -1],
  [2, 0, 0.125],
  [2.5, 1.5, 0],
  [0, 1, 0.75],
  [0, 0.5, 2],
  [1.5, 0, 2.25],
  [3, 2, 3],
  [0.25, 1, 2],
] as const
type Point = (typeof POINTS)[number]
const ELEMENT = POINTS.flat()
/** Points and nodes in rows of x, y and z. */
const [SORTED, NODES] = [[0, 1, 3, 2, 4, 5, 7, 6].map(v => POINTS[v] as Point), [1, 2, 4, 3, 5, 6, 8, 7]]

const each = (line: (point: Point, i: number) => string, points: readonly Point[] = POINTS) =>
  points.map(line).join('\n')

function meshOf(text: string, name = 'a.txt'): Mesh {
  const meshes = readMeshes(textFile(name, text))
  expect(meshes).toHaveLength(1)
  return meshes[0] as Mesh
}

function refusal(text: string): string {
  try {
    return `read as ${meshOf(text).format}`
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
}

const decimal = (value: number) => value.toFixed(3).replace('.', ',')

describe('points', () => {
  test.each<readonly [string, string]>([
    ['decimal commas in quotes', each(p => p.map(x => `"${decimal(x)}"`).join(';'))],
    ['decimal commas in brackets', each((p, i) => `P${i + 1} = (${p.map(decimal).join('; ')})`)],
    ['decimal commas before commas', each(p => p.map(decimal).join(', '))],
    ['a table with bars of a box', each(p => `│ ${p.join(' ┆ ')} │`)],
    ['numbers over the columns', `   0  1  2\n${each((p, i) => `${i} ${p.map(x => x.toFixed(3)).join(' ')}`)}`],
    ['floats of Julia', each(p => `Point{3, Float32}(${p.map(x => `${x.toFixed(3)}f0`).join(', ')})`)],
    [
      'numbers of Mathematica with their precision',
      `{${each(p => `{${p.map(x => `${x}\`15.95`).join(', ')}}`).replaceAll('\n', ', ')}}`,
    ],
    ['a line for each coordinate', each(([x, y, z]) => `- x: ${x}\n  y: ${y}\n  z: ${z}`)],
    ['structures', each(([x, y, z]) => `Vec3 {\n    x: ${x},\n    y: ${y},\n    z: ${z},\n},`)],
    [
      'three calls of a library',
      ['x', 'y', 'z'].map((axis, k) => `${axis} = np.array([${POINTS.map(p => p[k])}])`).join('\n'),
    ],
    ['a second number behind that of the node', each((p, i) => `${i + 1} 0 ${p.join(' ')}`)],
    ['a size and a number behind', each((p, i) => `model.geo.addPoint(${p.join(', ')}, 1.0, ${i + 1})`)],
    ['ends of lines of old Macs', each(p => p.join(' ')).replaceAll('\n', '\r')],
    ['powers of ten as papers have them', each(p => p.map(x => `${1000 * x}×10⁻³`).join('  '))],
    ['powers of ten of LaTeX', each(p => `${p.map(x => `${x / 100} \\times 10^{2}`).join(' & ')} \\\\`)],
    ['decimal commas of LaTeX', each(p => `${p.map(x => decimal(x).replace(',', '{,}')).join(' & ')} \\\\`)],
    ['numbers in a macro of LaTeX', each(p => `${p.map(x => `\\num{${x}}`).join(' & ')} \\\\`)],
    ['fractions', `Matrix([${POINTS.map(p => `[${p.map(x => `${8 * x}/8`)}]`).join(', ')}])`],
    ['a list with its numbers', each((p, i) => `${i + 1}. ${p.join(', ')}`)],
    ['points called by letters', each((p, i) => `${'ABCDEFGH'[i]}(${p.join('|')})`)],
    ['homogeneous coordinates', each(p => `[${p.join(', ')}, 1.0]`)],
    [
      'displacements below',
      `NODE X Y Z\n${each((p, i) => `${i + 1} ${p.join(' ')}`)}\n\nNODE UX UY UZ\n${each((p, i) => `${i + 1} ${p.join(' ')}`)}`,
    ],
    ['points of a quadrature below', `nodes:\n${each(p => p.join(' '))}\ngauss points:\n${each(p => p.join(' '))}`],
    ['a matrix below', `${each(p => p.join(' '))}\nJ =\n1 0 0\n0 1 0\n0 0 1\n`],
  ])('%s', (_, text) => {
    const mesh = meshOf(text)
    expect(verticesOf(mesh, 0)).toEqual(ELEMENT)
    expect([mesh.cells.length, mesh.isOrderStated]).toEqual([8, false])
  })

  test('thousands of a German table', () => {
    const text = each(p =>
      p.map(x => (1000 * (x + 2)).toLocaleString('de-DE', { minimumFractionDigits: 2 })).join('\t'),
    )
    expect(text).toContain('2.125,00')
    expect(verticesOf(meshOf(text), 0)).toEqual(ELEMENT.map(x => 1000 * (x + 2)))
  })
})

test('commas between thousands', () => {
  const text = each(p => p.map(x => (1000 * (x + 2)).toLocaleString('en-US', { minimumFractionDigits: 2 })).join('\t'))
  expect(text).toContain('2,125.00')
  expect(verticesOf(meshOf(text), 0)).toEqual(ELEMENT.map(x => 1000 * (x + 2)))
})

test('columns that are not Cartesian are refused', () => {
  expect(refusal(`r theta z\n${each(p => p.join(' '))}`)).toBe(
    'a.txt: a column is called “r”: Cartesian x, y and z are read.',
  )
})

describe('points and cells', () => {
  const calls = each((p, i) => `ops.node(${i + 1}, ${p.join(', ')})`, SORTED)
  test.each<readonly [string, string]>([
    ['a material behind the nodes', `${calls}\nops.element('stdBrick', 1, ${NODES.join(', ')}, 1)`],
    ['the same without a number', `${each(p => p.join(' '), SORTED)}\n\nhex\n${NODES.join(' ')} 1`],
    [
      'lists in the function of a mesh',
      `ElementMesh[{${each(p => `{${p.join(', ')}}`, SORTED).replaceAll('\n', ', ')}}, {HexahedronElement[{{${NODES}}}]}]`,
    ],
    [
      'objects of points and of elements',
      JSON.stringify({
        nodes: SORTED.map((coords, i) => ({ id: i + 1, coords })),
        elements: [{ id: 7, type: 'hexa8', nodes: NODES }],
      }),
    ],
    [
      'lists in quotes',
      `nodal_positions = '${each(p => p.join(' '), SORTED)}'\nelement_connectivity = '${NODES.map(n => n - 1).join(' ')}'`,
    ],
    [
      'nodes set one by one',
      `${each((p, i) => `mesh.add_point(Point(${p.join(', ')}), ${i});`, SORTED)}\n${NODES.map((node, i) => `elem->set_node(${i}) = mesh.node_ptr(${node - 1});`).join('\n')}`,
    ],
    [
      'hyphens between the nodes',
      `${each((p, i) => `${i + 1} ${p.join(' ')}`, SORTED)}\n\nnodes: ${NODES.join('-')}\n`,
    ],
    [
      'a line for each node',
      `${each((p, i) => `${i + 1} ${p.join(' ')}`, SORTED)}\nconnectivity\n${NODES.join('\n')}\n`,
    ],
    [
      'nodes with their places',
      `${each((p, i) => `${i + 1} ${p.join(' ')}`, SORTED)}\n\n${NODES.map((node, i) => `N${i + 1}=${node}`).join(' ')}\n`,
    ],
    [
      'assignments of nodes',
      `double p[8][3]={${SORTED.map(p => `{${p}}`)}};\nint conn[8];\n${NODES.map((node, i) => `conn[${i}] = ${node - 1};`).join(' ')}\n`,
    ],
    [
      'ids inserted one by one',
      `${each(p => `points->InsertNextPoint(${p});`, SORTED)}\n${NODES.map(node => `ids->InsertNextId(${node - 1});`).join('\n')}\n`,
    ],
  ])('%s', (_, text) => {
    const mesh = meshOf(text)
    expect(verticesOf(mesh, 0)).toEqual(ELEMENT)
    expect([mesh.cells.length, mesh.isOrderStated]).toEqual([8, true])
  })
})

test.each([
  ['invalid', (p: Point, i: number) => (i === 6 ? [0.5, 0.5, 0.5] : p)],
  ['mirrored', ([x, y, z]: Point) => [10 - x, y, z]],
])('eight nodes of ten numbers, in an element that is %s', (_, placed) => {
  const points = POINTS.map(placed)
  const text = `nodes\n${points.map((p, i) => `${i + 1} ${p.join(' ')}`).join('\n')}\nelements\n1 1 2 3 4 5 6 7 8 1\n`
  expect(verticesOf(meshOf(text), 0)).toEqual(points.flat())
})

describe('formats', () => {
  test('MFEM: meshes of NURBS patches are refused by name', () => {
    expect(refusal(`MFEM NURBS NC-patch mesh v1.0\n\ndimension\n3\n${each(p => p.join(' '))}\n`)).toMatch(
      /^a\.txt, line 1: this is an MFEM NURBS NC-patch mesh; /,
    )
  })

  test('LS-DYNA: words beside their columns', () => {
    const line = (first: number, rest: readonly (number | string)[], width: number) =>
      `${String(first).padStart(9)}${rest.map(value => String(value).padStart(width)).join('')}`
    for (const id of [7, 12]) {
      const nodes = POINTS.map((p, i) => line(i + 1, p, 16)).join('\n')
      const text = `*KEYWORD\n*NODE\n${nodes}\n*ELEMENT_SOLID\n${line(id, [1, 1, 2, 3, 4, 5, 6, 7, 8], 8)}\n*END\n`
      const mesh = meshOf(text, 'a.k')
      expect([Array.from(mesh.ids as Float64Array), verticesOf(mesh, 0)]).toEqual([[id], ELEMENT])
    }
  })

  test('Kratos: geometries beside elements are the same cells', () => {
    const nodes = `Begin Nodes\n${each((p, i) => `${i + 1} ${p.join(' ')}`)}\nEnd Nodes\n`
    const geometries = 'Begin Geometries Hexahedra3D8\n3 1 2 3 4 5 6 7 8\nEnd Geometries\n'
    const elements = 'Begin Elements Element3D8N\n7 0 1 2 3 4 5 6 7 8\nEnd Elements\n'
    expect(Array.from(meshOf(nodes + elements + geometries).ids as Float64Array)).toEqual([7])
    expect(Array.from(meshOf(nodes + geometries).ids as Float64Array)).toEqual([3])
  })

  test.each([null, core])('Gmsh 4.0: heads of blocks that look like nodes', own => {
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(v => [v & 1, (v >> 1) & 1, v >> 2])
    const nodes = corners.map((p, i) => `${i + 1} 0 0 1\n${i + 1} ${p.join(' ')}`).join('\n')
    const text = `$MeshFormat\n4 0 8\n$EndMeshFormat\n$Nodes\n8 8\n${nodes}\n$EndNodes\n$Elements\n1 1\n1 3 5 1\n7 ${NODES.join(' ')}\n$EndElements\n`
    const [mesh] = readMeshes(textFile('a.msh', text), { core: own }) as [Mesh]
    expect(verticesOf(mesh, 0)).toEqual(NODES.flatMap(node => corners[node - 1] as number[]))
  })

  const twenty = Array.from({ length: 20 }, (_, i) => (i % 8) + 1)
  const lines = each((p, i) => `${i + 1} ${p.join(' ')}`)
  const key = `*KEYWORD\n*NODE\n${lines.replaceAll(' ', ',')}\n*ELEMENT_SOLID_H20\n7,1,${twenty.slice(0, 8)},\n${twenty.slice(8, 19)},\n${twenty[19]}\n*END\n`
  const medit = `MeshVersionFormatted 2\nDimension 3\nVertices\n8\n${each(p => `${p.join(' ')} 0`)}\nHexahedra\n1\n${twenty.join(' ')} 1\nEnd\n`
  const unvNodes = each((p, i) => `${i + 1} 1 1 11\n${p.join(' ')}`)
  const unv = `    -1\n  2411\n${unvNodes}\n    -1\n    -1\n  2412\n 7 115 1 0 7 20\n${twenty.slice(0, 8).join(' ')}\n${twenty.slice(8).join(' ')}\n    -1\n`
  const matlab = `msh.nbNod = 8;\nmsh.POS = [\n${each(p => `${p.join(' ')};`)}\n];\nmsh.HEXAS20 =[\n${twenty.join(' ')} 7\n];\n`
  test.each([
    ['LS-DYNA', key],
    ['Medit', medit],
    ['UNV', unv],
    ['MATLAB', matlab],
  ])('%s: hexahedra of 20 nodes as Gmsh writes them', (_, text) => {
    const { cells, notTrilinear } = meshOf(text)
    expect([cells.length, [...notTrilinear.corners]]).toEqual([0, [0, 1, 2, 3, 4, 5, 6, 7]])
  })

  test('SU2: borders of parts', () => {
    const text = `NDIME= 3\nNELEM= 1\n12 0 1 2 3 4 5 6 7\nNPOIN= 8\n${each(p => p.join(' '))}\nNMARK= 1\nMARKER_TAG= SEND_RECEIVE\nMARKER_ELEMS= 1\nSEND_TO= 1\n1 0 0\n`
    expect(verticesOf(meshOf(text), 0)).toEqual(ELEMENT)
  })

  test('Abaqus: ends of lines of old Macs', () => {
    const text = `*NODE\n${each((p, i) => `${i + 1}, ${p.join(', ')}`)}\n*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n`
    expect(verticesOf(meshOf(text.replaceAll('\n', '\r'), 'a.inp'), 0)).toEqual(ELEMENT)
  })
})

describe('decks without their end', () => {
  const nodes = POINTS.map((p, i) => [i + 1, ...p] as const)
  const bdf = `BEGIN BULK\n${nodes.map(([id, ...p]) => `GRID,${id},,${p.map(x => x.toFixed(3))}`).join('\n')}\nCHEXA,7,1,1,2,3,4,5,6\n,7,8\n`
  const key = `*KEYWORD\n*NODE\n${nodes.map(row => row.join(',')).join('\n')}\n*ELEMENT_SOLID\n7,2,1,2,3,4,5,6,7,8\n`
  test.each([
    ['a.bdf', bdf, 'ENDDATA'],
    ['a.k', key, '*END'],
  ])('%s', (name, text, end) => {
    expect(meshOf(text, name).notes).toEqual([`The text does not end with ${end}: it may be cut off.`])
    expect(meshOf(`${text}${end}\n`, name).notes).toEqual([])
  })
})
