/** MFEM's meshes, v1.0 to v1.3, whose vertices may be those of a grid function, and the leaves of non-conforming ones. */
import type { Mesh } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown, type TextCursor } from '../text-cursor'
import { LINE_HEAD, readInTurn, type Start, TextRecords } from '../text-records'
import { straightHexahedra } from './mfem-middles'
import { type NodeSpace, nodeSpaceOf } from './mfem-nodes'
import { placeNonConforming } from './mfem-tree'

/** Geometries by their number in the file. */
const GEOMETRIES: readonly { readonly kind: OtherCell | 'hexahedron'; readonly nodes: number }[] = [
  { kind: 'vertex', nodes: 1 },
  { kind: 'line', nodes: 2 },
  { kind: 'triangle', nodes: 3 },
  { kind: 'quadrilateral', nodes: 4 },
  { kind: 'tetrahedron', nodes: 4 },
  { kind: 'hexahedron', nodes: 8 },
  { kind: 'wedge', nodes: 6 },
  { kind: 'pyramid', nodes: 5 },
]

const HEADER = /^MFEM\b[A-Z -]*\bmesh v\d/
const SECTION =
  /^(?:dimension|elements|boundary|vertices|nodes|attribute_sets|bdr_attribute_sets|vertex_parents|coarse_elements|coordinates|root_state|rank|sfc_version|mfem_\w*mesh_end|communication_groups|edges|patches|knotvectors|weights|total_shared_\w+|shared_\w+)\b/

export const mfem: MeshFormat = {
  name: 'MFEM',
  recognizes(head) {
    const text = headText(head)
    return /^[ \t>]*MFEM\b[A-Z -]*\bmesh v\d/m.test(text) ? 'yes' : 'no'
  },
  read(file, options) {
    return readInTurn(file, cursor => new MfemReader(file, cursor, options))
  },
}

interface Quadratic {
  readonly cells: number[]
  readonly nodes: number
  readonly at: (node: number, axis: number) => number
}

class MfemReader {
  readonly #builder: MeshBuilder
  readonly #cursor: TextCursor
  readonly #records: TextRecords
  #isNonConforming = false
  /** The version of non-conforming meshes from which the place between two parents is stated. */
  #hasScales = false
  #vertexCount: number | null = null
  #mayLackVertices = false
  #lackingVertices = 0
  #space: NodeSpace | null = null
  /** Hexahedra of order 2, which are put into the mesh when all are known. */
  #quadratic: Quadratic | null = null
  #rank = 0
  #parents: Float64Array | null = null
  /** Names of groups of attributes, by attribute. */
  readonly #sets = new Map<number, string[]>()
  readonly #attributes: number[] = []
  readonly #vertices: number[] = []
  #elements: Start | null = null
  #boundary: Start | null = null
  /** The beginning of another mesh in the same text. */
  next: Start | null = null

