/** Kratos (.mdpa): blocks from "Begin" to "End". Nodes have an id and three coordinates; elements an id, a property and their nodes. */
import { IdIndex } from '../id-index'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import { type MeshFormat, progressOf } from '../source'
import { shown, significantDigits, TextCursor } from '../text-cursor'

/** Kinds by the number of nodes in three dimensions, if the name says no more. */
const BY_NODES: Readonly<Record<number, OtherCell>> = {
  4: 'tetrahedron',
  5: 'pyramid',
  6: 'wedge',
  10: 'tetrahedron',
  13: 'pyramid',
  15: 'wedge',
}
const ID = /^\d{1,15}$/

interface Element {
  readonly id: number
  readonly nodes: readonly number[]
  readonly name: string
}

export const kratos: MeshFormat = {
  name: 'Kratos',
  recognizes: head =>
    /^[ \t]*Begin[ \t]+(?:ModelPartData|Properties|Nodes|Elements|Table|Geometries)\b/m.test(headText(head))
      ? 'yes'
      : 'no',
  read(file, options) {
    const builder = new MeshBuilder('Kratos', file.name)
    const cursor = new TextCursor(file)
    const onLine = progressOf(file, options)
    const elements: Element[] = []
    /** The cells of a file without elements; beside these they are the same ones again. */
    const geometries: Element[] = []
    let block = ''
    let name = ''
    let depth = 0
    /** Parts of the model that are open, one inside of another; elements are listed in the last. */
    const parts: string[] = []
    const elementsOfParts: { readonly part: string; readonly id: number }[] = []
    let isPartElements = false
    let from = cursor.position
    for (let line = cursor.nextLine(); line !== null; line = cursor.nextLine()) {
      const lineFrom = from
      from = cursor.position
      onLine(from)
      const words = line.split('//')[0]?.trim().split(/\s+/) ?? []
      const [first = ''] = words
      if (first === '') continue
      if (first === 'Begin') {
        const [, kind = '', own = ''] = words
        if (depth++ === 0) [block, name] = [kind, own]
        if (kind === 'SubModelPart') parts.push(own)
        isPartElements = kind === 'SubModelPartElements' || kind === 'SubModelPartGeometries'
      } else if (first === 'End') {
        if (--depth < 0) cursor.refuse('“End” stands here without “Begin”.')
        if (depth === 0) block = ''
        if (words[1] === 'SubModelPart') parts.pop()
        isPartElements = false
      } else if (isPartElements && parts.length > 0) {
        for (const word of words)
          if (ID.test(word)) elementsOfParts.push({ part: parts.at(-1) as string, id: Number(word) })
      } else if (depth === 1 && block === 'Nodes') {
        const [id, x, y, z] = words.map(Number)
        if (words.length < 4 || !ID.test(first)) cursor.refuse('a node has an id and three coordinates.')
        if ([x, y, z].some(value => Number.isNaN(value))) cursor.refuse(`the coordinates of node ${id} are no numbers.`)
        let at = line.indexOf(first) + first.length
        for (const word of words.slice(1, 4)) {
          at = line.indexOf(word, at)
          builder.coordinateToken(lineFrom + at, word.length)
          builder.digits.see(Number(word), significantDigits(word))
          at += word.length
        }
        builder.pointWithId(id as number, x as number, y as number, z as number)
      } else if (depth === 1 && (block === 'Elements' || block === 'Geometries')) {
        if (!words.every(word => ID.test(word)))
          cursor.refuse(`${shown(words.find(word => !ID.test(word)) ?? '')} is no number of a node.`)
        const nodes = words.slice(block === 'Elements' ? 2 : 1).map(Number)
        const said = Number(/(\d+)N$/.exec(name)?.[1] ?? nodes.length)
        if (nodes.length !== said) cursor.refuse(`element ${first} of type ${shown(name)} has ${nodes.length} nodes.`)
        ;(block === 'Elements' ? elements : geometries).push({ id: Number(first), nodes, name })
      }
    }
    if (depth > 0) cursor.refuse(`the file ends in the block ${shown(block)}, where “End” was expected.`)
    const cellOfId = new IdIndex()
    for (const { id, nodes, name: type } of elements.length > 0 ? elements : geometries) {
      const before = builder.cellCount
      addElement(builder, id, nodes, type)
      if (builder.cellCount > before && cellOfId.get(id) < 0) cellOfId.set(id, before)
    }
    for (const { part, id } of elementsOfParts) {
      const cell = cellOfId.get(id)
      if (cell >= 0) builder.inBlock(part, cell)
    }
    return [builder.mesh()]
  },
}

function addElement(builder: MeshBuilder, id: number, nodes: readonly number[], type: string): void {
  const isSolid = !/2D/.test(type)
  const indices = nodes.map(node => builder.indexOfId(node, `element ${id}`))
  if (isSolid && nodes.length === 8) builder.inBlock(type, builder.hexahedron(indices, id))
  else if (isSolid && (nodes.length === 20 || nodes.length === 27)) builder.notTrilinear(indices.slice(0, 8))
  else if (isSolid && !/shell|membrane|quad|3D4S/i.test(type)) builder.otherCell(BY_NODES[nodes.length] ?? 'other')
  else
    builder.otherCell(
      nodes.length === 3 || nodes.length === 6 ? 'triangle' : nodes.length === 2 ? 'line' : 'quadrilateral',
    )
}
