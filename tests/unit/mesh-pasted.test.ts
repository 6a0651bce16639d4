/** Texts as they are pasted, through the one reader: which elements come out, by which format, and what is said of the others. */
import { describe, expect, test } from 'vitest'
import { joined } from '../../web/mesh/join-meshes'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readTogether } from '../../web/mesh/read-mesh'
import { verticesOf } from '../../web/mesh/vertices-of'
import { stateDocument } from '../../web/model/state-document'
import { createStore } from '../../web/model/store'
import { textFile } from './mesh-expectations'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const upper = cube.map((value, i) => (i % 3 === 2 ? value + 1 : value))
const rows = (vertices: readonly number[]) => Array.from({ length: 8 }, (_, v) => vertices.slice(3 * v, 3 * v + 3))
const columns = (vertices: readonly number[]) => [0, 1, 2].map(axis => vertices.filter((_, i) => i % 3 === axis))

interface Element {
  /** The name in the text; the index if there are no names. */
  readonly id: string
  readonly vertices: readonly number[]
}

function meshesOf(text: string): readonly Mesh[] {
  return readTogether([textFile('The text', text)], { onProgress: () => {}, throwIfCancelled: () => {} })
}

function read(text: string) {
  const meshes = meshesOf(text)
  const mesh = joined(meshes as [Mesh])
  const elements = Array.from({ length: mesh.cells.length / 8 }, (_, cell): Element => {
    return { id: String(mesh.ids?.[cell] ?? cell), vertices: verticesOf(mesh, cell) }
  })
  return {
    format: mesh.format,
    elements,
    notes: mesh.notes.join(' '),
    other: [...mesh.other],
    isOrderStated: mesh.isOrderStated,
  }
}

/** Exactly one element, by this format. */
function only(text: string) {
  const { format, elements } = read(text)
  expect(elements).toHaveLength(1)
  return [format, elements[0]?.vertices]
}

