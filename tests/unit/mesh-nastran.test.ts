import { describe, expect, it } from 'vitest'
import { expectCells, expectPaste, linear, readShared, readText, validity, verticesOf } from './mesh-expectations'

const CUBE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const point = (v: number) => CUBE.slice(3 * v, 3 * v + 3)
const free = Array.from({ length: 8 }, (_, v) => `GRID,${v + 1},,${point(v).map(x => `${x}.`)}`).join('\n')
const HEX = 'CHEXA,1,5,1,2,3,4,5,6\n,7,8\n'

function refusal(text: string, others: Readonly<Record<string, string>> = {}): string {
  try {
    return `read ${readText('a.bdf', text, others).cells.length / 8}`
  } catch (error) {
    return (error as Error).message
  }
}

const cubeOf = (text: string) => verticesOf(readText('a.bdf', text), 0)

/** Fields in columns. */
const small = (...fields: (string | number)[]) => fields.map(field => String(field).padEnd(8)).join('')
const large = (name: string, ...fields: (string | number)[]) =>
  name.padEnd(8) + fields.map(field => String(field).padStart(16)).join('')

describe('files of ../shared', () => {
  it.each([
    ['gmsh-free.bdf', 1e-4],
    ['gmsh-small.bdf', 1e-3],
    ['meshio.bdf', 1e-9],
  ])('reads %s', (file, tolerance) => {
    const mesh = readShared(`meshes/made/${file}`)
    expect(mesh.cells.length / 8).toBe(15)
    expectCells(mesh, linear, tolerance)
    expect(Object.fromEntries(mesh.other)).toEqual({ quadrilateral: 2, tetrahedron: 2, wedge: 1, pyramid: 1 })
    expect(mesh.notes.length).toBe(1)
    expect(mesh.coordinatePlaces?.kind).toBe('tokens')
  })

  it('reads rot063akd2s_107.bdf', () => {
    const mesh = readShared('meshes/real/rot063akd2s_107.bdf')
    const { valid, invalid, least } = validity(mesh)
    expect([valid, invalid]).toEqual([2400, 0])
    expect(least).toBeCloseTo(3130.83, 2)
  })

  it.each(['07', '09'])('reads paste %s', prefix => {
    const mesh = expectPaste(prefix)
    expect(mesh.blocks.map(({ name }) => name)).toEqual(['PID 1'])
    expect(Array.from(mesh.ids as Float64Array)).toEqual([1])
  })
})

