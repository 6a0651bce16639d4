/** Gmsh's MSH 1, 2 to 2.2, 4.0 and 4.1, text and binary, and parts of these texts as people post them. */
import { BinaryCursor } from '../binary-cursor'
import { type Mesh, MeshRefusal } from '../mesh'
import { headText, isEllipsis, LARGEST_SNIPPET } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown, type TextCursor } from '../text-cursor'
import { readInTurn, type Start } from '../text-records'
import { type BinarySection, readElements2, readElements4, readNodes2, readNodes4, type Version } from './gmsh-binary'
import { type Numbers, readEntities } from './gmsh-entities'
import { GmshMesh } from './gmsh-mesh'
import { GmshText } from './gmsh-text'

const DOLLAR = 36

export const gmsh: MeshFormat = {
  name: 'Gmsh',
  recognizes(head) {
    const text = headText(head)
    if (/^[ \t>]*\$MeshFormat[ \t]*\r?$/m.test(text)) return 'yes'
    // Nastran and LS-DYNA have comments that begin with a dollar sign: there no count follows.
    if (/^[ \t>]*\$(?:NOD|ELM|Nodes|ParametricNodes|Elements)[ \t]*\r?\n[ \t>]*[\d.]+[ \t]*(?:\r?$|\d)/m.test(text))
      return 'yes'
    return 'no'
  },
  read(file, options) {
    return readInTurn(file, cursor => new GmshReader(file, cursor, options))
  },
}

class GmshReader {
  readonly #file: MeshFile
  readonly #options: ReadOptions
  readonly #mesh: GmshMesh
  readonly #isSnippet: boolean
  readonly #cursor: TextCursor
  /** Null until the format is stated, or a section shows it. */
  #version: Version | null = null
  #isStated = false
  #isBinary = false
  #isLittleEndian = true
  #sizeBytes: 4 | 8 = 8
  #hasNodes = false
  #hasElements = false
  #lateElements: Start | null = null
  /** The beginning of another file in the same text. */
  next: Start | null = null

  constructor(file: MeshFile, cursor: TextCursor, options: ReadOptions) {
    this.#file = file
    this.#options = options
    this.#mesh = new GmshMesh(file.name)
    this.#isSnippet = file.size <= LARGEST_SNIPPET
    this.#cursor = cursor
  }

  mesh(): Mesh {
    for (let begun = false; ; ) {
      const start = this.#nextSection()
      if (start === null) break
      if (start.name === 'MeshFormat' && begun) {
        this.next = start
        break
      }
      if (!this.#isStated && this.#hasElements && /^(?:NOD|Nodes)$/.test(start.name)) {
        this.next = start
        break
      }
      this.#section(start.name)
      begun ||= start.name !== 'Comments'
    }
    if (!this.#hasNodes) this.#cursor.refuse('the nodes were expected, in $Nodes or $NOD; there are none.')
    if (this.#lateElements !== null) {
      this.#cursor.goTo(this.#lateElements)
      this.#elements()
    }
    return this.#finished()
  }

  #finished(): Mesh {
    const { builder, lackingNodes } = this.#mesh
    if (!this.#hasElements) {
      if (!this.#isSnippet || this.#isBinary || builder.pointCount !== 8)
        this.#cursor.refuse('the elements were expected, in $Elements or $ELM; the file ends without them.')
      builder.isOrderStated = false
      builder.hexahedron([0, 1, 2, 3, 4, 5, 6, 7])
      builder.note('The text has eight nodes and no elements: they are taken in the order of the text.')
    }
    builder.noteLacking(lackingNodes, 'nodes', 'elements')
    return builder.mesh()
  }

  /** Passes what stands between sections, and the line with the name of the next; null at the end. */
  #nextSection(): (Start & { name: string }) | null {
    const cursor = this.#cursor
    for (;;) {
      cursor.skipBlanks()
      const byte = cursor.peek()
      if (byte === -1) return null
      if (byte === DOLLAR) {
        const start = { position: cursor.position, line: cursor.line }
        const name = cursor.word().slice(1)
        cursor.skipLine()
        if (/^[A-Z]/i.test(name) && !/^end/i.test(name)) return { ...start, name }
      } else cursor.skipLine()
    }
  }

