/** Medit's .mesh and .meshb, versions 1 to 4, and parts of these texts as people post them. */
import type { Mesh } from '../mesh'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown, type TextCursor } from '../text-cursor'
import { LINE_HEAD, readInTurn, type Start, TextRecords } from '../text-records'
import { wordTable } from '../word-table'
import { isMeditBinary, readMeditBinary } from './medit-binary'
import { type MeditCells, meditCellsByName, meditCounted } from './medit-keywords'
import { MeditMesh } from './medit-mesh'

const SECOND_ORDER: Readonly<Record<string, readonly number[]>> = wordTable({
  hexahedron: [20, 27],
  quadrilateral: [8, 9],
  tetrahedron: [10],
  triangle: [6],
  wedge: [15, 18],
  pyramid: [13, 14],
  line: [3],
})

const HASH = 35

export const medit: MeshFormat = {
  name: 'Medit',
  recognizes(head, name) {
    if (isMeditBinary(head)) return 'yes'
    const text = headText(head)
    if (/^[ \t>]*MeshVersionFormatted\b/m.test(text)) return 'yes'
    // OpenVolumeMesh has vertices of the same look.
    if (/^\s*OVM/.test(text)) return 'no'
    if (/^[ \t>]*Vertices[ \t]*\r?\n[ \t>]*\d+[ \t]*\r?\n[ \t>]*[-+.\d]\S*[ \t]+[-+.\d]\S*[ \t]+[-+.\d]/m.test(text))
      return 'yes'
    return name.endsWith('.meshb') ? 'maybe' : 'no'
  },
  read(file, options) {
    if (isMeditBinary(file.read(0, Math.min(8, file.size)))) return [readMeditBinary(file, options)]
    return readInTurn(file, cursor => new MeditReader(file, cursor, options))
  },
}

/** True if the line begins a section: a word alone or with a number, or one of the usual words. */
function isKeyword(line: string): boolean {
  if (/^[A-Z][A-Za-z0-9_]*(?:\s+\d+)?\s*$/.test(line)) return true
  const [, word = '', rest] = /^([A-Z][A-Za-z0-9]*)\s+(?:(\d)|[A-Z])/.exec(line) ?? []
  if (/^(?:MeshVersionFormatted|Dimension|Vertices|End)$/.test(word)) return rest !== undefined || word === 'End'
  return rest !== undefined && meditCellsByName.has(word)
}

class MeditReader {
  readonly #mesh: MeditMesh
  readonly #cursor: TextCursor
  readonly #records: TextRecords
  #hasVertices = false
  #hasCells = false
  /** Cells before the vertices, and those whose order may be stated after them. */
  readonly #late: (Start & { cells: MeditCells })[] = []
  /** The beginning of another file in the same text. */
  next: Start | null = null

