/**
 * VTU, the XML file of VTK's unstructured grids, in all its encodings; .pvtu, which names the pieces of one, and .pvd, which names those of
 * its time steps, of which one is read.
 */
import type { Mesh } from '../mesh'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { missingStep } from '../step-note'
import { shown } from '../text-cursor'
import { XmlScanner } from '../xml-scanner'
import { type CellData, cellDataOf } from './vtk-cell-data'
import { firstFall, VtkMesh } from './vtk-mesh'
import { precisionOf } from './vtk-middles'
import type { NumberList } from './vtk-numbers'
import { type DataArray, endOfBlocks, listOf, type ReadArray, readArray, type Storage } from './vtu-arrays'
import {
  COLLECTION,
  GRID,
  PARALLEL_GRID,
  type Piece,
  refuse,
  refuseType,
  scanDocument,
  type VtkDocument,
} from './vtu-document'
import { piecesOf, stepsOf } from './vtu-sources'

export const vtu: MeshFormat = {
  name: 'VTU',

  recognizes(head, name) {
    const text = headText(head)
    if (/^(?:\u00ef\u00bb\u00bf)?\s*</.test(text) && text.includes('<VTKFile')) return 'yes'
    return text.includes('<VTKFile') || /\.(?:vtu|pvtu|pvd)$/.test(name) ? 'maybe' : 'no'
  },

  read(file, options) {
    const meshes: Mesh[] = []
    const scanner = new XmlScanner(file)
    for (;;) {
      const document = scanDocument(scanner, file, options)
      if (document === null) break
      const mesh = new VtkMesh('VTU', what => refuse(file, what))
      readDocument(document, file, options, mesh)
      meshes.push(mesh.mesh())
      // Text after appended data is part of it or of no document.
      if (document.storage.appended !== null || !document.isComplete) break
    }
    if (meshes.length === 0) refuse(file, 'this is no VTU: there is no <VTKFile> in it.')
    return meshes
  },

  listsIn(file) {
    const document = scanDocument(new XmlScanner(file), file, { ...NOTHING_BESIDE, core: null }, endOfBlocks)
    if (document === null) return []
    const rising = [...new Set(document.offsets)].sort((a, b) => a - b)
    const ends = new Map(rising.map((offset, i) => [offset, rising[i + 1] ?? Infinity]))
    return document.pieces.flatMap(({ arrays, points, cells }) =>
      [...arrays.values()].flatMap(array => {
        const room = (ends.get(array.offset) ?? Infinity) - array.offset
        return listOf(document.storage, array, { points, cells, room })
      }),
    )
  },
}

const NOTHING_BESIDE = { find: () => null, onProgress() {}, throwIfCancelled() {}, step: 0, hdf5: null } as const

function readDocument(document: VtkDocument, file: MeshFile, options: ReadOptions, mesh: VtkMesh): void {
  if (document.type === PARALLEL_GRID || document.type === COLLECTION) readSources(document, file, options, mesh)
  else readPieces(document, mesh, null)
  if (document.time !== null && mesh.steps.length === 0) {
    const { list } = readArray(document.storage, document.time, 1, Float64Array)
    mesh.steps = [String(list[0])]
  }
  if (document.isComplete) return
  mesh.isCutOff = true
  mesh.note('The end of the file is missing: there is no </VTKFile>. What is whole was read.')
}

function readSources(document: VtkDocument, file: MeshFile, options: ReadOptions, mesh: VtkMesh): void {
  const isCollection = document.type === COLLECTION
  const steps = isCollection ? stepsOf(document) : []
  const step = options.step === 'last' ? steps.length - 1 : options.step
  if (step >= steps.length && steps.length > 0) refuse(file, missingStep(steps.length, step))
  const names = isCollection ? (steps[step]?.files ?? []) : piecesOf(document)
  if (names.length === 0) refuse(file, `it names no ${isCollection ? 'file' : 'piece'}.`)
  if (isCollection) {
    mesh.steps = steps.map(({ time }) => time)
    mesh.isSteady = steps.every(({ files }) => files.join('\n') === names.join('\n'))
    mesh.noteSteps(options.step)
  }
  const found = names.map(name => options.find(name))
  const missing = names.filter((_, i) => found[i] === null)
  if (missing.length > 0) {
    const some = missing.slice(0, 3).map(shown).join(', ')
    const more = missing.length > 3 ? ` and ${missing.length - 3} more` : ''
    refuse(
      file,
      `it needs ${some}${more} beside it: give ${missing.length > 1 ? 'them' : 'it'} together with this file.`,
    )
  }
  found.forEach((piece, i) => {
    const name = shown(names[i] as string).slice(1, -1)
    const named: MeshFile = {
      name,
      size: (piece as MeshFile).size,
      read: (from, to) => (piece as MeshFile).read(from, to),
    }
    const inner = scanDocument(new XmlScanner(named), named, options)
    if (inner === null) refuse(named, 'this is no VTU: there is no <VTKFile> in it.')
    if (inner.type !== GRID && !(isCollection && inner.type === PARALLEL_GRID))
      refuse(named, `a piece of type ${shown(inner.type)} stands where one of type ${GRID} was expected.`)
    if (!inner.isComplete) refuse(named, 'the file is cut off: there is no </VTKFile>.')
    if (inner.type === PARALLEL_GRID) readSources(inner, named, options, mesh)
    else readPieces(inner, mesh, name)
  })
}

