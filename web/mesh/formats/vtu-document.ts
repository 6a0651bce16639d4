/** The elements of VTK's XML files: which arrays lie where, in which pieces; or which files have these. */
import { MeshRefusal } from '../mesh'
import type { MeshFile, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import type { XmlScanner, XmlTag } from '../xml-scanner'
import { cellDataRank } from './vtk-cell-data'
import { isNumberType } from './vtk-numbers'
import { type DataArray, decompressorNamed, type Storage, ZLIB } from './vtu-arrays'

const DEEPEST = 64
const [LESS, UNDERSCORE] = [60, 95] as const

/** The sizes of a <Piece>, and its arrays that are needed. */
export interface Piece {
  readonly at: number
  readonly points: number
  readonly cells: number
  readonly arrays: Map<string, DataArray>
  /** Arrays of cells that may be ids or blocks. */
  readonly cellArrays: Map<string, DataArray>
  /** The array of cells that the file calls global ids. */
  globalIds: string | null
}

/** The contents of a <VTKFile>. */
export interface VtkDocument {
  readonly type: string
  readonly storage: Storage
  readonly pieces: Piece[]
  /** Tags <Piece Source> of .pvtu and <DataSet file> of .pvd. */
  readonly sources: XmlTag[]
  /** The time of the one grid, as an array of the file. */
  time: DataArray | null
  /** The offsets of all arrays that are appended, needed or not. */
  readonly offsets: number[]
  readonly isComplete: boolean
}

export const GRID = 'UnstructuredGrid'
export const PARALLEL_GRID = 'PUnstructuredGrid'
export const COLLECTION = 'Collection'

export function refuse(file: MeshFile, what: string): never {
  throw new MeshRefusal(`${file.name}: ${what}`)
}

export function refuseType(file: MeshFile, type: string): never {
  refuse(
    file,
    `this is VTK's XML file of type ${shown(type)}, which is not read: ParaView saves it as an unstructured grid (.vtu).`,
  )
}

/** The next <VTKFile> and what is needed of it; null if there is none. */
export function scanDocument(
  scanner: XmlScanner,
  file: MeshFile,
  options: ReadOptions,
  endOf: EndOf = () => null,
): VtkDocument | null {
  for (let tag = scanner.next(); tag !== null; tag = scanner.next())
    if (tag.kind === 'open' && tag.name === 'VTKFile')
      return new DocumentScan(scanner, file, options, endOf, tag).document
  return null
}

/** A byte up to which the text of an array goes at least that begins at `from`, if that is known before it has been looked through. */
type EndOf = (storage: Storage, from: number) => number | null

class DocumentScan {
  readonly document: VtkDocument
  readonly #scanner: XmlScanner
  readonly #file: MeshFile
  readonly #endOf: EndOf
  /** Names of the elements that are open, the root first. */
  readonly #open: string[] = ['VTKFile']

  constructor(scanner: XmlScanner, file: MeshFile, options: ReadOptions, endOf: EndOf, root: XmlTag) {
    this.#scanner = scanner
    this.#file = file
    this.#endOf = endOf
    const type = root.attributes.get('type') ?? ''
    const storage = storageOf(scanner, file, options, root)
    const document = {
      type,
      storage,
      pieces: [] as Piece[],
      sources: [] as XmlTag[],
      time: null,
      offsets: [] as number[],
      isComplete: false,
    }
    this.document = document
    if (![GRID, PARALLEL_GRID, COLLECTION].includes(type)) refuseType(file, type)
    for (let tag = scanner.next(); tag !== null; tag = scanner.next()) {
      options.throwIfCancelled()
      if (tag.kind === 'close') {
        const name = this.#open.pop()
        if (name !== tag.name)
          scanner.refuse(
            tag.from,
            `</${shown(tag.name).slice(1, -1)}> stands where </${shown(name ?? '').slice(1, -1)}> was expected.`,
          )
        if (this.#open.length === 0) {
          document.isComplete = true
          return
        }
        continue
      }
      if (tag.name === 'AppendedData') {
        this.document = {
          ...document,
          storage: { ...storage, appended: this.#appended(tag) },
          // It lies far behind, and not everybody asks.
          get isComplete() {
            return endsWell(file)
          },
        }
        return
      }
      this.#take(tag, document)
      if (tag.isEmpty) continue
      this.#open.push(tag.name)
      if (this.#open.length > DEEPEST) scanner.refuse(tag.from, 'the elements are nested deeper than in any mesh.')
    }
    const inner = this.#open.at(-1)
    if (inner !== GRID && inner !== 'VTKFile' && inner !== PARALLEL_GRID && inner !== COLLECTION)
      refuse(
        file,
        `the file is cut off: it ends at byte ${file.size}, inside of <${shown(inner as string).slice(1, -1)}>.`,
      )
  }

  #take(tag: XmlTag, document: VtkDocument): void {
    const parent = this.#open.at(-1)
    if (tag.attributes.get('format') === 'appended') document.offsets.push(Number(tag.attributes.get('offset') ?? 0))
    if (tag.name === 'Piece' && parent === GRID) document.pieces.push(this.#piece(tag))
    else if ((tag.name === 'Piece' && parent === PARALLEL_GRID) || (tag.name === 'DataSet' && parent === COLLECTION))
      document.sources.push(tag)
    else if (tag.name === 'CellData' && parent === 'Piece') {
      const piece = document.pieces.at(-1)
      if (piece !== undefined) piece.globalIds = tag.attributes.get('GlobalIds') ?? null
    } else if (tag.name === 'DataArray') this.#takeArray(tag, document, parent)
  }

  /** What is known of its text is passed before all else. */
  #takeArray(tag: XmlTag, document: VtkDocument, parent: string | undefined): void {
    if (tag.attributes.get('format') === 'binary' && !tag.isEmpty)
      this.#scanner.position =
        this.#file.unpacked?.(tag.to)?.to ?? this.#endOf(document.storage, tag.to) ?? this.#scanner.position
    if (parent === 'FieldData' && isTime(tag)) document.time = this.#array(tag, 'TimeValue')
    else {
      const piece = document.pieces.at(-1)
      const name = parent === 'Points' ? 'Points' : (tag.attributes.get('Name') ?? '')
      const isNeeded = parent === 'Points' || parent === 'Cells' || (parent === 'CellData' && name === 'vtkGhostType')
      if (piece === undefined || !this.#open.includes('Piece')) return
      if (parent === 'CellData' && this.#isCellArray(tag, name, piece))
        piece.cellArrays.set(name, this.#array(tag, name))
      if (!isNeeded) return
      if (!['Points', 'connectivity', 'offsets', 'types', 'vtkGhostType'].includes(name)) return
      if (piece.arrays.has(name)) this.#scanner.refuse(tag.from, `a second array ${shown(name)} stands in one <Piece>.`)
      piece.arrays.set(name, this.#array(tag, name))
    }
  }

  #isCellArray({ attributes }: XmlTag, name: string, { globalIds }: Piece): boolean {
    const isOne = (attributes.get('NumberOfComponents') ?? '1').trim() === '1'
    return isOne && isNumberType(attributes.get('type') ?? '') && (name === globalIds || cellDataRank(name) >= 0)
  }

  #piece(tag: XmlTag): Piece {
    const countOf = (name: string): number => {
      const text = (tag.attributes.get(name) ?? '').trim()
      if (!/^\d{1,15}$/.test(text))
        this.#scanner.refuse(tag.from, `${name} is ${shown(text)}, where a count was expected.`)
      return Number(text)
    }
    const [points, cells] = [countOf('NumberOfPoints'), countOf('NumberOfCells')]
    if (Math.max(points, cells) > 0xffffffff)
      this.#scanner.refuse(tag.from, 'more than 2^32 points or cells are not read.')
    return { at: tag.from, points, cells, arrays: new Map(), cellArrays: new Map(), globalIds: null }
  }

  #array(tag: XmlTag, name: string): DataArray {
    const { attributes, from, to, isEmpty } = tag
    const type = attributes.get('type') ?? ''
    if (!isNumberType(type))
      this.#scanner.refuse(
        from,
        `${shown(name)} has type ${shown(type)}, where one like Float64 or Int64 was expected.`,
      )
    const format = attributes.get('format') ?? 'ascii'
    if (format !== 'ascii' && format !== 'binary' && format !== 'appended')
      this.#scanner.refuse(from, `${shown(name)} has format ${shown(format)}: ascii, binary or appended was expected.`)
    const components = attributes.get('NumberOfComponents')
    if (name === 'Points' && components !== undefined && components.trim() !== '3')
      this.#scanner.refuse(from, `the points have ${shown(components)} components, where 3 were expected.`)
    const offset = (attributes.get('offset') ?? '').trim()
    if (format === 'appended' && !/^\d{1,15}$/.test(offset))
      this.#scanner.refuse(
        from,
        `the offset of ${shown(name)} is ${shown(offset)}, where a count of bytes was expected.`,
      )
    const found = isEmpty ? to : this.#scanner.indexOf(LESS, this.#scanner.position)
    const end = found < 0 ? this.#file.size : found
    this.#scanner.position = end
    return {
      name,
      type,
      format,
      offset: format === 'appended' ? Number(offset) : 0,
      from: to,
      to: end,
    }
  }

  #appended(tag: XmlTag): Storage['appended'] {
    const encoding = tag.attributes.get('encoding') ?? 'raw'
    if (encoding !== 'raw' && encoding !== 'base64')
      this.#scanner.refuse(tag.from, `the appended data are encoded as ${shown(encoding)}: raw or base64 was expected.`)
    const underscore = this.#scanner.indexOf(UNDERSCORE, tag.to)
    if (underscore < 0) refuse(this.#file, 'the file is cut off at the beginning of its appended data.')
    return { from: underscore + 1, isBase64: encoding === 'base64' }
  }
}

function storageOf(scanner: XmlScanner, file: MeshFile, options: ReadOptions, { attributes, from }: XmlTag): Storage {
  const order = attributes.get('byte_order') ?? 'LittleEndian'
  if (order !== 'LittleEndian' && order !== 'BigEndian')
    scanner.refuse(from, `the byte order is ${shown(order)}: LittleEndian or BigEndian was expected.`)
  const headerType = attributes.get('header_type') ?? 'UInt32'
  if (headerType !== 'UInt32' && headerType !== 'UInt64')
    scanner.refuse(from, `the header type is ${shown(headerType)}: UInt32 or UInt64 was expected.`)
  const compressor = attributes.get('compressor') ?? ''
  const decompress = compressor === '' ? null : decompressorNamed(compressor, options.core)
  if (decompress === undefined)
    scanner.refuse(
      from,
      `the compressor is ${shown(compressor)}: vtkZLib-, vtkLZ4- or vtkLZMADataCompressor was expected.`,
    )
  return {
    file,
    options,
    isLittleEndian: order === 'LittleEndian',
    headerType,
    decompress,
    isZlib: compressor === ZLIB,
    appended: null,
  }
}

function isTime({ attributes }: XmlTag): boolean {
  const isOne = (attributes.get('NumberOfTuples') ?? '1').trim() === '1'
  return isOne && /^time(?:value)?$/i.test(attributes.get('Name') ?? '') && isNumberType(attributes.get('type') ?? '')
}

const END = '</VTKFile>'

/** True if the end tag is the last thing in the file. */
function endsWell(file: MeshFile): boolean {
  const tail = file.read(Math.max(0, file.size - 4096), file.size)
  return new TextDecoder('latin1').decode(tail).trimEnd().endsWith(END)
}