  #section(name: string): void {
    if (name === 'MeshFormat') this.#format()
    else if (name === 'PhysicalNames') this.#physicalNames()
    else if (name === 'Entities' || name === 'PartitionedEntities') this.#entities(name)
    else if (name === 'Nodes' || name === 'NOD' || name === 'ParametricNodes') {
      this.#hasNodes = true
      if (name === 'NOD') this.#version ??= 1
      this.#nodes(name)
    } else if (name === 'Elements' || name === 'ELM') {
      if (name === 'ELM') this.#version ??= 1
      this.#hasElements = true
      if (this.#hasNodes) this.#elements()
      else {
        this.#lateElements ??= { position: this.#cursor.position, line: this.#cursor.line }
        this.#pass(name)
      }
    } else this.#pass(name)
  }

  /** Passes a section that nobody needs: up to its end, in a text up to the next section if it has none. */
  #pass(name: string): void {
    const end = `$End${name}`.toLowerCase()
    for (; !this.#cursor.isAtEnd; this.#cursor.skipLine())
      if (this.#cursor.peek() === DOLLAR && (!this.#isBinary || this.#startsWith(end))) return
  }

  /** Passes as many bytes as are the same. */
  #startsWith(word: string): boolean {
    for (let i = 0; i < word.length; ++i) {
      const byte = this.#cursor.peek()
      if (byte === -1 || String.fromCharCode(byte).toLowerCase() !== word[i]) return false
      this.#cursor.skip()
    }
    return true
  }