describe('fields', () => {
  it('reads exponents without a letter', () => {
    const text = free.replace('GRID,2,,1.,0.,0.', 'GRID,2,,10.-1,0.0+3,.0').replace('GRID,7,,1.,', 'GRID,7,,1.0D+0,')
    expect(cubeOf(`${text}\n${HEX}`)).toEqual(CUBE)
    expect(Array.from(readText('a.bdf', 'GRID,1,,1.0-3,-2.5+2,+3.\n').points)).toEqual([0.001, -250, 3])
  })

  it('reads small fields with tabs, comments and lower case', () => {
    const grids = Array.from(
      { length: 8 },
      (_, v) => `grid\t${v + 1}\t\t${point(v).join('.\t')}. $ a comment, with a comma`,
    )
    const text = `${grids.join('\n')}\n$ comment\n\nchexa   1       5       1       2       3       4       5       6\n        7       8\n`
    expect(cubeOf(text)).toEqual(CUBE)
  })

  it('reads wide fields in columns, and mixtures', () => {
    const grids = Array.from({ length: 8 }, (_, v) => {
      const [x, y, z] = point(v)
      return `${large('GRID*', v + 1, '', `${x}.`, `${y}.`)}*G${v}\n${large(`*G${v}`, `${z}.`)}`
    })
    const element = `${large('CHEXA*', 1, 5, 1, 2)}\n${large('*', 3, 4, 5, 6)}\n${small('', 7, 8)}\n`
    expect(cubeOf(`${grids.join('\n')}\n${element}`)).toEqual(CUBE)
  })

  it('reads wide free fields', () => {
    const grids = Array.from(
      { length: 8 },
      (_, v) => `GRID*,${v + 1},,${point(v)[0]}.,${point(v)[1]}.\n*,${point(v)[2]}.`,
    )
    expect(cubeOf(`${grids.join('\n')}\nCHEXA*,1,5,1,2,*A\n*A,3,4,5,6\n*,7,8\n`)).toEqual(CUBE)
  })

  it.each([
    ['without mnemonics', 'CHEXA,1,1,1,2,3,4,5,6\n,7,8'],
    ['with a plus sign', 'CHEXA,1,1,1,2,3,4,5,6,+\n+,7,8'],
    ['with names', 'CHEXA,1,1,1,2,3,4,5,6,+C1\n+C1,7,8'],
    ['on one line', 'CHEXA,1,1,1,2,3,4,5,6,7,8'],
    ['in columns', `${small('CHEXA', 1, 1, 1, 2, 3, 4, 5, 6, '+C1')}\n${small('+C1', 7, 8)}`],
    ['after other entries', `${small('CHEXA', 1, 1, 1, 2, 3, 4, 5, 6, '+C1')}\nPSOLID,1,1,\n${small('+C1', 7, 8)}`],
    [
      'before their entry',
      `GRDSET,,0\n${small('CHEXA', 9, 1, 1, 2, 3, 4, 5, 6, '+C9')}\n${small('+C1', 7, 8)}\n${small('+C9', 7, 8)}\n${small('CHEXA', 1, 1, 1, 2, 3, 4, 5, 6, '+C1')}`,
    ],
  ])('continues entries %s', (_, element) => {
    expect(cubeOf(`${free}\n${element}\n`)).toEqual(CUBE)
  })

  it('does not take the continuation of another entry', () => {
    const text = `${free}\n${small('CHEXA', 1, 1, 1, 2, 3, 4, 5, 6)}\n${small('PBEAM', 1, 1, 1)}\n${small('', 7, 8)}\n`
    expect(refusal(text)).toBe('a.bdf, line 9: CHEXA 1 has 6 nodes; 8 or 20 were expected.')
  })

  it('reads elements of 20 nodes in the order of Nastran', () => {
    const corner = (v: number) => point(v)
    const middles = [
      [0, 1],
      [1, 2],
      [2, 3],
      [3, 0],
      [0, 4],
      [1, 5],
      [2, 6],
      [3, 7],
      [4, 5],
      [5, 6],
      [6, 7],
      [7, 4],
    ]
    const grids = middles.map(
      ([a = 0, b = 0], i) => `GRID,${i + 9},,${corner(a).map((x, axis) => (x + (corner(b)[axis] as number)) / 2)}`,
    )
    const text = `${free}\n${grids.join('\n')}\nCHEXA,1,1,1,2,3,4,5,6\n,7,8,9,10,11,12,13,14\n,15,16,17,18,19,20\n`
    const mesh = readText('a.bdf', text)
    expect([mesh.cells.length, mesh.notTrilinear.corners.length, mesh.notTrilinear.straight]).toEqual([0, 8, 1])
    expect(readText('a.bdf', text.replace('GRID,13,,0,0,0.5', 'GRID,13,,0,0.1,0.5')).notTrilinear.straight).toBe(0)
  })

  it('refuses what is short or wrong, with its place', () => {
    expect(refusal(`${free.replace('GRID,5,,0.,0.,1.', 'GRID,5,,0.,0.')}\n${HEX}`)).toBe(
      'a.bdf, line 5: node 5 has 2 coordinates, not 3.',
    )
    expect(refusal(`${free}\nCHEXA,1,5,1,2,3,4,5,6\nCHEXA,2,5,1,2,3,4,5,6\n,7,8\n`)).toBe(
      'a.bdf, line 9: CHEXA 1 has 6 nodes; 8 or 20 were expected.',
    )
    expect(refusal(`${free}\n${HEX.replace(',7,8', ',7,9')}`)).toBe(
      'a.bdf: element 1 names node 9, which is not defined.',
    )
    expect(refusal(`${free}\nGRID,1,,2.,0.,0.\n${HEX}`)).toBe(
      'a.bdf, line 9: node 1 is defined again, with other coordinates.',
    )
    expect(refusal(`${free}\nGRID,9,,1.x,0.,0.\n`)).toBe('a.bdf, line 9: “1.x” is not a number.')
    expect(refusal(`${free}\n=,*1,=,=,==\n`)).toContain('repeat others')
  })

  it('takes blank fields in columns for 0, and says so', () => {
    const grids = Array.from({ length: 8 }, (_, v) =>
      small('GRID', v + 1, '', ...point(v).map(x => (x === 0 ? '' : `${x}.`))).trimEnd(),
    )
    const mesh = readText('a.bdf', `${grids.join('\n')}\n${HEX}`)
    expect(verticesOf(mesh, 0)).toEqual(CUBE)
    expect(mesh.notes).toEqual(['Blank coordinates are 0, as Nastran reads them.'])
  })
})

