/** VTU in compressed blocks, as programs write it. */
import { deflateSync } from 'node:zlib'
import type { Mesh } from '../../web/mesh/mesh'

export const BLOCK = 32768

/** A list in blocks of zlib behind their header, as VTK writes it. */
function packed(list: ArrayBufferView, isBase64: boolean): Buffer {
  const plain = Buffer.from(list.buffer as ArrayBuffer, list.byteOffset, list.byteLength)
  const blocks = Array.from({ length: Math.ceil(plain.length / BLOCK) }, (_, i) =>
    deflateSync(plain.subarray(BLOCK * i, BLOCK * (i + 1)), { level: 1 }),
  )
  const header = Uint32Array.of(blocks.length, BLOCK, plain.length % BLOCK, ...blocks.map(({ length }) => length))
  const parts = [Buffer.from(header.buffer), Buffer.concat(blocks)]
  return isBase64 ? Buffer.from(parts.map(part => part.toString('base64')).join('')) : Buffer.concat(parts)
}

/** Hexahedra in the arrays' own places as PyVista writes them, behind an array that nobody needs, or appended. */
export function packedVtu({ points, cells }: Pick<Mesh, 'points' | 'cells'>, way: 'inline' | 'appended'): Buffer {
  const long = (list: Iterable<number>) => BigInt64Array.from(list as never, BigInt)
  const ends = Array.from({ length: cells.length / 8 }, (_, i) => 8 * (i + 1))
  const lists = [points, long(cells), long(ends), new Uint8Array(ends.length).fill(12)]
  const isInline = way === 'inline'
  const data = lists.map(list => packed(list, isInline))
  let offset = 0
  const arrays = [
    'Float64" NumberOfComponents="3',
    'Int64" Name="connectivity',
    'Int64" Name="offsets',
    'UInt8" Name="types',
  ].map((words, i) => {
    const own = data[i] as Buffer
    const place = isInline ? ['binary">\n  ', own, '\n</DataArray>'] : [`appended" offset="${offset}"/>`]
    offset += own.length
    return [`<DataArray type="${words}" format="`, ...place]
  })
  const unneeded = [
    '<PointData><DataArray type="Float32" Name="t" format="binary">',
    packed(new Float32Array(9e4), true),
  ]
  const parts = [
    '<VTKFile type="UnstructuredGrid" byte_order="LittleEndian" header_type="UInt32" compressor="vtkZLibDataCompressor">',
    `<UnstructuredGrid><Piece NumberOfPoints="${points.length / 3}" NumberOfCells="${ends.length}">`,
    ...(isInline ? [...unneeded, '</DataArray></PointData>'] : []),
    ...[
      '<Points>',
      ...(arrays[0] ?? []),
      '</Points><Cells>',
      ...arrays.slice(1).flat(),
      '</Cells></Piece></UnstructuredGrid>',
    ],
    ...(isInline ? [] : ['<AppendedData encoding="raw">_', ...data, '</AppendedData>']),
    '</VTKFile>',
  ]
  return Buffer.concat(parts.map(part => (typeof part === 'string' ? Buffer.from(part) : part)))
}
