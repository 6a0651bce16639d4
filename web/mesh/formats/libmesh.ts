/**
 * The output of libMesh for an element (`Elem::print_info`): "Elem Information", the type, and a
 * line for each node. The fields are as wide as `setw` makes them, so a bracket may or may not be
 * followed by blanks. Nodes are in VTK's order, corners first.
 */
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { printedDigits } from '../precision'
import { headText } from '../snippet-text'
import { Tokens } from '../snippets/tokens'
import type { MeshFormat } from '../source'
import { TextCursor } from '../text-cursor'

const MARK = 'Elem Information'
const NODE_LINE = /Node id\(\)=(\d{1,15}|\S{1,30}).{0,200}?Point=\(x,y,z\)=\(/
const LONGEST_LINE = 2000

const OTHER: readonly (readonly [RegExp, OtherCell])[] = [
  [/^HEX$/, 'other'],
  [/^TET/, 'tetrahedron'],
  [/^PRISM/, 'wedge'],
  [/^PYRAMID/, 'pyramid'],
  [/^QUAD/, 'quadrilateral'],
  [/^TRI/, 'triangle'],
  [/^EDGE/, 'line'],
]

interface Element {
  id: number | null
  type: string
  readonly points: number[][]
  nodes: number
}

export const libMesh: MeshFormat = {
  name: 'libMesh',
  recognizes: head => {
    const text = headText(head)
    return text.includes(MARK) && text.includes('type()=') ? 'yes' : 'no'
  },
  read(file, { throwIfCancelled }) {
    const builder = new MeshBuilder('libMesh', file.name)
    const cursor = new TextCursor(file)
    let element: Element | null = null
    let digits = 0
    let cut = 0
    const end = () => {
      if (element !== null && !added(element, builder)) cut++
      element = null
    }
    for (let line = cursor.nextLine(); line !== null; line = cursor.nextLine()) {
      if (cursor.line % 65_536 === 0) throwIfCancelled()
      if (line.length > LONGEST_LINE) continue
      if (line.includes(MARK)) {
        end()
        element = { id: null, type: '', points: [], nodes: 0 }
        continue
      }
      if (element === null) continue
      const own: Element = element
      const node = NODE_LINE.exec(line)
      if (node !== null) {
        const tokens = new Tokens(line, node.index + node[0].length)
        const point: number[] = []
        for (let kind = tokens.next(); kind === 'number' || tokens.word === ','; kind = tokens.next()) {
          if (kind !== 'number') continue
          point.push(tokens.value)
          digits = Math.max(digits, tokens.digits)
        }
        if (point.length !== 3) cursor.refuse('a node has three coordinates in brackets.')
        own.points.push(point)
        continue
      }
      const id = /^\W{0,40}id\(\)=(\d{1,15})/.exec(line)?.[1]
      if (id !== undefined && own.points.length === 0) own.id = Number(id)
      own.type ||= /\btype\(\)=(\w{1,20})/.exec(line)?.[1] ?? ''
      const count = /\bn_nodes\(\)=(\d{1,3})\b/.exec(line)?.[1]
      if (count !== undefined) own.nodes = Number(count)
    }
    end()
    if (cut > 0) {
      builder.isCutOff = true
      builder.note('The text leaves something out: the elements that are whole have been read.')
    }
    const mesh = builder.mesh()
    const note = printedDigits(digits, mesh.points).note()
    return [note === null ? mesh : { ...mesh, notes: [...mesh.notes, note] }]
  },
}

/** True if the element has all its nodes. */
function added({ id, type, points, nodes }: Element, builder: MeshBuilder): boolean {
  const count = Number(/\d+$/.exec(type)?.[0] ?? nodes)
  if (type.startsWith('HEX') || (type === '' && nodes === 8)) {
    if (points.length < Math.max(count, 8)) return false
    if (points.length > Math.max(count, 8))
      builder.refuse(`element ${id ?? builder.cellCount} of ${count} nodes has ${points.length} points.`)
    const first = builder.pointCount
    for (const [x, y, z] of points) builder.point(x as number, y as number, z as number)
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(v => first + v)
    if (count === 8) builder.hexahedron(corners, id)
    else builder.notTrilinear(corners)
    return true
  }
  builder.otherCell(OTHER.find(([pattern]) => pattern.test(type))?.[1] ?? 'other')
  return true
}
