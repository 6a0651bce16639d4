/** One element, written in many ways: the file's own order and ids come through, whichever way it is. */
import { describe, expect, test } from 'vitest'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'
import { readText, textFile, verticesOf } from './mesh-expectations'
import { checked } from './mesh-fixtures'

/** Valid in this order, invalid in most others. */
const rows = [
  [0, 0, 0],
  [1.25, 0, 0.125],
  [1.5, 1, 0],
  [0, 1.25, 0],
  [0, 0.125, 1],
  [1, 0, 1.5],
  [1.125, 1, 1.25],
  [0.25, 1, 1],
]
const flat = rows.flat()
const columns = [0, 1, 2].map(axis => rows.map(row => row[axis] as number))
const eachRow = (of: (row: readonly number[], i: number) => string, between = '\n') => rows.map(of).join(between)
/** The same points in another order, and the cell that names them, counted from 0. */
const shuffle = [3, 0, 6, 1, 7, 2, 5, 4]
const shuffled = shuffle.map(i => rows[i] as number[])
const cell = rows.map((_, i) => shuffle.indexOf(i))

/** A number as Python prints it: 13 digits behind the point, whatever they are. */
function hex(x: number): string {
  if (x === 0) return '0x0.0p+0'
  const power = Math.floor(Math.log2(x))
  const fraction = Math.round((x / 2 ** power - 1) * 2 ** 52)
  return `0x1.${fraction.toString(16).padStart(13, '0')}p${power < 0 ? '' : '+'}${power}`
}

function expectElement(text: string, count = 1): void {
  const mesh = readText('a.txt', text)
  expect(mesh.cells.length / 8).toBe(count)
  expect(verticesOf(mesh, 0)).toEqual(flat)
}

