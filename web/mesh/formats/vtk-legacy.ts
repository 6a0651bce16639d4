/**
 * VTK's legacy files, versions 1 to 5: unstructured grids, and structured and rectilinear grids and structured points, whose cells are
 * implied; in text, several after each other, or in big-endian binary.
 */
import { type CoordinatePlaces, type Mesh, MeshRefusal } from '../mesh'
import { headText, isEllipsis } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown, TextCursor } from '../text-cursor'
import type { CellData } from './vtk-cell-data'
import { VTK_HEXAHEDRON } from './vtk-cells'
import { type LegacyCells, readCells } from './vtk-legacy-cells'
import { readCellData } from './vtk-legacy-data'
import { LegacyLattice } from './vtk-legacy-lattice'
import { LegacyStream, lineThatBegins } from './vtk-legacy-stream'
import { VtkMesh } from './vtk-mesh'
import { precisionOf } from './vtk-middles'
import { type NumberType, sizeOf } from './vtk-numbers'

const MAGIC = '# vtk DataFile Version'
/** A part of a file that somebody has cut out begins with one of its sections. */
const SECTION =
  /^[ \t]*(?:DATASET[ \t]+(?:UN)?STRUCTURED_|DATASET[ \t]+RECTILINEAR_|POINTS[ \t]+\d+[ \t]+(?:float|double)\b)/im

const DATASETS = ['UNSTRUCTURED_GRID', 'STRUCTURED_GRID', 'RECTILINEAR_GRID', 'STRUCTURED_POINTS'] as const
type DatasetType = (typeof DATASETS)[number]

