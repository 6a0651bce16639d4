import { describe, expect, it } from 'vitest'
import { expectCells, expectPaste, linear, readShared, readText, verticesOf } from './mesh-expectations'

const CUBE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const point = (v: number) => CUBE.slice(3 * v, 3 * v + 3)
const columns = (width: number, ...values: (number | string)[]) =>
  values.map(value => String(value).padStart(width)).join('')
const nodes = (id = 8, real = 16) =>
  `${Array.from({ length: 8 }, (_, v) => columns(id, v + 1) + columns(real, ...point(v).map(x => x.toFixed(1)))).join('\n')}\n`
const NODES = `*KEYWORD\n*NODE\n${nodes()}`
const ONE = [1, 2, 3, 4, 5, 6, 7, 8]

function refusal(text: string, others: Readonly<Record<string, string>> = {}): string {
  try {
    return `read ${readText('a.k', text, others).cells.length / 8}`
  } catch (error) {
    return (error as Error).message
  }
}

const cubeOf = (text: string) => verticesOf(readText('a.k', text), 0)

describe('files of ../shared', () => {
  it('reads gmsh.key', () => {
    const mesh = readShared('meshes/made/gmsh.key')
    expect(mesh.cells.length / 8).toBe(15)
    expectCells(mesh, linear, 1e-9)
    // Gmsh has written no pyramid.
    expect(Object.fromEntries(mesh.other)).toEqual({ quadrilateral: 2, tetrahedron: 2, wedge: 1 })
  })

  it('reads paste 21', () => {
    expectPaste('21')
  })
})

describe('columns', () => {
  it.each([
    ['on one line', `*ELEMENT_SOLID\n${columns(8, 5, 1, ...ONE)}`],
    ['on two lines', `*ELEMENT_SOLID\n$ a comment\n${columns(8, 5, 1)}\n$\n${columns(8, ...ONE)}`],
    [
      'of ten nodes, two of them 0',
      `*ELEMENT_SOLID (ten nodes format)\n${columns(8, 5, 1)}\n${columns(8, ...ONE, 0, 0)}`,
    ],
    ['between commas', `*Element_Solid\n5,1\n${ONE}`],
    ['wide', `*ELEMENT_SOLID +\n${columns(20, 5, 1, ...ONE)}`],
    ['of ten columns', `*ELEMENT_SOLID %\n${columns(10, 5, 1)}\n${columns(10, ...ONE)}`],
    [
      'with axes',
      `*ELEMENT_SOLID_ORTHO\n${columns(8, 5, 1, ...ONE)}\n${columns(16, '1.0', '0.0', '0.0')}\n${columns(16, '0.0', '1.0', '0.0')}`,
    ],
    ['of thick shells', `*ELEMENT_TSHELL\n${columns(8, 5, 1, ...ONE)}`],
    ['at blanks', `*ELEMENT_SOLID\n5 1 1 2 3 4 5 6 7 8`],
  ])('reads elements %s', (_, text) => {
    const mesh = readText('a.k', `${NODES}${text}\n*END\n`)
    expect(verticesOf(mesh, 0)).toEqual(CUBE)
    expect([Array.from(mesh.ids as Float64Array), mesh.cells.length]).toEqual([[5], 8])
  })

  it('reads several elements with axes', () => {
    const axes = `${columns(16, '1.0', '0.0', '0.0')}\n${columns(16, '0.0', '1.0', '0.0')}\n`
    const one = (id: number) => `${columns(8, id, 1)}\n${columns(8, ...ONE)}\n${axes}`
    expect(readText('a.k', `${NODES}*ELEMENT_SOLID_ORTHO\n${one(1)}${one(2)}${one(3)}`).cells.length / 8).toBe(3)
  })

  it('reads wide files', () => {
    const text = `*KEYWORD LONG=Y\n*NODE\n${nodes(20, 20)}*ELEMENT_SOLID\n${columns(20, 5, 1)}\n${columns(20, ...ONE)}\n*NODE -\n${columns(8, 9)}${columns(16, 1, 2, 3)}\n*END`
    const mesh = readText('a.k', text)
    expect(verticesOf(mesh, 0)).toEqual(CUBE)
    expect(mesh.points.length / 3).toBe(9)
  })

  it('reads nodes at blanks, and words that touch in columns', () => {
    const blank = Array.from({ length: 8 }, (_, v) => `${v + 1} ${point(v).join(' ')}`).join('\n')
    expect(cubeOf(`*KEYWORD\n*NODE\n${blank}\n*ELEMENT_SOLID\n${columns(8, 5, 1, ...ONE)}\n`)).toEqual(CUBE)
    const touching = nodes().replace(
      '             0.0             0.0             0.0',
      '-1.23456789E-001-1.23456789E-0011.234567890E+001',
    )
    expect(cubeOf(`*KEYWORD\n*NODE\n${touching}*ELEMENT_SOLID\n${columns(8, 5, 1, ...ONE)}\n`).slice(0, 3)).toEqual([
      -0.123456789, -0.123456789, 12.3456789,
    ])
  })
})

