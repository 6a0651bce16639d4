/**
 * AVS UCD (.inp): counts, nodes, then a line for each cell: id, material, type, nodes. Programs write hexahedra in two orders that are each
 * other's mirror image, bottom first or, as AVS has it, top first; deal.II takes either. So the sign of most cells decides, and is said.
 */
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import { type MeshFormat, progressOf } from '../source'
import { shown, TextCursor } from '../text-cursor'
import { wordTable } from '../word-table'

const TYPES: Readonly<Record<string, readonly [OtherCell | 'hexahedron', number]>> = wordTable({
  pt: ['vertex', 1],
  line: ['line', 2],
  tri: ['triangle', 3],
  quad: ['quadrilateral', 4],
  tet: ['tetrahedron', 4],
  pyr: ['pyramid', 5],
  prism: ['wedge', 6],
  hex: ['hexahedron', 8],
})
const HEADER = /^(?:[ \t]*#[^\n]{0,1000}\n|[ \t]*\r?\n){0,100}[ \t]*\d{1,12}(?:[ \t]+\d{1,12}){4}[ \t]*\r?\n/
const CELL = /^[ \t]*\d{1,12}[ \t]+-?\d{1,12}[ \t]+(?:pt|line|tri|quad|tet|pyr|prism|hex)[ \t]+\d/m
const TOP_FIRST = [4, 5, 6, 7, 0, 1, 2, 3]

export const ucd: MeshFormat = {
  name: 'UCD',
  recognizes(head, name) {
    const text = headText(head)
    if (!HEADER.test(text)) return 'no'
    if (CELL.test(text)) return 'yes'
    return /\.(?:inp|ucd|avs)$/.test(name) && /^[ \t]*\d+(?:[ \t]+[-+.\deE]+){3}[ \t]*$/m.test(text.slice(0, 5000))
      ? 'yes'
      : 'no'
  },
  read(file, options) {
    const builder = new MeshBuilder('UCD', file.name)
    const cursor = new TextCursor(file)
    const onRecord = progressOf(file, options)
    skipComments(cursor)
    const nodes = cursor.count('the number of nodes')
    const cells = cursor.count('the number of cells')
    cursor.skipLine()
    for (let i = 0; i < nodes; i++) {
      builder.pointWithId(cursor.count('the number of a node'), ...builder.readPoint(cursor))
      onRecord(cursor.position)
    }
    const hexahedra: { readonly id: number; readonly nodes: readonly number[] }[] = []
    for (let i = 0; i < cells; i++) {
      const id = cursor.count('the number of a cell')
      const material = cursor.word()
      if (material === '') cursor.refuse(`the file ends at cell ${i} of ${cells}.`)
      const word = cursor.word()
      const [type, count] = TYPES[word.toLowerCase()] ?? cursor.refuse(`${shown(word)} is no type of a UCD cell.`)
      const indices = Array.from({ length: count }, () =>
        builder.indexOfId(cursor.count('the number of a node'), `cell ${id}`),
      )
      if (type === 'hexahedron') hexahedra.push({ id, nodes: indices })
      else builder.otherCell(type)
      onRecord(cursor.position)
    }
    const points = builder.mesh().points
    const mirrored = hexahedra.filter(cell => orientation(points, cell.nodes) < 0).length
    const isTopFirst = mirrored > hexahedra.length - mirrored
    for (const cell of hexahedra)
      builder.hexahedron(isTopFirst ? TOP_FIRST.map(v => cell.nodes[v] as number) : cell.nodes, cell.id)
    if (hexahedra.length > 0) {
      const order = isTopFirst ? 'top first, as AVS has them' : 'bottom first'
      builder.note(
        `Hexahedra of UCD files are written in two orders, mirror images of each other; these were read ${order}, which makes most of them upright.`,
      )
    }
    return [builder.mesh()]
  },
}

function skipComments(cursor: TextCursor): void {
  for (cursor.skipBlanks(); cursor.peek() === 35; cursor.skipBlanks()) cursor.skipLine()
}

/** The sign of the cell's volume, as far as its diagonals tell it. */
function orientation(points: Float64Array, nodes: readonly number[]): number {
  const at = (v: number, axis: number) => points[3 * (nodes[v] as number) + axis] as number
  const across = (from: readonly number[], to: readonly number[]) =>
    [0, 1, 2].map(axis => to.reduce((sum, v) => sum + at(v, axis), 0) - from.reduce((sum, v) => sum + at(v, axis), 0))
  const [a, b, c] = [
    across([0, 3, 4, 7], [1, 2, 5, 6]),
    across([0, 1, 4, 5], [3, 2, 7, 6]),
    across([0, 1, 2, 3], [4, 5, 6, 7]),
  ] as [number[], number[], number[]]
  const [a0 = 0, a1 = 0, a2 = 0] = a
  const [b0 = 0, b1 = 0, b2 = 0] = b
  const [c0 = 0, c1 = 0, c2 = 0] = c
  return Math.sign(a0 * (b1 * c2 - b2 * c1) - a1 * (b0 * c2 - b2 * c0) + a2 * (b0 * c1 - b1 * c0))
}
