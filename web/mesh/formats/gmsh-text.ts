/** Nodes and elements of Gmsh's files as text, of all versions. */
import { RowPattern } from '../../core/reading-interface'
import type { FileRows } from '../file-rows'
import { isEllipsis } from '../snippet-text'
import type { MeshFile, ReadOptions } from '../source'
import { RowCursor, shown, type TextCursor } from '../text-cursor'
import { LINE_HEAD, TextRecords } from '../text-records'
import { TypedList } from '../typed-list'
import type { Version } from './gmsh-binary'
import type { GmshMesh } from './gmsh-mesh'
import { type GmshType, gmshTypes } from './gmsh-types'

const DOLLAR = 36
const HEXAHEDRON_TYPE = '5'
/** The most tags of elements that are read as rows; those with more are read one by one. */
const MOST_TAGS = 16

const NODE_ROW = new RowPattern(['whole', 'real', 'real', 'real', 'end'])
const ID_ROW = new RowPattern(['whole', 'end'])
const COORDINATES_ROW = new RowPattern(['real', 'real', 'real', 'end'])
const HEXAHEDRON_ROW = new RowPattern([...wholes(9), 'end'])

function wholes(count: number): string[] {
  return Array.from({ length: count }, () => 'whole')
}

const elementRows = new Map<string, RowPattern>()

/** MSH 1: type, two tags, the number of nodes; MSH 2: type, the number of tags, tags. */
function elementRow(version: Version, head: string, tags: number): RowPattern {
  const key = `${version}${head}`
  const parts = version === 1 ? [...wholes(2), '= 8 '] : wholes(tags)
  const row = elementRows.get(key) ?? new RowPattern(['whole', `=${head}`, ...parts, ...wholes(8), 'end'])
  elementRows.set(key, row)
  return row
}

const ENTITY = /^\s*[0-3]\s+\d+(?:\s|$)/

export class GmshText {
  readonly #cursor: TextCursor
  readonly #mesh: GmshMesh
  readonly #records: TextRecords
  readonly #nodes: number[] = []

