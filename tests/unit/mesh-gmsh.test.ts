/** Gmsh, Medit and MFEM: what is in ../shared of these formats, and texts that are made here. */
import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import type { Mesh } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { core } from './core-fixtures'

const shared = new URL('../../../shared/', import.meta.url)
const bytesOf = (path: string) => new Uint8Array(readFileSync(new URL(path, shared)))
const jsonOf = (path: string) => JSON.parse(new TextDecoder().decode(bytesOf(path)))

interface MadeFile {
  readonly file: string
  readonly format: string
  readonly counts: Readonly<Record<string, number>>
}
interface Linear {
  readonly name: string
  readonly valid: boolean
  readonly min_lower: number
  readonly min_upper: number
}

const made: { files: readonly MadeFile[]; linear: readonly Linear[]; quadratic: readonly Linear[] } =
  jsonOf('meshes/made/manifest.json')
const ours = made.files.filter(({ format }) => ['gmsh', 'medit', 'mfem'].includes(format))

function read(name: string, content: string | Uint8Array): readonly Mesh[] {
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content
  return readMeshes(fileOfBytes(name, bytes))
}

function one(name: string, content: string | Uint8Array): Mesh {
  const meshes = read(name, content)
  expect(meshes.length).toBe(1)
  return meshes[0] as Mesh
}

function verticesOf({ points }: Mesh, cells: Uint32Array, cell: number): number[] {
  return [...cells.subarray(8 * cell, 8 * cell + 8)].flatMap(point => [...points.subarray(3 * point, 3 * point + 3)])
}