describe('the file', () => {
  it('passes over what stands before the bulk data', () => {
    const text = `SOL 101\nCEND\nTITLE = GRID, a title\nSET 1 = 1 THRU 8\nDISP = ALL\nBEGIN BULK\n${free}\n${HEX}ENDDATA\nGRID,1,,9.,9.,9.\n`
    expect(cubeOf(text)).toEqual(CUBE)
  })

  it('includes files, and asks for those that are missing', () => {
    const text = `BEGIN BULK\nINCLUDE 'parts/\nnodes.bdf'\n${HEX}ENDDATA\n`
    expect(refusal(text)).toBe(
      'a.bdf, line 3: INCLUDE names “parts/nodes.bdf”, which is missing: give it together with this file.',
    )
    expect(verticesOf(readText('a.bdf', text, { 'parts/nodes.bdf': free }), 0)).toEqual(CUBE)
  })

  it('refuses a second model', () => {
    expect(refusal(`BEGIN BULK\n${free}\n${HEX}BEGIN SUPER=1\n${free}\n`)).toContain('a second model')
  })
})

describe('frames', () => {
  const inFrame = (frame: string, nodes: string) => {
    const { points } = readText('a.bdf', `${frame}\n${nodes}\n`)
    return Array.from(points, value => Math.round(value * 1e12) / 1e12 + 0)
  }

  it('turns coordinates out of each kind', () => {
    expect(inFrame('CORD2R,1,,1.,0.,0.,1.,0.,1.\n,1.,1.,0.', 'GRID,1,1,1.,2.,3.')).toEqual([-1, 1, 3])
    expect(inFrame('CORD2C,1,,0.,0.,1.,0.,0.,2.\n,1.,0.,1.', 'GRID,1,1,2.,90.,3.')).toEqual([0, 2, 4])
    expect(inFrame('CORD2S,1,0,0.,0.,0.,0.,0.,1.\n,1.,0.,0.', 'GRID,1,1,2.,90.,90.')).toEqual([0, 2, 0])
  })

  it('knows frames in frames, by nodes, and the usual frame of GRDSET', () => {
    const nested = 'CORD2R,1,,1.,0.,0.,1.,0.,1.\n,2.,0.,0.\nCORD2R,2,1,1.,0.,0.,1.,0.,1.\n,2.,0.,0.'
    expect(inFrame(nested, 'GRID,1,2,1.,2.,3.')).toEqual([3, 2, 3])
    const byNodes = 'GRID,11,0,5.,0.,0.\nGRID,12,0,5.,0.,1.\nGRID,13,0,6.,0.,0.\nCORD1R,3,11,12,13\nGRDSET,,3'
    expect(inFrame(byNodes, 'GRID,1,,1.,2.,3.').slice(9)).toEqual([6, 2, 3])
  })

  it('refuses what is not defined, or by itself', () => {
    expect(refusal('GRID,1,7,1.,2.,3.\n')).toContain('the frame 7, in which coordinates are given, is defined by no')
    expect(refusal('CORD2R,1,1,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nGRID,1,1,1.,2.,3.\n')).toContain('defined by itself')
    expect(refusal('CORD1R,1,1,2,3\nGRID,1,1,1.,2.,3.\nGRID,2,1,1.,2.,3.\nGRID,3,1,1.,2.,3.\n')).toContain(
      'defined by itself',
    )
    expect(refusal('CORD2R,1,,0.,0.,0.,0.,0.,1.\n,0.,0.,2.\nGRID,1,1,1.,2.,3.\n')).toContain('lie on a line')
  })
})