  constructor(file: MeshFile, cursor: TextCursor, mesh: GmshMesh, options: ReadOptions) {
    this.#cursor = cursor
    this.#mesh = mesh
    this.#records = new TextRecords(file, cursor, mesh.builder, options, {
      endsSection: ahead => ahead.peek() === DOLLAR,
      hasComments: false,
      hasEnds: true,
    })
  }

  /** Gives back the version, which the first line of the section shows if nothing else states it. */
  nodes(stated: Version | null, isParametric: boolean): Version {
    const { header, version } = this.#header('nodes', stated)
    const [first = Infinity, second = Infinity] = header
    if (version <= 2) {
      const readRows = () => (isParametric ? 0 : this.#nodeRows(NODE_ROW))
      const readNode = () => this.#node(this.#id('a node'), isParametric, version === 1)
      this.#records.all(first, 'nodes', readNode, readRows)
    } else this.#nodes4(first, second, version)
    if (this.#records.isElided) this.#mesh.mayLackNodes = true
    return version
  }

  elements(stated: Version | null): Version {
    const { header, version } = this.#header('elements', stated)
    const [first = Infinity, second = Infinity] = header
    if (version <= 2) {
      this.#records.all(
        first,
        'elements',
        () => this.#element2(version),
        () => this.#elementRows2(version),
      )
    } else this.#elements4(first, second, version)
    return version
  }

  /** The numbers of a section's first line; none where the text leaves them out. */
  #header(what: string, stated: Version | null): { header: readonly number[]; version: Version } {
    const cursor = this.#cursor
    cursor.skipBlanks()
    const line = cursor.peekLine(LINE_HEAD).trim()
    const isLeftOut = this.#records.isSnippet && isEllipsis(line)
    const header = isLeftOut ? [] : line.split(/\s+/, 5).map(Number)
    if (header.some(number => !Number.isSafeInteger(number) || number < 0))
      cursor.refuse(`the number of ${what} was expected, not ${shown(line)}.`)
    const version = stated ?? (header.length === 2 ? 4 : header.length === 4 ? 4.1 : 2)
    const wanted = version === 4.1 ? 4 : version === 4 ? 2 : 1
    if (header.length !== wanted && !(isLeftOut && version <= 2))
      cursor.refuse(`the ${what} begin with ${wanted} numbers in version ${version}, not with ${shown(line)}.`)
    if (!isLeftOut) cursor.skipLine()
    return { header, version }
  }

  #id(what: string): number {
    return this.#cursor.count(`the id of ${what}`)
  }

  /** Three coordinates, which are in the same line; false where the text ends among them. */
  #node(id: number, hasParameters: boolean, mayHaveEntity = false): boolean {
    const point = this.#records.coordinates()
    if (point === null) return false
    // Into files of version 1 Gmsh writes the dimension and the tag of a node's entity, and parameters, without saying so.
    const hasEntity =
      hasParameters || (mayHaveEntity && this.#cursor.hasMoreOnLine() && ENTITY.test(this.#cursor.peekLine(LINE_HEAD)))
    if (!hasEntity) this.#records.endLine('a node')
    this.#mesh.node(this.#cursor, id, ...point)
    if (hasEntity) this.#cursor.skipLine()
    return true
  }

  #nodes4(blocks: number, count: number, version: Version): void {
    const cursor = this.#cursor
    const records = this.#records
    let seen = 0
    for (let block = 0; block < blocks && records.next('nodes') === 'record'; ++block) {
      const first = cursor.number('an entity')
      const second = cursor.number('an entity')
      const dimension = version === 4.1 ? first : second
      const hasParameters = cursor.count('whether nodes have parameters') > 0 && dimension > 0
      const nodes = cursor.count('a number of nodes')
      if (seen + nodes > count) cursor.refuse(`there are more nodes than the ${count} that were declared.`)
      seen += version === 4.1 ? this.#block41(nodes, hasParameters) : this.#block4(nodes, hasParameters)
      if (records.isElided && version === 4.1)
        cursor.refuse('the text leaves nodes out: whose coordinates these are cannot be told.')
      if (records.isElided) break
    }
    const next = records.next('nodes')
    if (next === 'record' && !records.isElided)
      cursor.refuse(`${blocks} entities with nodes are declared, there are more.`)
    records.check(next, seen, count, 'nodes')
  }

  /** Line by line: the head of the next block has four numbers, too. */
  #block4(nodes: number, hasParameters: boolean): number {
    let seen = 0
    for (; seen < nodes && this.#records.next('nodes') === 'record'; ++seen) {
      if (!this.#node(this.#id('a node'), hasParameters)) break
      this.#records.onRecord()
    }
    return seen
  }

  /** All ids of a block, then all coordinates. */
  #block41(nodes: number, hasParameters: boolean): number {
    const ids = new TypedList(Float64Array)
    while (ids.length < nodes && this.#records.next('nodes') === 'record') {
      const rows = this.#records.isElided ? null : this.#records.rows(ID_ROW)
      if (rows !== null) {
        if (ids.length + rows.count > nodes) this.#cursor.refuse(`a block of ${nodes} nodes has more lines of ids.`)
        for (let row = 0; row < rows.count; ++row) ids.push(rows.numbers[row] as number)
        continue
      }
      ids.push(this.#id('a node'))
      if (this.#records.isElided) break
      this.#records.endLine('the id of a node')
    }
    if (ids.length < nodes) return 0
    for (let seen = 0; seen < nodes; ++seen) {
      if (this.#records.next('nodes') !== 'record') return seen
      const rows = hasParameters ? null : this.#records.rows(COORDINATES_ROW)
      if (rows !== null) {
        if (seen + rows.count > nodes) this.#cursor.refuse(`a block of ${nodes} nodes has more lines of coordinates.`)
        this.#mesh.nodeRows(new RowCursor(this.#cursor, rows), rows, ids.values, seen)
        seen += rows.count - 1
      } else if (!this.#node(ids.values[seen] as number, hasParameters)) return seen
      this.#records.onRecord()
    }
    return nodes
  }

  /** The number of rows. */
  #nodeRows(pattern: RowPattern): number {
    const rows = this.#records.rows(pattern)
    if (rows !== null) this.#mesh.nodeRows(new RowCursor(this.#cursor, rows), rows)
    return rows?.count ?? 0
  }

  /** Hexahedra of the kind that is next, with one blank around the numbers that are the same in all. */
  #elementRows2(version: Version): number {
    const [, head, type = '', tags = ''] = /^\s*\d+( (\d+) (\d+) )/.exec(this.#cursor.peekLine(64)) ?? []
    if (type !== HEXAHEDRON_TYPE || head === undefined || Number(tags) > MOST_TAGS) return 0
    const rows = this.#records.rows(elementRow(version, version === 1 ? ` ${type} ` : head, Number(tags)))
    if (rows === null) return 0
    const { pattern, count, numbers } = rows
    const rowCursor = new RowCursor(this.#cursor, rows)
    const tagCount = pattern.numberCount - 9
    this.#mesh.builder.expectRows(rows, 'hexahedra')
    for (let row = 0; row < count; ++row) {
      const at = pattern.numberCount * row
      const group = tagCount > 0 ? (numbers[at + 1] as number) : 0
      const volume = tagCount > 1 ? (numbers[at + 2] as number) : 0
      this.#hexahedron(rowCursor, rows, row, this.#mesh.blocksOfElement(group, volume))
    }
    return count
  }

  /** Adds the hexahedron of a row that begins with the id and ends with the nodes. */
  #hexahedron(rowCursor: RowCursor, { pattern, numbers }: FileRows, row: number, blocks: readonly string[]): void {
    rowCursor.row = row
    const width = pattern.numberCount
    const type = gmshTypes.get(Number(HEXAHEDRON_TYPE)) as GmshType
    this.#mesh.element(rowCursor, type, numbers[width * row] as number, numbers, width * (row + 1) - 8, blocks)
  }

  /** MSH 1: id, type, group, volume, number of nodes; MSH 2: id, type, number of tags, tags. Then the nodes. */
  #element2(version: Version): boolean {
    const cursor = this.#cursor
    const records = this.#records
    const id = this.#id('an element')
    if (!records.hasField('the type of an element')) return false
    const type = cursor.count('the type of an element')
    if (version > 1 && !records.hasField('the number of tags')) return false
    const tags = version === 1 ? 3 : cursor.count('the number of tags')
    let group = 0
    let volume = 0
    for (let i = 0; i < tags; ++i) {
      if (!records.hasField('a tag')) return false
      const tag = cursor.number('a tag')
      if (i === 0) group = tag
      else if (i === 1) volume = tag
    }
    return this.#nodesOf(id, type, this.#mesh.blocksOfElement(group, volume))
  }

  /** The nodes of an element up to the end of its line. */
  #nodesOf(id: number, number: number, blocks: readonly string[]): boolean {
    const type = gmshTypes.get(number)
    if (!type) {
      this.#cursor.skipLine()
      this.#mesh.builder.otherCell('other')
      this.#mesh.builder.note(`Elements of type ${number} are none of Gmsh's: counted as “other”.`)
      return true
    }
    const nodes = this.#nodes
    for (let i = 0; i < type.nodes; ++i) {
      if (!this.#records.hasField('a node')) return false
      nodes[i] = this.#cursor.count('a node')
    }
    this.#records.endElement(`an element of type ${number}`)
    this.#mesh.element(this.#cursor, type, id, nodes, 0, blocks)
    return true
  }

  #elements4(blocks: number, count: number, version: Version): void {
    const cursor = this.#cursor
    const records = this.#records
    let seen = 0
    for (let block = 0; block < blocks && records.next('elements') === 'record' && !records.isElided; ++block) {
      const first = cursor.number('an entity')
      const second = cursor.number('an entity')
      const [dimension, tag] = version === 4.1 ? [first, second] : [second, first]
      const type = cursor.count('a type of elements')
      const elements = cursor.count('a number of elements')
      if (seen + elements > count) cursor.refuse(`there are more elements than the ${count} that were declared.`)
      const names = dimension === 3 ? this.#mesh.blocksOfVolume(tag) : []
      let whole = 0
      for (; whole < elements && records.next('elements') === 'record'; ++whole) {
        const rows = String(type) === HEXAHEDRON_TYPE ? records.rows(HEXAHEDRON_ROW) : null
        if (rows !== null) {
          if (whole + rows.count > elements)
            cursor.refuse(`a block of ${elements} elements has more lines of ${rows.pattern.numberCount} numbers.`)
          this.#mesh.builder.expectRows(rows, 'hexahedra')
          const rowCursor = new RowCursor(cursor, rows)
          for (let row = 0; row < rows.count; ++row) this.#hexahedron(rowCursor, rows, row, names)
          whole += rows.count - 1
          records.onRecord()
          continue
        }
        if (!this.#nodesOf(this.#id('an element'), type, names)) break
        records.onRecord()
      }
      seen += whole
      if (whole < elements) break
    }
    // A line after "..." may be an element or the beginning of a block: the rest is not read.
    const next = records.next('elements')
    if (next === 'record' && !records.isElided)
      cursor.refuse(`${blocks} entities with elements are declared, there are more.`)
    records.check(next, seen, count, 'elements')
  }
}
