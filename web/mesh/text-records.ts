/**
 * Records of a text, one a line: nodes, elements. A file must have as many as it declares. A snippet may end anywhere, or leave something
 * out with "...": its whole elements are read, and a note says so.
 */

import type { RowPattern } from '../core/reading-interface'
import { type FileRows, RowSearch } from './file-rows'
import type { Mesh } from './mesh'
import type { MeshBuilder } from './mesh-builder'
import { isEllipsis, LARGEST_SNIPPET } from './snippet-text'
import { type MeshFile, progressOf, type ReadOptions } from './source'
import { shown, TextCursor } from './text-cursor'

/** Characters of a line that tell what it is. */
export const LINE_HEAD = 240

const [PLUS, MINUS, HASH, ZERO, NINE] = [43, 45, 35, 48, 57] as const

/** The next item: a record, a section's beginning or end, or the end of the file's text. */
export type Next = 'record' | 'section' | 'end'

export interface RecordsOptions {
  /** True if the next line ends a section; it is not passed. */
  readonly endsSection: (cursor: TextCursor) => boolean
  readonly hasComments: boolean
  /** True if a section has a line that ends it. */
  readonly hasEnds: boolean
}

export class TextRecords {
  readonly cursor: TextCursor
  readonly #builder: MeshBuilder
  readonly #options: RecordsOptions
  readonly #rowSearch: RowSearch
  readonly #progress: (position: number) => void
  /** True if the text may be a part of a file. */
  readonly isSnippet: boolean
  /** True if the text leaves something out. */
  isElided = false

  constructor(
    file: MeshFile,
    cursor: TextCursor,
    builder: MeshBuilder,
    readOptions: ReadOptions,
    options: RecordsOptions,
  ) {
    this.cursor = cursor
    this.#builder = builder
    this.#options = options
    this.#rowSearch = new RowSearch(readOptions.core)
    this.#progress = progressOf(file, readOptions)
    this.isSnippet = file.size <= LARGEST_SNIPPET
  }

  /** Passes blank lines, comments, and lines that stand for what was left out. */
  next(what: string): Next {
    const { cursor, isSnippet } = this
    const { endsSection, hasComments } = this.#options
    for (;;) {
      cursor.skipBlanks()
      const byte = cursor.peek()
      if ((byte >= ZERO && byte <= NINE) || byte === MINUS || byte === PLUS) return 'record'
      if (byte === -1) return 'end'
      if (endsSection(cursor)) return 'section'
      const line = cursor.peekLine(LINE_HEAD)
      if (/^(?:\.\d|nan\b|inf)/i.test(line)) return 'record'
      if (isSnippet && isEllipsis(line)) this.isElided = true
      else if (!(hasComments && byte === HASH)) {
        if (isSnippet) return 'end'
        cursor.refuse(`${what} were expected, not ${shown(line)}.`)
      }
      cursor.skipLine()
    }
  }

  /** Records of one line each, as rows, where they are seen; null else. */
  rows(pattern: RowPattern): FileRows | null {
    return this.cursor.rows(this.#rowSearch, pattern)
  }

  /**
   * Reads records up to the end of the section or of the text, one by one or several as rows, which `readRows` then counts; the number of those
   * that are whole.
   */
  all(declared: number, what: string, read: () => boolean, readRows: () => number = () => 0): number {
    for (let count = 0; ; ++count) {
      const next = this.next(what)
      if (next !== 'record') {
        this.check(next, count, declared, what)
        return count
      }
      if (count === declared) this.cursor.refuse(`there are more ${what} than the ${declared} that were declared.`)
      const rows = readRows()
      if (count + rows > declared) this.cursor.refuse(`there are more ${what} than the ${declared} that were declared.`)
      if (rows > 0) count += rows - 1
      else if (!read()) {
        this.check('end', count, declared, what)
        return count
      }
      this.onRecord()
    }
  }

  /**
   * Reads points, which are counted and have no ids: of those after "..." it cannot be told which they are, so they are passed. True if some
   * are left out.
   */
  points(declared: number, what: string, read: (index: number) => boolean): boolean {
    let next = this.next(what)
    let count = 0
    for (; next === 'record' && !this.isElided; next = this.next(what)) {
      if (count === declared) this.cursor.refuse(`there are more ${what} than the ${declared} that were declared.`)
      if (!read(count)) {
        next = 'end'
        break
      }
      count++
      this.onRecord()
    }
    this.check(next, count, declared, what)
    if (this.isElided && next === 'record') this.passSection()
    return this.isElided
  }

  /** Passes the rest of a section. */
  passSection(): void {
    const { cursor } = this
    do {
      cursor.skipLine()
      cursor.skipBlanks()
    } while (!cursor.isAtEnd && !this.#options.endsSection(cursor))
  }

  onRecord(): void {
    this.#progress(this.cursor.position)
  }

  /** Says what is not there; refuses where that is no snippet's way to end. */
  check(next: Next, count: number, declared: number, what: string): void {
    const isElements = what === 'elements'
    if (this.isElided) this.#builder.note('The text leaves something out: what is whole in it has been read.')
    else if (next === 'end' && count < declared && !(this.isSnippet && isElements))
      this.cursor.refuse(`the file ends after ${count} of ${declared} ${what}.`)
    else if (count < declared && next === 'section')
      this.cursor.refuse(`${declared} ${what} are declared, the section has ${count}.`)
    if (isElements && count < declared && declared < Infinity) {
      this.#builder.isCutOff = true
      this.#builder.note(`The text is cut: of ${declared} elements ${count} are there.`)
    } else if (next === 'end' && this.#options.hasEnds)
      this.#builder.note(`The text ends before the end of the ${what}.`)
  }

  /** True if the line has another number; false if the text ends, which only a snippet may. */
  hasField(what: string): boolean {
    if (this.cursor.hasMoreOnLine()) return true
    if (this.isSnippet && this.cursor.isAtEnd) return false
    this.cursor.refuse(`the line ends where ${what} was expected.`)
  }

  /** The next three coordinates, which are in the same line; null where the text ends among them. */
  coordinates(): readonly [number, number, number] | null {
    if (!this.hasField('a coordinate')) return null
    const x = this.#builder.readCoordinate(this.cursor)
    if (!this.hasField('a coordinate')) return null
    const y = this.#builder.readCoordinate(this.cursor)
    if (!this.hasField('a coordinate')) return null
    return [x, y, this.#builder.readCoordinate(this.cursor)]
  }

  /** Refuses further numbers in the line. */
  endLine(what: string): void {
    if (this.cursor.hasMoreOnLine()) this.cursor.refuse(`the line has more numbers than ${what} has.`)
  }

  /** Ends an element; a text without an end of line behind it is cut off: digits may be lost. */
  endElement(what: string): void {
    this.endLine(what)
    if (this.cursor.isAtEnd) this.#builder.isCutOff = true
  }
}

/** The beginning of a section that is read later. */
export interface Start {
  readonly position: number
  readonly line: number
}

/** Reads one file of a text, and says where another begins. */
interface Reader {
  mesh(): Mesh
  readonly next: Start | null
}

/** All files that stand in one text, one after the other. */
export function readInTurn(file: MeshFile, readerAt: (cursor: TextCursor) => Reader): readonly Mesh[] {
  const meshes: Mesh[] = []
  const cursor = new TextCursor(file)
  for (let start: Start | null = { position: 0, line: 1 }; start !== null; ) {
    cursor.goTo(start)
    const reader: Reader = readerAt(cursor)
    meshes.push(reader.mesh())
    start = reader.next
  }
  return meshes
}
