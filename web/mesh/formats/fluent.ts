/**
 * Ansys Fluent's meshes (.msh, .cas): sections in brackets with whole numbers in hexadecimal, 10 for nodes, 12 for zones of cells, 13 for faces with
 * the cells c0 and c1 on their sides, 39 and 45 for names; with 20 or 30 in front their numbers are bytes. A face goes around anticlockwise seen from
 * c0. meshio writes another thing in section 12, the nodes of each cell.
 */
import { RowPattern } from '../../core/reading-interface'
import { BinaryCursor } from '../binary-cursor'
import { cellsOfFaces, NO_CELL } from '../cells-of-faces'
import { FileChunk } from '../file-chunk'
import { RowSearch } from '../file-rows'
import { type Mesh, MeshRefusal } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { lineAt } from '../number-run'
import { float32Note, largestOf } from '../precision'
import { headText } from '../snippet-text'
import { type MeshFile, type MeshFormat, progressOf, type ReadOptions } from '../source'
import { shown, TextCursor } from '../text-cursor'
import { TypedList } from '../typed-list'
import { blanked } from './row-text'

const [LF, QUOTE, OPEN, CLOSE, BACKSLASH] = [10, 34, 40, 41, 92] as const
const POINT_ROW = new RowPattern(['real', 'real', 'real', 'end'])
/** Cells by their type in section 12, with their nodes where meshio writes these. */
const CELLS: readonly (readonly [OtherCell | 'hexahedron', number] | undefined)[] = [
  undefined,
  ['triangle', 3],
  ['tetrahedron', 4],
  ['quadrilateral', 4],
  ['hexahedron', 8],
  ['pyramid', 5],
  ['wedge', 6],
]
const [MIXED_FACES, POLYGONS] = [0, 5] as const
const LONGEST_HEADING = 4096
const MOST_POINTS = 16_384
const AT_ONCE = 65_536
const NOTHING = new Uint8Array(0)

