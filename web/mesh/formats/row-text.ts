/**
 * Texts of lines with numbers: nodes and elements with ids. Lines that are alike are taken many at once, others one by one; elements may come
 * before their nodes, and are then read when these are there.
 */
import { RowPattern } from '../../core/reading-interface'
import { type FileRows, RowSearch } from '../file-rows'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { type MeshFile, progressOf, type ReadOptions } from '../source'
import { RowCursor, TextCursor } from '../text-cursor'

const [AMPERSAND, ZERO, NINE] = [38, 48, 57] as const
/** Characters of a line that tell what it is. */
export const LINE_HEAD = 1024
/** Nodes of one element. */
const MOST_NODES = 1024

/** What stands in a row around its numbers: in front, between two, and behind. */
export interface Around {
  readonly before?: string
  readonly between?: string
  readonly behind?: string
}

export interface HexahedronRows {
  /** Vertex v is node `order[v]` of the row. */
  readonly order?: readonly number[]
  /** True if eight nodes are another cell, which has been counted. */
  readonly isOther?: (nodes: Float64Array) => boolean
}

export class RowText {
  readonly builder: MeshBuilder
  readonly cursor: TextCursor
  readonly #options: ReadOptions
  readonly #progress: (position: number) => void
  readonly #isComment: RegExp
  readonly #patterns = new Map<string, RowPattern>()
  readonly #searches = new Map<RowPattern, RowSearch>()
  readonly #later: { readonly position: number; readonly line: number; readonly read: () => void }[] = []
  readonly #eight = new Float64Array(8)

  constructor(
    format: string,
    file: MeshFile,
    options: ReadOptions,
    isComment = /^\s*$/,
    builder = new MeshBuilder(format, file.name),
  ) {
    this.builder = builder
    this.cursor = new TextCursor(file)
    this.#options = options
    this.#progress = progressOf(file, options)
    this.#isComment = isComment
  }