export const vtkLegacy: MeshFormat = {
  name: 'VTK',

  recognizes(head, name) {
    const text = headText(head)
    if (/^(?:\u00ef\u00bb\u00bf)?\s*# vtk DataFile/i.test(text)) return 'yes'
    return name.endsWith('.vtk') || /^# vtk DataFile/im.test(text) || SECTION.test(text) ? 'maybe' : 'no'
  },

  read(file, options) {
    const meshes: Mesh[] = []
    let at = lineThatBegins(file, MAGIC, 0)
    if (at < 0) {
      const head = new TextDecoder('latin1').decode(file.read(0, Math.min(file.size, 65_536)))
      const section = SECTION.exec(head)
      if (section === null)
        throw new MeshRefusal(`${file.name}: this is no VTK file: it does not begin with “${MAGIC}”.`)
      return [new LegacyDataset(file, options, new TextCursor(file, section.index), false).read()]
    }
    for (const cursor = new TextCursor(file, at); at >= 0; ) {
      cursor.goTo({ position: at })
      const dataset = new LegacyDataset(file, options, cursor, true)
      meshes.push(dataset.read())
      at = dataset.isBinary ? -1 : lineThatBegins(file, MAGIC, cursor.position)
    }
    return meshes
  },
}

class LegacyDataset {
  readonly #stream: LegacyStream
  readonly #cursor: TextCursor
  readonly #hasHeader: boolean
  #type: DatasetType | null = null
  #points: Float64Array | null = null
  #declaredPoints = 0
  #pointsFrom = 0
  #pointsTo = 0
  #pointType: NumberType = 'Float64'
  #cells: LegacyCells | null = null
  #types: Uint8Array | null = null
  #cellData: CellData | null = null
  #time: string | null = null
  readonly #lattice: LegacyLattice

  constructor(file: MeshFile, options: ReadOptions, cursor: TextCursor, hasHeader: boolean) {
    this.#stream = new LegacyStream(file, options, cursor)
    this.#lattice = new LegacyLattice(this.#stream)
    this.#hasHeader = hasHeader
    this.#cursor = cursor
  }

  get isBinary(): boolean {
    return this.#stream.isBinary
  }

  read(): Mesh {
    if (this.#hasHeader) this.#readHeader()
    while (this.#readSection());
    return this.#mesh()
  }

  /** Two lines, and a third that says whether the file is text. */
  #readHeader(): void {
    const version = (this.#cursor.nextLine() ?? '').slice(MAGIC.length).trim()
    if (!/^[1-5]\.\d/.test(version)) this.#stream.refuse(`version ${shown(version)} is not read; 1.0 to 5.1 are.`)
    // The title may be missing in a text that somebody typed.
    const title = (this.#cursor.nextLine() ?? '').trim()
    const isTitle = !/^(?:ascii|binary)$/i.test(title)
    const kind = isTitle ? this.#cursor.word() : title
    if (!/^(?:ascii|binary)$/i.test(kind))
      this.#stream.refuse(`${shown(kind)} stands where ASCII or BINARY was expected.`)
    this.#stream.isBinary = kind.toLowerCase() === 'binary'
  }

  /** True if another may follow. */
  #readSection(): boolean {
    this.#stream.progress(this.#cursor.position)
    this.#cursor.skipBlanks()
    const from = this.#cursor.position
    if (this.#cursor.isAtEnd) return false
    // A second file begins, or what follows the grid of a binary one is not needed.
    if (this.#cursor.peek() === 35 && this.#isComplete()) return false
    const keyword = this.#cursor.word()
    switch (keyword.toUpperCase()) {
      case 'DATASET':
        this.#setType(this.#cursor.word())
        return true
      case 'POINTS':
        this.#readPoints()
        return true
      case 'CELLS':
        if (this.#cells !== null) this.#stream.refuse('a second section CELLS stands in one file.')
        this.#cells = readCells(this.#stream)
        return true
      case 'CELL_TYPES':
        this.#readTypes()
        return true
      case 'DIMENSIONS':
        this.#lattice.readSizes()
        return true
      case 'ORIGIN':
        this.#lattice.readOrigin()
        return true
      case 'SPACING':
      case 'ASPECT_RATIO':
        this.#lattice.readSpacing()
        return true
      case 'X_COORDINATES':
      case 'Y_COORDINATES':
      case 'Z_COORDINATES':
        this.#pointType = this.#lattice.readAxis('XYZ'.indexOf(keyword.charAt(0).toUpperCase()))
        return true
      case 'METADATA':
        this.#stream.passMetadata()
        return true
      case 'FIELD':
        this.#readField()
        return true
      case 'CELL_DATA':
      case 'POINT_DATA':
        if (this.#types !== null) this.#cellData = readCellData(this.#stream, keyword, this.#types.length)
        return false
    }
    if (isEllipsis(keyword) && !this.#stream.isBinary) {
      this.#stream.passElision()
      return true
    }
    if (this.#isComplete() && !/^[-+.\d]/.test(keyword)) return false
    return this.#stream.refuseAt(from, `${shown(keyword)} stands where a section like POINTS or CELLS was expected.`)
  }

  /** True if all that a mesh needs is there: anything may follow. */
  #isComplete(): boolean {
    if (this.#type === 'STRUCTURED_POINTS') return this.#lattice.hasSteps
    if (this.#type === 'RECTILINEAR_GRID') return this.#lattice.hasAxes
    if (this.#type === 'STRUCTURED_GRID') return this.#points !== null
    return this.#types !== null
  }

  #setType(type: string): void {
    const known = DATASETS.find(name => name === type.toUpperCase())
    if (known === undefined)
      this.#stream.refuse(`a dataset of type ${shown(type)} has no cells that are read: ${DATASETS.join(', ')} have.`)
    if (this.#type !== null) this.#stream.refuse('a second DATASET stands in one file.')
    this.#type = known
  }

  #readPoints(): void {
    if (this.#points !== null) this.#stream.refuse('a second section POINTS stands in one file.')
    this.#declaredPoints = this.#stream.count()
    if (this.#declaredPoints > 0xffffffff && this.#stream.isBinary)
      this.#stream.refuse('more than 2^32 points are not read.')
    this.#pointType = this.#stream.type()
    const from = this.#cursor.position
    const list = this.#stream.list(3 * this.#declaredPoints, this.#pointType, Float64Array, 'coordinate')
    this.#points = list.subarray(0, list.length - (list.length % 3))
    this.#pointsTo = this.#cursor.position
    this.#pointsFrom = this.#stream.isBinary ? this.#pointsTo - sizeOf(this.#pointType) * list.length : from
  }

  /** Reads the time among the arrays of the whole file. */
  #readField(): void {
    this.#stream.field((name, components, tuples, type) => {
      if (components * tuples === 1 && /^time(?:value)?$/i.test(name))
        this.#time = String(this.#stream.list(1, this.#stream.typeOf(type), Float64Array, 'time')[0])
      else this.#stream.pass(components * tuples, type)
    })
  }

  #readTypes(): void {
    const cells = this.#cells
    if (cells === null) this.#stream.refuse('CELL_TYPES stands before CELLS.')
    const count = this.#stream.count()
    if (count !== cells.declared) this.#stream.refuse(`CELL_TYPES has ${count}, CELLS has ${cells.declared} cells.`)
    this.#types = this.#stream.list(count, 'Int32', Uint8Array, 'type')
  }

  #mesh(): Mesh {
    const file = this.#stream.file
    const precision = precisionOf(this.#pointType, !this.#stream.isBinary, this.#stream.digits)
    const end = file.size
    const mesh = new VtkMesh('VTK', what => {
      throw new MeshRefusal(`${file.name}: ${what}`)
    })
    if (this.#type === 'STRUCTURED_POINTS' || this.#type === 'RECTILINEAR_GRID' || this.#type === 'STRUCTURED_GRID') {
      const sizes = this.#lattice.sizes()
      if (this.#type === 'STRUCTURED_GRID') this.#checkCount(sizes)
      const points = this.#type === 'STRUCTURED_GRID' ? this.#points : null
      const areSteps = this.#type === 'STRUCTURED_POINTS'
      mesh.addStructured(() => points ?? this.#lattice.points(sizes, areSteps), sizes, precision)
    } else {
      if (this.#points === null) this.#stream.refuseAt(end, 'the file ends, and no section POINTS was there.')
      // VTK writes no section for no cells.
      const isEmpty = this.#declaredPoints === 0 && this.#cells === null
      if (isEmpty) this.#cells = { connectivity: new Uint32Array(0), ends: new Uint32Array(0), declared: 0 }
      if (isEmpty) this.#types = new Uint8Array(0)
      const areTypesLeftOut = this.#types === null && !this.#hasHeader
      const missing = this.#cells === null ? 'CELLS' : this.#types === null && !areTypesLeftOut ? 'CELL_TYPES' : null
      if (missing !== null) this.#stream.refuseAt(end, `the file ends, and no section ${missing} was there.`)
      const { connectivity, ends, declared } = this.#cells as LegacyCells
      const types = this.#types ?? typesOfSizes(ends)
      const whole = Math.min(types.length, ends.length)
      mesh.add({
        points: this.#points,
        declaredPoints: this.#declaredPoints,
        connectivity,
        ends: ends.subarray(0, whole),
        types: types.subarray(0, whole),
        declaredCells: declared,
        hasFaceStreams: true,
        precision,
        cellData: this.#cellData,
      })
      if (areTypesLeftOut) {
        mesh.note(
          'The text has no CELL_TYPES: cells of eight points are taken for hexahedra (type 12), in the order of the text.',
        )
        return { ...mesh.mesh(), isOrderStated: false }
      }
    }
    mesh.steps = this.#time === null ? [] : [this.#time]
    mesh.coordinatePlaces = this.#places()
    return mesh.mesh()
  }

  /** Null where points are implied, left out, or binary whole numbers. */
  #places(): CoordinatePlaces | null {
    if (this.#points === null || this.#points.length < 3 * this.#declaredPoints) return null
    if (!this.#stream.isBinary) return { kind: 'run', from: this.#pointsFrom, to: this.#pointsTo }
    if (!this.#pointType.startsWith('Float')) return null
    const type = this.#pointType === 'Float32' ? 'float32' : 'float64'
    return { kind: 'block', from: this.#pointsFrom, type, isLittleEndian: false }
  }

  #checkCount(sizes: readonly [number, number, number]): void {
    const count = sizes[0] * sizes[1] * sizes[2]
    if (this.#points === null) this.#stream.refuse('the grid has no POINTS.')
    if (this.#declaredPoints !== count)
      this.#stream.refuse(`the dimensions ${sizes.join(' ')} need ${count} points; POINTS has ${this.#declaredPoints}.`)
    if (this.#points.length < 3 * count) this.#stream.refuse('a grid whose points are left out has no cells.')
  }
}

const EMPTY_CELL = 0

/** Types for a snippet without them: hexahedra by their eight points, the others unknown. */
function typesOfSizes(ends: { readonly length: number; readonly [cell: number]: number }): Uint8Array {
  return Uint8Array.from({ length: ends.length }, (_, cell) => {
    const size = (ends[cell] as number) - (cell === 0 ? 0 : (ends[cell - 1] as number))
    return size === 8 ? VTK_HEXAHEDRON : EMPTY_CELL
  })
}