function refusal(text: string): string {
  try {
    return `read as ${read(text).format}`
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
}

describe('what a text calculates with its numbers is not done, and said', () => {
  const array = `np.array(${JSON.stringify(rows(cube))})`
  const [x, y, z] = [0, 1, 2].map(axis => `[${rows(cube).map(point => point[axis])}]`)
  test.each([
    [`p = ${array} * [1, 1, -1]`, ') * ['],
    [`p = 1e-3*${array}`, '1e-3*np.array(['],
    [`p = ${array}/1000`, ')/1000'],
    [`X = ${x};\nY = ${y};\nZ = -${z};`, '= -['],
    [`X = ${x};\nY = ${y};\nZ = ${z}.*2.5;`, '].*2.5'],
  ])('%s', (text, at) => {
    expect(read(text).notes).toContain(`The text calculates with its numbers at “${at}”: this was not done here.`)
  })

  test.each([
    [`p = ${array}`],
    [
      `- [0, 0, 0]\n${rows(cube)
        .map(point => `- [${point}]\n`)
        .slice(1)
        .join('')}`,
    ],
  ])('%s', text => {
    expect(read(text).notes).not.toContain('calculates')
  })
})

describe('plain numbers', () => {
  test.each([
    ['spaces', cube.join(' ')],
    ['commas', cube.join(',')],
    [
      'semicolons and tabs',
      rows(cube)
        .map(point => point.join('\t'))
        .join(';'),
    ],
    [
      'brackets',
      `[[${rows(cube)
        .map(point => point.join(' '))
        .join(']\n [')}]]`,
    ],
    [
      'tuples on one line',
      `(${rows(cube)
        .map(point => point.join(', '))
        .join('), (')}) ,`,
    ],
    ['six on a line', cube.join(' ').replace(/((?:\S+ ){6})/g, '$1\n')],
    [
      'Windows ends of lines',
      rows(cube)
        .map(point => point.join(' '))
        .join('\r\n'),
    ],
    [
      'trailing comma, as JSON forbids',
      `[${rows(cube)
        .map(point => `[${point}],`)
        .join('\n')}]`,
    ],
  ])('with %s', (_, text) => {
    expect(only(text)[1]).toEqual(cube)
  })

  test('Fortran exponents, signs that touch, true minus signs', () => {
    const text = rows(cube)
      .map(point => point.map(value => `${value === 1 ? '-0.1000000D+01' : '-0.0000000D+00'}`).join(''))
      .join('\n')
    expect(only(text)[1]).toEqual(cube.map(value => (value === 1 ? -1 : -0)))
    expect(only(cube.map(value => `−${value}.5e0`).join(' '))[1]).toEqual(cube.map(value => -(value + 0.5)))
  })

  test('decimal commas are told from separators', () => {
    const { elements, notes } = read(cube.map(value => `${value},25`).join(' '))
    expect(elements[0]?.vertices).toEqual(cube.map(value => value + 0.25))
    expect(notes).toContain('Commas were taken for decimal points.')
    expect(
      only(
        rows(cube)
          .map(point => point.join(','))
          .join(' '),
      )[1],
    ).toEqual(cube)
  })

  test('three lines of eight are the coordinates by axes', () => {
    const { elements, isOrderStated } = read(
      columns(cube)
        .map(axis => axis.join(' '))
        .join('\n'),
    )
    expect(elements.map(({ vertices }) => vertices)).toEqual([cube])
    expect(isOrderStated).toBe(false)
  })

  test('of a multiple of 24 each is one', () => {
    const { elements } = read(`${cube.join(' ')}\n${upper.join(' ')}`)
    expect(elements).toEqual([
      { id: '0', vertices: cube },
      { id: '1', vertices: upper },
    ])
  })

  test('what is no element is refused with what was seen', () => {
    expect(refusal(cube.slice(1).join(' '))).toBe('The text: 23 numbers were found; an element needs 24.')
    expect(refusal('1')).toBe('The text: 1 number was found; an element needs 24.')
    expect(refusal('hello')).toBe('The text: 0 numbers were found; an element needs 24.')
    expect(refusal(' \n')).toBe('The text: there is no text in it.')
    expect(refusal('\x7fELF\0\0\0')).toMatch(/this is a program/)
    expect(refusal('a\0b')).toBe('The text: this is in no format that is known here.')
  })

  test.each([
    ['too large', '1e999', Infinity],
    ['no number', 'nan', Number.NaN],
  ])('a coordinate that is %s stays, and its element is unanswered', (_, word, value) => {
    const { elements } = read(cube.join(' ').replace('1', word))
    expect(elements.map(({ vertices }) => vertices)).toEqual([cube.with(3, value)])
  })
})

describe('JSON', () => {
  test.each([
    ['flat', cube],
    ['nested', rows(cube)],
    ['by axes', columns(cube)],
    ['as an object', { vertices: cube }],
    ['as an object of points', { name: 'a', vertices: rows(cube), note: [1, 2, 3] }],
    ['deep', { mesh: { cells: [{ id: 3, vertices: rows(cube) }] } }],
  ])('%s', (_, value) => {
    expect(only(JSON.stringify(value))).toEqual(['JSON', cube])
  })

  test('the list that analyze reads, with its names', () => {
    const list = [
      { name: 'lower', vertices: rows(cube) },
      { name: 'upper', vertices: rows(upper) },
    ]
    expect(read(JSON.stringify(list))).toMatchObject({
      elements: [{ id: 'lower' }, { id: 'upper' }],
      isOrderStated: true,
    })
    expect(read(JSON.stringify(list.map(({ name, vertices }) => ({ name, vertices: vertices.flat() }))))).toMatchObject(
      {
        elements: [
          { id: 'lower', vertices: cube },
          { id: 'upper', vertices: upper },
        ],
        isOrderStated: true,
      },
    )
    expect(refusal(JSON.stringify([...list, { name: 'short', vertices: rows(cube).slice(1) }]))).toBe(
      'The text: the vertices of entry 2 (“short”) are not 24 numbers, nor eight lists of three.',
    )
  })

  test('the state of an element is that element, whatever it started from', () => {
    const store = createStore(cube, null)
    store.dispatch({ type: 'set-vertices', vertices: upper.with(0, -0), preset: null })
    const state = stateDocument(store.state, { names: [], slices: [] })
    expect(only(JSON.stringify({ ...state, start: cube }))).toEqual(['JSON', upper.with(0, -0)])
  })

  test('signs of zero, and what is too large', () => {
    expect(only(`[${cube.map(() => '-0')}]`)[1]).toEqual(cube.map(() => -0))
    expect(only(`[${cube.join(',').replace('1', '1e999')}]`)[1]).toEqual(cube.with(3, Infinity))
    expect(refusal(JSON.stringify(rows(cube).slice(1)))).toBe('The text: 21 numbers were found; an element needs 24.')
    expect(refusal(JSON.stringify(cube.slice(1)))).toBe('The text: 23 numbers were found; an element needs 24.')
    expect(refusal('{"a": 1}')).toBe('The text: 1 number was found; an element needs 24.')
  })
})

describe('NumPy', () => {
  const repr = `array([[0.  , 0.  , 0.  ],
       [1.  , 0.  , 0.  ],
       [1.  , 1.  , 0.  ],
       [0.  , 1.  , 0.  ],
       [0.  , 0.  , 1.  ],
       [1.  , 0.  , 1.  ],
       [1.  , 1.  , 1.  ],
       [0.  , 1.  , 1.25]])`
  const last = cube.with(23, 1.25)

  test('repr, str, with a dtype, by axes, several in one array', () => {
    expect(only(repr)).toEqual(['NumPy', last])
    expect(only(`>>> hexa = np.${repr.replace(/\)$/, ', dtype=float32)')}`)[1]).toEqual(last)
    expect(only(repr.replace(/array\(|\)|,/g, ''))[1]).toEqual(last)
    expect(
      only(
        `array([[${columns(cube)
          .map(axis => axis.map(x => `${x}.`).join(', '))
          .join('],\n       [')}]])`,
      )[1],
    ).toEqual(cube)
    expect(only(`[${rows(cube).map(point => `[${point.map(x => `np.float64(${x}.0)`)}]`)}]`)[1]).toEqual(cube)
    const both = read(`points = np.array([[[${rows(cube).join('],[')}]],[[${rows(upper).join('],[')}]]])`)
    expect(both.elements).toEqual([
      { id: 'points, 0', vertices: cube },
      { id: 'points, 1', vertices: upper },
    ])
    expect(refusal('array([[1., 2., 3.]])')).toBe('The text: 3 numbers were found; an element needs 24.')
  })
})

describe('MATLAB', () => {
  test('a printed 8×3 matrix with a common factor, not rounded twice', () => {
    const text = `
V =

   1.0e+03 *

         0         0         0
    1.0000         0         0
    1.0000    1.0000         0
         0    1.0000         0
         0         0    0.0011
    1.0000         0    0.0011
    1.0000    1.0000    0.0011
         0    1.0000    0.0011
`
    expect(only(text)).toEqual(['MATLAB', cube.map((x, i) => (i % 3 === 2 ? x * 1.1 : x * 1000))])
  })

  test('points as columns, in blocks', () => {
    const block = (from: number, to: number) =>
      columns(cube)
        .map(axis => `   ${axis.slice(from, to).join('     ')}`)
        .join('\n')
    const text = `P =\n\n  Columns 1 through 5\n\n${block(0, 5)}\n\n  Columns 6 through 8\n\n${block(5, 8)}\n\n`
    expect(only(text)).toEqual(['MATLAB', cube])
    expect(only(text.replaceAll('through', 'to'))[1]).toEqual(cube)
  })

  test('typed, with semicolons, rows or columns; several matrices by name', () => {
    expect(
      only(
        `V = [${rows(cube)
          .map(point => point.join(' '))
          .join('; ')}];`,
      ),
    ).toEqual(['MATLAB', cube])
    expect(
      only(
        `[${columns(cube)
          .map(axis => axis.join(', '))
          .join('; ...\n')}]`,
      )[1],
    ).toEqual(cube)
    const printed = (name: string, vertices: number[]) =>
      `${name} =\n\n${rows(vertices)
        .map(p => `   ${p.join('   ')}`)
        .join('\n')}\n\n`
    expect(read(printed('A', cube) + printed('B', upper)).elements).toEqual([
      { id: 'A', vertices: cube },
      { id: 'B', vertices: upper },
    ])
    expect(refusal('A =\n\n   1.0e+03 *\n\n    1.0000    2.0000\n    3.0000    4.0000\n')).toBe(
      'The text: 5 numbers were found; an element needs 24.',
    )
  })
})

/** Two cells on top of each other, twelve nodes. */
const nodes = [...rows(cube), ...rows(upper).slice(4)]
const cells = [
  [0, 1, 2, 3, 4, 5, 6, 7],
  [4, 5, 6, 7, 8, 9, 10, 11],
]
const oneBased = cells.map(cell => cell.map(node => node + 1))

describe('VTK', () => {
  const points = `POINTS 12 double\n${nodes.map(point => point.join(' ')).join('\n')}\n`
  const header = '# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n'

  test('cells of type 12 among others', () => {
    const text = `${header}${points}CELLS 3 23\n8 ${cells[0]?.join(' ')}\n4 0 1 2 3\n8 ${cells[1]?.join(' ')}\nCELL_TYPES 3\n12\n9\n12\nCELL_DATA 3\n`
    const { format, elements, other } = read(text)
    expect([format, other]).toEqual(['VTK', [['quadrilateral', 1]]])
    expect(elements).toEqual([
      { id: '0', vertices: cube },
      { id: '1', vertices: upper },
    ])
  })

  test('version 5.1, and a snippet without types', () => {
    const text = `# vtk DataFile Version 5.1\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n${points}CELLS 3 16\nOFFSETS vtktypeint64\n0 8 16\nCONNECTIVITY vtktypeint64\n${cells.flat().join(' ')}\nCELL_TYPES 2\n12\n12\n`
    expect(read(text).elements.map(({ vertices }) => vertices)).toEqual([cube, upper])
    const snippet = `${points}CELLS 1 9\n8 ${cells[1]?.join(' ')}`
    expect(only(snippet)).toEqual(['VTK', upper])
    expect(read(snippet)).toMatchObject({ isOrderStated: false, notes: expect.stringMatching(/no CELL_TYPES/) })
    expect(refusal(`${header}${snippet}`)).toMatch(/no section CELL_TYPES was there/)
  })

  test('refusals', () => {
    expect(refusal(`${header.replace('ASCII', 'BINARY')}POINTS 8 double\n\0\0\nCELLS 1 9\n`)).toMatch(
      /^The text, byte 81: .*the file is cut off\.$/,
    )
    expect(read(`${header}${points}CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n`)).toMatchObject({
      elements: [],
      other: [['tetrahedron', 1]],
    })
    expect(refusal(`${header}POINTS 12 double\n0 0 0\nCELLS 1 9`)).toMatch(
      /line 7: “CELLS” stands where coordinate 4 of 36 was expected/,
    )
    expect(refusal(`${points}CELLS 1 9\n8 0 1 2`)).toMatch(/the file is cut off: it ends where number 5 of 9/)
    expect(refusal(`${points}CELLS 1 9\n8 0 1 2 3 4 5 6 77\n`)).toMatch(/names point 77/)
  })
})

describe('Gmsh', () => {
  const numbered = nodes.map((point, i) => `${i + 1} ${point.join(' ')}`).join('\n')
  const version2 = `$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
12
${numbered}
$EndNodes
$Elements
3
1 15 2 0 1 1
2 5 2 0 1 ${oneBased[0]?.join(' ')}
3 5 4 0 1 1 2 ${oneBased[1]?.join(' ')}
$EndElements
`
  const version4 = `$MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 0 1
1 0 0 0 1 1 2 0 0
$EndEntities
$Nodes
2 12 1 12
2 5 0 4
1
2
3
4
${nodes
  .slice(0, 4)
  .map(point => point.join(' '))
  .join('\n')}
3 1 1 8
${Array.from({ length: 8 }, (_, i) => i + 5).join('\n')}
${nodes
  .slice(4)
  .map(point => `${point.join(' ')} 0.5 0.5 0.5`)
  .join('\n')}
$EndNodes
$Elements
2 3 1 3
2 5 3 1
1 1 2 3 4 
3 1 5 2
2 ${oneBased[0]?.join(' ')} 
3 ${oneBased[1]?.join(' ')} 
$EndElements
`

  test.each([
    ['2.2', version2, 'vertex'],
    ['4.1', version4, 'quadrilateral'],
    ['4.1 without its header', version4.slice(version4.indexOf('$Nodes')), 'quadrilateral'],
  ])('version %s', (_, text, what) => {
    const { format, elements, other } = read(text)
    expect([format, other]).toEqual(['Gmsh', [[what, 1]]])
    expect(elements).toEqual([
      { id: '2', vertices: cube },
      { id: '3', vertices: upper },
    ])
  })

  test('refusals', () => {
    expect(refusal(version2.replace('2.2 0 8', '2.2 1 8'))).toMatch(/binary/)
    expect(refusal(version2.replace('2.2 0 8', '4 0 8'))).toMatch(/in version 4, not with “12”/)
    expect(read(version2.replace(/^([23]) 5 .*$/gm, '$1 15 2 0 1 1'))).toMatchObject({
      elements: [],
      other: [['vertex', 3]],
    })
  })
})

describe('Abaqus', () => {
  const text = `*HEADING
** a comment
*NODE, NSET=NALL
${nodes.map((point, i) => `${10 * (i + 1)}, ${point.map(x => `${x}.`).join(', ')}`).join('\n')}
*ELEMENT, TYPE=S4, ELSET=SHELL
1, 10, 20, 30, 40
*Element, type=C3D8R, elset=EALL
17, ${oneBased[0]?.map(node => 10 * node).join(', ')}
18, 50, 60, 70, 80,
90, 100, 110, 120
*NODE PRINT
U
*ELSET, ELSET=A
1, 2, 3
`

  test('bricks, with lines that go on', () => {
    const { format, elements, other } = read(text)
    expect([format, other]).toEqual(['Abaqus', [['quadrilateral', 1]]])
    expect(elements).toEqual([
      { id: '17', vertices: cube },
      { id: '18', vertices: upper },
    ])
  })

  test('node numbers hold within a part', () => {
    const part = (name: string, vertices: readonly number[]) =>
      `*PART, NAME=${name}\n*NODE\n${rows(vertices)
        .map((point, i) => `${i + 1}, ${point.join(', ')}`)
        .join('\n')}\n*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*END PART\n`
    const { format, elements } = read(part('A', cube) + part('B', upper))
    expect([format, ...elements.map(({ vertices }) => vertices)]).toEqual(['Abaqus', cube, upper])
  })

  test('refusals', () => {
    expect(refusal(text.replace('C3D8R', 'C3D20'))).toMatch(/element 17 has 8 nodes; C3D20 has 20/)
    expect(refusal(text.replace('*NODE, NSET=NALL', '*NODE, SYSTEM=S'))).toMatch(/spherical/)
    expect(read(text.replace('1., 1., 1.', '1., 1e999, 1.')).elements[0]?.vertices).toContain(Infinity)
  })
})

test('Medit, on lines or not, with comments', () => {
  const text = `MeshVersionFormatted 2
# written by hand
Dimension
3
Vertices
12
${nodes.map(point => `${point.join(' ')} 0`).join('\n')}
Quadrilaterals
1
1 2 3 4 7
Hexahedra
2
${oneBased.map(cell => `${cell.join(' ')} 1`).join('\n')}
End
`
  const expected = [
    { id: '0', vertices: cube },
    { id: '1', vertices: upper },
  ]
  expect(read(text)).toMatchObject({ format: 'Medit', elements: expected })
  expect(read(text.replace(/Dimension\n3/, 'Dimension 3').replaceAll(' 0\n', ' 0 ')).elements).toEqual(expected)
  expect(refusal(text.replace('Dimension\n3', 'Dimension 2'))).toMatch(
    /the mesh is two-dimensional: there are no hexahedra/,
  )
  expect(read(text.replace(/Hexahedra[\s\S]*/, 'End'))).toMatchObject({ elements: [], other: [['quadrilateral', 1]] })
})

test('OBJ and a C array', () => {
  const lines = rows(cube)
    .map(point => `v ${point.join(' ')}`)
    .join('\n')
  const faces = ['1 4 3 2', '5 6 7 8', '1 2 6 5', '3 4 8 7', '2 3 7 6', '1 5 8 4']
  const sides = faces.map(face => `f ${face.replace(/\d/g, '$&//1')}`).join('\n')
  const hexahedron = read(`o a b\n${lines}\nvn 0 0 1\n${sides}\n`)
  expect(hexahedron).toMatchObject({ format: 'OBJ', elements: [{ id: 'a b' }], isOrderStated: true })
  expect(new Set(rows(hexahedron.elements[0]?.vertices ?? []).map(String))).toEqual(new Set(rows(cube).map(String)))
  expect(only(lines)[1]).toEqual(cube)
  expect(refusal(`${lines}\nf 1 2 3 4\n`)).toMatch(/a surface in OBJ \(8 points, 1 faces\)/)
  expect(refusal(`${lines}\nv 1 1 1\nf 1 2 3\n`)).toMatch(/9 points/)
  expect(
    only(
      `const double hex[8][3] = {\n${rows(cube)
        .map(p => `  {${p.map(x => `${x}.0`).join(', ')}},`)
        .join(' // vertex 1\n')}\n};`,
    ),
  ).toEqual(['C', cube])
  expect(only(`static float v[] = {${cube.map(x => `${x}.5f`)}};`)[1]).toEqual(cube.map(x => x + 0.5))
  expect(refusal('double v[3] = {1, 2, 3};')).toMatch(/an element needs 24/)
  expect(only(`https://example.org/#v=1&vertices=${cube}`)).toEqual(['a link', cube])
  expect(refusal('#v=1&vertices=1,2')).toMatch(/holds 2 numbers/)
})

describe('points in other text', () => {
  test.each([
    ['tuples after words', (p: number[], v: number) => `node ${v + 17} (${p.join(', ')})`],
    ['labels', (p: number[]) => `  x= ${p[0]} y= ${p[1]} z= ${p[2]}`],
    ['labels with commas', (p: number[], v: number) => `vertex ${v}: X=${p[0]}, Y=${p[1]}, Z=${p[2]}`],
    [
      'a table with node numbers',
      (p: number[], v: number) => `${v + 101}   ${p.map(x => x.toExponential(6)).join('   ')}`,
    ],
    ['node numbers and a value', (p: number[], v: number) => `node ${v + 1}: ${p.join(' ')}  jac -0.25`],
    ['times', (p: number[]) => `2026-01-31 12:30:01.5 [info] ${p.map(x => `${x}.0`).join(' ')}`],
    ['Fortran', (p: number[], v: number) => ` NODE=${v + 1} ${p.map(x => `${x}.0D+00`).join(' ')}`],
  ])('%s', (_, line) => {
    const log = `*** ERROR: negative Jacobian in element 4711, det = -1.5D-03\n${rows(cube).map(line).join('\n')}\n3 elements were checked.\n`
    const { format, elements } = read(log)
    expect(format).toBe('points in text')
    expect(elements).toEqual([{ id: '4711', vertices: cube }])
  })

  test('another point among them does not hide the eight, and elements keep their numbers', () => {
    const log = (number: number, vertices: readonly number[]) =>
      `Element ${number} is inverted at (0.5, 0.5, 0.25):\n${rows(vertices)
        .map((p, v) => `  node ${v} (${p.join(', ')})`)
        .join('\n')}\n`
    expect(read(log(12, cube) + log(21, upper)).elements).toEqual([
      { id: '12', vertices: cube },
      { id: '21', vertices: upper },
    ])
  })

  test('all on one line', () => {
    expect(
      read(
        `cell 3 inverted: ${rows(cube)
          .map(p => `(${p.join(' ')})`)
          .join(' ')}`,
      ).elements,
    ).toEqual([{ id: '3', vertices: cube }])
  })

  test('seven points are refused with their count', () => {
    const log = rows(cube)
      .slice(1)
      .map((p, v) => `node ${v} (${p.join(', ')})`)
      .join('\n')
    expect(refusal(log)).toBe(
      'The text: 28 numbers were found, but no eight points of three numbers that belong together. 7 points of three coordinates are among them; an element has 8.',
    )
  })
})

test('of many elements all are there', () => {
  expect(read(Array.from({ length: 1500 }, () => cube.join(' ')).join('\n')).elements).toHaveLength(1500)
  const copies = Array.from({ length: 1500 }, (_, i) => `${i + 1} 5 0 1 2 3 4 5 6 7 8`).join('\n')
  const mesh = `$Nodes\n8\n${rows(cube)
    .map((p, v) => `${v + 1} ${p.join(' ')}`)
    .join('\n')}\n$EndNodes\n$Elements\n1500\n${copies}\n$EndElements`
  const inMesh = read(mesh)
  expect([inMesh.elements.length, inMesh.format]).toEqual([1500, 'Gmsh'])
})

test('long runs of what formats look for are read in one go', () => {
  for (const text of ['a', '1', ' ', '\n', '-', '[', '1.', 'v=', '(1 ', 'array(', '1;', 'x=', 'double v[]={']) {
    const long = text.repeat(400_000 / text.length)
    expect(refusal(long), JSON.stringify(text)).toMatch(/^The text.*\.$/)
  }
})