  #format(): void {
    const cursor = this.#cursor
    const at = cursor.line
    const [version = '', kind = '', size = '8'] = (cursor.nextLine() ?? '').trim().split(/\s+/)
    this.#version = versionOf(version)
    if (this.#version === null)
      cursor.refuse(`the version is ${shown(version)}; versions 1, 2 to 2.2, 4.0 and 4.1 of MSH are read.`, at)
    if (kind !== '0' && kind !== '1') cursor.refuse(`0 for text or 1 for binary was expected, not ${shown(kind)}.`, at)
    this.#isBinary = kind === '1'
    this.#isStated = true
    if (this.#version === 4.1) {
      if (size !== '4' && size !== '8') cursor.refuse(`a size of 4 or 8 bytes was expected, not ${shown(size)}.`, at)
      this.#sizeBytes = size === '4' ? 4 : 8
    }
    if (!this.#isBinary) return
    if (this.#version === 1) cursor.refuse('MSH 1 has no binary form.', at)
    const from = cursor.position
    const one = new BinaryCursor(this.#file, from, true).int32('the integer 1')
    if (one !== 1 && one !== 0x01000000) cursor.refuse(`the integer 1 was expected in binary, not ${one}.`)
    this.#isLittleEndian = one === 1
    cursor.goTo({ position: from + 4, line: cursor.line })
  }

  #physicalNames(): void {
    const cursor = this.#cursor
    for (;;) {
      cursor.skipBlanks()
      if (cursor.isAtEnd || cursor.peek() === DOLLAR) return
      const at = cursor.line
      const line = cursor.nextLine() ?? ''
      const [, dimension, tag, name = ''] = /^(?:(\d+)\s+)?(-?\d+)\s+"(.*)"\s*$/.exec(line.trimEnd()) ?? []
      if (tag !== undefined)
        this.#mesh.nameGroup(dimension === undefined ? null : Number(dimension), Number(tag), utf8(name))
      else if (!/^\d+\s*$/.test(line) && !isEllipsis(line))
        cursor.refuse(`a dimension, a number and a name in quotes were expected, not ${shown(line)}.`, at)
    }
  }

  #entities(name: string): void {
    const { position, line } = this.#cursor
    const isPartitioned = name !== 'Entities'
    try {
      if (this.#isBinary) {
        const cursor = this.#binary()
        const bytes = this.#sizeBytes
        const numbers: Numbers = {
          int: () => cursor.int32('an entity'),
          size: () => cursor.count(bytes, 'a number of entities'),
          double: () => cursor.float64('a coordinate'),
        }
        readEntities(numbers, this.#mesh, this.#version ?? 4.1, isPartitioned)
        this.#endBinary(cursor, name)
      } else {
        const cursor = this.#cursor
        const numbers: Numbers = {
          int: () => cursor.number('an integer'),
          size: () => cursor.count('a count'),
          double: () => cursor.number('a coordinate'),
        }
        readEntities(numbers, this.#mesh, this.#version ?? 4.1, isPartitioned)
      }
    } catch (error) {
      // A text that is cut in its entities still has its elements; what is lost are names.
      if (!(error instanceof MeshRefusal) || this.#isBinary || !this.#isSnippet) throw error
      this.#cursor.goTo({ position, line })
      this.#mesh.builder.note('The entities cannot be read: blocks lack the names of their groups.')
      this.#pass(name)
    }
  }

  #binary(): BinaryCursor {
    return new BinaryCursor(this.#file, this.#cursor.position, this.#isLittleEndian)
  }

  #endBinary(cursor: BinaryCursor, name: string): void {
    this.#cursor.goTo({ position: cursor.position, line: this.#cursor.line })
    this.#cursor.skipBlanks()
    const end = `$End${name}`
    if (this.#cursor.isAtEnd || this.#cursor.word() !== end) cursor.refuse(`${end} was expected.`)
  }

  #sectionOf(cursor: BinaryCursor): BinarySection {
    return {
      cursor,
      mesh: this.#mesh,
      version: this.#version ?? 4.1,
      sizeBytes: this.#sizeBytes,
      onRecord: position => {
        this.#options.throwIfCancelled()
        this.#options.onProgress(position / this.#file.size)
      },
    }
  }

  #text(): GmshText {
    return new GmshText(this.#file, this.#cursor, this.#mesh, this.#options)
  }

  #nodes(name: string): void {
    if (!this.#isBinary) {
      this.#version = this.#text().nodes(this.#version, name === 'ParametricNodes')
      return
    }
    const count = this.#version === 2 ? this.#binaryCount('the number of nodes') : 0
    const cursor = this.#binary()
    if (this.#version === 2) readNodes2(this.#sectionOf(cursor), count, name === 'ParametricNodes')
    else readNodes4(this.#sectionOf(cursor))
    this.#endBinary(cursor, name)
  }

  #elements(): void {
    if (!this.#isBinary) {
      this.#version = this.#text().elements(this.#version)
      return
    }
    const count = this.#version === 2 ? this.#binaryCount('the number of elements') : 0
    const cursor = this.#binary()
    if (this.#version === 2) readElements2(this.#sectionOf(cursor), count)
    else readElements4(this.#sectionOf(cursor))
    this.#endBinary(cursor, 'Elements')
  }

  /** A count in text, whose line ends before binary numbers begin. */
  #binaryCount(what: string): number {
    const count = this.#cursor.count(what)
    this.#cursor.skipLine()
    return count
  }
}

function versionOf(word: string): Version | null {
  const version = Number(word)
  if (version === 1) return 1
  if (version >= 2 && version <= 2.2) return 2
  return version === 4 ? 4 : version === 4.1 ? 4.1 : null
}

/** Words come as the bytes of a file, one a character. */
function utf8(word: string): string {
  return new TextDecoder().decode(Uint8Array.from(word, character => character.charCodeAt(0)))
}
