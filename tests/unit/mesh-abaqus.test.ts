import { describe, expect, it } from 'vitest'
import { readMeshes } from '../../web/mesh/read-mesh'
import {
  expectCells,
  expectPaste,
  linear,
  paste,
  quadratic,
  readShared,
  readText,
  sharedFile,
  validity,
  verticesOf,
} from './mesh-expectations'

const CUBE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const NODES = Array.from({ length: 8 }, (_, v) => `${v + 1}, ${CUBE.slice(3 * v, 3 * v + 3).join(', ')}`).join('\n')
const ELEMENT = '*Element, type=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8'
const PART = `*Part, name=P\n*Node\n${NODES}\n${ELEMENT}, \n*Elset, elset=Both, generate\n 1, 1, 1\n*End Part\n`

function refusal(text: string, others: Readonly<Record<string, string>> = {}): string {
  try {
    const mesh = readText('a.inp', text, others)
    return `read ${mesh.cells.length / 8}`
  } catch (error) {
    return (error as Error).message
  }
}

function moved(text: string): number[] {
  return verticesOf(
    readText('a.inp', `${PART}*Assembly, name=A\n*Instance, name=P-1, part=P\n${text}*End Instance\n*End Assembly\n`),
    0,
  )
}

describe('files of ../shared', () => {
  it('reads gmsh.inp', () => {
    const mesh = readShared('meshes/made/gmsh.inp')
    expect(mesh.cells.length / 8).toBe(15)
    expectCells(mesh, linear)
    expect([...mesh.other]).toEqual([
      ['quadrilateral', 2],
      ['tetrahedron', 2],
      ['wedge', 1],
      ['pyramid', 1],
    ])
    expect(Array.from(mesh.ids as Float64Array).slice(0, 3)).toEqual([3, 4, 5])
    expect(mesh.blocks.map(({ name, cells }) => [name, cells.length])).toEqual([['Volume1', 15]])
    expect(mesh.notes).toEqual([])
  })

  it('reads hand-continued.inp: two instances, elements of 20 nodes', () => {
    const mesh = readShared('meshes/made/hand-continued.inp')
    expect(mesh.cells.length / 8).toBe(30)
    expectCells(mesh, linear)
    expectCells(mesh, linear, 0, 15)
    expect((mesh.ids as string[])[0]).toBe('A-1.5')
    expect(mesh.notTrilinear.corners.length / 8).toBe(6)
    expect(mesh.notTrilinear.straight).toBe(4)
    expectCells(mesh, quadratic, 0, 0, mesh.notTrilinear.corners)
    expect(mesh.blocks.map(({ name }) => name)).toEqual(['A-1', 'A-1.hex', 'A-2', 'A-2.hex'])
  })

  it('refuses a short element by its place', () => {
    expect(() => readMeshes(sharedFile('meshes/malformed/inp-short-element.inp'))).toThrow(
      'inp-short-element.inp, line 11: element 1 has 6 nodes; C3D8 has 8.',
    )
  })

  it.each(['15', '18', '44', '49', '51', '72', '75', '77'])('reads paste %s', prefix => {
    const mesh = expectPaste(prefix)
    if (prefix === '18') expect(mesh.notTrilinear.corners.length / 8).toBe(2)
    if (prefix === '44') expect(validity(mesh)).toMatchObject({ valid: 5996, invalid: 4 })
    if (prefix === '51') expect(validity(mesh)).toMatchObject({ valid: 1, invalid: 0 })
    expect(mesh.isCutOff).toBe(false)
  })

  /** expected.json has the part as it was drawn; the instance B-1 is moved by 10 along x. */
  it('reads paste 19, an instance of it moved', () => {
    const mesh = readShared(`pastes/${paste('19').file}`)
    const [[, first], [, second]] = paste('19').expect as [[string, number[]], [string, number[]]]
    expect(verticesOf(mesh, 0)).toEqual(first)
    expect(verticesOf(mesh, 1)).toEqual(second.map((value, i) => (i % 3 === 0 ? value + 10 : value)))
    expect(validity(mesh)).toMatchObject({ valid: 1, invalid: 1 })
  })

  it('asks for what is included by its name', () => {
    expect(() => readMeshes(sharedFile(`pastes/${paste('17').file}`))).toThrow(
      '17-abaqus-include.inp, line 3: “*INCLUDE” names “mesh_nodes.inp”, which is missing: give it together with this file.',
    )
    const text = new TextDecoder().decode(
      sharedFile(`pastes/${paste('17').file}`)
        .read(0, 1000)
        .filter(byte => byte > 0),
    )
    expect(verticesOf(readText('a.inp', text, { 'mesh_nodes.inp': `*NODE\n${NODES}\n` }), 0)).toEqual(CUBE)
  })
})

