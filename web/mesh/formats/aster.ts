/**
 * Code_Aster's own meshes (.mail): COOR_3D has names and coordinates of nodes, HEXA8 and its kin names of elements and of their nodes, GROUP_MA
 * those of groups. Each ends with FINSF, the file with FIN; blanks and commas stand between words, "%" begins a comment.
 */
import type { MeshBuilder, OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import { type MeshFile, type MeshFormat, progressOf, type ReadOptions } from '../source'
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
  readonly #text: RowText
  readonly #builder: MeshBuilder
  readonly #progress: (position: number) => void
  readonly #nodes = new Map<string, number>()
  /** The cell of an element that is a hexahedron of 8 nodes. */
  readonly #cells = new Map<string, number>()

  constructor(file: MeshFile, options: ReadOptions) {
    this.#text = new RowText('Code_Aster', blanked(file, ','), options, /^\s*%/)
    this.#builder = this.#text.builder
    this.#progress = progressOf(file, options)
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
        text.later(() => this.#elements(name))
        this.#passRest()
      } else if (name === 'GROUP_MA') {
        text.later(() => this.#group())
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
    for (let name = this.#next(); name !== null; name = this.#next()) {
      if (this.#nodes.has(name)) this.#text.refuse(`node ${shown(name)} is defined twice.`)
      this.#nodes.set(name, this.#builder.point(...this.#builder.readPoint(cursor)))
    }
  }

  #elements(type: string): void {
    const [cell, size] = TYPES[type] as readonly [OtherCell | 'hexahedron', number]
    const nodes: number[] = []
    for (let name = this.#next(); name !== null; name = this.#next()) {
      nodes.length = 0
      for (let i = 0; i < size; ++i) {
        const node = this.#next() ?? this.#text.refuse(`element ${shown(name)} has ${i} nodes; ${type} has ${size}.`)
        const point = this.#nodes.get(node)
        if (point === undefined)
          this.#text.refuse(`element ${shown(name)} names node ${shown(node)}, which is not defined.`)
        nodes.push(point)
      }
      if (cell !== 'hexahedron') this.#builder.otherCell(cell)
      else if (size === 8) this.#cells.set(name, this.#builder.hexahedron(nodes, name))
      else this.#builder.quadraticCell(nodes.slice(0, 8), nodes.slice(8))
    }
  }

  #group(): void {
    const group = this.#next()
    if (group === null) return
    // Its name may stand behind a parameter: NOM = inside.
    let name = group
    if (/^NOM/i.test(group)) {
      const rest = group.includes('=') ? group.slice(group.indexOf('=') + 1) : (this.#next() ?? '')
      name = (rest === '' || rest === '=' ? this.#next() : rest) ?? ''
    }
    for (let element = this.#next(); element !== null; element = this.#next()) {
      const cell = this.#cells.get(element)
      if (cell !== undefined) this.#builder.inBlock(name, cell)
    }
  }
}
