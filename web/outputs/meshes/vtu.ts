/** VTU of VTK's XML, uncompressed, with appended raw data. */
import type { MeshWriter } from './mesh-form'
import { cellArrays, type MeshPart, PIECE, WHOLE_ARRAYS } from './mesh-part'

const VTK_HEXAHEDRON = 12

type Numbers = Float64Array | Int32Array | BigInt64Array | Uint8Array

interface DataArray {
  readonly section: 'PointData' | 'CellData' | 'Points' | 'Cells'
  readonly name: string
  readonly type: 'Float64' | 'Int32' | 'Int64' | 'UInt8'
  readonly components?: number
  readonly length: number
  /** The numbers from one to another. */
  numbers(from: number, to: number): Numbers
}

const isLittleEndian = new Uint8Array(Uint16Array.of(1).buffer)[0] === 1
const SIZES = { Float64: 8, Int32: 4, Int64: 8, UInt8: 1 }
/** Arrays that every file has: those of cells, the points, and three for the shape of the cells. */
const ARRAYS = WHOLE_ARRAYS + 4

export const vtu: MeshWriter = {
  chunks,
  count: ({ points, cells }) => ARRAYS + Math.ceil((3 * points + (8 + ARRAYS - 2) * cells) / PIECE),
}

function* chunks(part: MeshPart): Generator<string | Uint8Array> {
  const arrays = dataArrays(part)
  let offset = 0
  const elements = new Map<string, string[]>()
  for (const { section, name, type, components, length } of arrays) {
    const shape = components === undefined ? '' : ` NumberOfComponents="${components}"`
    const element = `<DataArray type="${type}" Name="${name}"${shape} format="appended" offset="${offset}"/>`
    elements.set(section, [...(elements.get(section) ?? []), element])
    offset += 8 + length * SIZES[type]
  }
  const section = (name: string) => `<${name}>\n${(elements.get(name) ?? []).join('\n')}\n</${name}>\n`
  yield `<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="${isLittleEndian ? 'LittleEndian' : 'BigEndian'}" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="${part.points.length / 3}" NumberOfCells="${part.cells.length / 8}">
${section('CellData')}${section('Points')}${section('Cells')}</Piece>
</UnstructuredGrid>
<AppendedData encoding="raw">
_`
  for (const { type, length, numbers } of arrays) {
    yield new Uint8Array(BigUint64Array.of(BigInt(length * SIZES[type])).buffer)
    for (let from = 0; from < length; from += PIECE) {
      const { buffer, byteOffset, byteLength } = numbers(from, Math.min(from + PIECE, length))
      yield new Uint8Array(buffer, byteOffset, byteLength)
    }
  }
  yield '\n</AppendedData>\n</VTKFile>\n'
}

function dataArrays(part: MeshPart): DataArray[] {
  const { points, cells } = part
  const count = cells.length / 8
  const areIndicesShort = points.length / 3 <= 2 ** 31 && cells.length < 2 ** 31
  const indices = (name: string, length: number, numberOf: (i: number) => number): DataArray => ({
    section: 'Cells',
    name,
    type: areIndicesShort ? 'Int32' : 'Int64',
    length,
    numbers: (from, to) =>
      areIndicesShort
        ? Int32Array.from({ length: to - from }, (_, i) => numberOf(from + i))
        : BigInt64Array.from({ length: to - from }, (_, i) => BigInt(numberOf(from + i))),
  })
  return [
    ...cellArrays(part).map(
      ({ name, type, numberOf }): DataArray => ({
        section: 'CellData',
        name,
        type,
        length: count,
        numbers: (from, to) =>
          type === 'UInt8'
            ? Uint8Array.from({ length: to - from }, (_, i) => numberOf(from + i))
            : Float64Array.from({ length: to - from }, (_, i) => numberOf(from + i)),
      }),
    ),
    {
      section: 'Points',
      name: 'Points',
      type: 'Float64',
      components: 3,
      length: points.length,
      numbers: (from, to) => points.subarray(from, to),
    },
    indices('connectivity', cells.length, i => cells[i] as number),
    indices('offsets', count, i => 8 * (i + 1)),
    {
      section: 'Cells',
      name: 'types',
      type: 'UInt8',
      length: count,
      numbers: (from, to) => new Uint8Array(to - from).fill(VTK_HEXAHEDRON),
    },
  ]
}
