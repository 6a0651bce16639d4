/**
 * VTK's legacy files, versions 1 to 5: unstructured grids, and structured and rectilinear grids and structured points, whose cells are
 * implied; in text, several after each other, or in big-endian binary.
 */
import { type CoordinatePlaces, type Mesh, MeshRefusal } from '../mesh'
import { lineAt, NumberRun } from '../number-run'
import { headText, isEllipsis } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown, TextCursor } from '../text-cursor'
import { firstFall, MOST_IMPLIED_CELLS, type Precision, VtkMesh } from './vtk-mesh'
import { alignedTo, NUMBER_SIZES, type NumberList, type NumberType, putNumbers } from './vtu-arrays'

const CHUNK = 256 * 1024
const FIRST_PIECE = 4096
const MAGIC = '# vtk DataFile Version'
/** A part of a file that somebody has cut out begins with one of its sections. */
const SECTION =
  /^[ \t]*(?:DATASET[ \t]+(?:UN)?STRUCTURED_|DATASET[ \t]+RECTILINEAR_|POINTS[ \t]+\d+[ \t]+(?:float|double)\b)/im

/** Types of arrays as these files name them. */
const TYPES: Readonly<Record<string, NumberType>> = {
  char: 'Int8',
  signed_char: 'Int8',
  unsigned_char: 'UInt8',
  short: 'Int16',
  unsigned_short: 'UInt16',
  int: 'Int32',
  unsigned_int: 'UInt32',
  long: 'Int64',
  unsigned_long: 'UInt64',
  long_long: 'Int64',
  unsigned_long_long: 'UInt64',
  vtktypeint64: 'Int64',
  vtktypeuint64: 'UInt64',
  // The ids of VTK are written as 32 bits whatever they have in memory.
  vtkidtype: 'Int32',
  float: 'Float32',
  double: 'Float64',
}

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
    let at = find(file, MAGIC, 0)
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
      at = dataset.isBinary ? -1 : find(file, MAGIC, cursor.position)
    }
    return meshes
  },
}

/** Where a line begins so, in any case of letters, from byte `from` on; -1 if none does. */
function find(file: MeshFile, words: string, from: number): number {
  const first = words.charCodeAt(0)
  let piece = FIRST_PIECE
  for (let start = from; start < file.size; start += piece, piece = Math.min(CHUNK, 2 * piece)) {
    // The words may go on, and the end of the line before lie, beyond the piece.
    const begin = Math.max(0, start - 1)
    const bytes = file.read(begin, Math.min(file.size, start + piece + words.length))
    for (let at = bytes.indexOf(first, start - begin); at >= 0; at = bytes.indexOf(first, at + 1)) {
      const isLineStart = at === 0 || (bytes[at - 1] as number) <= 32 || begin + at === 3
      if (!isLineStart) continue
      const text = String.fromCharCode(...bytes.subarray(at, at + words.length))
      if (text.toLowerCase() === words.toLowerCase()) return begin + at
    }
  }
  return -1
}

/** What is there of the cells of an unstructured grid. */
interface Cells {
  readonly connectivity: Uint32Array
  readonly ends: Uint32Array
  readonly declared: number
}

class LegacyDataset {
  readonly #file: MeshFile
  readonly #options: ReadOptions
  readonly #cursor: TextCursor
  readonly #hasHeader: boolean
  isBinary = false
  #type: DatasetType | null = null
  #points: Float64Array | null = null
  #declaredPoints = 0
  #pointsFrom = 0
  #pointsTo = 0
  #pointType: NumberType = 'Float64'
  #digits = 0
  #cells: Cells | null = null
  #types: Uint8Array | null = null
  #sizes: [number, number, number] | null = null
  #origin: [number, number, number] = [0, 0, 0]
  #spacing: [number, number, number] = [1, 1, 1]
  #hasSpacing = false
  readonly #axes: [Float64Array | null, Float64Array | null, Float64Array | null] = [null, null, null]

