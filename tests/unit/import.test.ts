import { describe, expect, test } from 'vitest'
import { MOST_CHARACTERS, readElements } from '../../web/model/import/import'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const upper = cube.map((value, i) => (i % 3 === 2 ? value + 1 : value))
const rows = (vertices: readonly number[]) => Array.from({ length: 8 }, (_, v) => vertices.slice(3 * v, 3 * v + 3))
const columns = (vertices: readonly number[]) => [0, 1, 2].map(axis => vertices.filter((_, i) => i % 3 === axis))

function read(text: string) {
  const result = readElements(text)
  if (!result.ok) throw new Error(`refused: ${result.message}`)
  return { format: result.format, ...result.reading }
}

/** Exactly one element, by this format. */
function only(text: string) {
  const { format, elements, count } = read(text)
  expect([elements.length, count]).toEqual([1, 1])
  return [format, elements[0]?.vertices]
}

function refusal(text: string): string {
  const result = readElements(text)
  return result.ok ? `read as ${result.format}` : result.message
}

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
    const { elements, note } = read(cube.map(value => `${value},25`).join(' '))
    expect(elements[0]?.vertices).toEqual(cube.map(value => value + 0.25))
    expect(note).toBe('Commas were taken for decimal points.')
    expect(
      only(
        rows(cube)
          .map(point => point.join(','))
          .join(' '),
      )[1],
    ).toEqual(cube)
  })

  test('three lines of eight may be meant both ways, and both are offered', () => {
    const { elements } = read(
      columns(cube)
        .map(axis => axis.join(' '))
        .join('\n'),
    )
    expect(elements.map(({ vertices }) => vertices)).toEqual([cube, columns(cube).flat()])
  })

  test('of a multiple of 24 each is offered', () => {
    const { elements } = read(`${cube.join(' ')}\n${upper.join(' ')}`)
    expect(elements).toEqual([
      { name: 'numbers 1 to 24', vertices: cube },
      { name: 'numbers 25 to 48', vertices: upper },
    ])
  })

  test('what is no element is refused with what was seen', () => {
    expect(refusal(cube.slice(1).join(' '))).toBe('23 numbers were found; an element needs 24.')
    expect(refusal('1')).toBe('1 number was found; an element needs 24.')
    expect(refusal('hello')).toBe('0 numbers were found; an element needs 24.')
    expect(refusal(' \n')).toBe('There is no text in it.')
    expect(refusal(cube.with(3, 1e300).join(' ').replace('1e+300', '1e999'))).toMatch(/^1e999 is too large/)
    expect(refusal(cube.join(' ').replace('1', 'nan'))).toBe(
      '23 numbers were found; an element needs 24. 1 point of three coordinates among them; an element has 8. “nan” is no number that a coordinate can be.',
    )
    expect(refusal('\x7fELF\0\0\0')).toMatch(/binary/)
    expect(refusal('0'.repeat(MOST_CHARACTERS + 1))).toMatch(/^This is 50 MB; up to 50 MB are read/)
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
      { name: 'short', vertices: rows(cube).slice(1) },
    ]
    const { elements, note } = read(JSON.stringify(list))
    expect(elements.map(({ name }) => name)).toEqual(['lower', 'upper'])
    expect(note).toMatch(/1 entry was left out. The vertices of “short”/)
  })

  test('signs of zero, and what is too large', () => {
    expect(only(`[${cube.map(() => '-0')}]`)[1]).toEqual(cube.map(() => -0))
    expect(refusal(`[${cube.join(',').replace('1', '1e999')}]`)).toBe(
      'Number 4 of the element is too large: a coordinate is a double, at most 1.8×10³⁰⁸.',
    )
    expect(refusal(JSON.stringify(rows(cube).slice(1)))).toBe('The element has 7 points; an element needs 8.')
    expect(refusal(JSON.stringify(cube.slice(1)))).toBe('23 numbers were found; an element needs 24.')
    expect(refusal('{"a": 1}')).toMatch(/nothing has eight points/)
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
      { name: 'points[0]', vertices: cube },
      { name: 'points[1]', vertices: upper },
    ])
    expect(refusal('array([[1., 2., 3.]])')).toBe('The array has 3 numbers; an element needs 24.')
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
      { name: 'A', vertices: cube },
      { name: 'B', vertices: upper },
    ])
    expect(refusal('A =\n\n   1.0e+03 *\n\n    1.0000    2.0000\n    3.0000    4.0000\n')).toMatch(
      /A matrix of 2×2 was found/,
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
    const { format, elements, count, note } = read(text)
    expect([format, count, note]).toEqual(['VTK', 2, '1 cell of other kinds left out.'])
    expect(elements).toEqual([
      { name: 'cell 0', vertices: cube },
      { name: 'cell 2', vertices: upper },
    ])
  })

  test('version 5.1, and a snippet without types', () => {
    const text = `# vtk DataFile Version 5.1\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n${points}CELLS 3 16\nOFFSETS vtktypeint64\n0 8 16\nCONNECTIVITY vtktypeint64\n${cells.flat().join(' ')}\nCELL_TYPES 2\n12\n12\n`
    expect(read(text).elements.map(({ vertices }) => vertices)).toEqual([cube, upper])
    expect(only(`${points}CELLS 1 9\n8 ${cells[1]?.join(' ')}`)).toEqual(['VTK', upper])
  })

  test('refusals', () => {
    expect(refusal(`${header.replace('ASCII', 'BINARY')}POINTS 8 double\n\0\0\nCELLS 1 9\n`)).toMatch(/binary/)
    expect(refusal(`${header}${points}CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n`)).toBe(
      '1 cell was found, but none is a cell of eight points and type 12 (VTK_HEXAHEDRON).',
    )
    expect(refusal(`${header}POINTS 12 double\n0 0 0\nCELLS 1 9`)).toMatch(/stands where a number/)
    expect(refusal(`${points}CELLS 1 9\n8 0 1 2`)).toBe('The text ends in the middle of its cells.')
    expect(refusal(`${points}CELLS 1 9\n8 0 1 2 3 4 5 6 77\n`)).toMatch(/not the nodes/)
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
    ['2.2', version2],
    ['4.1', version4],
    ['4.1 without its header', version4.slice(version4.indexOf('$Nodes'))],
  ])('version %s', (_, text) => {
    const { format, elements, count, note } = read(text)
    expect([format, count, note]).toEqual(['Gmsh', 2, '1 cell of other kinds left out.'])
    expect(elements).toEqual([
      { name: 'element 2', vertices: cube },
      { name: 'element 3', vertices: upper },
    ])
  })

  test('refusals', () => {
    expect(refusal(version2.replace('2.2 0 8', '2.2 1 8'))).toMatch(/binary/)
    expect(refusal(version2.replace('2.2 0 8', '4 0 8'))).toMatch(/4\.0/)
    expect(refusal(version2.replace(/ 5 (?=[24])/g, ' 17 '))).toMatch(/3 cells were found, but none is of type 5/)
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
    const { format, elements, count, note } = read(text)
    expect([format, count, note]).toEqual(['Abaqus', 2, '1 cell of other kinds left out.'])
    expect(elements).toEqual([
      { name: 'element 17', vertices: cube },
      { name: 'element 18', vertices: upper },
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
    expect(refusal(text.replace('C3D8R', 'C3D20'))).toMatch(/none is a brick of eight nodes/)
    expect(refusal(text.replace('*NODE, NSET=NALL', '*NODE, SYSTEM=C'))).toMatch(/cylindrical/)
    expect(refusal(text.replace('1., 1., 1.', '1., 1e999, 1.'))).toMatch(/1e999 is too large/)
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
    { name: 'hexahedron 1', vertices: cube },
    { name: 'hexahedron 2', vertices: upper },
  ]
  expect(read(text)).toMatchObject({ format: 'Medit', count: 2, elements: expected })
  expect(read(text.replace(/Dimension\n3/, 'Dimension 3').replaceAll(' 0\n', ' 0 ')).elements).toEqual(expected)
  expect(refusal(text.replace('Dimension\n3', 'Dimension 2'))).toMatch(/of the plane/)
  expect(refusal(text.replace(/Hexahedra[\s\S]*/, 'End'))).toMatch(/No cells were found/)
})

test('OBJ and a C array', () => {
  const lines = rows(cube)
    .map(point => `v ${point.join(' ')}`)
    .join('\n')
  expect(read(`o a b\n${lines}\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n`)).toMatchObject({
    format: 'OBJ',
    elements: [{ name: 'a b', vertices: cube }],
  })
  expect(refusal(`${lines}\nv 1 1 1\nf 1 2 3\n`)).toMatch(/9 points/)
  expect(
    only(
      `const double hex[8][3] = {\n${rows(cube)
        .map(p => `  {${p.map(x => `${x}.0`).join(', ')}},`)
        .join(' // vertex 1\n')}\n};`,
    ),
  ).toEqual(['C', cube])
  expect(only(`static float v[] = {${cube.map(x => `${x}.5f`)}};`)[1]).toEqual(cube.map(x => x + 0.5))
  expect(refusal('double v[3] = {1, 2, 3};')).toBe('The array v has 3 numbers; an element needs 24.')
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
    expect(format).toBe('points in other text')
    expect(elements).toEqual([{ name: 'element 4711', vertices: cube }])
  })

  test('another point among them does not hide the eight, and elements keep their numbers', () => {
    const log = (number: number, vertices: readonly number[]) =>
      `Element ${number} is inverted at (0.5, 0.5, 0.25):\n${rows(vertices)
        .map((p, v) => `  node ${v} (${p.join(', ')})`)
        .join('\n')}\n`
    expect(read(log(12, cube) + log(21, upper)).elements).toEqual([
      { name: 'element 12', vertices: cube },
      { name: 'element 21', vertices: upper },
    ])
  })

  test('all on one line', () => {
    expect(
      read(
        `cell 3 inverted: ${rows(cube)
          .map(p => `(${p.join(' ')})`)
          .join(' ')}`,
      ).elements,
    ).toEqual([{ name: 'element 3', vertices: cube }])
  })

  test('seven points are refused with their count', () => {
    const log = rows(cube)
      .slice(1)
      .map((p, v) => `node ${v} (${p.join(', ')})`)
      .join('\n')
    expect(refusal(log)).toBe(
      '28 numbers were found; an element needs 24. 7 points of three coordinates among them; an element has 8.',
    )
  })
})

test('of many elements the first thousand are listed, and all counted', () => {
  const { elements, count } = read(Array.from({ length: 1500 }, () => cube.join(' ')).join('\n'))
  expect([elements.length, count]).toEqual([1000, 1500])
  const copies = Array.from({ length: 1500 }, (_, i) => `${i + 1} 5 0 1 2 3 4 5 6 7 8`).join('\n')
  const mesh = `$Nodes\n8\n${rows(cube)
    .map((p, v) => `${v + 1} ${p.join(' ')}`)
    .join('\n')}\n$EndNodes\n$Elements\n1500\n${copies}\n$EndElements`
  const inMesh = read(mesh)
  expect([inMesh.elements.length, inMesh.count, inMesh.format]).toEqual([1000, 1500, 'Gmsh'])
})

test('long runs of what formats look for are read in one go', () => {
  for (const text of ['a', '1', ' ', '\n', '-', '[', '1.', 'v=', '(1 ', 'array(', '1;', 'x=', 'double v[]={']) {
    const long = text.repeat(400_000 / text.length)
    expect(readElements(long).ok, JSON.stringify(text)).toBe(false)
  }
})
