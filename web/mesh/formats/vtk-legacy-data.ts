/** Arrays of cells behind the grid of VTK's legacy files: ids and blocks are read. */
import { MeshRefusal } from '../mesh'
import { wordTable } from '../word-table'
import { type CellData, cellDataOf, cellDataRank } from './vtk-cell-data'
import { decoded, type LegacyStream } from './vtk-legacy-stream'

/** Words of a section for one array, and how many numbers each cell or point has in it. */
const SIZES: Readonly<Record<string, number>> = wordTable({
  VECTORS: 3,
  NORMALS: 3,
  TENSORS: 9,
  TENSORS6: 6,
  GLOBAL_IDS: 1,
  PEDIGREE_IDS: 1,
})

/**
 * The arrays of `cells` cells; the cursor stands behind the word CELL_DATA or POINT_DATA. Null where there are none of use: a part that is
 * damaged or of another kind is nobody's question, and ends the reading.
 */
export function readCellData(stream: LegacyStream, keyword: string, cells: number): CellData | null {
  const arrays = new Map<string, Float64Array>()
  const data = { arrays, globalIds: null as string | null, cells }
  try {
    let tuples = stream.count()
    let areCells = keyword.toUpperCase() === 'CELL_DATA'
    if (!areCells && !stream.isBinary) areCells = stream.skipToLine('CELL_DATA')
    if (areCells && keyword.toUpperCase() !== 'CELL_DATA') tuples = stream.count()
    for (let word = stream.nextKeyword(); word !== ''; word = stream.nextKeyword()) {
      if (word === 'CELL_DATA' || word === 'POINT_DATA') {
        areCells = word === 'CELL_DATA'
        tuples = stream.count()
      } else if (!readArray(stream, word, tuples, areCells ? data : null)) break
    }
  } catch (error) {
    if (!(error instanceof MeshRefusal)) throw error
  }
  return cellDataOf(arrays, data.globalIds)
}

interface Found {
  readonly arrays: Map<string, Float64Array>
  globalIds: string | null
  readonly cells: number
}

/** True if the section is known. `found` is null for arrays of points. */
function readArray(stream: LegacyStream, word: string, tuples: number, found: Found | null): boolean {
  const take = (name: string, isGlobal: boolean, components: number, count: number, type: string): void => {
    const isWanted = found !== null && components === 1 && count === found.cells && type.toLowerCase() !== 'string'
    if (!isWanted || (!isGlobal && cellDataRank(name) < 0)) {
      stream.pass(components * count, type)
      return
    }
    const list = stream.list(count, stream.typeOf(type), Float64Array, 'number')
    if (list.length < count) return
    found.arrays.set(name, list)
    if (isGlobal) found.globalIds = name
  }
  if (word === 'METADATA') stream.passMetadata()
  else if (word === 'FIELD') stream.field((name, components, count, type) => take(name, false, components, count, type))
  else if (word === 'SCALARS') {
    const [name = '', type = '', components = '1'] = stream.restOfLine()
    if (stream.nextKeyword() !== 'LOOKUP_TABLE') return false
    stream.cursor.word()
    take(decoded(name), false, Number(components), tuples, type)
  } else if (word === 'LOOKUP_TABLE') {
    const [, size = ''] = stream.restOfLine()
    stream.pass(4 * Number(size), stream.isBinary ? 'unsigned_char' : 'float')
  } else if (word === 'COLOR_SCALARS') {
    const [, size = ''] = stream.restOfLine()
    stream.pass(Number(size) * tuples, stream.isBinary ? 'unsigned_char' : 'float')
  } else if (word === 'TEXTURE_COORDINATES') {
    const [, size = '', type = ''] = stream.restOfLine()
    stream.pass(Number(size) * tuples, type)
  } else {
    const size = SIZES[word]
    if (size === undefined) return false
    const [name = '', type = ''] = stream.restOfLine()
    take(decoded(name), word === 'GLOBAL_IDS', size, tuples, type)
  }
  return true
}
