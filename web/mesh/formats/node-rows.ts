/** Cells of one type as a table of nodes: a row for each cell, all of the same length, in VTK's order or another. */
import type { MeshBuilder, OtherCell } from '../mesh-builder'
import { shown } from '../shown'

export interface RowType {
  /** 'curved' has eight corners first, and further nodes. */
  readonly kind: 'hexahedron' | 'curved' | OtherCell
  readonly nodes: number
}

export interface NodeRows {
  readonly type: RowType
  readonly nodes: Uint32Array
  /** Places of a cell's eight corners in its row; that of VTK if not given. */
  readonly order?: readonly number[]
  /** True if the first nodes of all cells come first, then the second ones, and so on. */
  readonly isByNode?: boolean
  /** The number of the first point in the file, its index here, and how many there are. */
  readonly firstNode: number
  readonly firstPoint: number
  readonly points: number
  /** Ids of the cells; null if they have none. */
  readonly ids: ArrayLike<number> | null
  /** The name of the table, for sentences. */
  readonly place: string
}

const VTK_ORDER = [0, 1, 2, 3, 4, 5, 6, 7] as const

/** Adds the cells; a node that is not there is refused. Returns how many hexahedra were there before. */
export function addRows(builder: MeshBuilder, rows: NodeRows): number {
  const { nodes, order = VTK_ORDER, isByNode = false, firstNode, firstPoint, points, ids, place } = rows
  const { kind, nodes: width } = rows.type
  const before = builder.cellCount
  if (nodes.length % width !== 0)
    builder.refuse(`${shown(place)} has ${nodes.length} numbers; a multiple of ${width} was expected.`)
  const count = nodes.length / width
  if (ids !== null && ids.length !== count)
    builder.refuse(`${shown(place)} has ${count} cells, and there are ids of ${ids.length}.`)
  for (let i = 0; i < nodes.length; ++i) {
    const node = nodes[i] as number
    if (node >= firstNode && node - firstNode < points) continue
    const cell = isByNode ? i % count : Math.floor(i / width)
    builder.refuse(
      `cell ${ids?.[cell] ?? cell} of ${shown(place)} names node ${node}; the nodes are ${firstNode} to ${firstNode + points - 1}.`,
    )
  }
  if (kind !== 'hexahedron' && kind !== 'curved') {
    builder.otherCell(kind, count)
    return before
  }
  if (kind === 'hexahedron') builder.reserve(0, before + count - builder.cellCount)
  const corners = [0, 0, 0, 0, 0, 0, 0, 0]
  const [cellStep, nodeStep] = isByNode ? [1, count] : [width, 1]
  const shift = firstPoint - firstNode
  for (let cell = 0; cell < count; ++cell) {
    const from = cell * cellStep
    for (let v = 0; v < 8; ++v) corners[v] = (nodes[from + (order[v] as number) * nodeStep] as number) + shift
    if (kind === 'hexahedron') builder.hexahedron(corners, ids === null ? null : (ids[cell] as number))
    else {
      const others = Array.from({ length: width - 8 }, (_, i) => (nodes[from + (8 + i) * nodeStep] as number) + shift)
      builder.quadraticCell(corners, others)
    }
  }
  return before
}

/** Ids that count up. */
export function countedFrom(first: number, count: number): Float64Array {
  const ids = new Float64Array(count)
  for (let i = 0; i < count; ++i) ids[i] = first + i
  return ids
}
