/**
 * `--annotate`: the hexahedra as an uncompressed VTU with appended raw data, and as cell arrays what is said of each: valid (255 where
 * a cell is unanswered), boundary_min, relative_min and volume (NaN where there is none). Of invalid ones alone also what they are
 * called: index, counted from 0 in the file's order, and cell_id, the same where the file has no ids.
 */
import type { MeshCheck } from '../mesh/mesh-check'
import { invalidCells } from './invalid-cells'
import type { Output } from './output'

const VTK_HEXAHEDRON = 12
const UNANSWERED = 255

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

export function vtuOutput(): Output {
  return {
    lists: { minima: true, volumes: true },
    *file(result) {
      if ('check' in result) yield* vtu(partOf(result.check, null))
    },
    *end() {},
  }
}

export function* invalidVtu(check: MeshCheck): Generator<string | Uint8Array> {
  yield* vtu(partOf(check, Uint32Array.from(invalidCells(check))))
}

/** How many pieces `vtuOutput` yields of a mesh, about. */
export function vtuPieces({ mesh, hexahedra }: MeshCheck): number {
  return ARRAYS + Math.ceil((mesh.points.length + mesh.cells.length + (ARRAYS - 2) * hexahedra) / PIECE)
}

/** Cells of a mesh with the points that are theirs. */
interface Part {
  readonly check: MeshCheck
  readonly points: Float64Array
  /** Eight indices of these points a cell. */
  readonly cells: Uint32Array
  /** Their indices in the mesh; null for all cells in its order. */
  readonly chosen: Uint32Array | null
}

function partOf(check: MeshCheck, chosen: Uint32Array | null): Part {
  const { points, cells } = check.mesh
  if (chosen === null) return { check, points, cells, chosen }
  const places = new Map<number, number>()
  const own = new Uint32Array(8 * chosen.length)
  for (let i = 0; i < own.length; ++i) {
    const point = cells[8 * (chosen[i >> 3] as number) + (i & 7)] as number
    const place = places.get(point) ?? places.size
    places.set(point, place)
    own[i] = place
  }
  const ownPoints = new Float64Array(3 * places.size)
  for (const [point, place] of places) ownPoints.set(points.subarray(3 * point, 3 * point + 3), 3 * place)
  return { check, points: ownPoints, cells: own, chosen }
}

const isLittleEndian = new Uint8Array(Uint16Array.of(1).buffer)[0] === 1
const SIZES = { Float64: 8, Int32: 4, Int64: 8, UInt8: 1 }
/** Numbers are written in chunks of so many. */
const PIECE = 131_072
/** Arrays that every file has. */
const ARRAYS = 8

function* vtu(part: Part): Generator<string | Uint8Array> {
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

function dataArrays({ check, points, cells, chosen }: Part): DataArray[] {
  const { answers, isAnswered } = check
  const { minima, volumes, relativeMinima, valid } = answers
  if (!minima || !volumes) throw new Error('The minima and volumes were not asked for.')
  const count = cells.length / 8
  const cellAt = (i: number) => (chosen === null ? i : (chosen[i] as number))
  const doubles = (name: string, numberOf: (cell: number) => number): DataArray => ({
    section: 'CellData',
    name,
    type: 'Float64',
    length: count,
    numbers: (from, to) => Float64Array.from({ length: to - from }, (_, i) => numberOf(cellAt(from + i))),
  })
  const ifAnswered = (cell: number, value: number) => (isAnswered(cell) ? value : Number.NaN)
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
    {
      section: 'CellData',
      name: 'valid',
      type: 'UInt8',
      length: count,
      numbers: (from, to) =>
        Uint8Array.from({ length: to - from }, (_, i) => {
          const cell = cellAt(from + i)
          return isAnswered(cell) ? (valid[cell] as number) : UNANSWERED
        }),
    },
    doubles('boundary_min', cell => ifAnswered(cell, scaled(minima.values[cell], minima.exponents[cell]))),
    doubles('relative_min', cell => ifAnswered(cell, relativeMinima[cell] as number)),
    doubles('volume', cell => ifAnswered(cell, scaled(volumes.values[cell], volumes.exponents[cell]))),
    ...(chosen === null ? [] : namesOf(check).map(([name, numberOf]) => doubles(name, numberOf))),
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

/** What cells are called, in numbers; ids that are words have no place in a VTU. */
function namesOf({ mesh: { ids } }: MeshCheck): [name: string, numberOf: (cell: number) => number][] {
  const index = (cell: number) => cell
  if (ids === null)
    return [
      ['index', index],
      ['cell_id', index],
    ]
  return ids instanceof Float64Array
    ? [
        ['index', index],
        ['cell_id', cell => ids[cell] as number],
      ]
    : [['index', index]]
}

/** value * 2^exponent in a double: an infinity or 0 where there is no room for it. Two steps, as 2^exponent alone may have none. */
function scaled(value = Number.NaN, exponent = 0): number {
  if (value === 0) return 0
  const half = Math.trunc(exponent / 2)
  return value * 2 ** half * 2 ** (exponent - half)
}
