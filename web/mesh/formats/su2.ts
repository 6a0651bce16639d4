/**
 * SU2: NDIME, NELEM with a line for each element (VTK's type, points from 0 on, perhaps its number), NPOIN with a line for each point (its
 * coordinates, perhaps its number), markers of the boundary. Cells have VTK's order.
 */
import type { OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { RowText } from './row-text'

const TYPES: ReadonlyMap<number, OtherCell | 'hexahedron'> = new Map([
  [1, 'vertex'],
  [3, 'line'],
  [5, 'triangle'],
  [9, 'quadrilateral'],
  [10, 'tetrahedron'],
  [12, 'hexahedron'],
  [13, 'wedge'],
  [14, 'pyramid'],
])
const COUNTS = new Set(['NDIME', 'NZONE', 'NELEM', 'NPOIN', 'MARKER_ELEMS'])
const isKeyword = (line: string) => /^\s*[A-Z]\w*\s*=/i.test(line)

export const su2: MeshFormat = {
  name: 'SU2',
  recognizes: head => (/^[ \t]*NDIME\s{0,9}=\s{0,9}\d/m.test(headText(head)) ? 'yes' : 'no'),
  read(file, options) {
    return [new Su2Reader(file, options).read()]
  },
}

class Su2Reader {
  readonly #text: RowText

  constructor(file: MeshFile, options: ReadOptions) {
    this.#text = new RowText('SU2', file, options, /^\s*%/)
  }

  read() {
    const text = this.#text
    for (let line = text.line(); line !== null; line = text.line()) {
      const [, word = '', rest = ''] = /^\s*(\w+)\s*=\s*([^%]*)/.exec(line) ?? []
      const name = word.toUpperCase()
      if (name === '') text.refuse(`${shown(line.trim())} stands where a keyword was expected, as NELEM= or NPOIN=.`)
      const count = Number(rest.trim().split(/\s+/)[0])
      if (COUNTS.has(name) && !(Number.isSafeInteger(count) && count >= 0))
        text.refuse(`${shown(rest.trim())} is no number behind ${name}=.`)
      if (name === 'NDIME' && count !== 3) text.refuse(`a mesh of ${count} dimensions has no hexahedra.`)
      if (name === 'NZONE' && count > 1)
        text.refuse(`the file has ${count} zones; one alone is read: save each as a file.`)
      text.cursor.skipLine()
      if (name === 'NPOIN') this.#points(count)
      else if (name === 'NELEM' || name === 'MARKER_ELEMS') {
        const isMarker = name !== 'NELEM'
        // The neighbour of a part, between the count and the elements.
        if (isMarker && /^\s*SEND_TO/i.test(text.line() ?? '')) text.cursor.skipLine()
        text.later(() => this.#elements(count, isMarker))
        text.pass(isKeyword)
      } else text.pass(isKeyword)
    }
    if (text.builder.pointCount === 0) text.refuse('the points were expected, behind NPOIN=; there are none.')
    text.builder.numberPoints(0)
    text.readLater()
    return text.builder.mesh()
  }

  #points(count: number): void {
    const { builder, cursor } = this.#text
    if (builder.pointCount > 0) this.#text.refuse('the points are there twice.')
    this.#text.lines(
      isKeyword,
      () => {
        builder.point(...builder.readPoint(cursor))
        cursor.skipLine()
      },
      line => {
        const kinds = line.trim().split(/\s+/).length > 3 ? 'rrrw' : 'rrr'
        const rows = this.#text.rows(kinds)
        if (rows !== null) builder.pointRows(rows, false, 0)
        return rows !== null
      },
    )
    if (builder.pointCount !== count)
      this.#text.refuse(`${count} points are declared, and ${builder.pointCount} are there.`)
  }

  /** Elements are counted from 0; those of the boundary are no cells of the mesh and have no numbers. */
  #elements(count: number, isMarker: boolean): void {
    const text = this.#text
    const { builder, cursor } = text
    let seen = 0
    text.lines(
      isKeyword,
      () => {
        const type = cursor.count('the type of an element')
        const cell = TYPES.get(type) ?? text.refuse(`${type} is no type of an element of SU2.`)
        if (cell === 'hexahedron') {
          const nodes = text.numbers('the number of a point')
          if (nodes.length !== 8 && nodes.length !== 9)
            text.refuse(`a hexahedron has 8 points and perhaps its number, not ${nodes.length} numbers.`)
          text.hexahedron(seen, nodes.slice(0, 8), () => {})
        } else builder.otherCell(cell)
        seen++
        cursor.skipLine()
      },
      line => {
        if (isMarker || !/^\s*12\s/.test(line)) return false
        const [before = ''] = /^\s*12/.exec(line) ?? []
        const kinds = line.trim().split(/\s+/).length > 9 ? 'wwwwwwwww' : 'wwwwwwww'
        const rows = text.rows(kinds, { before })
        const first = seen
        if (rows === null) return false
        text.hexahedronRows(
          rows,
          row => first + row,
          0,
          () => {},
        )
        seen += rows.count
        return true
      },
    )
    if (seen !== count) text.refuse(`${count} elements are declared, and ${seen} are there.`)
  }
}
