/**
 * Nodes and elements of Gmsh's files as text, of all versions. A snippet may end anywhere, or leave something out with "...": elements that
 * are whole are read.
 */
import { isEllipsis } from '../snippet-text'
import { shown, type TextCursor } from '../text-cursor'
import type { Version } from './gmsh-binary'
import type { GmshMesh } from './gmsh-mesh'
import { gmshTypes } from './gmsh-types'

const [PLUS, MINUS, DOLLAR, ZERO, NINE] = [43, 45, 36, 48, 57] as const
/** What a record gives back that ends with the text, in its middle. */
const INCOMPLETE = -1

/** What stands next: a record, the name of a section, or anything else. */
type Next = 'record' | 'section' | 'end'

export class GmshText {
  readonly #cursor: TextCursor
  readonly #mesh: GmshMesh
  readonly #isSnippet: boolean
  readonly #onRecord: (position: number) => void
  #isElided = false
  #headerLine = 0
  readonly #numbers: number[] = []

  constructor(cursor: TextCursor, mesh: GmshMesh, isSnippet: boolean, onRecord: (position: number) => void) {
    this.#cursor = cursor
    this.#mesh = mesh
    this.#isSnippet = isSnippet
    this.#onRecord = onRecord
  }

  /** Gives back the version, which the first line of the section shows if nothing else states it. */
  nodes(stated: Version | null, isParametric: boolean): Version {
    const header = this.#header('nodes')
    const version = stated ?? (header.length === 2 ? 4 : header.length === 4 ? 4.1 : 2)
    this.#checkHeader(header, version, 'nodes')
    if (version <= 2) this.#nodes2(header[0] ?? Infinity, isParametric)
    else this.#nodes4(header[0] as number, header[1] as number, version)
    return version
  }

  elements(stated: Version | null): Version {
    const header = this.#header('elements')
    const version = stated ?? (header.length === 2 ? 4 : header.length === 4 ? 4.1 : 2)
    this.#checkHeader(header, version, 'elements')
    if (version <= 2) this.#elements2(header[0] ?? Infinity, version)
    else this.#elements4(header[0] as number, header[1] as number, version)
    return version
  }

  /** The numbers of a section's first line; none where the text leaves them out. */
  #header(what: string): number[] {
    const cursor = this.#cursor
    cursor.skipBlanks()
    this.#headerLine = cursor.line
    const line = (cursor.nextLine() ?? '').trim()
    if (this.#isSnippet && isEllipsis(line)) {
      this.#isElided = true
      return []
    }
    const numbers = line.split(/\s+/).map(Number)
    if (numbers.length > 4 || numbers.some(number => !Number.isSafeInteger(number) || number < 0))
      cursor.refuse(`the number of ${what} was expected, not ${shown(line)}.`, this.#headerLine)
    return numbers
  }

