/** The mesh of Medit's files: vertices counted from 1, cells with references, orders of nodes. */
import { vertexReference } from '../../model/hexahedron'
import type { Refusing } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import type { MeditCells } from './medit-keywords'

export class MeditMesh {
  readonly builder: MeshBuilder
  /** True if the text leaves vertices out: cells may then name some that are not there. */
  mayLackVertices = false
  lackingVertices = 0
  readonly #references: number[] = []
  /** The corners and the other nodes of cells, by their number of nodes. */
  readonly #orders = new Map<number, { corners: readonly number[]; others: readonly number[] }>()
  readonly #indices: number[] = []

  constructor(fileName: string) {
    this.builder = new MeshBuilder('Medit', fileName)
  }

  /** The place of each node of a cell in a cube of side 1, 2, ..., as HexahedraQ2Ordering and its kin state it. */
  orderNodes(cursor: Refusing, places: readonly (readonly number[])[]): void {
    const side = Math.max(...places.flat())
    const corners = vertexReference.map(corner =>
      places.findIndex(node => node.every((value, axis) => value === side * (corner[axis] as number))),
    )
    if (corners.includes(-1)) cursor.refuse('the order of the nodes lacks a corner.')
    this.#orders.set(places.length, { corners, others: places.map((_, i) => i).filter(i => !corners.includes(i)) })
  }

  /** A cell by its vertices, which are `vertices[from]` and following, counted from 1. */
  cell(cursor: Refusing, cells: MeditCells, vertices: ArrayLike<number>, from: number, reference: number): void {
    const { kind, nodes, name } = cells
    const count = this.builder.pointCount
    const indices = this.#indices
    indices.length = nodes
    for (let i = 0; i < nodes; ++i) {
      const vertex = vertices[from + i] as number
      if (vertex < 1 || vertex > count) {
        if (!this.mayLackVertices || vertex < 1)
          cursor.refuse(`a cell of ${name} names vertex ${vertex}; the vertices are 1 to ${count}.`)
        this.lackingVertices++
        return
      }
      indices[i] = vertex - 1
    }
    if (kind !== 'hexahedron' && kind !== 'curved') {
      this.builder.otherCell(kind)
      return
    }
    const order = this.#orders.get(nodes)
    const corners = order ? order.corners.map(i => indices[i] as number) : indices.slice(0, 8)
    if (kind === 'hexahedron') {
      this.builder.hexahedron(order ? corners : indices)
      this.#references.push(reference)
      return
    }
    const others = order ? order.others.map(i => indices[i] as number) : indices.slice(8)
    this.builder.quadraticCell(corners, others)
  }

  /** Different references become blocks, and what was noticed becomes notes. */
  finish(): void {
    const { builder } = this
    const first = this.#references[0]
    if (this.#references.some(reference => reference !== first)) {
      const names = new Map<number, string>()
      for (const [cell, reference] of this.#references.entries()) {
        let name = names.get(reference)
        if (name === undefined) {
          name = `reference ${reference}`
          names.set(reference, name)
        }
        builder.inBlock(name, cell)
      }
    }
    builder.noteLacking(this.lackingVertices, 'vertices', 'cells')
  }
}