function reportOf(mesh: Mesh, cells: Uint32Array, cell: number) {
  const result = core.analyze(verticesOf(mesh, cells, cell))
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function validOf(mesh: Mesh, cells = mesh.cells): boolean[] {
  return Array.from({ length: cells.length / 8 }, (_, cell) => reportOf(mesh, cells, cell).valid)
}

function refusalOf(name: string, content: string | Uint8Array): string {
  try {
    read(name, content)
  } catch (error) {
    return (error as Error).message
  }
  throw new Error(`${name} was read.`)
}

const NAMES: Readonly<Record<string, string>> = { tetra: 'tetrahedron', quad: 'quadrilateral' }

describe('meshes of ../shared', () => {
  it.each(ours.map(file => [file.file, file] as const))(
    '%s has the counts and verdicts of the manifest',
    (name, file) => {
      const mesh = one(name, bytesOf(`meshes/made/${name}`))
      const { hexahedron = 0, hexahedron20 = 0, ...others } = file.counts
      expect(mesh.cells.length / 8).toBe(hexahedron)
      expect(mesh.notTrilinear.corners.length / 8).toBe(hexahedron20)
      expect(Object.fromEntries(mesh.other)).toEqual(
        Object.fromEntries(Object.entries(others).map(([type, count]) => [NAMES[type] ?? type, count])),
      )
      for (const [cell, linear] of made.linear.entries()) {
        const report = reportOf(mesh, mesh.cells, cell)
        expect(report.valid, linear.name).toBe(linear.valid)
        const slack = report.boundaryMinimumError
        expect(report.boundaryMinimum, linear.name).toBeGreaterThanOrEqual(linear.min_lower - slack)
        expect(report.boundaryMinimum, linear.name).toBeLessThanOrEqual(linear.min_upper + slack)
      }
      if (hexahedron20 > 0) {
        expect(validOf(mesh, mesh.notTrilinear.corners)).toEqual(made.quadratic.map(({ valid }) => valid))
        expect(mesh.notTrilinear.straight).toBe(2)
      }
      expect(mesh.isOrderStated && !mesh.isCutOff).toBe(true)
    },
  )

  it.each([
    ['rockerarm.mesh', 10_600, 4076, 0.107841],
    ['cylinder-hex.mesh', 252, 204, 0.00138889],
    ['mesh_hex.msh', 150, 195, 2.30427e9],
  ])('%s is valid, with its least minimum', (name, hexahedra, quadrilaterals, least) => {
    const mesh = one(name, bytesOf(`meshes/real/${name}`))
    expect(mesh.cells.length / 8).toBe(hexahedra)
    expect(mesh.other.get('quadrilateral')).toBe(quadrilaterals)
    let minimum = Infinity
    for (let cell = 0; cell < hexahedra; ++cell) {
      const report = reportOf(mesh, mesh.cells, cell)
      expect(report.valid).toBe(true)
      minimum = Math.min(minimum, report.boundaryMinimum)
    }
    expect(Math.abs(minimum / least - 1)).toBeLessThan(1e-5)
  })

  it.each([
    ['truncated-tail-msh41-bin.msh', /byte 7656: 504 bytes of elements were expected/],
    ['truncated-half-msh22-ascii.msh', /line 138: the file ends after 132 of 182 nodes/],
    ['truncated-half-meshb.meshb', /byte 36: .* the file ends at byte 3662/],
    ['msh-node-twice.msh', /line 14: node 1 is defined twice/],
    ['msh-version.msh', /line 2: the version is “9.9”/],
    ['medit-index-0.mesh', /line 15: .* names vertex 0; the vertices are 1 to 8/],
    ['medit-2d.mesh', /line 2: .* there are no hexahedra/],
  ])('%s is refused with its place', (name, expected) => {
    expect(refusalOf(name, bytesOf(`meshes/malformed/${name}`))).toMatch(expected)
  })

  it('ids beyond 32 bits are kept', () => {
    const mesh = one('msh-sparse-ids.msh', bytesOf('meshes/malformed/msh-sparse-ids.msh'))
    expect(mesh.ids).toEqual(Float64Array.of(7))
    expect(reportOf(mesh, mesh.cells, 0).boundaryMinimum).toBe(1)
  })
})

describe('pastes of ../shared', () => {
  const expected: readonly { file: string; expect: readonly [string, readonly number[]][] | null }[] =
    jsonOf('pastes/expected.json')
  const names = /^(?:22|24|62|63|79|80)-/
  it.each(expected.filter(({ file }) => names.test(file)).map(entry => [entry.file, entry] as const))(
    '%s has its elements',
    (file, entry) => {
      const mesh = one(file, bytesOf(`pastes/${file}`))
      expect(mesh.cells.length / 8).toBe(entry.expect?.length)
      for (const [cell, [, vertices]] of (entry.expect ?? []).entries())
        expect(verticesOf(mesh, mesh.cells, cell)).toEqual(vertices)
      expect(mesh.isCutOff).toBe(false)
      expect(mesh.isOrderStated).toBe(!file.startsWith('62'))
      expect(mesh.notes.some(note => note.startsWith('The text'))).toBe(/^(?:62|79|80)/.test(file))
    },
  )

  it('what MFEM prints of bad elements is no mesh', () => {
    expect(refusalOf('45.txt', bytesOf('pastes/45-mfem-mesh-explorer-1835.txt'))).toMatch(/45\.txt/)
  })
})

const NODES = `$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
`
const HEADER = '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n'
const ELEMENT = '1 5 2 3 1 1 2 3 4 5 6 7 8\n'

describe('Gmsh', () => {
  it('snippets may be quoted, fenced, indented, with other ends of lines', () => {
    const text = `${HEADER}${NODES}$Elements\n1\n${ELEMENT}$EndElements\n`
    const wrapped = [
      `My mesh:\n\`\`\`text\n${text}\`\`\`\nwhat is wrong?\n`,
      `On Monday A. wrote:\n${text.replace(/^/gm, '> ')}\nand so on`,
      text.replace(/^/gm, '>> '),
      text.replace(/^/gm, '    '),
      text.replaceAll('\n', '\r\n'),
      `\u{feff}${text.replaceAll(' ', '\u00a0')}`,
    ]
    for (const snippet of wrapped) {
      const mesh = one('a.txt', snippet)
      expect(validOf(mesh)).toEqual([true])
      expect(mesh.ids).toEqual(Float64Array.of(1))
      expect(mesh.blocks).toEqual([{ name: 'physical 3', cells: Uint32Array.of(0) }])
    }
  })

  it('whole elements of a text that is cut are read, and it is said', () => {
    const whole = `${HEADER}${NODES}$Elements\n3\n${ELEMENT}`
    for (const end of [
      '',
      '2 5 2 3 1 1 2 3 4\n'.slice(0, -1),
      '...\n$EndElements\n',
      '[… 2 more …]\n',
      '```\nWhy?\n',
    ]) {
      const mesh = one('a.msh', whole + end)
      expect(validOf(mesh)).toEqual([true])
      expect(mesh.isCutOff).toBe(true)
      expect(mesh.notes).toContain('The text is cut: of 3 elements 1 are there.')
    }
    expect(refusalOf('a.msh', `${whole}$EndElements\n`)).toMatch(/line 18: 3 elements are declared, the section has 1/)
    expect(refusalOf('a.msh', `${whole}2 5 2 3 1 1 2 3 4\n${ELEMENT}`)).toMatch(/line 18: the line ends where a node/)
  })

  it('elements that name nodes which are left out are not read', () => {
    const text = NODES.replace('8\n1', '100\n1').replace('$End', '...\n100 5 5 5\n$End')
    const mesh = one('a.msh', `${text}$Elements\n2\n${ELEMENT}2 5 2 3 1 1 2 3 4 5 6 7 9\n$EndElements\n`)
    expect(validOf(mesh)).toEqual([true])
    expect(mesh.isCutOff).toBe(true)
    expect(refusalOf('a.msh', `${NODES}$Elements\n1\n${ELEMENT.replace('8\n', '9\n')}$EndElements\n`)).toMatch(
      /line 14: element 1 names node 9/,
    )
  })

  it('a line with too few or too many numbers shifts nothing', () => {
    expect(refusalOf('a.msh', HEADER + NODES.replace('3 1 1 0', '3 1 1'))).toMatch(/line 8: the line ends where/)
    expect(refusalOf('a.msh', HEADER + NODES.replace('3 1 1 0', '3 1 1 0 7'))).toMatch(/line 8: the line has more/)
  })

  it('the bytes of each coordinate are known, in quoted texts as well', () => {
    for (const text of [`${HEADER}${NODES}$Elements\n1\n${ELEMENT}`, MEDIT, mfemMesh('v1.0', `3\n${ROWS}`)])
      for (const content of [text, text.replace(/^/gm, '> ')]) {
        const { points, coordinatePlaces: places } = one('a.txt', content)
        if (places?.kind !== 'tokens') throw new Error('no places')
        const tokens = [...places.from].map((from, i) => content.slice(from, from + (places.lengths[i] as number)))
        expect(tokens.map(Number)).toEqual([...points])
      }
  })

  it('two files in one text are two meshes', () => {
    const text = `${HEADER}${NODES}$Elements\n1\n${ELEMENT}$EndElements\n`
    expect(read('a.msh', text + text).map(mesh => mesh.cells.length)).toEqual([8, 8])
    expect(read('a.msh', `${text}${text}`.replaceAll(HEADER, '')).length).toBe(2)
  })

  it('elements before the nodes, names, and sections that nobody needs', () => {
    const names = '$PhysicalNames\n1\n3 3 "linke Hälfte"\n$EndPhysicalNames\n'
    const data = '$NodeData\n1\n"x"\n1\n0\n3\n0\n1\n8\n1 0.5\n$EndNodeData\n'
    const mesh = one('a.msh', `${HEADER}${names}${data}$Elements\n1\n${ELEMENT}$EndElements\n${NODES}${data}`)
    expect(mesh.blocks.map(({ name }) => name)).toEqual(['linke Hälfte'])
    expect(validOf(mesh)).toEqual([true])
  })

  it('MSH 2.2 and 4.1 in both orders of bytes', () => {
    for (const little of [true, false])
      for (const version of ['2.2', '4.1'] as const) {
        const mesh = one('a.msh', binaryCube(version, little))
        expect(validOf(mesh)).toEqual([true])
        expect(mesh.ids).toEqual(Float64Array.of(9))
        expect(mesh.blocks.map(({ name }) => name)).toEqual(['volume 4'])
      }
  })

  it('a binary file that ends anywhere is refused', () => {
    for (const version of ['2.2', '4.1'] as const) {
      const bytes = binaryCube(version, true)
      for (let size = 30; size < bytes.length - 1; size += 7)
        expect(refusalOf('a.msh', bytes.subarray(0, size))).toMatch(/^a\.msh/)
    }
  })

  it('counts that lie allocate nothing', () => {
    expect(refusalOf('a.msh', HEADER + NODES.replace('8\n1', '9000000000000\n1'))).toMatch(/9000000000000/)
    const bytes = binaryCube('4.1', true)
    const at = new TextDecoder('latin1').decode(bytes).indexOf('$Nodes\n') + 7
    new DataView(bytes.buffer).setUint32(at + 12, 1, true)
    expect(refusalOf('a.msh', bytes)).toMatch(/byte \d+: \d+ bytes of nodes were expected/)
  })

  it('coordinates that are printed with fewer than 17 digits get a note, round numbers do not', () => {
    const noted = one(
      'a.msh',
      `${HEADER}${NODES.replace('1 0\n', '1.00001 0\n')}$Elements\n1\n${ELEMENT}$EndElements\n`,
    )
    expect(noted.notes).toEqual(['Coordinates are printed with at most 6 digits: that can move one by up to 5e-6.'])
    const thirds = NODES.replace('1 0\n', '0.667 0\n')
    expect(one('a.msh', `${HEADER}${thirds}$Elements\n1\n${ELEMENT}$EndElements\n`).notes).toHaveLength(1)
    expect(one('a.msh', `${HEADER}${NODES}$Elements\n1\n${ELEMENT}$EndElements\n`).notes).toEqual([])
  })
})

const CORNERS = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 0, 1],
  [1, 1, 1],
  [0, 1, 1],
]

