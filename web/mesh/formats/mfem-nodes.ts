/** The spaces of MFEM's nodes: which of a grid function's numbers are the corners of a hexahedron. */
import type { Refusing } from '../mesh'
import type { OtherCell } from '../mesh-builder'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'

export interface NodeSpace {
  readonly name: string
  readonly order: number
  /** True if elements share nodes, the first of which are the vertices'; else each has its own. */
  readonly isContinuous: boolean
  /** All x, then all y, then all z; else the three of a node together. */
  readonly isByNode: boolean
  /** Indices of the corners among a hexahedron's own nodes, in VTK_HEXAHEDRON order. */
  readonly corners: readonly number[]
  /** The number of an element's own nodes. */
  nodesOf(kind: OtherCell | 'hexahedron'): number
}

const NAMED: Readonly<Record<string, number>> = wordTable({ Linear: 1, Quadratic: 2, Cubic: 3 })
const MOST = 32

/** Refuses spaces without nodes at the corners. */
export function nodeSpaceOf(cursor: Refusing, entries: ReadonlyMap<string, string>): NodeSpace {
  const name = entries.get('FiniteElementCollection') ?? ''
  const [, isContinuous, isClosed, power] = /^(?:(H1(?:Pos|Ser)?)|(L2_T1))(?:@[A-Za-z])?_3D_P(\d+)$/.exec(name) ?? []
  const order = NAMED[name] ?? Number(power ?? 0)
  if (order < 1 || order > MOST)
    cursor.refuse(`the nodes are ${shown(name)}; H1_3D_P1 and higher orders, L2_T1_3D_P1 and Linear are read.`)
  if (entries.get('VDim') !== '3')
    cursor.refuse(`the nodes have ${shown(entries.get('VDim') ?? 'no')} coordinates; 3 were expected.`)
  const ordering = entries.get('Ordering')
  if (ordering !== '0' && ordering !== '1')
    cursor.refuse(`an Ordering of 0 or 1 was expected, not ${shown(ordering ?? '')}.`)
  const n = order + 1
  const last = order * (1 + n + n * n)
  return {
    name,
    order,
    isContinuous: isClosed === undefined || isContinuous !== undefined,
    isByNode: ordering === '0',
    corners: [
      0,
      order,
      order + order * n,
      order * n,
      order * n * n,
      order + order * n * n,
      last,
      order * n + order * n * n,
    ],
    nodesOf(kind) {
      if (kind === 'hexahedron') return n ** 3
      if (kind === 'tetrahedron') return (n * (n + 1) * (n + 2)) / 6
      if (kind === 'wedge') return (n * n * (n + 1)) / 2
      if (kind === 'pyramid') return (n * (n + 1) * (2 * n + 1)) / 6
      return cursor.refuse(`an element of the kind ${kind} has no nodes of its own here.`)
    },
  }
}