describe('lines', () => {
  it('continues keyword lines, also over comments, and data lines', () => {
    const mesh = readText(
      'a.inp',
      `*node,\n** here\nnset=a,\n${NODES}\n*ELEMENT,\nTYPE = "c3d8r",\nelset='My Set'\n7,1,2,3,\n4,5,\n6,7,8\n`,
    )
    expect(verticesOf(mesh, 0)).toEqual(CUBE)
    expect(mesh.blocks.map(({ name }) => name)).toEqual(['My Set'])
  })

  it('reads exponents, D, CRLF and blanks in columns', () => {
    const nodes = NODES.replaceAll('1', '1').replace('2, 1, 0, 0', '  2 , 1.0D+0,\t0.0e0 , .0')
    expect(
      verticesOf(
        readText('a.inp', `*NODE\r\n${nodes.replaceAll('\n', '\r\n')}\r\n${ELEMENT.replaceAll('\n', '\r\n')}`),
        0,
      ),
    ).toEqual(CUBE)
  })

  it.each(['C3D8', 'C3D8R', 'C3D8I', 'C3D8H', 'C3D8T', 'C3D8RH', 'SC8R', 'DC3D8', 'AC3D8', 'CSS8', 'EC3D8R'])(
    'takes %s for a hexahedron',
    type => {
      expect(readText('a.inp', `*NODE\n${NODES}\n${ELEMENT.replace('C3D8', type)}`).cells.length / 8).toBe(1)
    },
  )

  it.each([
    ['S4R', '1,1,2,3,4', 'quadrilateral'],
    ['S8R', '1,1,2,3,4,5,6,7,8', 'quadrilateral'],
    ['M3D8', '1,1,2,3,4,5,6,7,8', 'quadrilateral'],
    ['COH3D8', '1,1,2,3,4,5,6,7,8', 'other'],
    ['C3D10M', '1,1,2,3,4,5,6,7,8,9,10', 'tetrahedron'],
    ['C3D15', '1,1,2,3,4,5,6,7,8,9,10,11,12,\n13,14,15', 'wedge'],
    ['B31', '1,1,2', 'line'],
    ['STRI65', '1,1,2,3,4,5,6', 'triangle'],
    ['CONN3D2', '1, A-1.1, A-2.3', 'other'],
  ])('counts %s apart', (type, line, cell) => {
    const mesh = readText('a.inp', `*NODE\n${NODES}\n*ELEMENT, TYPE=${type}\n${line}\n`)
    expect([mesh.cells.length, [...mesh.other]]).toEqual([0, [[cell, 1]]])
  })

  it('refuses what is short, with its place', () => {
    const short = NODES.replace('5, 0, 0, 1', '5, 0, 0')
    expect(refusal(`*NODE\n${short}\n${ELEMENT}`)).toBe('a.inp, line 6: node 5 has 2 coordinates, not 3.')
    expect(refusal(`*NODE\n${NODES}\n*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7\n2,1,2,3,4,5,6,7,8`)).toBe(
      'a.inp, line 11: element 1 has 7 nodes; C3D8 has 8.',
    )
    expect(refusal(`*NODE\n${NODES}\n${ELEMENT}, 9`)).toBe(
      'a.inp, line 11: element 1 has more than the 8 nodes of C3D8.',
    )
    expect(refusal(`*NODE\n${NODES}\n${ELEMENT.replace('8\n', '8\n').replace('7, 8', '7, 9')}`)).toBe(
      'a.inp: element 1 names node 9, which is not defined.',
    )
    expect(refusal(`*NODE\n${NODES}\n1, 3, 3, 3\n${ELEMENT}`)).toBe(
      'a.inp, line 10: node 1 is defined again, with other coordinates.',
    )
    expect(refusal(`*NODE\n${NODES.replace('1, 1, 1', '1, 1,5, 1x')}\n${ELEMENT}`)).toMatch(
      /^a.inp, line 8: “1x” is not a number/,
    )
    expect(refusal(`*NODE\n${NODES}\n*ELEMENT\n1,1,2,3,4,5,6,7,8`)).toContain('without TYPE')
  })

  it('reads nodes of two dimensions where no hexahedron uses them', () => {
    const mesh = readText('a.inp', '*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT,TYPE=CPS4\n1,1,2,3,4\n')
    expect([...mesh.other]).toEqual([['quadrilateral', 1]])
  })

  it('leaves out what the text leaves out', () => {
    const mesh = readText('a.inp', `*NODE\n${NODES}\n...\n${ELEMENT}\n...\n9, 1,2,3,4,5,6,7,99\n`)
    expect([mesh.cells.length / 8, mesh.isCutOff]).toEqual([1, true])
    expect(mesh.notes.join()).toContain('1 elements')
  })

  it('reads fenced and indented text, and prose around it', () => {
    const text = `*NODE\n${NODES}\n${ELEMENT}`
    expect(verticesOf(readText('a.txt', `Hello *world*\n\n\`\`\`\n${text}\n\`\`\`\nThanks, 1 2 3\n`), 0)).toEqual(CUBE)
    expect(verticesOf(readText('a.txt', text.replace(/^/gm, '    ')), 0)).toEqual(CUBE)
  })

  it('passes over prose below, and says so', () => {
    const mesh = readText('a.txt', `*NODE\n${NODES}\n${ELEMENT}\n\nIt says negative jacobian. Why?\n`)
    expect([mesh.cells.length, mesh.notes]).toEqual([
      8,
      ['Line 13 is text: what follows it, up to the next keyword, is passed over.'],
    ])
    expect(refusal(`*NODE\n${NODES}\n${ELEMENT}\nwords, 1, 2\n`)).toContain('“words” is not an element number')
  })

  it('says what printing lost, where something was lost', () => {
    const thirds = NODES.replaceAll(', 1', ', 0.333333')
    expect(readText('a.inp', `*NODE\n${thirds}\n${ELEMENT}`).notes).toEqual([
      'Coordinates are printed with at most 6 digits: that can move one by up to 5e-7.',
    ])
    expect(readText('a.inp', `*NODE\n${NODES}\n${ELEMENT}`).notes).toEqual([])
  })

  it('knows where the coordinates stand', () => {
    const text = `*NODE\n${NODES}\n${ELEMENT}`
    const places = readText('a.inp', text).coordinatePlaces
    if (places?.kind !== 'tokens') throw new Error('no places')
    expect(
      Array.from(places.from, (from, i) => Number(text.slice(from, from + (places.lengths[i] as number)))),
    ).toEqual(CUBE)
  })
})