/** Bytes of a binary file, put together of text and numbers. */
class Bytes {
  readonly #bytes: number[] = []
  constructor(private readonly little: boolean) {}
  text(text: string): this {
    for (const byte of new TextEncoder().encode(text)) this.#bytes.push(byte)
    return this
  }
  #put(size: number, set: (view: DataView) => void): this {
    const view = new DataView(new ArrayBuffer(size))
    set(view)
    this.#bytes.push(...new Uint8Array(view.buffer))
    return this
  }
  ints(...values: number[]): this {
    for (const value of values) this.#put(4, view => view.setInt32(0, value, this.little))
    return this
  }
  longs(...values: number[]): this {
    for (const value of values) this.#put(8, view => view.setBigInt64(0, BigInt(value), this.little))
    return this
  }
  floats(...values: number[]): this {
    for (const value of values) this.#put(4, view => view.setFloat32(0, value, this.little))
    return this
  }
  doubles(...values: number[]): this {
    for (const value of values) this.#put(8, view => view.setFloat64(0, value, this.little))
    return this
  }
  get length(): number {
    return this.#bytes.length
  }
  whole(): Uint8Array {
    return Uint8Array.from(this.#bytes)
  }
}

function binaryCube(version: '2.2' | '4.1', little: boolean): Uint8Array {
  const bytes = new Bytes(little).text(`$MeshFormat\n${version} 1 8\n`).ints(1).text('\n$EndMeshFormat\n$Nodes\n')
  if (version === '2.2') {
    bytes.text('8\n')
    for (const [i, corner] of CORNERS.entries()) bytes.ints(i + 1).doubles(...corner)
    bytes.text('\n$EndNodes\n$Elements\n1\n').ints(5, 1, 2, 9, 0, 4, 1, 2, 3, 4, 5, 6, 7, 8)
  } else {
    bytes.longs(1, 8, 1, 8).ints(3, 4, 0).longs(8, 1, 2, 3, 4, 5, 6, 7, 8)
    for (const corner of CORNERS) bytes.doubles(...corner)
    bytes.text('\n$EndNodes\n$Elements\n').longs(1, 1, 9, 9).ints(3, 4, 5).longs(1, 9, 1, 2, 3, 4, 5, 6, 7, 8)
  }
  return bytes.text('\n$EndElements\n').whole()
}