describe('elements', () => {
  it('counts others by type', () => {
    const text = `${NODES}*ELEMENT_SOLID\n${columns(8, 1, 1, 1, 2, 3, 4, 4, 4, 4, 4)}\n${columns(8, 2, 1, 1, 2, 3, 4, 5, 5, 6, 6)}\n${columns(8, 3, 1)}\n${columns(8, ...ONE, 1, 2)}\n*ELEMENT_SHELL_THICKNESS\n${columns(8, 4, 1, 1, 2, 3, 3)}\n${columns(16, 1, 1, 1, 1)}\n${columns(8, 5, 1, 1, 2, 3, 4)}\n${columns(16, 1, 1, 1, 1)}\n*ELEMENT_BEAM\n${columns(8, 6, 1, 1, 2, 3)}\n*ELEMENT_MASS\n${columns(8, 7, 1)}\n`
    const mesh = readText('a.k', text)
    expect([mesh.cells.length, Object.fromEntries(mesh.other)]).toEqual([
      0,
      { tetrahedron: 2, wedge: 1, triangle: 1, quadrilateral: 1, line: 1, other: 1 },
    ])
  })

  it('reads elements of 20 nodes, which are not trilinear', () => {
    const text = `${NODES}*ELEMENT_SOLID_H20\n${columns(8, 1, 1)}\n${columns(8, ...ONE, 1, 2)}\n${columns(8, 3, 4, 5, 6, 7, 8, 1, 2, 3, 4)}\n`
    const mesh = readText('a.k', text)
    expect([mesh.cells.length, mesh.notTrilinear.corners.length, mesh.notTrilinear.straight]).toEqual([0, 8, 0])
  })

  it('knows parts by their titles', () => {
    const text = `*KEYWORD\n*PART\n$# title\nThe beam\n${columns(10, 1, 1, 1)}\n\n*PART\nThe plate\n${columns(10, 2, 1, 1)}\nAnother\n${columns(10, 4, 1, 1)}\n*NODE\n${nodes()}*ELEMENT_SOLID\n${columns(8, 5, 1, ...ONE)}\n${columns(8, 6, 2, ...ONE)}\n${columns(8, 7, 3, ...ONE)}\n${columns(8, 8, 4, ...ONE)}\n`
    expect(readText('a.k', text).blocks.map(({ name, cells }) => [name, Array.from(cells)])).toEqual([
      ['The beam', [0]],
      ['The plate', [1]],
      ['Part 3', [2]],
      ['Another', [3]],
    ])
  })
})

describe('files', () => {
  const main = `*KEYWORD\n*INCLUDE\nnodes.k\n*ELEMENT_SOLID\n${columns(8, 5, 1, ...ONE)}\n*END\n*NODE\n1,9,9,9\n`
  it('includes files, and asks for those that are missing', () => {
    expect(refusal(main)).toBe(
      'a.k, line 3: *INCLUDE names “nodes.k”, which is missing: give it together with this file.',
    )
    expect(verticesOf(readText('a.k', main, { 'nodes.k': `${NODES}*END\n` }), 0)).toEqual(CUBE)
  })

  it.each([
    '*INCLUDE_TRANSFORM\nb.k',
    '*NODE_TRANSFORM\n1',
    '*ELEMENT_SOLID_PERI\n1,1',
    '*ELEMENT_TSHELL_COMPOSITE\n1,1',
  ])('refuses %s by its name', text => {
    expect(refusal(`${NODES}${text}\n`)).toContain(text.slice(0, text.indexOf('\n')))
  })

  it('refuses what is short or wrong, with its place', () => {
    const element = `*ELEMENT_SOLID\n${columns(8, 5, 1, ...ONE)}\n`
    expect(
      refusal(`${NODES}*ELEMENT_SOLID\n${columns(8, 5, 1, 1, 2, 3, 4, 5, 6)}\n${columns(8, 6, 1, ...ONE)}\n`),
    ).toBe('a.k, line 12: element 5 has 6 nodes; 8 were expected.')
    expect(refusal(`${NODES}*ELEMENT_SOLID\n${columns(8, 5, 1)}\n*END\n`)).toBe(
      'a.k, line 12: element 5 has no line of nodes.',
    )
    expect(refusal(`${NODES.replace(/(\n {7}5.*?) +\S+\n/, '$1\n')}${element}`)).toBe(
      'a.k, line 7: node 5 has 2 coordinates, not 3.',
    )
    expect(refusal(`${NODES}*ELEMENT_SOLID\n5,1,1,2,3,4,5,6,7,99\n`)).toBe(
      'a.k: element 5 names node 99, which is not defined.',
    )
    expect(refusal(`${NODES}1,2,2,2\n${element}`)).toBe(
      'a.k, line 11: node 1 is defined again, with other coordinates.',
    )
    expect(refusal(`${NODES}9,&x,0,0\n${element}`)).toBe('a.k, line 11: “&x” is not a number.')
  })
})