  constructor(file: MeshFile, cursor: TextCursor, options: ReadOptions) {
    this.#builder = new MeshBuilder('MFEM', file.name)
    this.#cursor = cursor
    this.#records = new TextRecords(file, cursor, this.#builder, options, {
      endsSection: ahead => isSection(ahead.peekLine(LINE_HEAD)),
      hasComments: true,
      hasEnds: false,
    })
  }

  mesh(): Mesh {
    this.#header()
    for (let start = this.#nextSection(); start !== null; start = this.#nextSection()) {
      if (HEADER.test(start.name)) {
        this.next = start
        break
      }
      this.#section(start)
    }
    if (this.#vertexCount === null)
      this.#cursor.refuse(
        `the ${this.#isNonConforming ? 'coordinates' : 'vertices'} were expected; the file ends without them.`,
      )
    if (this.#elements === null) this.#cursor.refuse('the elements were expected; there are none.')
    this.#cursor.goTo(this.#elements)
    if (this.#isNonConforming) this.#readLeaves()
    else this.#readElements('elements')
    if (this.#boundary !== null) {
      this.#cursor.goTo(this.#boundary)
      this.#readElements('boundary elements')
    }
    return this.#finished()
  }

  #finished(): Mesh {
    const builder = this.#builder
    if (this.#quadratic !== null) {
      const { cells, nodes, at } = this.#quadratic
      const straight = straightHexahedra(cells, this.#vertexCount ?? 0, nodes, at)
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

  /** Passes what stands before the line with the format, and that line. */
  #header(): void {
    const cursor = this.#cursor
    for (;;) {
      cursor.skipBlanks()
      if (cursor.isAtEnd) cursor.refuse('a line such as “MFEM mesh v1.0” was expected.')
      const line = cursor.peekLine(LINE_HEAD).trim()
      if (!HEADER.test(line)) {
        cursor.skipLine()
        continue
      }
      const [, kind = '', version] = /^MFEM ([A-Z -]*?) ?mesh v(\d+\.\d+)$/i.exec(line) ?? []
      if (/NURBS|INLINE/.test(kind))
        cursor.refuse(`this is an MFEM ${kind} mesh; refine it with MFEM and save it as “MFEM mesh v1.0”.`)
      this.#isNonConforming = kind === 'NC'
      this.#hasScales = this.#isNonConforming && version === '1.1'
      const isKnown = this.#isNonConforming
        ? version === '1.0' || version === '1.1'
        : kind === '' && /^1\.[0-3]$/.test(version ?? '')
      if (!isKnown) cursor.refuse(`the format is ${shown(line)}; MFEM mesh v1.0 to v1.3 are read.`)
      cursor.skipLine()
      return
    }
  }

  /** Passes what is no section; null at the end of the mesh. */
  #nextSection(): (Start & { name: string }) | null {
    const cursor = this.#cursor
    for (;;) {
      cursor.skipBlanks()
      if (cursor.isAtEnd) return null
      const line = cursor.peekLine(LINE_HEAD)
      const start = { position: cursor.position, line: cursor.line }
      if (HEADER.test(line)) return { ...start, name: line }
      if (SECTION.test(line)) return { ...start, name: cursor.word() }
      cursor.skipLine()
    }
  }

  #section({ name }: { name: string }): void {
    const cursor = this.#cursor
    const here = () => ({ position: cursor.position, line: cursor.line })
    if (name === 'dimension') {
      const dimension = cursor.count('a dimension')
      if (dimension !== 3)
        cursor.refuse(`the mesh has dimension ${dimension}: there are no hexahedra; dimension 3 was expected.`)
    } else if (name === 'elements') {
      if (this.#elements !== null) cursor.refuse('there are elements twice.')
      this.#elements = here()
      this.#records.passSection()
    } else if (name === 'boundary') {
      this.#boundary = here()
      this.#records.passSection()
    } else if (name === 'vertices') this.#readVertices()
    else if (name === 'coordinates' && this.#isNonConforming) this.#readVertices()
    else if (name === 'nodes') this.#readNodes()
    else if (name === 'attribute_sets') this.#readSets()
    else if (name === 'rank') this.#rank = cursor.count('a rank')
    else if (name === 'vertex_parents' && this.#isNonConforming) this.#readParents()
    else this.#records.passSection()
  }

  #readVertices(): void {
    if (this.#vertexCount !== null) this.#cursor.refuse('there are vertices twice.')
    const cursor = this.#cursor
    const records = this.#records
    const count = cursor.count('the number of vertices')
    this.#vertexCount = count
    // "nodes" follows where a grid function has the places.
    if (records.next('vertices') !== 'record' || count === 0) return
    const dimension = cursor.count('the dimension of the space')
    if (dimension !== 3) cursor.refuse(`the vertices have ${dimension} coordinates; 3 were expected.`)
    this.#mayLackVertices = records.points(count, 'vertices', id => this.#readVertex(id))
  }

  #readVertex(id: number): boolean {
    const point = this.#records.coordinates()
    if (point === null) return false
    this.#records.endLine('a vertex')
    if (this.#isNonConforming) this.#builder.pointWithId(id, ...point)
    else this.#builder.point(...point)
    return true
  }

  /** A grid function: the lines that say what it is, then its numbers. */
  #readNodes(): void {
    const cursor = this.#cursor
    if (this.#isNonConforming) cursor.refuse('a non-conforming mesh with curved elements is not read.')
    const vertices = this.#vertexCount ?? cursor.refuse('the number of vertices was expected before the nodes.')
    if (this.#builder.pointCount > 0) cursor.refuse('there are vertices and nodes.')
    const entries = new Map<string, string>()
    while (this.#records.next('what the nodes are') !== 'record') {
      if (cursor.isAtEnd) cursor.refuse('the file ends where the nodes were expected.')
      const line = (cursor.nextLine() ?? '').trim()
      const colon = line.indexOf(':')
      if (colon > 0) entries.set(line.slice(0, colon), line.slice(colon + 1).trim())
    }
    const space = nodeSpaceOf(cursor, entries)
    const values: number[] = []
    do {
      const value = cursor.number('a coordinate')
      this.#builder.digits.see(value, cursor.digits)
      values.push(value)
      if (cursor.hasMoreOnLine()) continue
      this.#records.onRecord()
      if (this.#records.next('nodes') !== 'record') break
    } while (!this.#records.isElided)
    if (this.#records.isElided) cursor.refuse('the text leaves nodes out: whose the others are cannot be told.')
    const nodes = values.length / 3
    if (!Number.isInteger(nodes))
      cursor.refuse(`the nodes have ${values.length} coordinates, which is no multiple of 3.`)
    const isWrong = space.isContinuous && (space.order === 1 ? nodes !== vertices : nodes < vertices)
    if (isWrong) cursor.refuse(`there are ${nodes} nodes for ${vertices} vertices.`)
    // The first nodes of a continuous space are those of the vertices.
    const wanted = space.isContinuous ? vertices : nodes
    const at = (node: number, axis: number) => values[space.isByNode ? axis * nodes + node : 3 * node + axis] as number
    for (let i = 0; i < wanted; ++i) this.#builder.point(at(i, 0), at(i, 1), at(i, 2))
    this.#space = space
    if (space.isContinuous && space.order === 2) this.#quadratic = { cells: [], nodes, at }
    if (space.order > 1)
      this.#builder.note(`The nodes are ${space.name}: the elements are of order ${space.order}, not trilinear.`)
  }

  #readSets(): void {
    const cursor = this.#cursor
    for (let left = cursor.count('a number of sets'); left > 0; --left) {
      cursor.skipBlanks()
      const [, name = '', list = ''] = /^\s*"([^"]*)"\s+([\d\s]+)$/.exec(cursor.peekLine()) ?? []
      const [count, ...attributes] = list.trim().split(/\s+/).map(Number)
      if (list === '' || count !== attributes.length)
        cursor.refuse(
          `a name in quotes, a number and so many attributes were expected, not ${shown(cursor.peekLine())}.`,
        )
      for (const attribute of attributes) this.#sets.set(attribute, [...(this.#sets.get(attribute) ?? []), name])
      cursor.skipLine()
    }
  }

  /** Vertex, its two parents, and from v1.1 on where it lies between them. */
  #readParents(): void {
    const cursor = this.#cursor
    const count = cursor.count('a number of vertices')
    const values: number[] = []
    this.#records.all(count, 'vertices with parents', () => {
      for (let i = 0; i < 3; ++i) values.push(cursor.count('a vertex'))
      values.push(this.#hasScales ? cursor.number('a place between two vertices') : 0.5)
      return true
    })
    this.#parents = Float64Array.from(values)
  }

  #readElements(what: 'elements' | 'boundary elements'): void {
    const cursor = this.#cursor
    const records = this.#records
    let node = 0
    records.all(cursor.count(`the number of ${what}`), what, () => {
      const attribute = cursor.number('an attribute')
      if (!records.hasField('a geometry')) return false
      const geometry = this.#geometry()
      if (!this.#readIds(geometry.nodes)) return false
      const space = this.#space
      if (what === 'elements' && space !== null && !space.isContinuous) {
        this.#ownNodes(geometry.kind, attribute, node, space)
        node += space.nodesOf(geometry.kind)
      } else this.#element(geometry.kind, attribute)
      return true
    })
    if (node > this.#builder.pointCount)
      cursor.refuse(`the elements have ${node} nodes; there are ${this.#builder.pointCount}.`)
  }

  #geometry(): (typeof GEOMETRIES)[number] {
    const number = this.#cursor.number('a geometry')
    return GEOMETRIES[number] ?? this.#cursor.refuse(`an element has geometry ${number}; 0 to 7 were expected.`)
  }

  #readIds(count: number): boolean {
    this.#vertices.length = count
    for (let i = 0; i < count; ++i) {
      if (!this.#records.hasField('a vertex')) return false
      this.#vertices[i] = this.#cursor.count('a vertex')
    }
    this.#records.endElement('an element of this geometry')
    return true
  }

  /** An element whose vertices are points. */
  #element(kind: OtherCell | 'hexahedron', attribute: number): void {
    const vertices = this.#vertices
    const count = this.#vertexCount ?? 0
    const there = this.#space?.isContinuous === false ? count : this.#builder.pointCount
    for (const [i, vertex] of vertices.entries()) {
      const index = this.#isNonConforming ? this.#builder.findId(vertex) : vertex < there ? vertex : -1
      if (index < 0) {
        if (this.#isNonConforming) this.#cursor.refuse(`an element names vertex ${vertex}, which has no place.`)
        if (!this.#mayLackVertices || vertex >= count)
          this.#cursor.refuse(`an element names vertex ${vertex}; the vertices are 0 to ${count - 1}.`)
        this.#lackingVertices++
        return
      }
      vertices[i] = index
    }
    this.#put(kind, attribute, vertices)
  }

  /** An element with nodes of its own, in lexicographic order. */
  #ownNodes(kind: OtherCell | 'hexahedron', attribute: number, first: number, space: NodeSpace): void {
    if (kind !== 'hexahedron') this.#put(kind, attribute, [])
    else
      this.#put(
        kind,
        attribute,
        space.corners.map(corner => first + corner),
      )
  }

  #put(kind: OtherCell | 'hexahedron', attribute: number, points: readonly number[]): void {
    if (kind !== 'hexahedron') this.#builder.otherCell(kind)
    else if (this.#quadratic !== null) for (const point of points) this.#quadratic.cells.push(point)
    else if (this.#space !== null && this.#space.order > 1) this.#builder.notTrilinear(points)
    else {
      this.#builder.hexahedron(points)
      this.#attributes.push(attribute)
    }
  }

  /** Elements of a tree: rank, attribute, geometry, type of refinement, then vertices where it is 0, else children. */
  #readLeaves(): void {
    const cursor = this.#cursor
    const records = this.#records
    placeNonConforming(cursor, this.#builder, this.#parents ?? new Float64Array(0))
    let others = 0
    records.all(cursor.count('the number of elements'), 'elements', () => {
      const rank = cursor.number('a rank')
      const attribute = cursor.number('an attribute')
      const number = cursor.number('a geometry')
      if (number === -1) {
        cursor.skipLine()
        return true
      }
      const geometry = GEOMETRIES[number] ?? cursor.refuse(`an element has geometry ${number}; 0 to 7 were expected.`)
      const refinement = cursor.count('a type of refinement')
      if (refinement !== 0 || rank !== this.#rank) {
        if (refinement === 0) others++
        cursor.skipLine()
        return true
      }
      if (!this.#readIds(geometry.nodes)) return false
      this.#element(geometry.kind, attribute)
      return true
    })
    this.#builder.note('The mesh is non-conforming: its leaves are read.')
    if (others > 0) this.#builder.note(`${others} elements belong to other ranks: they are not read.`)
  }
}

function isSection(line: string): boolean {
  return SECTION.test(line) || HEADER.test(line)
}