const MEDIT = `MeshVersionFormatted 2
Dimension
3
# a comment
Vertices
8
${CORNERS.map(corner => `${corner.join(' ')} 0`).join('\n')}
Hexahedra
2
1 2 3 4 5 6 7 8 1
1 2 3 4 5 6 7 8 2
Tetrahedra
1
1 2 3 5 0
RequiredVertices
1
1
End
`

describe('Medit', () => {
  it('references become blocks; sections that nobody needs are passed over', () => {
    const mesh = one('a.mesh', MEDIT)
    expect(validOf(mesh)).toEqual([true, true])
    expect(mesh.blocks.map(({ name }) => name)).toEqual(['reference 1', 'reference 2'])
    expect(Object.fromEntries(mesh.other)).toEqual({ tetrahedron: 1 })
  })

  it('all in one line', () => {
    const mesh = one('a.mesh', MEDIT.replace('# a comment\n', '').replaceAll('\n', ' '))
    expect(validOf(mesh)).toEqual([true, true])
  })

  it('a text that is cut or leaves something out', () => {
    const cut = one('a.txt', `\`\`\`\n${MEDIT.slice(0, MEDIT.indexOf('1 2 3 4 5 6 7 8 2'))}\`\`\`\n`)
    expect(validOf(cut)).toEqual([true])
    expect(cut.isCutOff).toBe(true)
    const elided = one(
      'a.txt',
      MEDIT.replace('8\n0 0 0', '900\n0 0 0').replace('Hexahedra', '...\nHexahedra').replace('8 2', '9 2'),
    )
    expect(validOf(elided)).toEqual([true])
    expect(elided.isCutOff).toBe(true)
  })

  it('a line with too few numbers shifts nothing', () => {
    expect(refusalOf('a.mesh', MEDIT.replace('1 1 0 0', '1 1 0'))).toMatch(/line 9: the line ends where a reference/)
    expect(refusalOf('a.mesh', MEDIT.replace('6 7 8 2', '6 7 8'))).toMatch(/line 18: /)
  })

  it('versions 1 to 4 of .meshb, in both orders of bytes', () => {
    for (const little of [true, false])
      for (const version of [1, 2, 3, 4]) {
        const mesh = one('a.meshb', meshb(version, little))
        expect(validOf(mesh)).toEqual([true])
        expect(validOf(mesh, mesh.notTrilinear.corners)).toEqual([true])
        expect(mesh.notTrilinear.straight).toBe(1)
        expect(mesh.notes.some(note => note.includes('Float32'))).toBe(version === 1)
      }
  })

  it('a .meshb that ends anywhere is refused', () => {
    const bytes = meshb(3, true)
    for (let size = 8; size < bytes.length - 12; size += 5)
      expect(refusalOf('a.meshb', bytes.subarray(0, size))).toMatch(/^a\.meshb, byte \d+: /)
  })
})

