import { describe, expect, it } from 'vitest'
import { expectCells, linear, readShared, readText, reportOf, validity, verticesOf } from './mesh-expectations'

const CUBE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const point = (v: number) => CUBE.slice(3 * v, 3 * v + 3)

const integers = (width: number, ...values: number[]) => values.map(value => String(value).padStart(width)).join('')
const reals = (width: number, digits: number, ...values: number[]) =>
  values.map(value => value.toExponential(digits).padStart(width)).join('')

const nodes = (first = 0) =>
  Array.from(
    { length: 8 - first },
    (_, i) => integers(9, i + first + 1, 0, 0) + reals(21, 13, ...point(i + first)),
  ).join('\n')
const NBLOCK = `NBLOCK,6,SOLID,       8,       8\n(3i9,6e21.13e3)\n${nodes()}\nN,R5.3,LOC,       -1,\n`
const element = (id: number, type: number, ids: readonly number[], count = ids.length) =>
  integers(9, 1, type, 1, 1, 0, 0, 0, 0, count, 0, id, ...ids.slice(0, 8)) +
  (ids.length > 8 ? `\n${integers(9, ...ids.slice(8))}` : '')
const ONE = [1, 2, 3, 4, 5, 6, 7, 8]
const eblock = (...elements: string[]) =>
  `EBLOCK,19,SOLID,  99,  ${elements.length}\n(19i9)\n${elements.join('\n')}\n       -1\n`

function refusal(text: string): string {
  try {
    return `read ${readText('a.cdb', text).cells.length / 8}`
  } catch (error) {
    return (error as Error).message
  }
}

describe('files of ../shared', () => {
  it('reads hand.cdb', () => {
    const mesh = readShared('meshes/made/hand.cdb')
    expect(mesh.cells.length / 8).toBe(19)
    expectCells(mesh, linear)
    for (let cell = 15; cell < 19; ++cell) expect(reportOf(mesh, cell).valid).toBe(false)
    expect(mesh.notes).toEqual([
      '7 elements repeat nodes, as Ansys writes wedges, pyramids and tetrahedra: as hexahedra they have J <= 0 somewhere.',
    ])
  })

  /** The file's README speaks of 20 nodes; the archive says SOLID185, 8 nodes each. */
  it('reads sector.cdb', () => {
    const mesh = readShared('meshes/real/sector.cdb')
    expect(mesh.cells.length / 8).toBe(105)
    expect(validity(mesh)).toMatchObject({ valid: 101, invalid: 4 })
    const least = Math.min(
      ...Array.from({ length: 105 }, (_, cell) => reportOf(mesh, cell).minimum).filter(minimum => minimum > 0),
    )
    expect(least).toBeCloseTo(6.47639e-6, 10)
    expect((mesh.ids as Float64Array)[0]).toBe(224)
  })
})

describe('blocks', () => {
  it('reads widths that the format line gives', () => {
    const lines = Array.from({ length: 8 }, (_, v) => integers(8, v + 1) + reals(20, 9, ...point(v))).join('\n')
    const text = `nblock,3\n(1i8,3e20.9e3)\n${lines}\n-1\net,1,SOLID185\neblock,19,solid,,1\n(19i10)\n${integers(10, 1, 1, 1, 1, 0, 0, 0, 0, 8, 0, 7, ...ONE)}\n-1\n`
    const mesh = readText('ds.dat', text)
    expect(verticesOf(mesh, 0)).toEqual(CUBE)
    expect(Array.from(mesh.ids as Float64Array)).toEqual([7])
  })

  it('reads coordinates that Ansys leaves out as 0', () => {
    const short = NBLOCK.replace(nodes(), [integers(9, 1, 0, 0), nodes(1)].join('\n'))
    expect(verticesOf(readText('a.cdb', `${short}ET,1,185\n${eblock(element(1, 1, ONE))}`), 0)).toEqual(CUBE)
  })

  it('knows elements by their types', () => {
    const text = `ET,1,186\nET,2,181\nET,3,187\nET,4,45\nET,5,170\n${NBLOCK}${eblock(
      element(1, 1, [...ONE, ...ONE, 1, 2, 3, 4]),
      element(2, 2, [1, 2, 3, 4]),
      element(3, 2, [1, 2, 3, 3]),
      element(4, 3, [...ONE, 1, 2]),
      element(5, 4, ONE),
      element(6, 5, ONE),
    )}`
    const mesh = readText('a.cdb', text)
    expect(mesh.cells.length / 8).toBe(1)
    expect(mesh.notTrilinear.corners.length / 8).toBe(1)
    expect(Object.fromEntries(mesh.other)).toEqual({ quadrilateral: 1, triangle: 1, tetrahedron: 1, other: 1 })
  })

  it('reads blocks that are not solid', () => {
    const text = `${NBLOCK}ET,1,185\nET,2,154\nTYPE,2\nEBLOCK,10,,,1\n(15i9)\n${integers(9, 5, 1, 1, 1, 0, 1, 2, 3, 4)}\n       -1\n${eblock(element(1, 1, ONE))}`
    const mesh = readText('a.cdb', text)
    expect([mesh.cells.length / 8, Object.fromEntries(mesh.other)]).toEqual([1, { quadrilateral: 1 }])
  })

  it('makes blocks of components', () => {
    const text = `${NBLOCK}ET,1,185\n${eblock(element(5, 1, ONE), element(6, 1, ONE), element(9, 1, ONE))}CMBLOCK,PART    ,ELEM,       3  ! users element component definition\n(8i10)\n${integers(10, 5, -6, 12)}\nCMBLOCK,N,NODE,1\n(8i10)\n${integers(10, 5)}\nFINISH\n`
    expect(readText('a.cdb', text).blocks.map(({ name, cells }) => [name, Array.from(cells)])).toEqual([
      ['PART', [0, 1]],
    ])
  })

  it('refuses what is short or cut off, with its place', () => {
    const good = `${NBLOCK}ET,1,185\n`
    expect(refusal(`${good}${eblock(element(1, 1, ONE.slice(0, 6), 8))}`)).toBe(
      'a.cdb, line 15: element 1 has 6 nodes; 8 are declared.',
    )
    expect(refusal(`${good}${eblock(element(1, 1, [1, 2, 3, 4, 5, 6, 7, 99]))}`)).toBe(
      'a.cdb: element 1 names node 99, which is not defined.',
    )
    expect(refusal(`${good}${eblock(element(1, 1, ONE)).replace(',  1\n', ',  2\n')}`)).toBe(
      'a.cdb, line 16: EBLOCK has 1 elements; 2 are declared.',
    )
    expect(refusal(`${NBLOCK.slice(0, 295)}\n-1\n`)).toContain('the last number of the line is cut off')
    expect(refusal(NBLOCK.slice(0, NBLOCK.indexOf('N,R5')))).toContain('the file ends within an NBLOCK, after 8 nodes')
    expect(refusal(NBLOCK.replace('(3i9,6e21.13e3)', '(nonsense)'))).toContain(
      'line 2: NBLOCK: a format as (3i9,6e21.13e3) was expected',
    )
    expect(refusal(`${NBLOCK}${NBLOCK.replace('1.0000000000000e+0', '2.0000000000000e+0')}`)).toContain(
      'is defined again',
    )
    expect(refusal(`/PREP7\nN,1,0,0,0\nE,1,2,3,4,5,6,7,8\n`)).toContain('element 1 names node 2, which')
  })
})