  /** The same mesh, which goes on in another file. */
  of(file: MeshFile): RowText {
    return new RowText('', file, this.#options, this.#isComment, this.builder)
  }

  refuse(what: string): never {
    this.cursor.refuse(what)
  }

  /** The beginning of the next line that is neither blank nor a comment; null at the end of the file. */
  line(): string | null {
    const { cursor } = this
    for (; !cursor.isAtEnd; cursor.skipLine()) {
      const text = cursor.peekLine(LINE_HEAD)
      if (!this.#isComment.test(text) && text.trim() !== '') return text
      this.#progress(cursor.position)
    }
    return null
  }

  /** Reads all lines up to one that ends them: as many at once as `many` takes, or else one by `one`, which passes it. */
  lines(isEnd: (line: string) => boolean, one: (line: string) => void, many: (line: string) => boolean): void {
    for (let line = this.line(); line !== null && !isEnd(line); line = this.line()) {
      if (!many(line)) one(line)
      this.#progress(this.cursor.position)
    }
  }

  /** Passes all lines up to one that ends them, which begins with no digit. */
  pass(isEnd: (line: string) => boolean): void {
    const { cursor } = this
    for (; !cursor.isAtEnd; cursor.skipLine()) {
      cursor.skipBlanks()
      const byte = cursor.peek()
      if (byte >= ZERO && byte <= NINE) continue
      const line = this.line()
      if (line === null || isEnd(line)) return
    }
  }

  /** Reads what begins here when the rest of the file has been read. */
  later(read: () => void): void {
    this.#later.push({ position: this.cursor.position, line: this.cursor.line, read })
  }

  /** Reads all that was left for later. */
  readLater(): void {
    for (const { position, line, read } of this.#later) {
      this.#options.throwIfCancelled()
      this.cursor.goTo({ position, line })
      read()
    }
  }

  /** Rows from here on: `kinds` has a letter for each number, w of a whole and r of a real one. */
  rows(kinds: string, { before = '', between = '', behind = '' }: Around = {}): FileRows | null {
    const key = [kinds, before, between, behind].join('\0')
    let pattern = this.#patterns.get(key)
    if (pattern === undefined) {
      const parts = [...kinds].flatMap((kind, i) => [
        ...bytesPart(i === 0 ? before : between),
        kind === 'w' ? 'whole' : 'real',
      ])
      pattern = new RowPattern([...parts, ...bytesPart(behind), 'end'])
      this.#patterns.set(key, pattern)
    }
    return this.rowsOf(pattern)
  }

  rowsOf(pattern: RowPattern): FileRows | null {
    let search = this.#searches.get(pattern)
    if (search === undefined) {
      search = new RowSearch(this.#options.core)
      this.#searches.set(pattern, search)
    }
    return this.cursor.rows(search, pattern)
  }

  /** Nodes in lines of an id and three coordinates. */
  nodes(isEnd: (line: string) => boolean): void {
    const { cursor } = this
    this.lines(
      isEnd,
      () => {
        this.node()
        cursor.skipLine()
      },
      () => this.nodeRows({}),
    )
  }

  /** Takes rows of nodes; false where there are none. */
  nodeRows(around: Around): boolean {
    const rows = this.rows('wrrr', around)
    if (rows !== null) this.builder.pointRows(rows, true)
    return rows !== null
  }

  /** The id and the coordinates that are next in the line. */
  node(): void {
    const { builder, cursor } = this
    const id = cursor.count('the number of a node')
    const [x, y, z] = [this.#coordinate(), this.#coordinate(), this.#coordinate()]
    if (!builder.newPointWithId(id, x, y, z)) this.refuse(`node ${id} is defined twice.`)
  }

  #coordinate(): number {
    if (!this.cursor.hasMoreOnLine()) this.refuse('the line ends where a coordinate was expected.')
    return this.builder.readCoordinate(this.cursor)
  }

  /** The whole numbers that are left of the line. */
  numbers(what: string, most = MOST_NODES): number[] {
    const { cursor } = this
    const numbers: number[] = []
    while (cursor.hasMoreOnLine()) {
      if (numbers.length === most) this.refuse(`the line has more than ${most} numbers.`)
      numbers.push(cursor.count(what))
    }
    return numbers
  }

  /** Takes rows with an id as number `idAt`, or the id of each row by that, and eight nodes from number `nodesAt` on; false where there are none. */
  hexahedronRows(
    rows: FileRows | null,
    idAt: number | ((row: number) => number),
    nodesAt: number,
    put: (cell: number, id: number) => void,
    { order, isOther = () => false }: HexahedronRows = {},
  ): boolean {
    if (rows === null) return false
    const { builder } = this
    const { numbers, pattern, count } = rows
    builder.expectRows(rows, 'hexahedra')
    const own = this.#eight
    for (let row = 0; row < count; ++row) {
      const at = row * pattern.numberCount
      for (let v = 0; v < 8; ++v) own[v] = numbers[at + nodesAt + (order?.[v] ?? v)] as number
      if (isOther(own)) continue
      const id = typeof idAt === 'number' ? (numbers[at + idAt] as number) : idAt(row)
      const cell = builder.hexahedronByIds(own, 0, id)
      if (cell < 0) {
        const place = new RowCursor(this.cursor, rows)
        place.row = row
        this.#refuseNodes(place, own, id)
      }
      put(cell, id)
    }
    return true
  }

  /** Adds a hexahedron of 8 nodes or, with 20 and more, a cell that is not trilinear; the corners come first. */
  hexahedron(
    id: number,
    nodes: readonly number[],
    put: (cell: number, id: number) => void,
    order?: readonly number[],
  ): void {
    const { builder, cursor } = this
    if (nodes.length < 8) this.refuse(`element ${id} has ${nodes.length} nodes; a hexahedron has 8 or more.`)
    const ordered = order === undefined ? nodes : [...order.map(v => nodes[v] as number), ...nodes.slice(8)]
    if (nodes.length > 8) {
      const indices = ordered.map(node => this.#found(node, id))
      builder.quadraticCell(indices.slice(0, 8), indices.slice(8))
      return
    }
    const cell = builder.hexahedronByIds(ordered, 0, id)
    if (cell < 0) this.#refuseNodes(cursor, ordered, id)
    put(cell, id)
  }

  #found(node: number, id: number): number {
    const index = this.builder.findId(node)
    if (index < 0) this.refuse(`element ${id} names node ${node}, which is not defined.`)
    return index
  }

  #refuseNodes(place: { refuse(what: string): never }, nodes: ArrayLike<number>, id: number): never {
    const missing = Array.from(nodes).find(node => this.builder.findId(node) < 0)
    return place.refuse(`element ${id} names node ${missing}, which is not defined.`)
  }

  /** Elements in lines of an id and their nodes, of a type that is a hexahedron or another cell; lines that begin with & go on. */
  elements(type: OtherCell | 'hexahedron', block: string | null, isEnd: (line: string) => boolean): void {
    const { builder, cursor } = this
    const put = (cell: number) => {
      if (block !== null) builder.inBlock(block, cell)
    }
    this.lines(
      isEnd,
      () => {
        if (type === 'hexahedron') {
          const id = cursor.count('the number of an element')
          const nodes = this.numbers('the number of a node')
          for (cursor.skipLine(); this.#goesOn(); cursor.skipLine()) nodes.push(...this.numbers('the number of a node'))
          this.hexahedron(id, nodes, put)
          return
        }
        builder.otherCell(type)
        for (cursor.skipLine(); this.#goesOn(); ) cursor.skipLine()
      },
      () => type === 'hexahedron' && this.hexahedronRows(this.rows('wwwwwwwww'), 0, 1, put),
    )
  }

  /** True if the line goes on with the one before; the mark is passed. */
  #goesOn(): boolean {
    if (this.line() === null) return false
    this.cursor.skipBlanks()
    if (this.cursor.peek() !== AMPERSAND) return false
    this.cursor.skip()
    return true
  }
}

function bytesPart(text: string): readonly string[] {
  return text === '' ? [] : [`=${text}`]
}

/** The file with blanks in place of some characters, so that numbers stand between blanks. */
export function blanked(file: MeshFile, characters: string): MeshFile {
  const table = Uint8Array.from({ length: 256 }, (_, byte) =>
    characters.includes(String.fromCharCode(byte)) ? 32 : byte,
  )
  return {
    name: file.name,
    size: file.size,
    read(from, to, into) {
      const bytes = file.read(from, to, into)
      // A table, since there are many and no telling where.
      for (let i = 0; i < bytes.length; ++i) bytes[i] = table[bytes[i] as number] as number
      return bytes
    },
  }
}