describe('instances', () => {
  it('moves, then turns about an axis', () => {
    expect(moved('')).toEqual(CUBE)
    expect(moved('10., 0., 0.\n')).toEqual(CUBE.map((value, i) => (i % 3 === 0 ? value + 10 : value)))
    expect(moved('10, 0, 0\n10, 0, 0, 10, 0, 1, 90.\n').slice(0, 9)).toEqual([10, 0, 0, 10, 1, 0, 9, 1, 0])
  })

  it('knows sets of the assembly, and parts without an instance', () => {
    const text = `${PART}${PART.replaceAll('name=P', 'name=Q')}*Assembly, name=A\n*Instance, name=P-1, part=P\n*End Instance\n*Elset, elset=Top, instance=P-1\n1,\n*Elset, elset=_in, internal, instance=P-1\n1,\n*End Assembly\n`
    const mesh = readText('a.inp', text)
    expect(mesh.blocks.map(({ name }) => name)).toEqual(['Both', 'Top'])
    expect(mesh.cells.length / 8).toBe(1)
    expect(mesh.notes).toEqual(['Part “Q” has no instance: its 1 hexahedra are not in the assembly.'])
  })

  it('reads a part alone, and what an instance defines itself', () => {
    expect(verticesOf(readText('a.inp', PART), 0)).toEqual(CUBE)
    const own = `*Part, name=P\n*End Part\n*Assembly, name=A\n*Instance, name=P-1, part=P\n1, 0, 0\n*Node\n${NODES}\n${ELEMENT}\n*End Instance\n*End Assembly\n`
    expect(verticesOf(readText('a.inp', own), 0)[0]).toBe(1)
  })

  it('refuses what it is an instance of, if that is not there', () => {
    expect(refusal('*Assembly, name=A\n*Instance, name=P-1, part=P\n*End Instance\n*End Assembly')).toBe(
      'a.inp, line 2: instance “P-1” is of part “P”, which is not defined.',
    )
  })
})