describe('commands of one node or element', () => {
  const [bottom, top] = [ONE.slice(0, 4), ONE.slice(4)]
  const commands = (...elements: string[]) =>
    ['/PREP7', 'ET,1,SOLID185', ...ONE.map(id => `N,${id},${point(id - 1)} ! node`), ...elements].join('\n')

  it('are read as the blocks are', () => {
    const mesh = readText('a.inp', commands(`e,${ONE}`, `EN,12,${top},${bottom}`))
    expect([...(mesh.ids ?? [])]).toEqual([1, 12])
    expect(verticesOf(mesh, 0)).toEqual(CUBE)
    expect(validity(mesh)).toMatchObject({ valid: 1, invalid: 1 })
  })

  it('number nodes on where no number is given, and leave out coordinates that are 0', () => {
    const mesh = readText('a.cdb', `ET,1,185\nN,1\nN,,1\nN,,1,1\nN,,,1\nN,,,,1\nN,,1,,1\nN,,1,1,1\nN,,,1,1\nE,${ONE}`)
    expect(verticesOf(mesh, 0)).toEqual(CUBE)
  })

  it('go on with EMORE', () => {
    const middles = Array.from({ length: 12 }, (_, i) => `N,${i + 9},0.5,0.5,0.5`).join('\n')
    const text = `ET,1,186\n${ONE.map(id => `N,${id},${point(id - 1)}`).join('\n')}\n${middles}\nE,${ONE}\nEMORE,9,10,11,12,13,14,15,16\nEMORE,17,18,19,20`
    const mesh = readText('a.cdb', text)
    expect([mesh.cells.length, mesh.notTrilinear.corners.length]).toEqual([0, 8])
  })

  it('are refused where others change them', () => {
    const text = (command: string) =>
      `ET,1,185\n${ONE.map(id => `N,${id},${point(id - 1)}`).join('\n')}\nE,${ONE}\n${command}\n`
    for (const command of ['EGEN,2,10,1', 'nscale,0,all,,,1,-1,1', 'EMODIF,1,-1,2', 'Fill,1,2', 'NMODIF,1,5,5,5'])
      expect(refusal(text(command)), command).toMatch(
        new RegExp(`^a\\.cdb, line 11: ${command.split(',')[0]?.toUpperCase()} .*is not read here: write`),
      )
    const harmless = ['EMODIF,ALL,MAT,3', 'NMODIF,1,,,,45', 'LOCAL,R5.3,LOC,11,1', 'NSEL,ALL', 'FINISH', 'CSYS']
    expect(readText('a.cdb', text(harmless.join('\n'))).cells.length).toBe(8)
  })

  it('are refused in a frame that is not read', () => {
    expect(refusal(`ET,1,185\nCSYS,1\nN,1,1,90,0`)).toBe(
      'a.cdb, line 3: N: coordinates in frame 1 are not read; frame 0 was expected.',
    )
    for (const command of ['LOCAL,11,1,0,0,0', 'clocal,11'])
      expect(refusal(`ET,1,185\n${command}\nN,1,1,90,0`)).toBe(
        'a.cdb, line 3: N: coordinates in frame 11 are not read; frame 0 was expected.',
      )
    expect(refusal('ET,1,185\nCSYS,CYL\nN,1,1,90,0')).toContain('in frame “CYL” are not read')
    expect(refusal(`${NBLOCK}EMORE,1,2`)).toMatch(/EMORE: an element of E or EN was expected before it/)
  })
})