/** A hexahedron of 8 nodes and one of 27, whose nodes are in lexicographic order, which is stated after it. */
function meshb(version: number, little: boolean): Uint8Array {
  const places = Array.from({ length: 27 }, (_, i) => [i % 3, Math.floor(i / 3) % 3, Math.floor(i / 9)])
  const sections: [number, (bytes: Bytes) => void][] = []
  const ints = (bytes: Bytes, ...values: number[]) => (version < 4 ? bytes.ints(...values) : bytes.longs(...values))
  sections.push([3, bytes => bytes.ints(3)])
  sections.push([33, bytes => ints(bytes, 1, ...places.map((_, i) => i + 9), 0)])
  sections.push([
    4,
    bytes => {
      ints(bytes, 35)
      for (const point of [...CORNERS, ...places.map(place => place.map(value => value / 2))]) {
        if (version === 1) bytes.floats(...point)
        else bytes.doubles(...point)
        ints(bytes, 0)
      }
    },
  ])
  sections.push([10, bytes => ints(bytes, 1, 1, 2, 3, 4, 5, 6, 7, 8, 0)])
  sections.push([139, bytes => ints(bytes, 27, ...places.flat())])
  const all = new Bytes(little).ints(1, version)
  const parts = sections.map(([code, write]) => {
    const body = new Bytes(little)
    write(body)
    return { code, write, length: body.length }
  })
  for (const { code, write, length } of parts) {
    const next = all.length + 4 + (version < 3 ? 4 : 8) + length
    all.ints(code)
    if (version < 3) all.ints(next)
    else all.longs(next)
    write(all)
  }
  return (version < 3 ? all.ints(54, 0) : all.ints(54).longs(0)).whole()
}

const mfemMesh = (version: string, vertices: string, more = '') => `MFEM mesh ${version}

# a comment
dimension
3

elements
2
1 5 0 1 2 3 4 5 6 7
2 5 0 1 2 3 4 5 6 7
${more}
boundary
1
1 3 0 1 2 3

vertices
8
${vertices}
`
const SPACE = (name: string, ordering: number) =>
  `\nnodes\nFiniteElementSpace\nFiniteElementCollection: ${name}\nVDim: 3\nOrdering: ${ordering}\n\n`
