import { readdirSync, readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import type { Mesh } from '../../web/mesh/mesh'
import { MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { processorTime } from './processor-time'

const shared = new URL('../../../shared/', import.meta.url)
const pastes = new URL('pastes/', shared)

interface Expected {
  readonly file: string
  readonly hexahedra: number | null
  readonly exit: readonly number[]
  readonly expect: readonly (readonly [string, readonly number[]])[] | null
}

function readFile(url: URL, name: string): readonly Mesh[] {
  return readMeshes(fileOfBytes(name, readFileSync(new URL(name, url))))
}

function readText(text: string, name = 'paste.txt'): Mesh {
  const meshes = readMeshes(fileOfBytes(name, new TextEncoder().encode(text)))
  expect(meshes).toHaveLength(1)
  return meshes[0] as Mesh
}

function refusal(text: string | Uint8Array, name = 'paste.txt'): string {
  const bytes = typeof text === 'string' ? new TextEncoder().encode(text) : text
  try {
    const meshes = readMeshes(fileOfBytes(name, bytes))
    return `read as ${meshes.map(({ format, cells }) => `${format}, ${cells.length / 8}`)}`
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
}

function elements(mesh: Mesh): number[][] {
  return Array.from({ length: mesh.cells.length / 8 }, (_, i) =>
    [...mesh.cells.subarray(8 * i, 8 * i + 8)].flatMap(point => [...mesh.points.subarray(3 * point, 3 * point + 3)]),
  )
}

const expected: readonly Expected[] = JSON.parse(readFileSync(new URL('expected.json', pastes), 'utf8'))
const OTHERS = /^(?:07|09|15|17|18|19|21|22|24|29|31|32|44|49|51|63|68|72|73|75|77|79|80|82)-/
const UNSTATED = /^(?:02|13|26|43|47|53|54|56|57|59|62|65)-/

describe('texts as people post them', () => {
  test.each(expected.filter(({ file }) => !OTHERS.test(file)))('$file', ({ file, hexahedra, exit, expect: wanted }) => {
    let meshes: readonly Mesh[]
    try {
      meshes = readFile(pastes, file)
    } catch (error) {
      expect(error).toBeInstanceOf(MeshRefusal)
      expect(exit, String(error)).toContain(2)
      return
    }
    const found = meshes.flatMap(elements)
    expect(found).toHaveLength(hexahedra ?? found.length)
    for (const [i, [, coordinates]] of (wanted ?? []).entries()) {
      for (const [c, value] of coordinates.entries()) expect(found[i]?.[c]).toBeCloseTo(value, 4)
    }
    for (const mesh of meshes) expect(mesh.isOrderStated, mesh.format).toBe(!UNSTATED.test(file))
  })

  test.each(readdirSync(pastes).filter(name => name.startsWith('min-')))('%s ends quickly', name => {
    const start = processorTime()
    expect(refusal(readFileSync(new URL(name, pastes)), name)).toMatch(/\.$/)
    expect(processorTime() - start).toBeLessThan(5000)
  })
})

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const upper = cube.map((value, i) => (i % 3 === 2 ? value + 1 : value))
const rows = (vertices: readonly number[]) => Array.from({ length: 8 }, (_, v) => vertices.slice(3 * v, 3 * v + 3))
const columns = (vertices: readonly number[]) => [0, 1, 2].map(axis => vertices.filter((_, i) => i % 3 === axis))
/** The cube's points in lexicographic order, and the cell that names them in VTK's. */
const lexicographic = [0, 1, 3, 2, 4, 5, 7, 6].map(v => rows(cube)[v] as number[])
const cell = [0, 1, 3, 2, 4, 5, 7, 6]
const oneBased = cell.map(node => node + 1)

/** Exactly one element, and whether its order is stated. */
function only(text: string, name?: string): [readonly number[], boolean] {
  const mesh = readText(text, name)
  const found = elements(mesh)
  expect(found, mesh.format).toHaveLength(1)
  return [found[0] as number[], mesh.isOrderStated]
}

const lines = (points: readonly (readonly number[])[], write: (point: readonly number[], v: number) => string) =>
  points.map(write).join('\n')

describe('eight points without cells', () => {
  const flat = cube.join(', ')
  const nested = `[${rows(cube)
    .map(point => `[${point.join(', ')}]`)
    .join(', ')}]`
  test.each([
    ['blanks', cube.join(' ')],
    ['a number a line', cube.join('\n')],
    ['six a line', cube.join(' ').replace(/((?:\S+ ){6})/g, '$1\n')],
    ['ten a line', cube.join(' ').replace(/((?:\S+ ){10})/g, '$1\n')],
    ['three lines of eight', lines(columns(cube), axis => axis.join(' '))],
    ['decimal commas', lines(rows(cube), point => point.map(x => `${x},0`).join(' '))],
    ['decimal commas, semicolons', lines(rows(cube), point => point.map(x => `${x},0`).join(';'))],
    ['D exponents', lines(rows(cube), point => point.map(x => `${x}.0D+00`).join(' '))],
    ['a name', `vertices = ${flat}`],
    ['a name and a colon', `vertices: ${flat}`],
    ['a name, many lines', `vertices = ${lines(rows(cube), point => point.join(', '))}`.replace(/(\d)\n/g, '$1,\n')],
    ['JavaScript', `export const hex = new Float64Array([${flat}]);`],
    ['C', `const double hex[8][3] = {\n${lines(rows(cube), p => `  {${p.map(x => `${x}.0`)}}, // vertex`)}\n};`],
    ['C, flat', `static float v[] = {${cube.map(x => `${x}.f`)}};`],
    ['C++', `std::vector<double> v{${flat}};`],
    ['C++, points', `Vec3 p[8] = {${rows(cube).map(p => `Vec3(${p.join(', ')})`)}};`],
    ['NumPy', `points = np.array(${nested}, dtype=float)`],
    ['NumPy by axes', `p = np.array([${columns(cube).map(axis => `[${axis}]`)}])`],
    ['NumPy, reshaped', `x = np.array([${flat}]).reshape(8, 3)`],
    ['NumPy, reshaped to axes', `x = np.array([${columns(cube).flat()}]).reshape(3, 8)`],
    ['np.float64', `[${rows(cube).map(p => `[${p.map(x => `np.float64(${x}.0)`)}]`)}]`],
    ['str of an array', `[${lines(rows(cube), p => `[${p.map(x => `${x}.`).join(' ')}]`)}]`],
    [
      'a prompt that goes on',
      `>>> v = np.array([${lines(rows(cube), p => `[${p}],`).replaceAll('\n', '\n...               ')}])`,
    ],
    [
      'MATLAB',
      `V = [${rows(cube)
        .map(p => p.join(' '))
        .join('; ')}];`,
    ],
    ['MATLAB, lines', `V = [${lines(rows(cube), p => p.join(' '))}];`],
    [
      'MATLAB by axes',
      `[${columns(cube)
        .map(axis => axis.join(', '))
        .join('; ...\n')}]`,
    ],
    ['R', `m <- matrix(c(${columns(cube).flat()}), ncol = 3)`],
    ['R by rows', `m <- matrix(c(${flat}), ncol = 3, byrow = TRUE)`],
    ['Fortran', `x = reshape((/ ${flat} /), (/ 3, 8 /))`],
    ['Mathematica', `{${rows(cube).map(p => `{${p}}`)}}`],
    [
      'three lists',
      columns(cube)
        .map((axis, a) => `${'xyz'[a]} = [${axis}]`)
        .join('\n'),
    ],
    ['YAML', `points:\n${lines(rows(cube), p => `  - [${p.join(', ')}]`)}`],
    ['labels', lines(rows(cube), ([x, y, z]) => `  x= ${x} y= ${y} z= ${z}`)],
    ['JSON objects', JSON.stringify(rows(cube).map(([x, y, z]) => ({ x, y, z })))],
    ['CSV', `x,y,z\n${lines(rows(cube), p => p.join(','))}`],
    ['CSV, other columns', `"id";"T";"z";"x";"y"\n${lines(rows(cube), ([x, y, z], v) => `${v};20.5;${z};${x};${y}`)}`],
    ['CSV in tabs', `Node\tX [m]\tY [m]\tZ [m]\n${lines(rows(cube), (p, v) => [v + 1, ...p].join('\t'))}`],
    ['a table with an index', lines(rows(cube), (p, v) => `${v + 101}  ${p.map(x => x.toExponential(6)).join('  ')}`)],
    ['a table with a reference', lines(rows(cube), p => `${p.join(' ')} 0`)],
    ['a table with both', lines(rows(cube), (p, v) => `${v} ${p.join(' ')} 7`)],
    ['an element and an index', lines(rows(cube), (p, v) => `17 ${v + 1} ${p.join(' ')}`)],
    ['a last column that counts', lines(rows(cube), (p, v) => `${p.join(' ')} ${v}`)],
    ['LaTeX', `\\begin{bmatrix}\n${lines(rows(cube), p => `${p.join(' & ')} \\\\`)}\n\\end{bmatrix}`],
    ['Markdown', `| x | y | z |\n|---|---|---|\n${lines(rows(cube), p => `| ${p.join(' | ')} |`)}`],
    ['a log', lines(rows(cube), (p, v) => `node ${v + 17} (${p.join(', ')})`)],
    ['a log of times', lines(rows(cube), p => `2026-01-31 12:30:01.5 [info] ${p.map(x => `${x}.0`).join(' ')}`)],
    ['signs that touch', lines(rows(cube), p => p.map(x => (x === 0 ? '-0.00E+00' : '+1.00E+00')).join(''))],
  ])('%s', (_, text) => {
    const [found, isStated] = only(text)
    expect(found.map(x => x + 0)).toEqual(cube)
    expect(isStated).toBe(false)
  })

  test('several elements, with their numbers', () => {
    const log = (number: number, vertices: readonly number[]) =>
      `Element ${number} is inverted at (0.5, 0.5, 0.25):\n${lines(rows(vertices), (p, v) => `  node ${v} (${p.join(', ')})`)}\n`
    const mesh = readText(log(12, cube) + log(21, upper))
    expect(elements(mesh)).toEqual([cube, upper])
    expect([...(mesh.ids ?? [])]).toEqual([12, 21])
    expect(elements(readText(`a = np.array([[[${rows(cube).join('],[')}]],[[${rows(upper).join('],[')}]]])`))).toEqual([
      cube,
      upper,
    ])
    expect(elements(readText(`${cube.join(' ')}\n${upper.join(' ')}`))).toEqual([cube, upper])
    expect(elements(readText(`1 ${cube.join(' ')}\n2 ${upper.join(' ')}`))).toEqual([cube, upper])
    const table = [...rows(cube), ...rows(upper)].map(
      (p, i) => `${Math.floor(i / 8) + 1} ${(i % 8) + 1} ${p.join(' ')}`,
    )
    expect([...(readText(table.join('\n')).ids ?? [])]).toEqual([1, 2])
  })

  test('the list that analyze reads states its order', () => {
    const list = [
      { name: 'lower', vertices: rows(cube) },
      { name: 'upper', vertices: upper },
    ]
    const mesh = readText(JSON.stringify(list))
    expect([elements(mesh), mesh.ids, mesh.isOrderStated]).toEqual([[cube, upper], ['lower', 'upper'], true])
  })

  test('a cut text: whole elements are read', () => {
    const mesh = readText(
      `${lines(rows(cube), p => p.join(' '))}\n...\n${lines(rows(upper).slice(3), p => p.join(' '))}`,
    )
    expect([elements(mesh), mesh.isCutOff]).toEqual([[cube], true])
    expect(refusal(`[[0 0 0]\n [1 0 0]\n [1 1 0]\n ...\n [0 0 1]\n [1 0 1]\n [0 1 1]]`)).toMatch(/needs 24/)
  })

  test('a coordinate that is not finite stays', () => {
    const [found] = only(lines(rows(cube.with(3, Number.NaN)), p => p.join(' ')))
    expect(found[3]).toBeNaN()
  })

  test.each([
    ['23 numbers', cube.slice(1).join(' '), /23 numbers were found; an element needs 24/],
    ['words', 'hello', /0 numbers were found/],
    ['blanks', ' \n', /no text/],
    ['seven points', lines(rows(cube).slice(1), (p, v) => `node ${v} (${p.join(', ')})`), /7 points/],
    ['a line with too few', lines(rows(cube), (p, v) => (v === 4 ? p.slice(1) : p).join(' ')), /row 5|23 numbers/],
    [
      'a line with too few, one with too many',
      lines(rows(cube), (p, v) => [...(v === 4 ? p.slice(1) : p), ...(v === 6 ? [1] : [])].join(' ')),
      /row 5/,
    ],
    ['four columns that are nothing', lines(rows(cube), (p, v) => `${p.join(' ')} ${0.1 * v * v}`), /4 columns/],
    [
      'ranks that print at once',
      `rank 1: bad element\nrank 2: bad element\n${lines([...rows(cube), ...rows(upper)], p => p.map(x => `${x}.5`).join(' '))}`,
      /not certain/,
    ],
  ])('refused: %s', (_, text, sentence) => {
    expect(refusal(text)).toMatch(sentence)
  })
})

describe('cells that are there are used', () => {
  const points = `[${lexicographic.map(p => `[${p.map(x => `${x}.0`)}]`)}]`
  const table = lines(lexicographic, p => p.map(x => `${x}.0`).join(' '))
  const numbered = lines(lexicographic, (p, v) => `${v + 1} ${p.map(x => `${x}.0`).join(' ')}`)
  test.each([
    ['JSON', JSON.stringify({ points: lexicographic, cells: [cell] })],
    ['JSON, cells first', JSON.stringify({ cells: [{ type: 'hexahedron', data: [cell] }], points: lexicographic })],
    ['JSON, vertices', JSON.stringify({ vertices: lexicographic, hexahedra: [cell] })],
    ['meshio', `points = ${points}\ncells = [("hexahedron", np.array([[${cell}]]))]`],
    [
      'pyvista',
      `points = np.array(${points})\ncells = np.array([8, ${cell}])\ngrid = pv.UnstructuredGrid(cells, [12], points)`,
    ],
    [
      'pyvista, dictionary',
      `grid = pv.UnstructuredGrid({pv.CellType.HEXAHEDRON: np.array([[${cell}]])}, np.array(${points}))`,
    ],
    ['MATLAB', `nodes = [${lexicographic.map(p => p.join(' ')).join('; ')}];\nelements = [${oneBased.join(' ')}];`],
    [
      'Julia',
      `nodes = [Node((${lexicographic.map(p => p.map(x => `${x}.0`).join(', ')).join(')), Node((')}))]\ncells = [Hexahedron((${oneBased}))]`,
    ],
    ['tables without names', `${table}\n\n${cell.join(' ')}`],
    ['tables with names', `NODES\n8\n${table}\nELEMENTS\n1\n${cell.join(' ')}`],
    ['numbered tables', `${numbered}\n\n1 ${oneBased.join(' ')}`],
    ['numbered tables with tags', `# nodes\n${numbered}\n# elements\n1 5 2 1 1 ${oneBased.join(' ')}`],
    [
      'ids that are not in a row',
      `${lines(lexicographic, (p, v) => `${10 * v + 10}, ${p.map(x => `${x}.0`)}`)}\n\n7, ${oneBased.map(v => 10 * v)}`,
    ],
    [
      'a log',
      `${lines(lexicographic, (p, v) => `node ${v + 17} (${p.join(', ')})`)}\nelement 5: ${cell.map(v => v + 17).join(' ')}`,
    ],
    [
      'YAML',
      `points:\n${lines(lexicographic, p => `- [${p.map(x => `${x}.0`).join(', ')}]`)}\ncells:\n- [${cell.join(', ')}]`,
    ],
    [
      'a word before them',
      `${lines(lexicographic, p => `v ${p.map(x => `${x}.0`).join(' ')}`)}\nhex ${cell.join(' ')}`,
    ],
    ['faces', `verts = ${points}\nfaces = [[0,2,3,1],[4,5,7,6],[0,1,5,4],[1,3,7,5],[3,2,6,7],[2,0,4,6]]`],
  ])('%s', (_, text) => {
    const [found, isStated] = only(text)
    expect(found).toEqual(cube)
    expect(isStated).toBe(true)
  })

  test('cells that go on over lines', () => {
    const nodes = lines(lexicographic, (p, v) => `NODE,${v + 1},,${p.map(x => `${x}.`).join(',')}`)
    expect(only(`${nodes}\nBRICK,1,1,1,2,4,3,5,6,+\n+,8,7`)).toEqual([cube, true])
    expect(only(`${numbered}\n\n1, 1,2,4,3,5,\n6,8,7`)).toEqual([cube, true])
  })

  test('points counted from 0 or from 1: refused where that is open', () => {
    const ten = `${table}\n5.0 5.0 5.0\n6.0 6.0 6.0`
    expect(refusal(`${ten}\n\n${oneBased.join(' ')}`)).toMatch(/from 0 or from 1/)
    expect(only(`${ten}\n\n${cell.join(' ')}`)).toEqual([cube, true])
  })

  test('or the text is refused', () => {
    for (const cells of ['0 1 3 2', '90 91 93 92 94 95 97 96', '4 0 1 3 2\n4 4 5 7 6']) {
      const answer = refusal(`${table}\n\n${cells}`)
      expect(answer, cells).not.toMatch(/read as/)
    }
    expect(refusal(JSON.stringify({ points: lexicographic, cells: [[0, 1, 3, 2, 4, 5, 7, 99]] }))).toMatch(
      /names point 99/,
    )
  })

  test('tetrahedra are counted, not read as points', () => {
    const mesh = readText(
      JSON.stringify({
        points: lexicographic,
        tetrahedra: [
          [0, 1, 2, 4],
          [1, 2, 3, 7],
        ],
      }),
    )
    expect([mesh.cells.length, mesh.other.get('tetrahedron')]).toEqual([0, 2])
  })

  test('two meshes in one text', () => {
    const one = (shift: number) =>
      `points = [${lexicographic.map(([x, y, z]) => `[${x}.0, ${y}.0, ${(z as number) + shift}.0]`)}]\ncells = [("hexahedron", [[${cell}]])]\n`
    expect(elements(readText(one(0) + one(1)))).toEqual([cube, upper])
  })

  test('quoted, in fences, in UTF-16', () => {
    const text = `my mesh:\n\n\`\`\`\n${numbered}\n\n1 ${oneBased.join(' ')}\n\`\`\`\nIs element 3 of 8 wrong?`
    expect(only(text)).toEqual([cube, true])
    expect(
      only(
        `On Monday you wrote:\n${
          lines(
            text.split('\n').map(() => []),
            () => '',
          ) && text.replace(/^/gm, '> ')
        }`,
      ),
    ).toEqual([cube, true])
    const utf16 = new Uint8Array([0xff, 0xfe, ...Array.from(text, c => [c.charCodeAt(0), 0]).flat()])
    expect(refusal(utf16)).toMatch(/read as .*, 1$/)
  })
})

test('Gmsh’s MATLAB file', () => {
  const [mesh] = readFile(new URL('meshes/made/', shared), 'gmsh.m')
  expect(mesh?.cells.length).toBe(8 * 15)
  expect(Object.fromEntries(mesh?.other ?? [])).toEqual({ quadrilateral: 2, tetrahedron: 2, wedge: 1, pyramid: 1 })
})

test('no text is slow', () => {
  const size = 100_000
  const repeated = [
    'a',
    '1',
    ' ',
    '\n',
    '-',
    '[',
    '1.',
    'v=',
    '(1 ',
    'array(',
    '1;',
    'x=',
    'double v[]={',
    'double a[',
    '/* ',
    '...',
    '...\n',
    '[;',
    '{',
    '"',
    "'",
    "a'",
    '`',
    '```\n',
    '> ',
    '>>> ',
    '#',
    '%',
    'p 1 2 3 ',
    'p 1 2 3\n',
    '1 2 3 4\n',
    '0 1 2 3 4 5 6 7\n',
    'x=1 y=2 z=',
    'x = 1 2 3\n',
    '[1,',
    '[[1,2,3],',
    '1e',
    '1.1',
    '0x1',
    '…',
    '{"a":',
    '[[[]',
    'element 1 ',
    'v 1 2 3\nf 1 2 3 4\n',
    'hex (',
    '\\',
    '&',
    '12:',
    '2026-',
    'e1e1e1',
    '−',
    'nan ',
    'ZONE ',
    'x=1,',
    'a=[1,2,3];',
    '1\t',
  ]
  for (const text of repeated) {
    for (const end of ['', ' q', '\n0 0 0']) {
      const start = processorTime()
      expect(refusal(text.repeat(size / text.length) + end), JSON.stringify(text)).not.toBe('')
      expect(processorTime() - start, JSON.stringify(text + end)).toBeLessThan(4000)
    }
  }
}, 600_000)