function readPieces({ storage, pieces, type }: VtkDocument, mesh: VtkMesh, block: string | null): void {
  const { file } = storage
  if (type !== GRID) refuseType(file, type)
  if (pieces.length === 0) refuse(file, 'it has no <Piece>.')
  let ghosts = 0
  for (const piece of pieces) ghosts += readPiece(storage, piece, pieces.length === 1, mesh, block)
  if (ghosts > 0) mesh.note(`${ghosts} cells are ghosts, copies of cells of another piece; they are counted in both.`)
}

/** Returns how many of the cells are copies of cells of other pieces. */
function readPiece(storage: Storage, piece: Piece, isOnly: boolean, mesh: VtkMesh, block: string | null): number {
  const { file } = storage
  const { points: pointCount, cells: cellCount, arrays } = piece
  const arrayOf = (name: string): DataArray => {
    const array = arrays.get(name)
    if (array === undefined) refuse(file, `the <Piece> at byte ${piece.at} has no array ${shown(name)}.`)
    return array
  }
  const read = <T extends NumberList>(
    name: string,
    count: number,
    List: new (length: number) => T,
    mayHaveFewer = false,
  ): ReadArray<T> =>
    count === 0 ? { list: new List(0), digits: 0 } : readArray(storage, arrayOf(name), count, List, mayHaveFewer)
  if (pointCount === 0 && cellCount === 0) return 0
  const { list: points, digits } = read('Points', 3 * pointCount, Float64Array)
  const { list: types } = read('types', cellCount, Uint8Array)
  const { list: ends, known: knownEnds = null } = read('offsets', cellCount, Uint32Array)
  const falling = knownEnds && knownEnds.step > 0 ? -1 : firstFall(ends)
  if (falling > 0)
    refuse(
      file,
      `the offset of cell ${falling} is ${ends[falling]}, less than ${ends[falling - 1]}, that of the cell before.`,
    )
  const isWhole = ends.length === cellCount
  const { list: connectivity, known = null } = read(
    'connectivity',
    isWhole ? (ends.at(-1) ?? 0) : 0xffffffff,
    Uint32Array,
    !isWhole,
  )
  // If the text leaves something out, those cells are whole that all three arrays have.
  let whole = Math.min(types.length, ends.length)
  while (whole > 0 && (ends[whole - 1] as number) > connectivity.length) whole--
  const isText = arrays.get('Points')?.format === 'ascii'
  mesh.add(
    {
      points: points.subarray(0, points.length - (points.length % 3)),
      declaredPoints: pointCount,
      connectivity,
      known: { connectivity: known, ends: knownEnds },
      ends: ends.subarray(0, whole),
      types: types.subarray(0, whole),
      declaredCells: cellCount,
      hasFaceStreams: false,
      precision: precisionOf(arrays.get('Points')?.type, isText, digits),
      cellData: cellData(storage, piece),
    },
    block,
  )
  if (isOnly && block === null && pointCount > 0 && points.length === 3 * pointCount)
    setPlaces(storage, arrayOf('Points'), mesh)
  return ghostCount(storage, arrays.get('vtkGhostType'), cellCount)
}

function cellData(storage: Storage, { cells, cellArrays, globalIds }: Piece): CellData | null {
  const arrays = new Map<string, Float64Array>()
  for (const [name, array] of cellArrays) {
    const { list } = readArray(storage, array, cells, Float64Array, true)
    if (list.length === cells) arrays.set(name, list)
  }
  return arrays.size === 0 ? null : cellDataOf(arrays, globalIds)
}

/** The coordinates are a run of the text, or one block of the file if they are neither in base64 nor packed. */
function setPlaces(storage: Storage, array: DataArray, mesh: VtkMesh): void {
  if (array.format === 'ascii') mesh.coordinatePlaces = { kind: 'run', from: array.from, to: array.to }
  const { appended, decompress, isLittleEndian, headerType } = storage
  if (array.format !== 'appended' || appended === null || appended.isBase64 || decompress !== null) return
  if (array.type !== 'Float32' && array.type !== 'Float64') return
  mesh.coordinatePlaces = {
    kind: 'block',
    from: appended.from + array.offset + (headerType === 'UInt32' ? 4 : 8),
    type: array.type === 'Float32' ? 'float32' : 'float64',
    isLittleEndian,
  }
}

/** vtkDataSetAttributes::DUPLICATECELL */
const IS_COPY = 1

function ghostCount(storage: Storage, array: DataArray | undefined, cells: number): number {
  if (array === undefined) return 0
  const { list } = readArray(storage, array, cells, Uint8Array)
  return list.reduce((count, ghost) => count + (ghost & IS_COPY), 0)
}