const ROWS = CORNERS.map(corner => corner.join(' ')).join('\n')
const COLUMNS = [0, 1, 2].flatMap(axis => CORNERS.map(corner => corner[axis])).join('\n')

describe('MFEM', () => {
  it('v1.0 to v1.3, attributes and their sets as blocks', () => {
    for (const version of ['v1.0', 'v1.1', 'v1.2', 'v1.3']) {
      const mesh = one('a.mesh', mfemMesh(version, `3\n${ROWS}\nmfem_mesh_end`))
      expect(validOf(mesh)).toEqual([true, true])
      expect(mesh.blocks.map(({ name }) => name)).toEqual(['attribute 1', 'attribute 2'])
      expect(Object.fromEntries(mesh.other)).toEqual({ quadrilateral: 1 })
    }
    const sets = '\nattribute_sets\n2\n"all of it" 2 1 2\n"one" 1 1\n'
    const mesh = one('a.mesh', mfemMesh('v1.3', `3\n${ROWS}`, sets))
    expect(mesh.blocks.map(({ name, cells }) => [name, cells.length])).toEqual([
      ['all of it', 2],
      ['one', 1],
    ])
  })

  it('vertices of a grid function, in either ordering', () => {
    for (const nodes of [SPACE('H1_3D_P1', 1) + ROWS, SPACE('Linear', 0) + COLUMNS])
      expect(validOf(one('a.mesh', mfemMesh('v1.0', nodes)))).toEqual([true, true])
    const own = [...CORNERS.keys()].map(i => [i & 1, (i >> 1) & 1, i >> 2].join(' ')).join('\n')
    const periodic = one('a.mesh', mfemMesh('v1.0', `${SPACE('L2_T1_3D_P1', 1)}${own}\n${own}`))
    expect(validOf(periodic)).toEqual([true, true])
    expect(periodic.points.length / 3).toBe(16)
  })

  it('nodes of a higher order are not trilinear', () => {
    const mesh = one('a.mesh', mfemMesh('v1.0', `${SPACE('H1_3D_P2', 1)}${ROWS}\n${'0.5 0.5 0.5\n'.repeat(20)}`))
    expect(mesh.cells.length).toBe(0)
    expect(validOf(mesh, mesh.notTrilinear.corners)).toEqual([true, true])
    expect(mesh.notes.some(note => note.includes('order 2'))).toBe(true)
  })

  it('NURBS and INLINE are refused by name, and indices out of range', () => {
    expect(refusalOf('a.mesh', 'MFEM NURBS mesh v1.0\n')).toMatch(/MFEM NURBS mesh/)
    expect(refusalOf('a.mesh', 'MFEM INLINE mesh v1.0\n\ntype = hex\n')).toMatch(/MFEM INLINE mesh/)
    expect(refusalOf('a.mesh', mfemMesh('v1.0', `3\n${ROWS}`).replace('1 5 0', '1 5 8'))).toMatch(/line 9: .* vertex 8/)
    expect(refusalOf('a.mesh', mfemMesh('v2.0', `3\n${ROWS}`))).toMatch(/line 1: .*v2\.0/)
    expect(refusalOf('a.mesh', mfemMesh('v1.0', `3\n${ROWS.slice(0, 20)}`))).toMatch(/the file ends after|line ends/)
  })

  it('leaves of a non-conforming mesh, whose vertices lie between others', () => {
    const mesh = one(
      'a.mesh',
      `MFEM NC mesh v1.0\n\ndimension\n3\n\nelements\n3\n-1 1 5 1 1 2\n0 1 5 0 0 8 9 3 4 10 11 7\n0 1 5 0 8 1 2 9 10 5 6 11\n
boundary\n0\n\nvertex_parents\n4\n8 0 1\n9 2 3\n10 4 5\n11 6 7\n\ncoordinates\n8\n3\n${ROWS}\n`,
    )
    expect(validOf(mesh)).toEqual([true, true])
    expect(verticesOf(mesh, mesh.cells, 0).slice(3, 6)).toEqual([0.5, 0, 0])
  })
})
