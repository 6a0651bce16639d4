/**
 * Radioss starter files (.rad): /NODE has an id in ten columns and coordinates in twenty each, /BRICK/part an id and eight nodes in ten columns
 * each, /PART/part its name on the next line. A wedge is a brick whose upper edges are points: nodes 5 and 8, 6 and 7 are the same.
 */
import { RowPattern } from '../../core/reading-interface'
import type { OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import { fileOfBytes, type MeshFile, type MeshFormat, type ReadOptions } from '../source'
import { numberOf, shown, significantDigits, withoutControls } from '../text-cursor'
import { isRepeating } from './node-model'
import { RowText } from './row-text'

const FIRST = /^([ \t]*)(?:#RADIOSS STARTER|\/BEGIN\b)/m
const HEAD = 65_536
const [LF, SPACE] = [10, 32] as const
const NODE_ROW = new RowPattern(['whole10', 'real20', 'real20', 'real20', 'end'])
const BRICK_ROW = new RowPattern([...Array.from({ length: 9 }, () => 'whole10'), 'end'])
const [ID_WIDTH, COORDINATE_WIDTH] = [10, 20] as const
const OTHER: readonly (readonly [RegExp, OtherCell])[] = [
  [/^TETRA/, 'tetrahedron'],
  [/^PENTA/, 'wedge'],
  [/^(?:SHELL|QUAD)$/, 'quadrilateral'],
  [/^(?:SH3N|TRIA)$/, 'triangle'],
  [/^(?:BEAM|TRUSS|SPRING)$/, 'line'],
]
/** Corners and middles of a brick of 20 nodes, on three lines: eight, then as many as there is room for. */
const NODES_OF_BRIC20 = 20
const isKeyword = (line: string) => /^(?:\/|#include\b)/.test(line)

export const radioss: MeshFormat = {
  name: 'Radioss',
  recognizes: head => (FIRST.test(headText(head)) ? 'yes' : 'no'),
  read(file, options) {
    const [, { length: indent } = ''] = FIRST.exec(headText(file.read(0, Math.min(HEAD, file.size)))) ?? []
    if (indent === 0) return [new RadiossReader(file, options).read()]
    return [{ ...new RadiossReader(withoutIndent(file, indent), options).read(), coordinatePlaces: null }]
  },
}

/** The columns begin behind what all lines are indented by, as they are in a quotation. */
function withoutIndent(file: MeshFile, indent: number): MeshFile {
  const bytes = file.read(0, file.size)
  let length = 0
  for (let from = 0; from < bytes.length; ) {
    const to = 1 + bytes.indexOf(LF, from) || bytes.length
    let begin = from
    while (begin < from + indent && bytes[begin] === SPACE) begin++
    bytes.copyWithin(length, begin, to)
    length += to - begin
    from = to
  }
  return fileOfBytes(file.name, bytes.subarray(0, length))
}

class RadiossReader {
  readonly #text: RowText
  readonly #parts = new Map<string, string>()
  #degenerate = 0

  constructor(file: MeshFile, options: ReadOptions) {
    this.#text = new RowText('Radioss', file, options, /^(?:#(?!include\b)|\$)/)
  }

  read() {
    const text = this.#text
    const { builder, cursor } = text
    for (let line = text.line(); line !== null; line = text.line()) {
      if (!isKeyword(line)) text.refuse(`${shown(line.trim().slice(0, 40))} stands where a keyword was expected.`)
      const included = /^#include\s+(\S+)/.exec(line)?.[1]
      if (included !== undefined) text.refuse(`it includes ${shown(included)}, which is not read: put it in its place.`)
      const [, name = '', part = ''] = line.trim().toUpperCase().split('/')
      if (name === 'END') break
      cursor.skipLine()
      if (name === 'NODE') this.#nodes()
      else if (name === 'PART') this.#parts.set(part, withoutControls(text.line() ?? '').trim())
      else if (name === 'BRICK' || name === 'BRIC20') text.later(() => this.#bricks(name === 'BRIC20', part))
      else if (name === 'TRANSFORM')
        text.refuse('/TRANSFORM is not read here: write the nodes where they are in the end.')
      else this.#others(name)
      text.pass(isKeyword)
    }
    if (builder.pointCount === 0) text.refuse('the nodes were expected, behind /NODE; there are none.')
    text.readLater()
    if (this.#degenerate > 0)
      builder.note(`${this.#degenerate} bricks repeat nodes: as hexahedra they have J <= 0 somewhere.`)
    return builder.mesh()
  }

  #nodes(): void {
    const text = this.#text
    const { builder, cursor } = text
    text.lines(
      isKeyword,
      () => {
        const from = cursor.position
        const line = cursor.nextLine() ?? ''
        const id = this.#whole(line, 0, 'the number of a node')
        const [x = 0, y = 0, z = 0] = [0, 1, 2].map(axis => {
          const at = ID_WIDTH + axis * COORDINATE_WIDTH
          const field = line.slice(at, at + COORDINATE_WIDTH)
          const value =
            numberOf(field.trim()) ?? cursor.refuse(`${shown(field.trim())} is not a coordinate.`, cursor.line - 1)
          builder.coordinateToken(from + at + field.search(/\S/), field.trim().length)
          builder.digits.see(value, significantDigits(field.trim()))
          return value
        })
        builder.pointWithId(id, x, y, z)
      },
      () => {
        const rows = text.rowsOf(NODE_ROW)
        if (rows !== null) builder.pointRows(rows, true)
        return rows !== null
      },
    )
  }

  #whole(line: string, field: number, what: string): number {
    const word = fieldOf(line, field)
    if (!/^\d+$/.test(word)) this.#text.cursor.refuse(`${shown(word)} is not ${what}.`, this.#text.cursor.line - 1)
    return Number(word)
  }

  #bricks(isQuadratic: boolean, part: string): void {
    const text = this.#text
    const { cursor, builder } = text
    const name = this.#parts.get(part) || `part ${part}`
    const put = (cell: number) => builder.inBlock(name, cell)
    text.lines(
      isKeyword,
      () => {
        const line = cursor.nextLine() ?? ''
        const id = this.#whole(line, 0, 'the number of an element')
        const nodes = Array.from({ length: 8 }, (_, v) =>
          v >= 4 && fieldOf(line, v + 1) === '' ? 0 : this.#whole(line, v + 1, 'the number of a node'),
        )
        while (isQuadratic && nodes.length < NODES_OF_BRIC20) {
          const more = (cursor.nextLine() ?? '').trimEnd()
          const count = Math.min(Math.max(1, Math.ceil(more.length / ID_WIDTH)), NODES_OF_BRIC20 - nodes.length)
          for (let field = 0; field < count; ++field) nodes.push(this.#whole(more, field, 'the number of a node'))
        }
        if (isQuadratic || !this.#isOther(nodes)) text.hexahedron(id, nodes, put)
      },
      () => {
        const rows = isQuadratic ? null : text.rowsOf(BRICK_ROW)
        return text.hexahedronRows(rows, 0, 1, put, { isOther: nodes => this.#isOther(nodes) })
      },
    )
  }

  #isOther(nodes: ArrayLike<number>): boolean {
    if (!isRepeating(nodes)) return false
    // Nodes 5 to 8 of a tetrahedron are 0, or blank.
    if ([4, 5, 6, 7].every(v => nodes[v] === 0)) {
      this.#text.builder.otherCell('tetrahedron')
      return true
    }
    const isWedge = nodes[4] === nodes[7] && nodes[5] === nodes[6] && new Set(Array.from(nodes)).size === 6
    if (isWedge) this.#text.builder.otherCell('wedge')
    else this.#degenerate++
    return isWedge
  }

  #others(name: string): void {
    const cell = OTHER.find(([pattern]) => pattern.test(name))?.[1] ?? (name === 'SHEL16' ? 'other' : null)
    if (cell === null) return
    this.#text.lines(
      isKeyword,
      () => {
        this.#text.cursor.skipLine()
        if (name === 'TETRA10' || name === 'SHEL16') this.#text.cursor.skipLine()
        this.#text.builder.otherCell(cell)
      },
      () => false,
    )
  }
}

function fieldOf(line: string, field: number): string {
  return line.slice(ID_WIDTH * field, ID_WIDTH * (field + 1)).trim()
}
