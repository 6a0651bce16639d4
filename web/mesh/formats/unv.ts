/**
 * I-DEAS universal files (.unv): datasets between lines of -1. 2411 and 781 have nodes, 2412 and 780 elements: a record of label and
 * descriptor, for beams one more, then the nodes; 115 is the linear brick in VTK's order, 116 that of 20 nodes, whose corners and middles
 * of each layer go around together.
 */
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFormat } from '../source'
import { TextCursor } from '../text-cursor'

const NODES = new Set([2411, 781])
const ELEMENTS = new Set([2412, 780])
const BRICK = 115
const BRICK_20 = 116
/** Corners of the brick of 20 nodes among its nodes: bottom around, four uprights, top around. */
const CORNERS_20 = [0, 2, 4, 6, 12, 14, 16, 18]
const BEAMS = new Set([11, 21, 22, 23, 24])

const OTHER: readonly (readonly [OtherCell, readonly number[]])[] = [
  ['line', [11, 21, 22, 23, 24, 121, 122]],
  ['triangle', [41, 42, 51, 52, 61, 62, 63, 71, 72, 74, 81, 82, 91, 92]],
  ['quadrilateral', [44, 45, 54, 55, 64, 65, 84, 85, 94, 95]],
  ['tetrahedron', [111, 118]],
  ['wedge', [112, 113]],
  ['pyramid', [312, 313]],
]

export const unv: MeshFormat = {
  name: 'UNV',
  recognizes: head =>
    /^(?:[ \t]*\r?\n){0,5} {0,10}-1[ \t]*\r?\n[ \t]{0,10}\d{2,5}[bB]?[ \t]*\r?\n/.test(headText(head, 4096))
      ? 'yes'
      : 'no',
  read(file, { onProgress, throwIfCancelled }) {
    const builder = new MeshBuilder('UNV', file.name)
    const cursor = new TextCursor(file)
    const elements: { readonly id: number; readonly nodes: readonly number[]; readonly isLinear: boolean }[] = []
    for (let word = cursor.word(); word !== ''; word = cursor.word()) {
      if (word !== '-1') cursor.refuse('a dataset begins with a line of -1.')
      const set = cursor.count('the number of a dataset')
      cursor.skipLine()
      throwIfCancelled()
      onProgress(cursor.position / file.size)
      if (NODES.has(set)) readNodes(cursor, builder)
      else if (ELEMENTS.has(set)) readElements(cursor, builder, elements, set === 780)
      else skipSet(cursor)
    }
    if (builder.pointCount === 0) cursor.refuse('nodes were expected, in dataset 2411; there are none.')
    for (const { id, nodes, isLinear } of elements) {
      const indices = nodes.map(node => builder.indexOfId(node, `element ${id}`))
      if (isLinear) builder.hexahedron(indices, id)
      else builder.notTrilinear(indices)
    }
    return [builder.mesh()]
  },
}

/** True if the dataset ends here; its end is passed. */
function isAtEndOfSet(cursor: TextCursor): boolean {
  cursor.skipBlanks()
  if (cursor.isAtEnd) cursor.refuse('the file ends in the middle of a dataset, where -1 was expected.')
  if (cursor.peek() !== 45) return false
  const line = cursor.nextLine()?.trim()
  if (line !== '-1') cursor.refuse('a dataset ends with a line of -1.')
  return true
}

function readNodes(cursor: TextCursor, builder: MeshBuilder): void {
  while (!isAtEndOfSet(cursor)) {
    const id = cursor.count('the number of a node')
    cursor.skipLine()
    builder.pointWithId(id, ...builder.readPoint(cursor))
    cursor.skipLine()
  }
}

function readElements(
  cursor: TextCursor,
  builder: MeshBuilder,
  elements: { readonly id: number; readonly nodes: readonly number[]; readonly isLinear: boolean }[],
  isOld: boolean,
): void {
  while (!isAtEndOfSet(cursor)) {
    const id = cursor.count('the number of an element')
    const type = cursor.count('the descriptor of an element')
    // Property and material (two of each in the old dataset), colour, then the number of nodes.
    for (let i = 0; i < (isOld ? 5 : 3); i++) cursor.number('an integer')
    const count = cursor.count('the number of nodes')
    if (count > 10_000) cursor.refuse(`${count} nodes are more than an element has.`)
    cursor.skipLine()
    if (BEAMS.has(type)) cursor.skipLine()
    const nodes = Array.from({ length: count }, () => cursor.count('the number of a node'))
    if (type === BRICK) {
      // Gmsh gives bricks of second order the same number.
      if (![8, 20, 27].includes(count)) cursor.refuse(`element ${id} is a linear brick and has ${count} nodes.`)
      elements.push({ id, nodes: nodes.slice(0, 8), isLinear: count === 8 })
    } else if (type === BRICK_20) {
      if (count !== 20) cursor.refuse(`element ${id} is a parabolic brick and has ${count} nodes.`)
      elements.push({ id, nodes: CORNERS_20.map(v => nodes[v] as number), isLinear: false })
    } else builder.otherCell(OTHER.find(([, types]) => types.includes(type))?.[0] ?? 'other')
  }
}

function skipSet(cursor: TextCursor): void {
  for (;;) {
    if (cursor.isAtEnd) cursor.refuse('the file ends in the middle of a dataset, where -1 was expected.')
    cursor.skipBlanks()
    if (cursor.peek() === 45) {
      if (cursor.nextLine()?.trim() === '-1') return
    } else cursor.skipLine()
  }
}