export const fluent: MeshFormat = {
  name: 'Fluent',
  recognizes: head =>
    /^\s{0,20}\((?:0|1)\s{0,9}"|^\s{0,20}\(2\s{1,9}3\)|^\s{0,20}\(10\s{1,9}\(0\s/.test(headText(head)) ? 'yes' : 'no',
  read(file, options) {
    return [new FluentReader(file, options).read()]
  },
}

interface Heading {
  /** The number of the section without that of its bytes: 10, 12, 13. */
  readonly section: number
  /** 20 for floats and integers of four bytes, 30 for doubles; 0 for text. */
  readonly bytes: number
  /** Zone, first and last index, type, and one number more. */
  readonly numbers: readonly number[]
}

interface Zone {
  readonly id: number
  readonly first: number
  readonly last: number
}

class FluentReader {
  readonly #file: MeshFile
  readonly #options: ReadOptions
  readonly #builder: MeshBuilder
  readonly #cursor: TextCursor
  readonly #progress: (position: number) => void
  readonly #points = new TypedList(Uint32Array)
  readonly #ends = new TypedList(Uint32Array)
  readonly #outward = new TypedList(Uint32Array)
  readonly #inward = new TypedList(Uint32Array)
  readonly #zones: Zone[] = []
  readonly #names = new Map<number, string>()
  #listed = 0
  #largest = 0

  constructor(file: MeshFile, options: ReadOptions) {
    this.#file = file
    this.#options = options
    this.#builder = new MeshBuilder('Fluent', file.name)
    this.#cursor = new TextCursor(file)
    this.#progress = progressOf(file, options)
  }

  #refuse(what: string, position = this.#cursor.position): never {
    throw new MeshRefusal(
      `${this.#file.name}, line ${lineAt(this.#file, Math.min(position, this.#file.size))}: ${what}`,
    )
  }

  read(): Mesh {
    const builder = this.#builder
    for (let byte = this.#next(); byte !== -1; byte = this.#next()) {
      if (byte !== OPEN) this.#refuse(`${shown(this.#cursor.word())} stands where a bracket was expected.`)
      this.#cursor.skip()
      this.#section()
      this.#progress(this.#cursor.position)
    }
    if (builder.pointCount === 0) builder.refuse('it has no section 10 with nodes.')
    if (this.#ends.length > 0) this.#cellsOfFaces()
    else if (this.#listed === 0) builder.refuse('it has no section 13 with faces.')
    const note = this.#largest > 0 ? float32Note(this.#largest) : null
    if (note !== null) builder.note(note)
    return builder.mesh()
  }

  #next(): number {
    this.#cursor.skipBlanks()
    return this.#cursor.peek()
  }

  /** The bytes up to one of the marks, which is not passed. */
  #upTo(...marks: readonly number[]): string {
    let text = ''
    for (let byte = this.#cursor.peek(); byte !== -1 && !marks.includes(byte); byte = this.#cursor.peek()) {
      text += String.fromCharCode(byte)
      this.#cursor.skip()
      if (text.length > LONGEST_HEADING) this.#refuse('a section has a longer heading than sections have.')
    }
    return text
  }

  #section(): void {
    const word = this.#upTo(OPEN, CLOSE, QUOTE, 32, LF).trim()
    const index = Number(word)
    if (!/^\d{1,5}$/.test(word)) this.#refuse(`${shown(word)} is no number of a section.`)
    if (index === 2) {
      const dimensions = this.#upTo(CLOSE).trim()
      if (dimensions !== '3') this.#refuse(`a mesh of ${shown(dimensions)} dimensions has no hexahedra.`)
    }
    const section = index % 1000
    const bytes = (index - section) / 100
    if ([10, 12, 13, 39, 45].includes(section) && this.#next() === OPEN) {
      this.#cursor.skip()
      const heading = this.#upTo(CLOSE)
      this.#cursor.skip()
      if (section === 39 || section === 45) this.#name(heading)
      else {
        const numbers = heading
          .trim()
          .split(/\s+/)
          .map(number => Number.parseInt(number, 16))
        if (!numbers.every(Number.isSafeInteger)) this.#refuse(`${shown(heading)} are not numbers in hexadecimal.`)
        this.#known({ section, bytes, numbers })
      }
    }
    if (bytes > 0) this.#passBinary(index)
    else this.#pass()
  }

  /** Zone, type and name: 4 wall wall-4. */
  #name(heading: string): void {
    const [id = '', , name = ''] = heading.trim().split(/\s+/)
    if (/^\d+$/.test(id) && name !== '') this.#names.set(Number(id), name)
  }

  /** Passes what is left of a section, and its bracket. */
  #pass(): void {
    const { position } = this.#cursor
    let isQuoted = false
    for (let depth = 1; depth > 0; ) {
      const byte = this.#cursor.peek()
      if (byte === -1) this.#refuse('a section does not end: the file is cut off.', position)
      this.#cursor.skip()
      if (byte === BACKSLASH) this.#cursor.skip()
      else if (byte === QUOTE) isQuoted = !isQuoted
      else if (!isQuoted && byte === OPEN) depth++
      else if (!isQuoted && byte === CLOSE) depth--
    }
  }

  /** Passes what is left of a section of bytes, up to the line with which it ends. */
  #passBinary(index: number): void {
    const { position } = this.#cursor
    // A declaration has no bytes.
    if (this.#next() === CLOSE && !this.#startsBinaryEnd()) {
      this.#cursor.skip()
      return
    }
    const end = new TextEncoder().encode('End of Binary Section')
    for (; !this.#cursor.isAtEnd; this.#cursor.skip()) {
      if (this.#cursor.peek() !== end[0] || !this.#cursor.peekLine(end.length).startsWith('End of Binary Section'))
        continue
      if (Number(this.#upTo(CLOSE).replace(/\D/g, '')) === index) {
        this.#cursor.skip()
        return
      }
    }
    this.#refuse('a section of bytes does not end: the file is cut off.', position)
  }

  /** True if the bracket is the one behind bytes. */
  #startsBinaryEnd(): boolean {
    const { position } = this.#cursor
    const text = String.fromCharCode(...this.#file.read(position, Math.min(this.#file.size, position + 40)))
    return /^\)\s*End of Binary/.test(text)
  }

  #known(heading: Heading): void {
    const { section, numbers } = heading
    const [zone = 0, first = 0, last = 0, type = 0] = numbers
    const hasBody = this.#next() === OPEN
    if (section === 12 && zone > 0 && type > 0) this.#zones.push({ id: zone, first, last })
    if (!hasBody || zone === 0) return
    const count = last - first + 1
    // meshio counts cells from 0.
    if (!(first >= (section === 12 ? 0 : 1)) || count < 0)
      this.#refuse(`the indices ${first} to ${last} of a section are none.`)
    this.#cursor.skip()
    if (section === 10) this.#nodes(heading, first, count)
    else if (section === 13) this.#faces(heading, count)
    else this.#listedCells(heading, count)
    if (heading.bytes > 0) return
    if (this.#next() !== CLOSE)
      this.#refuse(`${shown(this.#cursor.word())} stands where a section of ${count} entries ends.`)
    this.#cursor.skip()
  }

  #nodes({ bytes, numbers }: Heading, first: number, count: number): void {
    const builder = this.#builder
    if (first !== builder.pointCount + 1)
      this.#refuse(`nodes ${first} and further follow on node ${builder.pointCount}.`)
    if ((numbers[4] ?? 3) !== 3) this.#refuse('nodes in two dimensions are of no hexahedra.')
    if (6 * count > this.#file.size) this.#refuse(`the file is too short for ${count} nodes.`)
    if (bytes === 0) {
      this.#textNodes(count)
      return
    }
    const isFloat32 = bytes === 20
    const from = this.#binaryFrom(3 * count * (isFloat32 ? 4 : 8), 'coordinates')
    const cursor = new BinaryCursor(this.#file, from, true)
    builder.reserve(count, 0)
    for (let done = 0; done < count; ) {
      const some = Math.min(AT_ONCE, count - done)
      const values = isFloat32
        ? Float64Array.from({ length: 3 * some }, () => cursor.float32('a coordinate'))
        : cursor.float64s(3 * some, 'coordinates')
      for (let i = 0; i < values.length; i += 3)
        builder.point(values[i] as number, values[i + 1] as number, values[i + 2] as number)
      if (isFloat32) this.#largest = Math.max(this.#largest, largestOf(values))
      done += some
      this.#progress(cursor.position)
    }
    this.#cursor.goTo({ position: cursor.position })
  }

  #textNodes(count: number): void {
    const builder = this.#builder
    const { position } = this.#cursor
    const cursor = new TextCursor(blanked(this.#file, '()'), position, lineAt(this.#file, position))
    const search = new RowSearch(this.#options.core)
    const end = builder.pointCount + count
    while (builder.pointCount < end) {
      cursor.skipBlanks()
      const rows = end - builder.pointCount < 4 ? null : cursor.rows(search, POINT_ROW)
      if (rows === null) builder.point(...builder.readPoint(cursor))
      else if (builder.pointCount + rows.count > end)
        cursor.refuse(`there are more nodes than the ${count} of the section.`)
      else builder.pointRows(rows)
      this.#progress(cursor.position)
    }
    this.#cursor.goTo({ position: cursor.position })
  }

  /** The first of so many bytes: behind the bracket, or behind the end of its line. */
  #binaryFrom(count: number, what: string): number {
    const { position } = this.#cursor
    const from = this.#startOfBinary(count)
    return from ?? this.#refuse(`${count} bytes of ${what} were expected, with a bracket behind them.`, position)
  }

  #startOfBinary(count: number): number | null {
    const { position } = this.#cursor
    for (const skipped of ['', '\n', '\r\n']) {
      const from = position + skipped.length
      if (from + count >= this.#file.size) continue
      if (String.fromCharCode(...this.#file.read(position, from)) !== skipped) continue
      const behind = this.#file.read(from + count, Math.min(this.#file.size, from + count + 4))
      if (/^\s*\)/.test(String.fromCharCode(...behind))) return from
    }
    return null
  }

  #faces({ bytes, numbers }: Heading, count: number): void {
    const type = numbers[4] ?? MIXED_FACES
    if (2 * count > this.#file.size) this.#refuse(`the file is too short for ${count} faces.`)
    const size = type === MIXED_FACES || type === POLYGONS ? 0 : type
    if (bytes === 0) {
      const run = new HexadecimalRun(this.#file, this.#cursor.position, this.#progress)
      this.#addFaces(
        count,
        size,
        (list, from, to) => run.numbers(list, from, to),
        () => run.position,
      )
      this.#cursor.goTo({ position: run.position })
      return
    }
    this.#binaryFaces(count, size)
  }

  /** Integers have four bytes or, as meshio writes them in sections of 30, eight. */
  #binaryFaces(count: number, size: number): void {
    const width = size + 2
    const intBytes = ([4, 8] as const).find(one => size === 0 || this.#startOfBinary(width * count * one) !== null)
    if (intBytes === undefined) this.#refuse(`the bytes of ${count} faces were expected, with a bracket behind them.`)
    const from = size === 0 ? this.#cursor.position : this.#binaryFrom(width * count * intBytes, 'faces')
    const cursor = new BinaryCursor(this.#file, from, true)
    const numbers = (list: Uint32Array, start: number, to: number) => {
      const some = Math.min(to - start, Math.floor(cursor.left / intBytes))
      const values = cursor.ints(some, intBytes, 'faces')
      for (let i = 0; i < some; ++i) list[start + i] = values[i] as number
      return start + some
    }
    this.#addFaces(count, size, numbers, () => cursor.position)
    this.#cursor.goTo({ position: cursor.position })
  }

  /** Faces of `size` points, or of as many as each says itself in front; behind them c0 and c1. */
  #addFaces(
    count: number,
    size: number,
    numbers: (list: Uint32Array, from: number, to: number) => number,
    position: () => number,
  ): void {
    const points = this.#points
    const some = new Uint32Array(AT_ONCE)
    const least = size === 0 ? 5 : size + 2
    let [held, face] = [0, 0]
    while (face < count) {
      // No number behind the last face.
      const filled = numbers(some, held, Math.min(AT_ONCE, Math.max(held + 1, least * (count - face))))
      let at = 0
      for (; at < filled && face < count; ++face) {
        const own = size === 0 ? (some[at] as number) : size
        const first = size === 0 ? at + 1 : at
        if (own > MOST_POINTS || own < 2) this.#refuse(`face ${face + 1} of a section has ${own} points.`, position())
        if (first + own + 2 > filled) break
        points.reserve(points.length + own)
        for (let i = 0; i < own; ++i) {
          const point = some[first + i] as number
          if (point === 0) this.#refuse('a face names node 0; nodes count from 1.', position())
          points.values[points.length++] = point - 1
        }
        this.#ends.push(points.length)
        const [c0, c1] = [some[first + own] as number, some[first + own + 1] as number]
        this.#inward.push(c0 === 0 ? NO_CELL : c0 - 1)
        this.#outward.push(c1 === 0 ? NO_CELL : c1 - 1)
        at = first + own + 2
      }
      if (filled === held && at === 0) this.#refuse(`a section of ${count} faces ends after ${face}.`, position())
      some.copyWithin(0, at, filled)
      held = filled - at
    }
    if (held > 0) this.#refuse(`a section has more than its ${count} faces.`, position())
  }

  /** Cells with their nodes, as meshio writes them; types of mixed cells, which their faces say as well, are passed. */
  #listedCells({ bytes, numbers }: Heading, count: number): void {
    const [, first = 1, , , type = 0] = numbers
    const [cell, size] = CELLS[type] ?? []
    if (cell === undefined || size === undefined) {
      if (type !== 0) this.#builder.note(`Cells of type ${type} are known by their faces alone.`)
      this.#upToBracket()
      return
    }
    if (2 * size * count > this.#file.size) this.#refuse(`the file is too short for ${count} cells.`)
    this.#listed += count
    const nodes = new Uint32Array(size * count)
    let filled = 0
    if (bytes === 0) {
      const run = new HexadecimalRun(this.#file, this.#cursor.position, this.#progress)
      filled = run.numbers(nodes, 0, nodes.length)
      this.#cursor.goTo({ position: run.position })
    } else {
      const intBytes = bytes === 20 ? 4 : 8
      const cursor = new BinaryCursor(this.#file, this.#binaryFrom(intBytes * nodes.length, 'cells'), true)
      nodes.set(cursor.ints(nodes.length, intBytes, 'cells'))
      filled = nodes.length
      this.#cursor.goTo({ position: cursor.position })
    }
    if (filled < nodes.length) this.#refuse(`a section of ${count} cells has ${filled} nodes.`)
    if (cell !== 'hexahedron') {
      this.#builder.otherCell(cell, count)
      return
    }
    const points = this.#builder.pointCount
    for (let i = 0; i < nodes.length; ++i)
      if (!((nodes[i] as number) >= 1 && (nodes[i] as number) <= points))
        this.#refuse(`cell ${first + Math.floor(i / 8)} names node ${nodes[i]}; the nodes are 1 to ${points}.`)
    this.#builder.hexahedra(
      nodes,
      1,
      Float64Array.from({ length: count }, (_, i) => first + i),
    )
    this.#builder.note('Cells are listed with their nodes, as meshio writes them: Fluent itself has faces alone.')
  }

  /** Passes the body that is not read, up to its bracket. */
  #upToBracket(): void {
    for (let byte = this.#cursor.peek(); byte !== CLOSE && byte !== -1; byte = this.#cursor.peek()) this.#cursor.skip()
  }

  #cellsOfFaces(): void {
    const builder = this.#builder
    const faces = { points: this.#points.whole(), ends: this.#ends.whole() }
    const places = cellsOfFaces(builder, faces, this.#outward.whole(), this.#inward.whole(), 1)
    for (const { id, first, last } of this.#zones) {
      const name = this.#names.get(id) ?? `zone ${id}`
      for (let cell = Math.max(1, first); cell <= Math.min(last, places.length); ++cell) {
        const place = places[cell - 1] as number
        if (place > 0) builder.inBlock(name, place - 1)
      }
    }
    if (builder.cellCount > 0)
      builder.note('Cells of Fluent are polyhedra; those with the faces of a hexahedron are checked as trilinear ones.')
  }
}

/** Whole numbers in hexadecimal between blanks, up to a bracket. */
class HexadecimalRun {
  readonly #file: MeshFile
  readonly #progress: (position: number) => void
  readonly #memory = new FileChunk()
  #bytes: Uint8Array = NOTHING
  #start: number
  #at = 0

  constructor(file: MeshFile, from: number, progress: (position: number) => void) {
    this.#file = file
    this.#start = from
    this.#progress = progress
  }

  get position(): number {
    return this.#start + this.#at
  }

  /** Fills `list` from `from` to `to`; returns how far it came. */
  numbers(list: Uint32Array, from: number, to: number): number {
    for (let i = from; i < to; ++i) {
      if (this.#bytes.length - this.#at < 64) this.#fill()
      const bytes = this.#bytes
      let at = this.#at
      while (at < bytes.length && (bytes[at] as number) <= 32) at++
      if (bytes.length - at < 32 && this.#start + bytes.length < this.#file.size) {
        this.#at = at
        i--
        this.#fill()
        continue
      }
      const first = at
      let value = 0
      for (
        let digit = HEXADECIMAL[bytes[at] as number] ?? 16;
        digit < 16;
        digit = HEXADECIMAL[bytes[++at] as number] ?? 16
      )
        value = 16 * value + digit
      if (
        at === first ||
        value > 0xffffffff ||
        (at < bytes.length && (bytes[at] as number) > 32 && bytes[at] !== CLOSE)
      ) {
        this.#at = first
        return i
      }
      this.#at = at
      list[i] = value
    }
    return to
  }

  #fill(): void {
    const from = this.#start + this.#bytes.length
    const to = Math.min(this.#file.size, from + 16 * AT_ONCE)
    if (to <= from) return
    this.#progress(from)
    const kept = this.#bytes.subarray(this.#at)
    this.#start += this.#at
    this.#bytes = this.#memory.next(this.#file, kept, from, to)
    this.#at = 0
  }
}

/** The value of each byte as a digit, 16 of those that are none. */
const HEXADECIMAL = Uint8Array.from({ length: 256 }, (_, byte) => {
  const value = '0123456789abcdef'.indexOf(String.fromCharCode(byte).toLowerCase())
  return value < 0 ? 16 : value
})