  constructor(file: MeshFile, options: ReadOptions, cursor: TextCursor, hasHeader: boolean) {
    this.#file = file
    this.#options = options
    this.#hasHeader = hasHeader
    this.#cursor = cursor
  }

  #refuseAt(position: number, what: string): never {
    const place = this.isBinary ? `byte ${position}` : `line ${lineAt(this.#file, position)}`
    throw new MeshRefusal(`${this.#file.name}, ${place}: ${what}`)
  }

  #refuse(what: string): never {
    this.#refuseAt(this.#cursor.position, what)
  }

  read(): Mesh {
    if (this.#hasHeader) this.#readHeader()
    while (this.#readSection());
    return this.#mesh()
  }

  #report(position: number): void {
    this.#options.throwIfCancelled()
    this.#options.onProgress(position / this.#file.size)
  }

  /** Two lines, and a third that says whether the file is text. */
  #readHeader(): void {
    const version = (this.#cursor.nextLine() ?? '').slice(MAGIC.length).trim()
    if (!/^[1-5]\.\d/.test(version)) this.#refuse(`version ${shown(version)} is not read; 1.0 to 5.1 are.`)
    // The title may be missing in a text that somebody typed.
    const title = (this.#cursor.nextLine() ?? '').trim()
    const isTitle = !/^(?:ascii|binary)$/i.test(title)
    const kind = isTitle ? this.#cursor.word() : title
    if (!/^(?:ascii|binary)$/i.test(kind)) this.#refuse(`${shown(kind)} stands where ASCII or BINARY was expected.`)
    this.isBinary = kind.toLowerCase() === 'binary'
  }

  /** Whether another may follow. */
  #readSection(): boolean {
    this.#report(this.#cursor.position)
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
        this.#readCells()
        return true
      case 'CELL_TYPES':
        this.#readTypes()
        return true
      case 'DIMENSIONS':
        this.#sizes = [this.#count(), this.#count(), this.#count()]
        return true
      case 'ORIGIN':
        this.#origin = this.#triple()
        return true
      case 'SPACING':
      case 'ASPECT_RATIO':
        this.#spacing = this.#triple()
        this.#hasSpacing = true
        return true
      case 'X_COORDINATES':
      case 'Y_COORDINATES':
      case 'Z_COORDINATES':
        this.#readAxis('XYZ'.indexOf(keyword.charAt(0).toUpperCase()))
        return true
      case 'METADATA':
        this.#passMetadata()
        return true
      case 'FIELD':
        this.#passField()
        return true
      case 'CELL_DATA':
      case 'POINT_DATA':
        return false
    }
    if (isEllipsis(keyword) && !this.isBinary) {
      this.#passElision()
      return true
    }
    if (this.#isComplete() && !/^[-+.\d]/.test(keyword)) return false
    return this.#refuseAt(from, `${shown(keyword)} stands where a section like POINTS or CELLS was expected.`)
  }

  /** Whether all that a mesh needs is there: what follows may be anything. */
  #isComplete(): boolean {
    if (this.#type === 'STRUCTURED_POINTS') return this.#sizes !== null && this.#hasSpacing
    if (this.#type === 'RECTILINEAR_GRID') return this.#axes.every(axis => axis !== null)
    if (this.#type === 'STRUCTURED_GRID') return this.#points !== null
    return this.#types !== null
  }

  #setType(type: string): void {
    const known = DATASETS.find(name => name === type.toUpperCase())
    if (known === undefined)
      this.#refuse(`a dataset of type ${shown(type)} has no cells that are read: ${DATASETS.join(', ')} have.`)
    if (this.#type !== null) this.#refuse('a second DATASET stands in one file.')
    this.#type = known
  }

  #count(): number {
    const word = this.#cursor.word()
    if (!/^\d{1,15}$/.test(word)) this.#refuse(`${shown(word)} stands where a count was expected.`)
    return Number(word)
  }

  #triple(): [number, number, number] {
    const three = new Float64Array(3)
    const run = new NumberRun(this.#file, this.#cursor.position, this.#file.size, this.#options.core)
    if (run.numbers(three, 0, 3) < 3)
      this.#refuseAt(run.position, `${shown(run.nextWord())} stands where a number was expected.`)
    this.#cursor.goTo({ position: run.position })
    return [...three] as [number, number, number]
  }

  #typeOf(word: string): NumberType {
    const type = TYPES[word.toLowerCase()]
    if (type === undefined) this.#refuse(`${shown(word)} stands where a type like double or int was expected.`)
    return type
  }

  /**
   * The next `count` numbers. Of a text that leaves some out there may be fewer; then what is left out has been passed.
   */
  #list<T extends NumberList>(count: number, type: NumberType, make: (length: number) => T, what: string): T {
    if (this.isBinary) return this.#binaryList(count, type, make, what)
    const from = this.#cursor.position
    const list = make(Math.min(count, Math.ceil((this.#file.size - from) / 2)))
    const run = new NumberRun(this.#file, from, this.#file.size, this.#options.core, position => this.#report(position))
    const filled = list instanceof Float64Array ? run.numbers(list, 0, list.length) : run.indices(list, 0, list.length)
    this.#digits = Math.max(this.#digits, run.mostDigits)
    if (filled < count) {
      const word = run.nextWord()
      if (!isEllipsis(word))
        this.#refuseAt(
          run.position,
          `${word === '' ? 'the file is cut off: it ends' : `${shown(word)} stands`} where ${what} ${filled + 1} of ${count} was expected.`,
        )
    }
    this.#cursor.goTo({ position: run.position })
    if (filled === count) return list
    this.#passElision()
    return list.slice(0, filled) as T
  }

  #binaryList<T extends NumberList>(count: number, type: NumberType, make: (length: number) => T, what: string): T {
    this.#cursor.skipLine()
    const size = NUMBER_SIZES[type]
    let at = this.#cursor.position
    const end = at + size * count
    if (end > this.#file.size) {
      const has = `${count} times ${what} in ${size} bytes were expected, ${this.#file.size - at} bytes are left`
      this.#refuseAt(at, `${has}: the file is cut off.`)
    }
    const list = make(count)
    const piece = new Uint8Array(Math.min(CHUNK, size * count))
    for (let filled = 0; filled < count; ) {
      const bytes = this.#file.read(at, Math.min(end, at + CHUNK), piece)
      const bad = putNumbers(type, alignedTo(size, bytes), true, list, filled)
      if (bad !== null)
        this.#refuseAt(
          at + size * bad.at,
          `${what} ${filled + bad.at + 1} is ${bad.value}, where a whole number from 0 on was expected.`,
        )
      filled += bytes.length / size
      at += bytes.length
      this.#report(at)
    }
    this.#cursor.goTo({ position: at })
    return list
  }

  /** Goes to the next line that begins with a letter or #. */
  #passElision(): void {
    this.#cursor.skipLine()
    for (this.#cursor.skipBlanks(); !this.#cursor.isAtEnd; this.#cursor.skipBlanks()) {
      const byte = this.#cursor.peek() | 32
      if ((byte >= 97 && byte <= 122) || this.#cursor.peek() === 35) return
      this.#cursor.skipLine()
    }
  }

  #readPoints(): void {
    if (this.#points !== null) this.#refuse('a second section POINTS stands in one file.')
    this.#declaredPoints = this.#count()
    if (this.#declaredPoints > 0xffffffff && this.isBinary) this.#refuse('more than 2^32 points are not read.')
    this.#pointType = this.#typeOf(this.#cursor.word())
    const from = this.#cursor.position
    const list = this.#list(3 * this.#declaredPoints, this.#pointType, length => new Float64Array(length), 'coordinate')
    this.#points = list.subarray(0, list.length - (list.length % 3))
    this.#pointsTo = this.#cursor.position
    this.#pointsFrom = this.isBinary ? this.#pointsTo - NUMBER_SIZES[this.#pointType] * list.length : from
  }

  #readAxis(axis: number): void {
    const count = this.#count()
    const type = this.#typeOf(this.#cursor.word())
    this.#pointType = type
    const list = this.#list(count, type, length => new Float64Array(length), `${'xyz'[axis]} coordinate`)
    if (list.length < count) this.#refuse('a grid whose coordinates are left out has no cells.')
    this.#axes[axis] = list
  }

  #readCells(): void {
    if (this.#cells !== null) this.#refuse('a second section CELLS stands in one file.')
    const first = this.#count()
    const second = this.#count()
    if (Math.max(first, second) > 0xffffffff) this.#refuse('more than 2^32 cells or numbers of cells are not read.')
    const line = this.#cursor.position
    // Version 5 has offsets. In binary files these must begin on the next line, or the numbers do.
    const isEnded = this.#cursor.nextLine()?.trim() === ''
    if (!this.isBinary) this.#cursor.skipBlanks(false)
    if (isEnded && /^o/i.test(String.fromCharCode(Math.max(0, this.#cursor.peek())))) {
      const before = this.#cursor.position
      if (this.#cursor.word().toUpperCase() === 'OFFSETS') {
        this.#cells = this.#cellsByOffsets(first, second)
        return
      }
      this.#cursor.goTo({ position: before })
    }
    this.#cursor.goTo({ position: line })
    this.#cells = this.#cellsByCounts(first, second)
  }

  /** Before version 5: for each cell its number of points and these. */
  #cellsByCounts(declared: number, size: number): Cells {
    const list = this.#list(size, 'Int32', length => new Uint32Array(length), 'number')
    const isElided = list.length < size
    const ends = new Uint32Array(Math.min(declared, list.length))
    let at = 0
    let filled = 0
    let cell = 0
    for (; cell < declared && at < list.length; ++cell) {
      const count = list[at++] as number
      if (at + count > list.length) break
      if (filled + count !== at + count) list.copyWithin(filled, at, at + count)
      at += count
      filled += count
      ends[cell] = filled
    }
    if (!isElided && (cell < declared || at < size)) {
      const have = `the ${size} numbers of CELLS hold ${cell} whole cells${at < size ? ` and ${size - at} more numbers` : ''}`
      this.#refuse(`${have}; ${declared} cells were expected.`)
    }
    return { connectivity: list.subarray(0, filled), ends: ends.subarray(0, cell), declared }
  }

  /** From version 5 on: where each cell begins and the last ends, then all points. */
  #cellsByOffsets(count: number, size: number): Cells {
    const uint32 = (length: number) => new Uint32Array(length)
    const declared = Math.max(0, count - 1)
    const offsets = this.#list(count, this.#typeOf(this.#cursor.word()), uint32, 'offset')
    const keyword = this.#cursor.word()
    if (keyword.toUpperCase() !== 'CONNECTIVITY')
      this.#refuse(`${shown(keyword)} stands where CONNECTIVITY was expected.`)
    const connectivity = this.#list(size, this.#typeOf(this.#cursor.word()), uint32, 'index')
    if (offsets.length > 0 && offsets[0] !== 0) this.#refuse(`the first offset is ${offsets[0]}, where 0 was expected.`)
    const falling = firstFall(offsets)
    if (falling > 0)
      this.#refuse(`offset ${falling} is ${offsets[falling]}, less than ${offsets[falling - 1]}, the one before.`)
    const isElided = offsets.length < count || connectivity.length < size
    let cells = Math.max(0, offsets.length - 1)
    if (!isElided && (offsets[cells] ?? 0) !== size)
      this.#refuse(`the offsets end at ${offsets[cells] ?? 0}, where ${size}, the number of indices, was expected.`)
    while (cells > 0 && (offsets[cells] as number) > connectivity.length) cells--
    return { connectivity, ends: offsets.subarray(1, cells + 1), declared }
  }

  #readTypes(): void {
    const cells = this.#cells
    if (cells === null) this.#refuse('CELL_TYPES stands before CELLS.')
    const count = this.#count()
    if (count !== cells.declared) this.#refuse(`CELL_TYPES has ${count}, CELLS has ${cells.declared} cells.`)
    this.#types = this.#list(count, 'Int32', length => new Uint8Array(length), 'type')
  }

  /** Lines up to an empty one. */
  #passMetadata(): void {
    this.#cursor.skipLine()
    for (let line = this.#cursor.nextLine(); line !== null; line = this.#cursor.nextLine())
      if (line.trim() === '') return
  }

  /** Arrays of names and times, which are not needed. */
  #passField(): void {
    this.#cursor.word()
    const count = this.#count()
    for (let i = 0; i < count; ++i) {
      if (this.#cursor.word().toUpperCase() === 'METADATA') {
        this.#passMetadata()
        this.#cursor.word()
      }
      const numbers = this.#count() * this.#count()
      const type = this.#cursor.word().toLowerCase()
      if (type === 'string') this.#passStrings(numbers)
      else if (!this.isBinary) this.#passNumbers(numbers)
      else {
        this.#cursor.skipLine()
        const bytes = type === 'bit' ? Math.ceil(numbers / 8) : numbers * NUMBER_SIZES[this.#typeOf(type)]
        if (this.#cursor.position + bytes > this.#file.size)
          this.#refuse(`an array of ${bytes} bytes was expected: the file is cut off.`)
        this.#cursor.goTo({ position: this.#cursor.position + bytes })
      }
    }
  }

  #passNumbers(count: number): void {
    const run = new NumberRun(this.#file, this.#cursor.position, this.#file.size, this.#options.core)
    const some = new Float64Array(1024)
    for (let left = count; left > 0; left -= some.length) {
      const part = Math.min(left, some.length)
      if (run.numbers(some, 0, part) === part) continue
      this.#refuseAt(run.position, `${shown(run.nextWord())} stands where a number of a field was expected.`)
    }
    this.#cursor.goTo({ position: run.position })
  }

  /** In text a line each; in binary files a length of one, two, four or eight bytes, as its highest two bits say, and the bytes. */
  #passStrings(count: number): void {
    this.#cursor.skipLine()
    if (!this.isBinary) {
      for (let i = 0; i < count && !this.#cursor.isAtEnd; ++i) this.#cursor.skipLine()
      return
    }
    let at = this.#cursor.position
    for (let i = 0; i < count; ++i) {
      const head = this.#file.read(Math.min(at, this.#file.size), Math.min(at + 8, this.#file.size))
      const kind = (head[0] ?? 0) >> 6
      const bytes = [8, 4, 2, 1][kind] as number
      let length = (head[0] ?? 0) & 63
      for (let k = 1; k < bytes; ++k) length = 256 * length + (head[k] ?? 0)
      at += bytes + length
      if (at > this.#file.size) this.#refuse('a text of a field goes on behind the end of the file: it is cut off.')
    }
    this.#cursor.goTo({ position: at })
  }

  #precision(): Precision {
    const isFloat32 = this.#pointType === 'Float32'
    // A Float32 needs nine digits; those that are printed with fewer are known to them.
    return this.isBinary
      ? { isFloat32, digits: 0 }
      : { isFloat32: isFloat32 && this.#digits >= 9, digits: this.#digits }
  }

  #mesh(): Mesh {
    const file = this.#file
    const end = file.size
    const mesh = new VtkMesh('VTK', what => {
      throw new MeshRefusal(`${file.name}: ${what}`)
    })
    if (this.#type === 'STRUCTURED_POINTS' || this.#type === 'RECTILINEAR_GRID' || this.#type === 'STRUCTURED_GRID') {
      const sizes = this.#checkedSizes()
      mesh.addStructured(() => this.#structuredPoints(sizes), sizes, this.#precision())
    } else {
      if (this.#points === null) this.#refuseAt(end, 'the file ends, and no section POINTS was there.')
      const missing = this.#cells === null ? 'CELLS' : this.#types === null ? 'CELL_TYPES' : null
      if (missing !== null) this.#refuseAt(end, `the file ends, and no section ${missing} was there.`)
      const { connectivity, ends, declared } = this.#cells as Cells
      const types = this.#types as Uint8Array
      const whole = Math.min(types.length, ends.length)
      mesh.add({
        points: this.#points,
        declaredPoints: this.#declaredPoints,
        connectivity,
        ends: ends.subarray(0, whole),
        types: types.subarray(0, whole),
        declaredCells: declared,
        hasFaceStreams: true,
        precision: this.#precision(),
      })
    }
    mesh.coordinatePlaces = this.#places()
    return mesh.mesh()
  }

  /** Null where points are implied, left out, or binary whole numbers. */
  #places(): CoordinatePlaces | null {
    if (this.#points === null || this.#points.length < 3 * this.#declaredPoints) return null
    if (!this.isBinary) return { kind: 'run', from: this.#pointsFrom, to: this.#pointsTo }
    if (!this.#pointType.startsWith('Float')) return null
    const type = this.#pointType === 'Float32' ? 'float32' : 'float64'
    return { kind: 'block', from: this.#pointsFrom, type, isLittleEndian: false }
  }

  #checkedSizes(): [number, number, number] {
    const sizes = this.#sizes
    if (sizes === null) return this.#refuse('the grid has no DIMENSIONS.')
    if (sizes.includes(0)) this.#refuse(`the dimensions are ${sizes.join(' ')}, where counts from 1 on were expected.`)
    const cells = sizes.reduce((product, size) => product * Math.max(1, size - 1), 1)
    const points = sizes.reduce((product, size) => product * size, 1)
    if (cells > MOST_IMPLIED_CELLS || points > 2 * MOST_IMPLIED_CELLS)
      this.#refuse(
        `the dimensions ${sizes.join(' ')} imply ${cells} cells and ${points} points; at most ${MOST_IMPLIED_CELLS} cells and twice as many points are read.`,
      )
    return sizes
  }

  #structuredPoints(sizes: readonly [number, number, number]): Float64Array {
    const count = sizes[0] * sizes[1] * sizes[2]
    if (this.#type === 'STRUCTURED_GRID') {
      if (this.#points === null) this.#refuse('the grid has no POINTS.')
      if (this.#declaredPoints !== count)
        this.#refuse(`the dimensions ${sizes.join(' ')} need ${count} points; POINTS has ${this.#declaredPoints}.`)
      if (this.#points.length < 3 * count) this.#refuse('a grid whose points are left out has no cells.')
      return this.#points
    }
    const axes = this.#type === 'RECTILINEAR_GRID' ? this.#axes : this.#evenAxes(sizes)
    const [x, y, z] = axes.map((axis, i) => {
      const name = 'XYZ'[i]
      if (axis === null) return this.#refuse(`the grid has no ${name}_COORDINATES.`)
      if (axis.length !== sizes[i])
        this.#refuse(`${name}_COORDINATES has ${axis.length}, the dimension is ${sizes[i]}.`)
      return axis
    }) as [Float64Array, Float64Array, Float64Array]
    const points = new Float64Array(3 * count)
    let at = 0
    for (const zk of z)
      for (const yj of y)
        for (const xi of x) {
          points[at] = xi
          points[at + 1] = yj
          points[at + 2] = zk
          at += 3
        }
    return points
  }

  #evenAxes(sizes: readonly [number, number, number]): Float64Array[] {
    return sizes.map((size, axis) =>
      Float64Array.from(
        { length: size },
        (_, i) => (this.#origin[axis] as number) + i * (this.#spacing[axis] as number),
      ),
    )
  }
}
