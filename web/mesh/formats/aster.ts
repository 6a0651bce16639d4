/**
 * Code_Aster's own meshes (.mail): COOR_3D has names and coordinates of nodes, HEXA8 and its kin names of elements and of their nodes, GROUP_MA
 * those of groups. Each ends with FINSF, the file with FIN; blanks and commas stand between words, "%" begins a comment.
 */
import type { MeshBuilder, OtherCell } from '../mesh-builder'
import { NameIndex, NameWords } from '../name-words'
import { lineAt } from '../number-run'
import { headText } from '../snippet-text'
import { fileOfBytes, type MeshFile, type MeshFormat, progressOf, type ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'
import { blanked, RowText } from './row-text'

/** Elements with the number of their nodes. */
const TYPES: Readonly<Record<string, readonly [OtherCell | 'hexahedron', number]>> = wordTable({
  POI1: ['vertex', 1],
  SEG2: ['line', 2],
  SEG22: ['line', 2],
  SEG3: ['line', 3],
  SEG4: ['line', 4],
  TRIA3: ['triangle', 3],
  TRIA33: ['triangle', 3],
  TRIA6: ['triangle', 6],
  TRIA66: ['triangle', 6],
  TRIA7: ['triangle', 7],
  QUAD4: ['quadrilateral', 4],
  QUAD44: ['quadrilateral', 4],
  QUAD8: ['quadrilateral', 8],
  QUAD88: ['quadrilateral', 8],
  QUAD9: ['quadrilateral', 9],
  QUAD99: ['quadrilateral', 9],
  TETRA4: ['tetrahedron', 4],
  TETRA8: ['tetrahedron', 8],
  TETRA10: ['tetrahedron', 10],
  PENTA6: ['wedge', 6],
  PENTA15: ['wedge', 15],
  PENTA18: ['wedge', 18],
  PYRAM5: ['pyramid', 5],
  PYRAM13: ['pyramid', 13],
  HEXA8: ['hexahedron', 8],
  HEXA20: ['hexahedron', 20],
  HEXA27: ['hexahedron', 27],
})
const PERCENT = 37

export const aster: MeshFormat = {
  name: 'Code_Aster',
  recognizes: head => (/^[ \t]*(?:COOR_[23]D|HEXA(?:8|20|27))\b/m.test(headText(head)) ? 'yes' : 'no'),
  read(file, options) {
    return [new AsterReader(file, options).read()]
  },
}

class AsterReader {
  readonly #file: MeshFile
  readonly #text: RowText
  readonly #builder: MeshBuilder
  readonly #progress: (position: number) => void
  readonly #onChunk: (position: number) => void
  readonly #nodes = new NameIndex()
  /** The cell of an element that is a hexahedron of 8 nodes. */
  readonly #cells = new NameIndex()

  constructor(file: MeshFile, options: ReadOptions) {
    this.#file = file
    this.#text = new RowText('Code_Aster', blanked(file, ','), options, /^\s*%/)
    this.#builder = this.#text.builder
    this.#progress = progressOf(file, options)
    this.#onChunk = position => {
      options.throwIfCancelled()
      options.onProgress(position / file.size)
    }
  }

  read() {
    const text = this.#text
    for (let word = this.#word(); word !== '' && word !== 'FIN'; word = this.#word()) {
      const name = word.toUpperCase()
      if (name === 'COOR_2D') text.refuse('a mesh of two dimensions has no hexahedra.')
      if (name === 'COOR_3D') {
        this.#passHeading()
        this.#points()
      } else if (TYPES[name] !== undefined) {
        this.#passHeading()
        text.later(() => this.#elements(name, text.cursor.position))
        this.#passRest()
      } else if (name === 'GROUP_MA') {
        text.later(() => this.#group(text.cursor.position))
        this.#passRest()
      } else if (/^(?:TITRE|GROUP_NO|DUMP|DEBUG)$/.test(name)) this.#passRest()
      else text.refuse(`${shown(word)} stands where a keyword was expected, as COOR_3D or HEXA8.`)
    }
    if (this.#builder.pointCount === 0) text.refuse('the nodes were expected, behind COOR_3D; there are none.')
    text.readLater()
    return this.#builder.mesh()
  }

  /** The next word that is in no comment; '' at the end. */
  #word(): string {
    const { cursor } = this.#text
    for (;;) {
      cursor.skipBlanks()
      if (cursor.peek() !== PERCENT) return cursor.word(PERCENT)
      cursor.skipLine()
    }
  }

  /** The next word of a part of the file, null at its end. */
  #next(): string | null {
    const word = this.#word()
    if (word === '') this.#text.refuse('the file ends where FINSF was expected.')
    this.#progress(this.#text.cursor.position)
    return word.toUpperCase() === 'FINSF' ? null : word
  }

  #passRest(): void {
    const { cursor } = this.#text
    for (; !cursor.isAtEnd; cursor.skipLine()) {
      cursor.skipBlanks()
      if (cursor.peek() === 70 && /^FINSF\b/.test(cursor.peekLine(8))) {
        cursor.word()
        return
      }
    }
    this.#text.refuse('the file ends where FINSF was expected.')
  }

  /** What stands behind the keyword in its line, and in further lines if it says so: NOM=, NBOBJ=, NBLIGE=. */
  #passHeading(): void {
    const { cursor } = this.#text
    const heading = cursor.peekLine()
    const lines = Number(/\bNBLIG[ET]\s*=\s*(\d{1,4})/.exec(heading)?.[1] ?? 1)
    if (heading.includes('=')) for (let i = 0; i < lines; ++i) cursor.skipLine()
  }

  #points(): void {
    const { cursor } = this.#text
    for (;;) {
      if (this.#pointRows()) continue
      const name = this.#next()
      if (name === null) return
      const word = new NameWords(fileOfBytes('', new TextEncoder().encode(name)), 0, () => {})
      word.next()
      if (this.#nodes.get(word) >= 0) this.#text.refuse(`node ${shown(name)} is defined twice.`)
      this.#nodes.set(word, this.#builder.point(...this.#builder.readPoint(cursor)))
    }
  }

  /** Takes many lines with names of the same beginning; false if there are none. */
  #pointRows(): boolean {
    const { cursor, builder } = this.#text
    cursor.skipBlanks()
    const [, stem] = /^([^\s\d%]{0,16})\d{1,15}\s/.exec(cursor.peekLine(64)) ?? []
    const rows = stem === undefined ? null : this.#text.rows('wrrr', { before: stem })
    if (rows === null || stem === undefined) return false
    const numbers = this.#nodes.numbers(stem)
    const first = builder.pointCount
    numbers.expect(first + rows.ahead)
    for (let row = 0; row < rows.count; ++row) {
      const number = rows.numbers[4 * row] as number
      if (numbers.get(number) >= 0) this.#text.refuse(`node ${shown(`${stem}${number}`)} is defined twice.`)
      numbers.set(number, first + row)
    }
    builder.pointRows(rows)
    return true
  }

  #words(from: number): NameWords {
    return new NameWords(this.#file, from, this.#onChunk)
  }

  /** Reads the next name of a part of the file; false at its end. Refuses a file that ends before. */
  #hasName(words: NameWords): boolean {
    if (!words.next()) this.#text.refuse('the file ends where FINSF was expected.')
    return words.number >= 0 || words.text().toUpperCase() !== 'FINSF'
  }

  #elements(type: string, from: number): void {
    const [cell, size] = TYPES[type] as readonly [OtherCell | 'hexahedron', number]
    const isTrilinear = cell === 'hexahedron' && size === 8
    const builder = this.#builder
    const words = this.#words(from)
    const nodes = Array.from({ length: size }, () => 0)
    let name = ''
    const refuse = (what: string) =>
      this.#text.cursor.refuse(`element ${shown(name)} ${what}`, lineAt(this.#file, words.position))
    while (this.#hasName(words)) {
      name = words.text()
      if (isTrilinear) {
        if (this.#cells.get(words) >= 0) refuse('is defined twice.')
        this.#cells.set(words, builder.cellCount)
      }
      for (let i = 0; i < size; ++i) {
        if (!this.#hasName(words)) refuse(`has ${i} nodes; ${type} has ${size}.`)
        const point = this.#nodes.get(words)
        if (point < 0) refuse(`names node ${shown(words.text())}, which is not defined.`)
        nodes[i] = point
      }
      if (cell !== 'hexahedron') builder.otherCell(cell)
      else if (isTrilinear) builder.hexahedron(nodes, name)
      else builder.quadraticCell(nodes.slice(0, 8), nodes.slice(8))
    }
  }

  #group(from: number): void {
    const words = this.#words(from)
    let name: string | null = null
    while (this.#hasName(words)) {
      if (name === null || /^NOM(?:\s*=\s*)?$/i.test(name)) {
        // Its name may stand behind a parameter: NOM = inside.
        const text = words.text()
        if (text === '=') continue
        name = /^NOM=./i.test(text) ? text.slice(4) : text
        continue
      }
      const cell = this.#cells.get(words)
      if (cell >= 0) this.#builder.inBlock(name, cell)
    }
  }
}