  #checkHeader(header: readonly number[], version: Version, what: string): void {
    const wanted = version === 4.1 ? 4 : version === 4 ? 2 : 1
    if (header.length !== wanted && !(header.length === 0 && version <= 2))
      this.#cursor.refuse(
        `the first line of the ${what} has ${header.length} numbers; ${wanted} were expected in version ${version}.`,
        this.#headerLine,
      )
  }

  /** Passes blank lines, and lines that stand for what was left out. */
  #nextOf(what: string): Next {
    const cursor = this.#cursor
    for (;;) {
      cursor.skipBlanks()
      const byte = cursor.peek()
      if ((byte >= ZERO && byte <= NINE) || byte === MINUS || byte === PLUS) return 'record'
      if (byte === DOLLAR) return 'section'
      if (byte === -1) return 'end'
      const at = cursor.line
      const line = cursor.nextLine() ?? ''
      if (this.#isSnippet && isEllipsis(line)) {
        this.#isElided = true
        this.#mesh.mayLackNodes = true
      } else if (this.#isSnippet) return 'end'
      else cursor.refuse(`${what} were expected, not ${shown(line)}.`, at)
    }
  }

  /** Reads records up to the end of the section or of the text; the number of those that are whole. */
  #records(declared: number, what: string, read: () => boolean): number {
    let count = 0
    let next: Next = 'record'
    for (; ; ++count) {
      next = this.#nextOf(what)
      if (next !== 'record') break
      if (count === declared) this.#cursor.refuse(`there are more ${what} than the ${declared} that were declared.`)
      if (!read()) {
        next = 'end'
        break
      }
      this.#onRecord(this.#cursor.position)
    }
    this.#check(next, count, declared, what)
    return count
  }

  /** Says what is not there; refuses where that is no snippet's way to end. */
  #check(next: Next, count: number, declared: number, what: string): void {
    const { builder } = this.#mesh
    if (this.#isElided) builder.note('The text leaves something out: what is whole in it has been read.')
    else if (next === 'end' && count < declared && !(this.#isSnippet && what === 'elements'))
      this.#cursor.refuse(`the file ends after ${count} of ${declared} ${what}.`)
    else if (next === 'end') builder.note(`The text is cut: it ends before the end of the ${what}.`)
    else if (count < declared) this.#cursor.refuse(`${declared} ${what} are declared, the section has ${count}.`)
    if (what === 'elements' && count < declared && declared < Infinity) {
      builder.isCutOff = true
      builder.note(`Of ${declared} elements ${count} are there.`)
    }
  }

  /** The next integer of the line, or INCOMPLETE where the text ends. */
  #id(what: string): number {
    return this.#hasField(what) ? this.#cursor.count(what) : INCOMPLETE
  }

  #hasField(what: string): boolean {
    if (this.#cursor.hasMoreOnLine()) return true
    if (this.#isSnippet && this.#cursor.isAtEnd) return false
    this.#cursor.refuse(`the line ends where ${what} was expected.`)
  }

  #endLine(what: string): void {
    if (this.#cursor.hasMoreOnLine()) this.#cursor.refuse(`the line has more numbers than ${what} has.`)
  }

  #nodes2(count: number, isParametric: boolean): void {
    this.#records(count, 'nodes', () => this.#node(this.#cursor.count('the id of a node'), isParametric))
  }

  /** Three coordinates, which are in the same line; false where the text ends among them. */
  #node(id: number, hasParameters: boolean): boolean {
    const cursor = this.#cursor
    if (!this.#hasField('a coordinate')) return false
    const x = this.#coordinate()
    if (!this.#hasField('a coordinate')) return false
    const y = this.#coordinate()
    if (!this.#hasField('a coordinate')) return false
    const z = this.#coordinate()
    if (hasParameters) cursor.skipLine()
    else this.#endLine('a node')
    this.#mesh.node(cursor, id, x, y, z)
    return true
  }

  #coordinate(): number {
    const value = this.#cursor.number('a coordinate')
    this.#mesh.digits.see(value, this.#cursor.digits)
    return value
  }

  #nodes4(blocks: number, count: number, version: Version): void {
    const cursor = this.#cursor
    let seen = 0
    for (let block = 0; block < blocks; ++block) {
      if (this.#nextOf('nodes') !== 'record') break
      const first = cursor.number('an entity')
      const second = cursor.number('an entity')
      const dimension = version === 4.1 ? first : second
      const hasParameters = cursor.count('whether nodes have parameters') > 0 && dimension > 0
      const nodes = cursor.count('a number of nodes')
      if (seen + nodes > count) cursor.refuse(`there are more nodes than the ${count} that were declared.`)
      seen += version === 4.1 ? this.#block41(nodes, hasParameters) : this.#block4(nodes, hasParameters)
      if (this.#isElided && version === 4.1)
        cursor.refuse('the text leaves nodes out: whose coordinates these are cannot be told.')
    }
    const next = this.#nextOf('nodes')
    if (next === 'record') cursor.refuse(`there are more nodes than the ${blocks} entities have that were declared.`)
    this.#check(next, seen, count, 'nodes')
  }

  #block4(nodes: number, hasParameters: boolean): number {
    let seen = 0
    for (; seen < nodes && this.#nextOf('nodes') === 'record'; ++seen) {
      if (!this.#node(cursorId(this.#cursor), hasParameters)) break
      this.#onRecord(this.#cursor.position)
    }
    return seen
  }

  /** All ids of a block, then all coordinates. */
  #block41(nodes: number, hasParameters: boolean): number {
    const ids: number[] = []
    while (ids.length < nodes && this.#nextOf('nodes') === 'record') {
      ids.push(cursorId(this.#cursor))
      this.#endLine('the id of a node')
    }
    if (ids.length < nodes) return 0
    for (const [seen, id] of ids.entries()) {
      this.#cursor.skipBlanks()
      if (this.#cursor.peek() === -1 || this.#cursor.peek() === DOLLAR || !this.#node(id, hasParameters)) return seen
      this.#onRecord(this.#cursor.position)
    }
    return nodes
  }

  #elements2(count: number, version: Version): void {
    this.#records(count, 'elements', () => this.#element2(version))
  }

  /** MSH 1: id, type, group, volume, number of nodes; MSH 2: id, type, number of tags, tags. Then the nodes. */
  #element2(version: Version): boolean {
    const cursor = this.#cursor
    const id = cursor.count('the id of an element')
    const number = this.#id('the type of an element')
    if (number === INCOMPLETE) return false
    const tags = version === 1 ? 3 : this.#id('the number of tags')
    if (tags === INCOMPLETE) return false
    const read: number[] = []
    for (let i = 0; i < tags; ++i) {
      if (!this.#hasField('a tag')) return false
      read[Math.min(i, 2)] = cursor.number('a tag')
    }
    return this.#nodesOf(id, number, this.#mesh.blocksOfElement(read[0] ?? 0, read[1] ?? 0))
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
    const nodes = this.#numbers
    for (let i = 0; i < type.nodes; ++i) {
      const node = this.#id('a node')
      if (node === INCOMPLETE) return false
      nodes[i] = node
    }
    this.#endLine(`an element of type ${number}`)
    // Where the text ends without an end of line, the last number may have lost digits.
    if (this.#cursor.isAtEnd) this.#mesh.builder.isCutOff = true
    this.#mesh.element(this.#cursor, type, id, nodes, 0, blocks)
    return true
  }

  #elements4(blocks: number, count: number, version: Version): void {
    const cursor = this.#cursor
    let seen = 0
    for (let block = 0; block < blocks && !this.#isElided; ++block) {
      if (this.#nextOf('elements') !== 'record' || this.#isElided) break
      const first = cursor.number('an entity')
      const second = cursor.number('an entity')
      const [dimension, tag] = version === 4.1 ? [first, second] : [second, first]
      const type = cursor.count('a type of elements')
      const elements = cursor.count('a number of elements')
      if (seen + elements > count) cursor.refuse(`there are more elements than the ${count} that were declared.`)
      const names = dimension === 3 ? this.#mesh.blocksOfVolume(tag) : []
      let whole = 0
      for (; whole < elements && this.#nextOf('elements') === 'record'; ++whole) {
        if (!this.#nodesOf(cursor.count('the id of an element'), type, names)) break
        this.#onRecord(cursor.position)
      }
      seen += whole
      if (whole < elements) break
    }
    // After "..." a line may be an element or the beginning of a block: what follows is not read.
    const next = this.#nextOf('elements')
    if (next === 'record' && !this.#isElided)
      cursor.refuse(`there are more elements than the ${blocks} entities have that were declared.`)
    this.#check(next, seen, count, 'elements')
  }
}

function cursorId(cursor: TextCursor): number {
  return cursor.count('the id of a node')
}