describe('lists and tables as languages and programs write them', () => {
  test.each<[string, string]>([
    ['C, entry by entry', eachRow((row, i) => row.map((x, j) => `c[${i}][${j}] = ${x};`).join('\n'))],
    ['C, axis by axis', eachRow(([x, y, z], i) => `x[${i}] = ${x}; y[${i}] = ${y}; z[${i}] = ${z};`)],
    ['members', eachRow(([x, y, z], i) => `p[${i}].x = ${x}; p[${i}].y = ${y}; p[${i}].z = ${z};`)],
    ['Fortran, counted from 1', eachRow((row, i) => row.map((x, j) => `x(${j + 1},${i + 1}) = ${x}d0`).join('\n'))],
    ['Eigen, three rows', `Eigen::Matrix<double, 3, 8> X;\nX << ${columns.map(c => c.join(', ')).join(',\n  ')};`],
    ['Fortran 90', `x = reshape( (/ &\n${eachRow(row => row.map(x => `${x}d0`).join(', '), ', &\n')} /), (/3,8/) )`],
    [
      'Fortran kinds',
      eachRow((row, i) => `x(:,${i + 1}) = [${row.map(x => `${x}.0_dp`.replace(/(\.\d+)\.0/, '$1'))}]`),
    ],
    ['Fortran 77', `      DATA X /\n${eachRow(row => `     & ${row.map(x => `${x.toFixed(3)}D+00`)}`, ',\n')}/`],
    ['Rust', `let x = [${flat.map(x => `${x.toFixed(3)}_f64`)}];`],
    ['Mathematica', `{${eachRow(row => `{${row.map(x => `${10 * x}*^-1`)}}`, ', ')}}`],
    ['numpy.reshape', `np.reshape([${columns.flat()}], (3, 8))`],
    ['NumPy, wrapped', `coords: [${flat.slice(0, 13).join(' ')}\n ${flat.slice(13).join(' ')}]\nj = -1`],
    ['R', [0, 1, 2].map(k => ` [${8 * k + 1}] ${flat.slice(8 * k, 8 * k + 8).join('  ')}`).join('\n')],
    ['YAML', `nodes:\n${eachRow(([x, y, z]) => `- - ${x}\n  - ${y}\n  - ${z}`)}`],
    ['a flat C array, entry by entry', flat.map((x, i) => `coord[${i}] = ${x}`).join('\n')],
    ['LLDB', `(double[24]) $0 = {\n${flat.map((x, i) => `  [${i}] = ${x}`).join('\n')}\n}`],
    ['units', eachRow((row, i) => `P${i}: ${row.map(x => `${x} mm`).join(', ')}`)],
    ["Python's float.hex", eachRow(row => row.map(hex).join(' '))],
    ['full-width commas', eachRow(row => row.join('，'))],
    ['colours', `\u001b[31merror\u001b[0m\n${eachRow(row => `\u001b[1;32m${row.join(' ')}\u001b[0m`)}`],
    ['thin spaces', eachRow(row => row.join('\u2009\u2003'))],
    [
      'LaTeX in one line',
      `\\begin{pmatrix} ${eachRow(row => row.map(x => `$${x}$`).join(' & '), ' \\\\ ')} \\end{pmatrix}`,
    ],
    ['LaTeX, the last row unlike', eachRow((row, i) => `\\mathbf{x}_${i} &= (${row.join(', ')})^T`, ' \\\\\n')],
    ['pandas', `    id   x   y   z\n${eachRow((row, i) => `${i}  ${100 + i}  ${row.join('  ')}`)}`],
    ['HTML', `<table>\n${eachRow(row => `<tr>\n<td>${row.join('</td>\n<td class="a">')}</td></tr>`)}</table>`],
    [
      'titles of 24 columns',
      `id,${columns.flatMap((_, axis) => rows.map((_, i) => `${'xyz'[axis]}${i}`))}\n7,${columns.flat()}`,
    ],
    ['points, then a matrix', `element 3\nnodes:\n${eachRow(row => row.join(' '))}\njacobian:\n1 0.5 0\n0 1 0\n0 0 -1`],
  ])('%s', (_, text) => expectElement(text))

  test.each([
    ['a flat list of x, then y, then z', `double v[24] = {${columns.flat()}};`, 'as eight x, eight y and eight z'],
    [
      'a flat list in three lines',
      `${[0, 1, 2].map(k => flat.slice(8 * k, 8 * k + 8).join(' ')).join('\n')}`,
      'as eight points one',
    ],
  ])('%s is told by the element that it makes', async (_, text, said) => {
    const check = await checked(readText('a.txt', text))
    expect([check.valid, check.mesh.isOrderStated]).toEqual([1, false])
    expect(verticesOf(check.mesh, 0)).toEqual(flat)
    expect(check.notes.join(' ')).toContain(said)
  })

  test('an invalid element stays in the layout that is usual', () => {
    const element = flat.with(21, 2)
    expect(verticesOf(readText('a.c', `double v[24] = {${element}};`), 0)).toEqual(element)
  })

  test('24 titled columns are named by the first', () => {
    const titles = rows.flatMap((_, i) => ['x', 'y', 'z'].map(axis => `p${i}_${axis}`))
    const mesh = readText('a.csv', `elem,${titles}\n7,${flat}\n9,${flat}\n`)
    expect([...(mesh.ids ?? [])]).toEqual([7, 9])
  })
})

describe('cells are used, in whatever way they are named', () => {
  test.each<[string, string]>([
    [
      'Gmsh in Python',
      `gmsh.model.mesh.addNodes(3, 1, [1,2,3,4,5,6,7,8], [${shuffled.flat()}])
       gmsh.model.mesh.addElementsByType(1, 5, [1], [${cell.map(i => i + 1)}])`,
    ],
    [
      'VTK in Python',
      `${shuffled.map(row => `pts.InsertNextPoint(${row.join(', ')})`).join('\n')}
       ${cell.map((id, i) => `hexa.GetPointIds().SetId(${i}, ${id})`).join('\n')}`,
    ],
    [
      'JSON by id',
      JSON.stringify({
        nodes: Object.fromEntries(shuffled.map((row, i) => [`${i + 1}`, row])),
        elements: { 1: cell.map(i => i + 1) },
      }),
    ],
    [
      'JSON, objects',
      JSON.stringify({
        nodes: shuffled.map(([x, y, z], i) => ({ id: 10 + i, x, y, z })),
        elements: [{ id: 5, type: 'HEX8', nodes: cell.map(i => 10 + i) }],
      }),
    ],
  ])('%s', (_, text) => expectElement(text))

  test('of a cut table the cells that are whole are read', () => {
    const nodes = shuffled.map((row, i) => `${11 + i}  ${row.join(' ')}`).join('\n')
    const mesh = readText(
      'a.txt',
      `${nodes}\n...\n\n1  ${cell.map(i => 11 + i).join(' ')}\n2  21 22 23 24 25 26 27 28\n`,
    )
    expect([mesh.cells.length, mesh.isCutOff, verticesOf(mesh, 0)]).toEqual([8, true, flat])
  })

  test.each([
    [
      'FEniCSx',
      `mesh = dolfinx.mesh.create_mesh(comm, [[0,1,3,2,4,5,7,6]], np.array([${eachRow(row => `[${row}]`, ',')}]), d)`,
    ],
    [
      'deal.II',
      `std::vector<Point<3>> v = {${[0, 1, 3, 2, 4, 5, 7, 6].map(i => `{${rows[i]}}`)}};\nstd::vector<CellData<3>> cells(1);\ncells[0].vertices = {0, 1, 2, 3, 4, 5, 6, 7};`,
    ],
  ])('the order of %s is its own', async (_, text) => {
    const check = await checked(readText('a.txt', text))
    expect([check.hexahedra, check.invalid, check.unanswered]).toEqual([1, 0, 1])
  })
})

describe('ids, blocks and time of VTK', () => {
  const two = [...flat, ...rows.flatMap(([x = 0, y = 0, z = 0]) => [x + 3, y, z])]
  const array = (type: string, name: string, values: readonly number[]) =>
    `<DataArray type="${type}" Name="${name}" format="ascii">${values.join(' ')}</DataArray>`
  const vtu = (cellData: string, fieldData = '') => `<VTKFile type="UnstructuredGrid"><UnstructuredGrid>${fieldData}
    <Piece NumberOfPoints="16" NumberOfCells="3">${cellData}
    <Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">${two.join(' ')}</DataArray></Points>
    <Cells>${array('Int64', 'connectivity', [0, 1, 3, 4, ...Array(16).keys()])}
    ${array('Int64', 'offsets', [4, 12, 20])}${array('UInt8', 'types', [10, 12, 12])}</Cells></Piece></UnstructuredGrid></VTKFile>`
  const vtk = (behind: string, before = '') => `# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID
${before}POINTS 16 double\n${two.join(' ')}\nCELLS 3 23\n4 0 1 3 4\n8 0 1 2 3 4 5 6 7\n8 8 9 10 11 12 13 14 15\nCELL_TYPES 3\n10 12 12\n${behind}`
  const said = (name: string, text: string) => {
    const { ids, blocks, steps } = readText(name, text)
    return { ids: ids === null ? null : [...ids], blocks: blocks.map(block => [block.name, ...block.cells]), steps }
  }

  test('VTU: global ids and materials', () => {
    const data = `<CellData GlobalIds="gid">${array('Int32', 'MaterialIds', [1, 2, 3])}${array('Int64', 'gid', [5, 70, 6])}</CellData>`
    expect(said('a.vtu', vtu(data))).toEqual({
      ids: [70, 6],
      blocks: [
        ['MaterialIds 2', 0],
        ['MaterialIds 3', 1],
      ],
      steps: [],
    })
  })

  test('VTU: ids that are not distinct are none, and fractions are no blocks', () => {
    const data = `<CellData>${array('Int64', 'GlobalElementId', [5, 5, 6])}${array('Float64', 'region', [1, 0.5, 2])}</CellData>`
    expect(said('a.vtu', vtu(data))).toEqual({ ids: null, blocks: [], steps: [] })
  })

  test('VTU: its time', () => {
    const time = `<FieldData><DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">0.25</DataArray></FieldData>`
    expect(said('a.vtu', vtu('', time)).steps).toEqual(['0.25'])
  })

  test.each([
    ['SCALARS', 'CELL_DATA 3\nSCALARS mat int 1\nLOOKUP_TABLE default\n1 2 3\nGLOBAL_IDS g vtkIdType\n5 70 6\n'],
    [
      'FIELD behind data of points',
      'POINT_DATA 16\nVECTORS u float\n1 2 3\nCELL_DATA 3\nFIELD f 2\nmat 1 3 int\n1 2 3\nElement%20Id 1 3 int\n5 70 6\n',
    ],
    [
      'arrays that are passed',
      'CELL_DATA 3\nVECTORS u float\n1 2 3 1 2 3 1 2 3\nTENSORS t float\n1 1 1 1 1 1 1 1 1\n1 1 1 1 1 1 1 1 1\n1 1 1 1 1 1 1 1 1\nMETADATA\nINFORMATION 0\n\nSCALARS mat int\nLOOKUP_TABLE default\n1 2 3\nPEDIGREE_IDS PedigreeIds int\n5 70 6\n',
    ],
  ])('legacy: %s', (_, data) => {
    expect(said('a.vtk', vtk(data))).toEqual({
      ids: [70, 6],
      blocks: [
        ['mat 2', 0],
        ['mat 3', 1],
      ],
      steps: [],
    })
  })

  test('legacy: time, and data that are damaged', () => {
    const { cells, steps } = readText(
      'a.vtk',
      vtk('CELL_DATA 3\nSCALARS mat int 1\nLOOKUP_TABLE default\nx\n', 'FIELD f 1\nTIME 1 1 double\n0.5\n'),
    )
    expect([cells.length, steps]).toEqual([16, ['0.5']])
  })

  test('legacy, binary: data of points are passed', () => {
    const numbers = (values: readonly number[], bytes: 4 | 8) => {
      const view = new DataView(new ArrayBuffer(bytes * values.length))
      for (const [i, value] of values.entries())
        bytes === 8 ? view.setFloat64(8 * i, value) : view.setInt32(4 * i, value)
      return new Uint8Array(view.buffer)
    }
    const parts = [
      '# vtk DataFile Version 3.0\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n',
      numbers(flat, 8),
      '\nCELLS 1 9\n',
      numbers([8, 0, 1, 2, 3, 4, 5, 6, 7], 4),
      '\nCELL_TYPES 1\n',
      numbers([12], 4),
      '\nPOINT_DATA 8\nSCALARS t int\nLOOKUP_TABLE default\n',
      numbers([1, 2, 3, 4, 5, 6, 7, 8], 4),
      '\nCELL_DATA 1\nFIELD f 1\nregion 1 1 int\n',
      numbers([3], 4),
      '\n',
    ].map(part => (typeof part === 'string' ? new TextEncoder().encode(part) : part))
    const bytes = Uint8Array.from(parts.flatMap(part => [...part]))
    expect(readMeshes(fileOfBytes('a.vtk', bytes))[0]?.blocks.map(({ name }) => name)).toEqual(['region 3'])
  })

  test('a grid of nothing, as VTK writes it', () => {
    const mesh = readText(
      'a.vtk',
      '# vtk DataFile Version 5.1\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 0 float\n\n',
    )
    expect(mesh.cells.length).toBe(0)
  })

  test('a .pvd: the step that is asked for', () => {
    const pvd = `<VTKFile type="Collection"><Collection>${[0, 0.5, 2].map(time => `<DataSet timestep="${time}" file="${time}.vtu"/>`)}</Collection></VTKFile>`
    const find = (name: string) => (name === '9.vtu' ? null : textFile(name, vtu('')))
    const read = (step: number | 'last') => readMeshes(textFile('a.pvd', pvd), { find, step })[0]
    expect(read('last')?.notes).toContain('Time step 3 of 3 was read: “2”.')
    expect(read(1)?.notes).toContain('Time step 2 of 3 was read: “0.5”.')
    expect(read(0)?.steps).toEqual(['0', '0.5', '2'])
    expect(() => read(3)).toThrow('a.pvd: it has 3 time steps, and step 4 was asked for.')
  })
})

test('a second heading of Abaqus begins another file', () => {
  const nodes = (dx: number) => rows.map(([x = 0, y, z], i) => `${i + 1}, ${x + dx}, ${y}, ${z}`).join('\n')
  const text = (dx: number) => `*Heading\nx\n*Node\n${nodes(dx)}\n*Element, type=C3D8\n1, 1,2,3,4,5,6,7,8\n`
  const meshes = readMeshes(textFile('a.inp', text(0) + text(4)))
  expect(meshes.map(mesh => verticesOf(mesh, 0)[0])).toEqual([0, 4])
})

test('fences that hold files of different formats are read one by one', () => {
  const nodes = (separator: string) => rows.map((row, i) => [i + 1, ...row].join(separator)).join('\n')
  const gmsh = `$Nodes\n8\n${nodes(' ')}\n$EndNodes\n$Elements\n1\n3 5 2 1 1 1 2 3 4 5 6 7 8\n$EndElements`
  const abaqus = `*Node\n${nodes(', ')}\n*Element, type=C3D8\n4, 1,2,3,4,5,6,7,8`
  const text = `This:\n\`\`\`\n${gmsh}\n\`\`\`\nand that:\n\`\`\`inp\n${abaqus}\n\`\`\`\n`
  const meshes = readMeshes(textFile('a.md', text))
  expect(meshes.map(({ format, ids }) => [format, ...(ids ?? [])])).toEqual([
    ['Gmsh', 3],
    ['Abaqus', 4],
  ])
  expect(meshes.map(mesh => verticesOf(mesh, 0))).toEqual([flat, flat])
  const parts = `nodes:\n\`\`\`\n${abaqus.split('*Element')[0]}\`\`\`\ncells:\n\`\`\`\n*Element${abaqus.split('*Element')[1]}\n\`\`\`\n`
  expectElement(parts)
})

test('nodes of version 1 of Gmsh with what it knows of their entities', () => {
  const nodes = rows.map((row, i) => `${i + 1} ${row.join(' ')} ${i < 4 ? '2 7 0.5 0.25' : '3 1'}`).join('\n')
  expectElement(`$NOD\n8\n${nodes}\n$ENDNOD\n$ELM\n1\n1 5 1 1 8 1 2 3 4 5 6 7 8\n$ENDELM\n`)
  expect(() => readText('a.msh', `$NOD\n1\n1 0 0 0 0.5\n$ENDNOD\n`)).toThrow('more numbers than a node has')
})

test('comments before the format of a Gmsh file', () => {
  const nodes = rows.map((row, i) => `${i + 1} ${row.join(' ')}`).join('\n')
  expectElement(
    `$Comments\nx\n$EndComments\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n${nodes}\n$EndNodes\n$Elements\n1\n1 5 2 1 1 1 2 3 4 5 6 7 8\n$EndElements\n`,
  )
})
