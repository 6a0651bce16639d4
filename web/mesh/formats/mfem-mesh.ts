/** The mesh of MFEM's files: vertices, or nodes in their place, and elements with attributes, which become blocks. */
import type { Mesh, Refusing } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { straightHexahedra } from './mfem-middles'
import type { NodeSpace } from './mfem-nodes'

type Kind = OtherCell | 'hexahedron'

export class MfemMesh {
  readonly builder: MeshBuilder
  /** True if vertices have ids: those between others are made last. */
  isNonConforming = false
  /** Null until the section of the vertices begins. */
  vertexCount: number | null = null
  /** True if the text leaves vertices out: elements may then name some that are not there. */
  mayLackVertices = false
  #lackingVertices = 0
  #space: NodeSpace | null = null
  /** Nodes of the elements so far, if each element has its own. */
  #ownNodes = 0
  /** Hexahedra of order 2, which are put into the mesh when all are known. */
  #quadratic: { cells: number[]; nodes: number; at: (node: number, axis: number) => number } | null = null
  /** Names of groups of attributes, by attribute. */
  readonly #sets = new Map<number, string[]>()
  readonly #attributes: number[] = []

  constructor(fileName: string) {
    this.builder = new MeshBuilder('MFEM', fileName)
  }

  /** The numbers of a grid function, which are nodes in the place of the vertices. */
  setNodes(cursor: Refusing, space: NodeSpace, values: readonly number[]): void {
    const vertices = this.vertexCount ?? 0
    const nodes = values.length / 3
    if (!Number.isInteger(nodes))
      cursor.refuse(`the nodes have ${values.length} coordinates, which is no multiple of 3.`)
    const isWrong = space.isContinuous && (space.order === 1 ? nodes !== vertices : nodes < vertices)
    if (isWrong) cursor.refuse(`there are ${nodes} nodes for ${vertices} vertices.`)
    // The first nodes of a continuous space are those of the vertices.
    const wanted = space.isContinuous ? vertices : nodes
    const at = (node: number, axis: number) => values[space.isByNode ? axis * nodes + node : 3 * node + axis] as number
    for (let i = 0; i < wanted; ++i) this.builder.point(at(i, 0), at(i, 1), at(i, 2))
    this.#space = space
    if (space.isContinuous && space.order === 2) this.#quadratic = { cells: [], nodes, at }
    if (space.order > 1)
      this.builder.note(`The nodes are ${space.name}: the elements are of order ${space.order}, not trilinear.`)
  }

  nameAttribute(attribute: number, name: string): void {
    this.#sets.set(attribute, [...(this.#sets.get(attribute) ?? []), name])
  }

  /** An element by its vertices, whose list is used up. */
  element(cursor: Refusing, kind: Kind, attribute: number, vertices: number[]): void {
    const count = this.vertexCount ?? 0
    const there = this.#space?.isContinuous === false ? count : this.builder.pointCount
    for (const [i, vertex] of vertices.entries()) {
      const index = this.isNonConforming ? this.builder.findId(vertex) : vertex < there ? vertex : -1
      if (index < 0) {
        if (this.isNonConforming) cursor.refuse(`an element names vertex ${vertex}, which has no place.`)
        if (!this.mayLackVertices || vertex >= count)
          cursor.refuse(`an element names vertex ${vertex}; the vertices are 0 to ${count - 1}.`)
        this.#lackingVertices++
        return
      }
      vertices[i] = index
    }
    this.#put(kind, attribute, vertices)
  }

  /** An element that has nodes of its own, in lexicographic order; false, and nothing is added, if elements share them. */
  elementByNodes(kind: Kind, attribute: number): boolean {
    const space = this.#space
    if (space === null || space.isContinuous) return false
    const first = this.#ownNodes
    this.#put(kind, attribute, kind === 'hexahedron' ? space.corners.map(corner => first + corner) : [])
    this.#ownNodes += space.nodesOf(kind)
    return true
  }

  /** Refuses elements that have more nodes than there are. */
  checkNodes(cursor: Refusing): void {
    const { pointCount } = this.builder
    if (this.#ownNodes > pointCount)
      cursor.refuse(`the elements have ${this.#ownNodes} nodes; there are ${pointCount}.`)
  }

  #put(kind: Kind, attribute: number, points: readonly number[]): void {
    if (kind !== 'hexahedron') this.builder.otherCell(kind)
    else if (this.#quadratic !== null) for (const point of points) this.#quadratic.cells.push(point)
    else if (this.#space !== null && this.#space.order > 1) this.builder.notTrilinear(points)
    else {
      this.builder.hexahedron(points)
      this.#attributes.push(attribute)
    }
  }

  finished(): Mesh {
    const { builder } = this
    if (this.#quadratic !== null) {
      const { cells, nodes, at } = this.#quadratic
      const straight = straightHexahedra(cells, this.vertexCount ?? 0, nodes, at)
      for (let cell = 0; 8 * cell < cells.length; ++cell)
        builder.notTrilinear(cells.slice(8 * cell, 8 * cell + 8), straight?.[cell] ?? null)
    }
    const first = this.#attributes[0]
    if (this.#sets.size > 0 || this.#attributes.some(attribute => attribute !== first))
      for (const [cell, attribute] of this.#attributes.entries())
        for (const name of this.#sets.get(attribute) ?? [`attribute ${attribute}`]) builder.inBlock(name, cell)
    builder.noteLacking(this.#lackingVertices, 'vertices', 'elements')
    return builder.mesh()
  }
}
