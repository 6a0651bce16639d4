import { deflateRawSync, deflateSync, gzipSync } from 'node:zlib'
import { describe, expect, test } from 'vitest'
import { adler32, crc32, crc64 } from '../../web/mesh/codecs/checksums'
import { inflate, unzlib } from '../../web/mesh/codecs/inflate'
import { unlz4 } from '../../web/mesh/codecs/lz4'
import { type Mesh, MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { processorTime } from './processor-time'

const cube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
const nodes = [0, 1, 2, 3, 4, 5, 6, 7]
const bytesOf = (text: string) => new TextEncoder().encode(text)

function read(text: string | Uint8Array, name = 'a.vtu', find: (name: string) => MeshFile | null = () => null): Mesh[] {
  return [...readMeshes(fileOfBytes(name, typeof text === 'string' ? bytesOf(text) : text), { find })]
}

function only(text: string | Uint8Array, name?: string): Mesh {
  const meshes = read(text, name)
  expect(meshes.length).toBe(1)
  return meshes[0] as Mesh
}

function refusalOf(run: () => unknown): string {
  try {
    run()
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  }
  return 'was read'
}

function joined(parts: readonly Uint8Array[]): Uint8Array {
  return new Uint8Array(Buffer.concat(parts))
}

/** Numbers as bytes. */
function packed(type: string, values: readonly number[], isLittle: boolean): Uint8Array {
  const size = Number(/\d+/.exec(type)?.[0]) / 8
  const view = new DataView(new ArrayBuffer(size * values.length))
  values.forEach((value, i) => {
    if (type === 'Float64') view.setFloat64(8 * i, value, isLittle)
    else if (type === 'Float32') view.setFloat32(4 * i, value, isLittle)
    else if (size === 8) view.setBigInt64(8 * i, BigInt(value), isLittle)
    else if (size === 4) view.setInt32(4 * i, value, isLittle)
    else if (size === 2) view.setInt16(2 * i, value, isLittle)
    else view.setInt8(i, value)
  })
  return new Uint8Array(view.buffer)
}

/** An LZ4 block of literals alone. */
function lz4(bytes: Uint8Array): Uint8Array {
  const lengths: number[] = []
  if (bytes.length >= 15) {
    let left = bytes.length - 15
    for (; left >= 255; left -= 255) lengths.push(255)
    lengths.push(left)
  }
  return joined([Uint8Array.of(Math.min(15, bytes.length) << 4, ...lengths), bytes])
}

interface Variant {
  readonly format: 'binary' | 'appended' | 'appended base64'
  readonly header: 'UInt32' | 'UInt64'
  readonly isLittle: boolean
  readonly compressor: 'none' | 'vtkZLibDataCompressor' | 'vtkLZ4DataCompressor'
  readonly blockSize: number
  readonly pointType: string
  readonly indexType: string
  readonly typesType: string
}

/** A VTU of cubes in a row, each with points of its own, in several pieces. */
function vtuOf(variant: Variant, pieces: readonly number[]): Uint8Array {
  const { format, header, isLittle, compressor, blockSize } = variant
  const headerBytes = (values: readonly number[]) => packed(header === 'UInt32' ? 'Int32' : 'Int64', values, isLittle)
  const base64 = (bytes: Uint8Array) => Buffer.from(bytes).toString('base64')
  const appended: Uint8Array[] = []
  let offset = 0
  const array = (name: string, type: string, values: readonly number[], more = ''): string => {
    const bytes = packed(type, values, isLittle)
    let parts = [headerBytes([bytes.length]), bytes]
    let text = base64(joined(parts))
    if (compressor !== 'none') {
      const blocks: Uint8Array[] = []
      for (let from = 0; from < bytes.length; from += blockSize) {
        const block = bytes.subarray(from, from + blockSize)
        blocks.push(compressor === 'vtkLZ4DataCompressor' ? lz4(block) : new Uint8Array(deflateSync(block)))
      }
      const sizes = blocks.map(block => block.length)
      parts = [headerBytes([blocks.length, blockSize, bytes.length % blockSize, ...sizes]), joined(blocks)]
      text = parts.map(base64).join('')
    }
    const start = `<DataArray type="${type}" Name="${name}" ${more}`
    if (format === 'binary') return `${start} format="binary">\n  ${text}\n</DataArray>`
    const data = format === 'appended' ? joined(parts) : bytesOf(text)
    appended.push(data)
    offset += data.length
    return `${start} format="appended" offset="${offset - data.length}"/>`
  }
  const grids = pieces.map((count, piece) => {
    const points = Array.from({ length: count }, (_, c) =>
      cube.map((x, i) => (i % 3 === 0 ? x + 2 * c : x + 5 * piece)),
    )
    const points3 = array('Points', variant.pointType, points.flat(), 'NumberOfComponents="3"')
    const indices = Array.from({ length: 8 * count }, (_, i) => i)
    const ends = Array.from({ length: count }, (_, c) => 8 * c + 8)
    return `<Piece NumberOfPoints="${8 * count}" NumberOfCells="${count}"><Points>${points3}</Points><Cells>
      ${array('connectivity', variant.indexType, indices)}${array('offsets', variant.indexType, ends)}
      ${array('types', variant.typesType, Array(count).fill(12))}</Cells></Piece>`
  })
  const packing = compressor === 'none' ? '' : ` compressor="${compressor}"`
  const order = isLittle ? 'LittleEndian' : 'BigEndian'
  const encoding = format === 'appended' ? 'raw' : 'base64'
  return joined([
    bytesOf(`<?xml version='1.0'?><!-- > -- > --><VTKFile type="UnstructuredGrid" byte_order="${order}" header_type='${header}'${packing}>
      <UnstructuredGrid>${grids.join('\n')}</UnstructuredGrid>`),
    ...(format === 'binary'
      ? []
      : [bytesOf(`<AppendedData encoding="${encoding}">\n _`), ...appended, bytesOf('</AppendedData>')]),
    bytesOf('</VTKFile>\n'),
  ])
}

const variants: Variant[] = []
for (const format of ['binary', 'appended', 'appended base64'] as const)
  for (const header of ['UInt32', 'UInt64'] as const)
    for (const isLittle of [true, false])
      for (const compressor of ['none', 'vtkZLibDataCompressor', 'vtkLZ4DataCompressor'] as const)
        for (const [blockSize, pointType, indexType, typesType] of [
          [32768, 'Float64', 'Int64', 'UInt8'],
          [1000, 'Float32', 'Int32', 'Int64'],
          [17, 'Float64', 'Int16', 'Int32'],
        ] as const)
          variants.push({ format, header, isLittle, compressor, blockSize, pointType, indexType, typesType })

test.each(variants)('$format $header little: $isLittle $compressor $blockSize $pointType $indexType', variant => {
  const mesh = only(vtuOf(variant, [3, 0, 70]))
  expect([mesh.points.length, mesh.cells.length]).toEqual([24 * 73, 8 * 73])
  expect([...mesh.cells]).toEqual(Array.from({ length: 8 * 73 }, (_, i) => i))
  const second = cube.map((x, i) => (i % 3 === 0 ? x + 2 * 69 : x + 10))
  expect([...mesh.points.subarray(-24)]).toEqual(second)
  expect(mesh.notes.length).toBe(variant.pointType === 'Float32' ? 1 : 0)
})

describe('VTU in text', () => {
  const vtu = (points: string, connectivity: string, offsets: string, types: string, counts = [8, 1]) =>
    `<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="${counts[0]}" NumberOfCells="${counts[1]}">
     <PointData><DataArray type="Float32" Name="types" format="ascii">1 2</DataArray></PointData><Points>
     <DataArray type="Float64" NumberOfComponents="3">${points}</DataArray></Points><Cells>
     <DataArray type="Int64" Name="connectivity">${connectivity}</DataArray>
     <DataArray type="Int64" Name="offsets">${offsets}</DataArray>
     <DataArray type="UInt8" Name="types">${types}</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>`
  const whole = vtu(cube.join(' '), nodes.join(' '), '8', '12')

  test('text around it, and two after each other', () => {
    expect(read(`my file:\n${whole}\nwhy?\n${whole}\n`).length).toBe(2)
  })

  test('the end tags are missing: read, and said', () => {
    const mesh = only(whole.slice(0, -'</UnstructuredGrid></VTKFile>'.length))
    expect([mesh.cells.length, mesh.isCutOff, mesh.notes.length]).toEqual([8, true, 1])
    expect(refusalOf(() => read(whole.slice(0, -100)))).toMatch(/cut off/)
  })

  test('what is left out is said, and what is whole is read', () => {
    const mesh = only(vtu(`${cube.join(' ')} ...`, `${nodes.join(' ')} …`, '8 16 ...', '12 12 [...]', [800, 90]))
    expect([mesh.cells.length, mesh.isCutOff]).toEqual([8, true])
    expect(mesh.notes[0]).toMatch(/792 of the declared points and 89 of the declared cells/)
  })

  test('indices beyond 32 bits, negative or not there', () => {
    for (const index of ['4294967296', '4294967303', '18446744073709551616', '-1', '8', '1e0', '7.0'])
      expect(refusalOf(() => read(vtu(cube.join(' '), `0 1 2 3 4 5 6 ${index}`, '8', '12')))).toContain(index)
  })

  test('cells with a wrong number of points, of types that do not exist, or points too many', () => {
    const of = (type: string) => refusalOf(() => read(vtu(cube.join(' '), nodes.join(' '), '8', type)))
    expect(of('10')).toBe('a.vtu: cell 0 of type 10 has 8 points; it must have 4.')
    expect(of('99')).toBe('a.vtu: cell 0 has type 99, which VTK does not have.')
    expect(of('300')).toMatch(/.300. in .types./)
    expect(refusalOf(() => read(vtu(cube.join(' '), `${nodes.join(' ')} 0`, '8', '12')))).toMatch(
      /more than the 8 numbers/,
    )
  })

  test('a Lagrange hexahedron of order 1 is trilinear', () => {
    expect(only(vtu(cube.join(' '), nodes.join(' '), '8', '72')).cells.length).toBe(8)
  })

  test('other types are refused by name', () => {
    const refusal = refusalOf(() => read('<VTKFile type="PolyData"></VTKFile>', 'a.vtp'))
    expect(refusal).toMatch(/type .PolyData., which is not read: ParaView saves it/)
  })

  test('a .pvd has time steps, of which the first is read', () => {
    const pvd = `<VTKFile type="Collection"><Collection><DataSet timestep="0.5" part="0" file="x &amp; y.vtu"/>
      <DataSet timestep="1" part="0" file="z.vtu"/></Collection></VTKFile>`
    const [mesh] = read(pvd, 'a.pvd', name => (name === 'x & y.vtu' ? fileOfBytes(name, bytesOf(whole)) : null))
    expect([mesh?.cells.length, mesh?.steps]).toEqual([8, ['0.5', '1']])
  })

  test('names are shown without control and bidirectional characters', () => {
    const refusal = refusalOf(() => read('<VTKFile type="\u202eX\u0007"></VTKFile>', '\u202ea\u001b[31m.vtu'))
    expect(['\u202e', '\u001b', '\u0007'].filter(character => refusal.includes(character))).toEqual([])
  })

  test.each(['<', '<!--', '<!-- >', '<?', '<a b="', '<a>'])('%s repeated is not slow', piece => {
    const started = processorTime()
    refusalOf(() => read(`<VTKFile type="UnstructuredGrid">${piece.repeat(300_000)}`))
    expect(processorTime() - started).toBeLessThan(2000)
  })
})

describe('legacy files', () => {
  const grid = (sections: string, version = '3.0') => `# vtk DataFile Version ${version}\ntitle\nASCII\n${sections}`
  const points = `POINTS 8 double\n${cube.join(' ')}\n`

  test('structured points, and what dimensions of 1 make', () => {
    const of = (sizes: string) =>
      only(grid(`DATASET STRUCTURED_POINTS\nDIMENSIONS ${sizes}\nORIGIN 1 2 3\nSPACING .5 1 2\nPOINT_DATA 1`), 'a.vtk')
    const box = of('3 2 2')
    expect([...box.cells]).toEqual([0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10])
    expect([...box.points.subarray(-3)]).toEqual([2, 3, 5])
    expect([...of('3 2 1').other]).toEqual([['quadrilateral', 2]])
    expect([...of('3 1 1').other]).toEqual([['line', 2]])
    expect(refusalOf(() => of('4000 4000 4000'))).toMatch(
      /imply 63952011999 cells and 64000000000 points; at most 50000000/,
    )
    expect(refusalOf(() => of('999999999999 1 1'))).toMatch(/at most 50000000/)
  })

  test('a field before the points, windows line ends, small letters, a part of a file', () => {
    const cells = `cells 1 9\n8 ${nodes.join(' ')}\ncell_types 1\n12\n`
    const field = 'FIELD FieldData 2\nTIME 1 1 double\n0.5\nnames 1 2 string\na b\nc\n'
    const text = grid(`dataset unstructured_grid\n${field}${points}${cells}`).replaceAll('\n', '\r\n')
    expect(only(text, 'a.vtk').cells.length).toBe(8)
    expect(only(`DATASET UNSTRUCTURED_GRID\n${points}${cells}`, 'paste').cells.length).toBe(8)
    expect(only(`see:\n\n${points}${cells}thanks`, 'paste').cells.length).toBe(8)
  })

  test('polyhedra as streams of faces', () => {
    const stream = '6 4 0 3 2 1 4 4 5 6 7 4 0 1 5 4 4 1 2 6 5 4 2 3 7 6 4 3 0 4 7'
    const of = (faces: string) => {
      const size = faces.split(' ').length
      const section = `CELLS 1 ${size + 1}\n${size} ${faces}\nCELL_TYPES 1\n42\n`
      return only(grid(`DATASET UNSTRUCTURED_GRID\n${points}${section}`), 'a.vtk')
    }
    expect([...of(stream).other]).toEqual([['polyhedron', 1]])
    expect(refusalOf(() => of(stream.replace('3 0 4 7', '3 0 4 9')))).toMatch(/names point 9/)
    expect(refusalOf(() => of(stream.replace('6 4 0', '7 4 0')))).toMatch(/do not fill/)
  })

  test('counts that do not agree', () => {
    const of = (cells: string, types = 'CELL_TYPES 1\n12') =>
      refusalOf(() => read(grid(`DATASET UNSTRUCTURED_GRID\n${points}${cells}\n${types}\n`), 'a.vtk'))
    expect(of(`CELLS 1 10\n8 ${nodes.join(' ')} 0`)).toMatch(/hold 1 whole cells and 1 more numbers/)
    expect(of(`CELLS 1 8\n8 ${nodes.slice(1).join(' ')}`)).toMatch(/hold 0 whole cells/)
    expect(of(`CELLS 1 9\n8 ${nodes.join(' ')} 5`)).toMatch(/line 8: .5. stands where a section/)
    expect(of('CELLS 2 8\nOFFSETS vtktypeint64\n0 9\nCONNECTIVITY vtktypeint64\n0 1 2 3 4 5 6 7')).toMatch(/end at 9/)
    expect(of('CELLS 4294967297 9\n8 0')).toMatch(/more than 2\^32/)
    expect(of(`CELLS 1 9\n8 ${nodes.join(' ')}`, 'CELL_TYPES 1\n12\n13')).toMatch(/.13. stands where a section/)
  })

  test('a binary field with text in it, metadata and long integers', () => {
    const file = joined([
      bytesOf('# vtk DataFile Version 5.1\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 2\nn 1 2 string\n'),
      Uint8Array.of(0xc3, 65, 10, 66, 0x80, 2, 67, 68),
      bytesOf('\nMETADATA\nINFORMATION 0\n\nt 1 1 double\n'),
      packed('Float64', [1], false),
      bytesOf('\nPOINTS 8 float\n'),
      packed('Float32', cube, false),
      bytesOf(
        '\nMETADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\nCELLS 2 8\nOFFSETS vtktypeint64\n',
      ),
      packed('Int64', [0, 8], false),
      bytesOf('\nCONNECTIVITY vtktypeint64\n'),
      packed('Int64', nodes, false),
      bytesOf('\nCELL_TYPES 1\n'),
      packed('Int32', [12], false),
      bytesOf('\nCELL_DATA 1\nSCALARS x float\nLOOKUP_TABLE default\n'),
      Uint8Array.of(35, 32, 118, 116),
    ])
    const mesh = only(file, 'a.vtk')
    expect([...mesh.points]).toEqual(cube)
    expect([...mesh.cells]).toEqual(nodes)
    expect(mesh.notes).toEqual(['Coordinates are stored as Float32: that can move one by up to 6.0e-8.'])
  })

  test('what is left out of a file, in whatever words', () => {
    for (const dots of ['...', '[...]', '…', '[snip]', '. . .', ':\n:\n']) {
      const text = grid(`DATASET UNSTRUCTURED_GRID
${points.replace('8', '900')}${dots}
1 2 3
CELLS 500 4500
8 ${nodes.join(' ')}
8 1 2 3 4 5 6 7 899
${dots}
8 1 2 3 4 5 6 7 8
CELL_TYPES 500
12
12
${dots}
12
`)
      const mesh = only(text, 'a.vtk')
      expect([...mesh.cells]).toEqual(nodes)
      expect(mesh.isCutOff).toBe(true)
      expect(mesh.notes[0]).toMatch(/892 of the declared points and 499 of the declared cells/)
      expect(refusalOf(() => read(text.replace('899', '900'), 'a.vtk'))).toMatch(
        /cell 1 names point 900 as its vertex 7/,
      )
    }
  })

  test.each(['... ', '...\n', 'METADATA\n', '# vtk DataFile Version 3.0\n', 'ORIGIN 1 1 1\n', '1 2 3 ', '#'])(
    '%s repeated is not slow',
    piece => {
      const started = processorTime()
      const many = piece.repeat(Math.floor(600_000 / piece.length))
      refusalOf(() => read(grid(`DATASET UNSTRUCTURED_GRID\n${many}`), 'a.vtk'))
      refusalOf(() => read(grid(`DATASET UNSTRUCTURED_GRID\n${points}CELLS 1 9\n${many}`), 'a.vtk'))
      expect(processorTime() - started).toBeLessThan(2000)
    },
  )

  test('thousands of small files after each other are not slow', () => {
    const one = grid(`DATASET UNSTRUCTURED_GRID\n${points}CELLS 1 9\n8 ${nodes.join(' ')}\nCELL_TYPES 1\n12\n`)
    const vtu = vtuOf(variants[0] as Variant, [1])
    const started = processorTime()
    expect(read(one.repeat(5000), 'a.vtk').length).toBe(5000)
    expect(read(joined(Array(1000).fill(vtu))).length).toBe(1000)
    expect(only(vtuOf(variants.at(-1) as Variant, Array(1000).fill(1))).cells.length).toBe(8000)
    expect(processorTime() - started).toBeLessThan(6000)
  })

  test('voxels that are no boxes in any order are said to be none', () => {
    const skew = cube.map((x, i) => (i === 18 ? 1.5 : x))
    const cells = `CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n11\n`
    const mesh = only(grid(`DATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n${skew.join(' ')}\n${cells}`), 'a.vtk')
    expect([...mesh.cells]).toEqual(nodes)
    expect([mesh.isOrderStated, mesh.notes.length]).toEqual([true, 1])
  })
})

describe('gzip', () => {
  const text = `# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n${cube.join(' ')}
CELLS 1 9\n8 ${nodes.join(' ')}\nCELL_TYPES 1\n12\n`
  const whole = new Uint8Array(gzipSync(text))

  test('of one member or several, whatever its name', () => {
    expect(only(whole, 'a.vtk.gz').cells.length).toBe(8)
    expect(only(whole, 'paste').cells.length).toBe(8)
    const parts = joined([text.slice(0, 100), text.slice(100)].map(part => gzipSync(part)))
    expect(only(parts, 'a.gz').cells.length).toBe(8)
    expect(only(joined([whole, new Uint8Array(512)]), 'a.gz').cells.length).toBe(8)
  })

  test('damaged at any byte, or cut off anywhere', () => {
    for (let at = 10; at < whole.length; at += 3) {
      expect(refusalOf(() => read(whole.slice(0, at), 'a.vtk.gz'))).not.toBe('was read')
      const damaged = whole.slice()
      damaged[at] = (damaged[at] as number) ^ 4
      expect(refusalOf(() => read(damaged, 'a.vtk.gz'))).not.toBe('was read')
    }
  })

  test('what unpacks to far too much ends early', () => {
    const bomb = new Uint8Array(gzipSync(new Uint8Array(100_000_000), { level: 9 }))
    const started = processorTime()
    expect(refusalOf(() => read(bomb, 'a.vtk.gz'))).toMatch(/which no mesh does|no VTK file/)
    expect(refusalOf(() => read(bomb, 'a'))).toMatch(/in no format/)
    expect(processorTime() - started).toBeLessThan(4000)
  })
})

describe('compressed streams', () => {
  const bytes = Uint8Array.from({ length: 100_000 }, (_, i) => (i * i) >> 7)

  test('of every strategy and level', () => {
    for (const strategy of [0, 1, 2, 3, 4])
      for (const level of [0, 1, 6, 9]) {
        const output = new Uint8Array(bytes.length)
        unzlib(new Uint8Array(deflateSync(bytes, { strategy, level })), output)
        expect(Buffer.compare(output, bytes)).toBe(0)
      }
  })

  test('the end of a stream is found, and memory grows as is allowed', () => {
    const stream = joined([new Uint8Array(deflateRawSync(bytes)), Uint8Array.of(1, 2, 3)])
    const inflated = inflate(stream, 0, new Uint8Array(10), 0, full => {
      const longer = new Uint8Array(2 * full.length)
      longer.set(full)
      return longer
    })
    expect([inflated.length, inflated.end, inflated.isWhole]).toEqual([bytes.length, stream.length - 3, true])
    expect(inflate(stream, 0, new Uint8Array(10)).isWhole).toBe(false)
  })

  test('LZ4 with repeats that overlap', () => {
    const output = new Uint8Array(24)
    unlz4(Uint8Array.of(0x2f, 1, 2, 2, 0, 3, 0), output.subarray(0, 24))
    expect([...output]).toEqual(Array.from({ length: 24 }, (_, i) => 1 + (i % 2)))
    expect(() => unlz4(Uint8Array.of(0x20, 1, 2, 3, 0), output)).toThrow('before its beginning')
  })

  test('checksums of "123456789"', () => {
    const digits = bytesOf('123456789')
    expect(adler32(digits)).toBe(0x091e01de)
    expect(crc32(digits)).toBe(0xcbf43926)
    expect(crc64(digits)).toEqual([0xdf1939fa, 0x995dc9bb])
  })
})