describe('what is generated', () => {
  const corners = '1,0,0,0\n3,2,0,0\n7,0,2,0\n9,2,2,0\n19,0,0,2\n21,2,0,2\n25,0,2,2\n27,2,2,2\n'
  const lines = '*NGEN, NSET=A\n1,3\n7,9,1\n*NGEN, NSET=B\n19,21\n25,27\n'
  it('fills a block: NGEN, NFILL, ELGEN', () => {
    const text = `*NODE\n${corners}${lines}*NSET, NSET=A1\n1,2,3\n*NSET,NSET=A2\n7,8,9\n*NSET,NSET=B1,GENERATE\n19,21\n*NSET,NSET=B2,GENERATE\n25,27,1\n*NFILL,NSET=BOTTOM\nA1,A2,2,3\n*NFILL,NSET=TOP\nB1,B2,2,3\n*NFILL\nBOTTOM,TOP,2,9\n*ELEMENT,TYPE=C3D8,ELSET=E\n1,1,2,5,4,10,11,14,13\n*ELGEN,ELSET=E\n1,2,1,1,2,3,2,2,9,4\n`
    const mesh = readText('a.inp', text)
    expect(mesh.points.length / 3).toBe(27)
    expect(validity(mesh)).toEqual({ valid: 8, invalid: 0, least: 1 })
    expect(Array.from(mesh.ids as Float64Array)).toEqual([1, 2, 3, 4, 5, 6, 7, 8])
    expect(mesh.blocks.map(({ name, cells }) => [name, cells.length])).toEqual([['E', 8]])
  })

  it('copies: NCOPY, ELCOPY', () => {
    const text = `*NODE, NSET=ALL\n${NODES}\n${ELEMENT.replace('C3D8', 'C3D8, ELSET=E')}\n*NCOPY, OLD SET=ALL, CHANGE NUMBER=100, SHIFT, MULTIPLE=2\n3, 0, 0\n,\n*ELCOPY, OLD SET=E, ELEMENT SHIFT=10, SHIFT NODES=200, NEW SET=F\n`
    const mesh = readText('a.inp', text)
    expect(verticesOf(mesh, 1)).toEqual(CUBE.map((value, i) => (i % 3 === 0 ? value + 6 : value)))
    expect(mesh.blocks.map(({ name }) => name)).toEqual(['E', 'F'])
  })

  it.each([
    ['*NGEN, LINE=C\n1,3', '*NGEN'],
    ['*NFILL, BIAS=0.5\nA,B,2,1', '*NFILL'],
    ['*NCOPY, OLD SET=A, CHANGE NUMBER=1, REFLECT=MIRROR', '*NCOPY'],
    ['*ELCOPY, OLD SET=A, ELEMENT SHIFT=1, SHIFT NODES=1, REFLECT', '*ELCOPY'],
    ['*NMAP, NSET=A', '*NMAP'],
    ['*NODE, SYSTEM=S\n1,1,1,1', '*NODE'],
  ])('refuses %s by its name', (text, name) => {
    expect(refusal(`*NODE\n${NODES}\n${text}\n${ELEMENT}`)).toContain(name)
  })

  it('refuses more than can be', () => {
    expect(refusal(`*NODE\n1,0,0,0\n1000000001,1,0,0\n*NGEN\n1,1000000001\n`)).toContain('more than 50000000')
    expect(refusal(`*NODE\n${NODES}\n${ELEMENT}\n*ELGEN\n1,100000,1,1,100000,1,1\n`)).toContain('more than 50000000')
  })

  it('reads nodes in frames: SYSTEM', () => {
    const text = `*SYSTEM\n1, 0, 0, 1, 1, 0\n0, 0, 0\n*NODE\n${NODES}\n*SYSTEM\n${ELEMENT}`
    const vertices = verticesOf(readText('a.inp', text), 0)
    expect(vertices.slice(0, 6)).toEqual([1, 0, 0, 1, 1, 0])
    expect(vertices.slice(6, 9)).toEqual([0, 1, 0])
    const ring = readText('a.inp', '*NODE, SYSTEM=C\n1, 2, 90, 3\n')
    expect(Array.from(ring.points, value => Math.round(value * 1e9) / 1e9)).toEqual([0, 2, 3])
  })
})
