import { readdirSync, readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { core } from './core-fixtures'

const made = new URL('../../../shared/meshes/made/', import.meta.url)
const manifest = JSON.parse(readFileSync(new URL('manifest.json', made), 'utf8'))

function read(bytes: Uint8Array | string, name: string): Mesh {
  const [mesh] = readMeshes(fileOfBytes(name, typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytes))
  return mesh as Mesh
}

function refusal(bytes: Uint8Array | string, name: string): string {
  try {
    return `read as ${read(bytes, name).format}`
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
}

function verticesOf({ cells, points }: Mesh, i: number): number[] {
  return [...cells.subarray(8 * i, 8 * i + 8)].flatMap(point => [...points.subarray(3 * point, 3 * point + 3)])
}

interface Linear {
  readonly name: string
  readonly valid: boolean
  readonly min_lower: number
  readonly min_upper: number
}

describe('the mesh that was written in many formats', () => {
  test.each([
    ['gmsh.unv', [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14], { quadrilateral: 2, tetrahedron: 2, wedge: 1 }],
    ['meshio-tec.dat', [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14], {}],
    [
      'gmsh.m',
      [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14],
      { quadrilateral: 2, tetrahedron: 2, wedge: 1, pyramid: 1 },
    ],
    ['hand.ovm', [0, 1, 3, 4], {}],
  ])('%s', (file, which, other) => {
    const mesh = read(readFileSync(new URL(file, made)), file)
    expect(mesh.cells.length / 8).toBe(which.length)
    expect(Object.fromEntries(mesh.other)).toEqual(other)
    expect(mesh.isOrderStated).toBe(true)
    for (const [i, cell] of which.entries()) {
      const wanted: Linear = manifest.linear[cell]
      const result = core.analyze(verticesOf(mesh, i))
      if (!result.ok) throw new Error(wanted.name)
      const least = result.value.boundaryMinimum * 2 ** result.value.exponent
      expect(result.value.valid, wanted.name).toBe(wanted.valid)
      if (!wanted.valid) continue
      expect(least).toBeGreaterThanOrEqual(wanted.min_lower * (1 - 1e-12))
      expect(least).toBeLessThanOrEqual(wanted.min_upper * (1 + 1e-12))
    }
  })
})

const REFUSED = /^gmsh\.diff$/

describe('what is refused by name', () => {
  test.each(readdirSync(made).filter(name => REFUSED.test(name)))('%s', name => {
    expect(refusal(readFileSync(new URL(name, made)), name)).toMatch(
      /: this is an? .*\. Hexlens does not read it yet; .*\.$/,
    )
  })

  test('by their content, whatever they are called', () => {
    expect(refusal(readFileSync(new URL('gmsh.diff', made)), 'a')).toMatch(/Diffpack/)
  })

  test('OpenFOAM’s files alone', () => {
    for (const name of ['points', 'faces', 'owner', 'neighbour', 'boundary'])
      expect(refusal(readFileSync(new URL(`foam/constant/polyMesh/${name}`, made)), name), name).toMatch(
        /it needs .*“(?:owner|neighbour)” of the same folder beside it: give all files of polyMesh together\.$/,
      )
  })

  test.each([
    ['mesh.nodes', '1 -1 0 0 0\n2 -1 1 0 0\n', /it needs “mesh\.elements” beside it/],
    ['a.stl', 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n', /STL/],
    ['a.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', /surface/],
    ['a.pdf', '%PDF-1.7', /PDF/],
    ['a.zip', 'PK\x03\x04', /zip/],
    ['a.html', '<!DOCTYPE html><p>1', /web page/],
    ['a.step', 'ISO-10303-21;', /STEP/],
  ])('%s', (name, text, sentence) => {
    expect(refusal(text, name)).toMatch(sentence)
  })

  test('images and other binary files', () => {
    expect(refusal(new Uint8Array([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0]), 'a.vtu')).toMatch(/image/)
    expect(refusal(new Uint8Array([1, 0, 2, 0, 3]), 'a.bin')).toMatch(/no format that is known/)
  })
})

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const corners = Array.from({ length: 8 }, (_, v) => cube.slice(3 * v, 3 * v + 3))
const numbered = corners.map((point, v) => `${v + 1} ${point.join(' ')}`).join('\n')

describe('UCD', () => {
  const file = (nodes: string, type = 'hex') => `8 2 0 0 0\n${numbered}\n7 1 ${type} ${nodes}\n8 1 tet 1 2 3 5\n`
  test('bottom first, or top first', () => {
    for (const nodes of ['1 2 3 4 5 6 7 8', '5 6 7 8 1 2 3 4']) {
      const mesh = read(file(nodes), 'a.inp')
      expect([verticesOf(mesh, 0), mesh.ids?.[0], mesh.other.get('tetrahedron')]).toEqual([cube, 7, 1])
    }
  })
  test('refusals', () => {
    expect(refusal(file('1 2 3 4 5 6 7 99'), 'a.inp')).toMatch(/cell 7 names node 99/)
    expect(refusal(file('1 2 3 4 5 6 7'), 'a.inp')).toMatch(/is not the number|names node|type/)
    expect(refusal(file('1 2 3 4 5 6 7 8').slice(0, 60), 'a.inp')).toMatch(/ends/)
    expect(refusal(`9999999999 1 0 0 0\n1 0 0 0\n1 1 hex 1 1 1 1 1 1 1 1`, 'a.inp')).toMatch(/line/)
  })
})

describe('Kratos', () => {
  const file = (type: string, nodes: string) =>
    `Begin Properties 0\nEnd Properties\nBegin Nodes\n${numbered}\nEnd Nodes // nodes\nBegin Elements ${type}\n 5 0 ${nodes}\nEnd Elements\nBegin SubModelPart a\n Begin SubModelPartNodes\n 1\n End SubModelPartNodes\nEnd SubModelPart\n`
  test('elements of eight and of four nodes', () => {
    const mesh = read(file('Element3D8N', '1 2 3 4 5 6 7 8'), 'a.mdpa')
    expect([verticesOf(mesh, 0), mesh.ids?.[0]]).toEqual([cube, 5])
    expect(read(file('Element3D4N', '1 2 3 5'), 'a.mdpa').other.get('tetrahedron')).toBe(1)
  })
  test('refusals', () => {
    expect(refusal(file('Element3D8N', '1 2 3 4'), 'a.mdpa')).toMatch(/has 4 nodes/)
    expect(refusal(file('Element3D8N', '1 2 3 4 5 6 7 x'), 'a.mdpa')).toMatch(/“x”/)
    expect(refusal(file('Element3D8N', '1 2 3 4 5 6 7 8').split('End Elements')[0] as string, 'a.mdpa')).toMatch(/ends/)
  })
})

describe('Tecplot', () => {
  const points = corners.map(point => point.join(' ')).join('\n')
  test.each([
    [
      'points',
      `TITLE = "a"\nVARIABLES = "X", "Y", "Z", "T"\nZONE T="b, c=1", NODES=8, ELEMENTS=1,\n DATAPACKING=POINT, ZONETYPE=FEBRICK\n${corners.map(p => `${p.join(' ')} 20.5`).join('\n')}\n1 2 3 4 5 6 7 8\n`,
    ],
    ['old', `VARIABLES = X Y Z\nZONE N=8, E=1, F=FEPOINT, ET=BRICK\n${points}\n1 2 3 4 5 6 7 8\n`],
    [
      'blocks, of cells too',
      `# c\nVARIABLES = "T" "x" "y" "z"\nZONE NODES=8 ELEMENTS=1 ZONETYPE=FEBRICK DATAPACKING=BLOCK VARLOCATION=([1]=CELLCENTERED)\n20.5\n${[0, 1, 2].map(axis => corners.map(p => p[axis]).join(' ')).join('\n')}\n1 2 3 4 5 6 7 8\n`,
    ],
    [
      'two zones',
      `VARIABLES = "X" "Y" "Z"\nZONE N=8 E=1 ZONETYPE=FEBRICK\n${points}\n1 2 3 4 5 6 7 8\nZONE N=8 E=1 ZONETYPE=FEBRICK\n${points}\n1 2 3 4 5 6 7 8\n`,
    ],
  ])('%s', (_, text) => {
    const mesh = read(text, 'a.dat')
    for (let i = 0; i < mesh.cells.length / 8; i++) expect(verticesOf(mesh, i)).toEqual(cube)
    expect(mesh.cells.length).toBeGreaterThan(0)
  })
  test('refusals', () => {
    const zone = (rest: string) => `VARIABLES = "X" "Y" "Z"\nZONE ${rest}\n${points}\n1 2 3 4 5 6 7 8\n`
    expect(refusal(zone('I=2 J=2 K=2'), 'a.dat')).toMatch(/ORDERED/)
    expect(refusal(zone('N=999999999999 E=1 ZONETYPE=FEBRICK'), 'a.dat')).toMatch(/too short/)
    expect(refusal(zone('N=7 E=1 ZONETYPE=FEBRICK'), 'a.dat')).toMatch(/names node 0/)
    expect(refusal(zone('N=8 E=1 ZONETYPE=FEBRICK VARSHARELIST=([1-3]=1)'), 'a.dat')).toMatch(/shares/)
  })
})

test('UNV: beams, parabolic bricks, other datasets', () => {
  const nodes = corners.map((point, v) => `${v + 1} 1 1 11\n${point.map(x => `${x}.0D+00`).join(' ')}`).join('\n')
  const text = (elements: string) =>
    `    -1\n   164\n 1 units\n 1.0D0 1.0D0\n    -1\n    -1\n  2411\n${nodes}\n    -1\n    -1\n  2412\n${elements}\n    -1\n`
  const mesh = read(text('1 11 1 1 7 2\n0 1 1\n1 2\n4 115 1 1 7 8\n1 2 3 4 5 6 7 8'), 'a.unv')
  expect([verticesOf(mesh, 0), mesh.ids?.[0], mesh.other.get('line')]).toEqual([cube, 4, 1])
  const twenty = [1, 1, 2, 2, 3, 3, 4, 4, 1, 2, 3, 4, 5, 5, 6, 6, 7, 7, 8, 8]
  const parabolic = read(
    text(
      `4 116 1 1 7 20\n${twenty.slice(0, 8).join(' ')}\n${twenty.slice(8, 16).join(' ')}\n${twenty.slice(16).join(' ')}`,
    ),
    'a.unv',
  )
  expect([...parabolic.notTrilinear.corners]).toEqual([0, 1, 2, 3, 4, 5, 6, 7])
  expect(refusal(text('4 115 1 1 7 8\n1 2 3 4 5 6 7 9'), 'a.unv')).toMatch(/names node 9/)
  expect(refusal(text('4 115 1 1 7 8\n1 2 3 4 5 6').slice(0, -8), 'a.unv')).toMatch(/ends|is not/)
})

test('blockMeshDict: names, comments, a scale, curved edges, faces that are no cells', () => {
  const vertices = corners.map((p, v) => `name v${v} (${p.join(' ')}) // ${v}`).join('\n')
  const text = `FoamFile { object blockMeshDict; }\n/* 1 ( */ scale 0.1;\nvertices\n(\n${vertices}\n);\nblocks ( hex (v0 v1 v2 v3 4 5 6 7) zone (20 20 1) simpleGrading (1 ((1 2 3) (1 2 3)) 1) );\nedges ( arc 0 1 (0.5 0.1 0) );\nboundary ( all { type wall; faces ((0 3 2 1) (4 5 6 7)); } );\n`
  const mesh = read(text, 'blockMeshDict')
  expect([verticesOf(mesh, 0), mesh.cells.length, mesh.ids]).toEqual([cube, 8, ['block 0']])
  expect(mesh.notes.join(' ')).toMatch(/scale.*curved/)
  expect(refusal(text.replace('(v0', '(v9'), 'a')).toMatch(/names vertex “v9”/)
  expect(refusal(text.replace('(0 0 0)', '($x 0 0)'), 'a')).toMatch(/only numbers/)
})

test('OVM: refusals', () => {
  const text = readFileSync(new URL('hand.ovm', made), 'latin1')
  expect(refusal(text.slice(0, text.length / 2), 'a.ovm')).toMatch(/line \d+/)
  expect(refusal(text.replace('182', '1e15'), 'a.ovm')).toMatch(/too short/)
})

test('OBJ: a closed box of six faces is a hexahedron', () => {
  const points = corners.map(p => `v ${p.join(' ')}`).join('\n')
  const mesh = read(
    `o box\n${points}\nf 1//1 4//1 3//1 2//1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`,
    'a.obj',
  )
  expect([verticesOf(mesh, 0), mesh.ids, mesh.isOrderStated]).toEqual([cube, ['box'], true])
})