  constructor(file: MeshFile, cursor: TextCursor, options: ReadOptions) {
    this.#mesh = new MeditMesh(file.name)
    this.#cursor = cursor
    this.#records = new TextRecords(file, cursor, this.#mesh.builder, options, {
      endsSection: cursor => isKeyword(cursor.peekLine(LINE_HEAD)),
      hasComments: true,
      hasEnds: false,
    })
  }

  mesh(): Mesh {
    const { builder } = this.#mesh
    let hasEnded = false
    for (let begun = false; ; ) {
      const start = this.#nextKeyword()
      if (start === null) break
      if (start.name === 'MeshVersionFormatted') {
        if (begun) {
          this.next = start
          break
        }
        const version = this.#cursor.count('a version')
        if (version < 1 || version > 4) this.#cursor.refuse(`the version is ${version}; versions 1 to 4 are read.`)
        begun = true
      } else if (hasEnded) this.#cursor.skipLine()
      else if (start.name === 'Vertices' && this.#hasVertices && !begun) {
        this.next = start
        break
      } else if (start.name === 'End') hasEnded = true
      else this.#section(start.name)
    }
    if (!this.#hasVertices) this.#cursor.refuse('the vertices were expected, after the word Vertices; there are none.')
    for (const { cells, ...start } of this.#late) {
      this.#cursor.goTo(start)
      this.#cells(cells)
    }
    if (!this.#hasCells && this.#records.isSnippet && !hasEnded && builder.pointCount === 8) {
      builder.isOrderStated = false
      builder.hexahedron([0, 1, 2, 3, 4, 5, 6, 7])
      builder.note('The text has eight vertices and no cells: they are taken in the order of the text.')
    }
    this.#mesh.finish()
    return builder.mesh()
  }

  /** Passes blanks, comments, in a snippet what is no keyword, and the next word; null at the end. */
  #nextKeyword(): (Start & { name: string }) | null {
    const cursor = this.#cursor
    for (;;) {
      cursor.skipBlanks()
      if (cursor.isAtEnd) return null
      const line = cursor.peekLine(LINE_HEAD)
      if (isKeyword(line)) return { position: cursor.position, line: cursor.line, name: cursor.word() }
      if (cursor.peek() !== HASH && !this.#records.isSnippet)
        cursor.refuse(`a keyword was expected, not ${shown(line)}.`)
      cursor.skipLine()
    }
  }

  #section(name: string): void {
    const cells = meditCellsByName.get(name)
    const counted = meditCounted.get(name)
    if (name === 'Dimension') {
      const dimension = this.#cursor.count('a dimension')
      if (dimension === 2) this.#cursor.refuse('the mesh is two-dimensional: there are no hexahedra.')
      if (dimension !== 3) this.#cursor.refuse(`the dimension is ${dimension}; 3 was expected.`)
    } else if (name === 'Vertices') this.#vertices()
    else if (cells) {
      this.#hasCells = true
      if (this.#hasVertices && cells.kind !== 'curved') this.#cells(cells)
      else {
        this.#late.push({ position: this.#cursor.position, line: this.#cursor.line, cells })
        this.#records.passSection()
      }
    } else if (counted) {
      this.#hasCells = true
      this.#mesh.builder.otherCell(counted, this.#cursor.count('a number of cells'))
      this.#records.passSection()
    } else if (/^HexahedraQ[1-4]Ordering$/.test(name)) this.#ordering(name)
    else this.#records.passSection()
  }

  /** The number of numbers in the first record; null if records are not lines. */
  #numbersInLine(least: number): number | null {
    if (this.#records.next('numbers') !== 'record') return null
    const count = this.#cursor
      .peekLine()
      .trim()
      .split(/\s+/, least + 2).length
    return count === least || count === least + 1 ? count : null
  }

  #vertices(): void {
    if (this.#hasVertices) this.#cursor.refuse('there are vertices twice.')
    this.#hasVertices = true
    const cursor = this.#cursor
    const records = this.#records
    const count = cursor.count('the number of vertices')
    const inLine = this.#numbersInLine(3)
    if (records.isElided) {
      this.#mesh.mayLackVertices = true
      this.#records.passSection()
      return
    }
    if (records.points(count, 'vertices', () => this.#vertex(inLine))) this.#mesh.mayLackVertices = true
  }

  /** False where the text ends in the middle. */
  #vertex(inLine: number | null): boolean {
    const cursor = this.#cursor
    const values: number[] = []
    for (let i = 0; i < 3; ++i) {
      if (inLine !== null && !this.#records.hasField('a coordinate')) return false
      values.push(this.#mesh.builder.readCoordinate(cursor))
    }
    if (inLine !== 3) {
      if (inLine !== null && !this.#records.hasField('a reference')) return false
      cursor.number('a reference')
    }
    if (inLine !== null) this.#records.endLine('a vertex')
    this.#mesh.builder.point(values[0] as number, values[1] as number, values[2] as number)
    return true
  }

  /** Cells of second order, which Gmsh writes under the names of those of first order: by the numbers in their lines. */
  #inSecondOrder(cells: MeditCells, count: number): MeditCells {
    const more = (SECOND_ORDER[cells.kind] ?? []).find(nodes => this.#numbersInLine(nodes) === nodes + 1)
    if (more === undefined || more + 1 === count * (cells.nodes + 1)) return cells
    return { ...cells, nodes: more, kind: cells.kind === 'hexahedron' ? 'curved' : cells.kind }
  }

  #cells(named: MeditCells): void {
    const cursor = this.#cursor
    const records = this.#records
    const count = cursor.count(`the number of ${named.name}`)
    const cells = this.#inSecondOrder(named, count)
    const inLine = this.#numbersInLine(cells.nodes)
    const vertices: number[] = []
    records.all(count, 'elements', () => {
      for (let i = 0; i < cells.nodes; ++i) {
        if (inLine !== null && !records.hasField('a vertex')) return false
        vertices[i] = cursor.count('a vertex')
      }
      let reference = 0
      if (inLine !== cells.nodes) {
        if (inLine !== null && !records.hasField('a reference')) return false
        reference = cursor.number('a reference')
      }
      if (inLine !== null) records.endElement(`a cell of ${cells.name}`)
      this.#mesh.cell(cursor, cells, vertices, 0, reference)
      return true
    })
  }

  #ordering(name: string): void {
    const cursor = this.#cursor
    const nodes = (Number(name[10]) + 1) ** 3
    const count = cursor.count('the number of nodes')
    if (count !== nodes) cursor.refuse(`${name} has ${count} nodes; ${nodes} were expected.`)
    if (nodes === 8 && this.#mesh.builder.cellCount > 0) cursor.refuse(`${name} stands after the cells.`)
    const places = Array.from({ length: nodes }, () => [0, 1, 2].map(() => cursor.count('a place in the cell')))
    this.#mesh.orderNodes(cursor, places)
  }
}
