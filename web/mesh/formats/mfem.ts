/** MFEM's meshes, v1.0 to v1.3, whose vertices may be those of a grid function, and the leaves of non-conforming ones. */
import type { Mesh } from '../mesh'
import type { OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown, type TextCursor } from '../text-cursor'
import { LINE_HEAD, readInTurn, type Start, TextRecords } from '../text-records'
import { MfemMesh } from './mfem-mesh'
import { nodeSpaceOf } from './mfem-nodes'
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

const HEADER = /^MFEM\b[A-Z -]*\bmesh v\d/i
const SECTION =
  /^(?:dimension|elements|boundary|vertices|nodes|attribute_sets|bdr_attribute_sets|vertex_parents|coarse_elements|coordinates|root_state|rank|sfc_version|mfem_\w*mesh_end|communication_groups|edges|patches|knotvectors|weights|total_shared_\w+|shared_\w+)\b/

export const mfem: MeshFormat = {
  name: 'MFEM',
  recognizes(head) {
    const text = headText(head)
    return /^[ \t>]*MFEM\b[A-Z -]*\bmesh v\d/im.test(text) ? 'yes' : 'no'
  },
  read(file, options) {
    return readInTurn(file, cursor => new MfemReader(file, cursor, options))
  },
}

class MfemReader {
  readonly #mesh: MfemMesh
  readonly #cursor: TextCursor
  readonly #records: TextRecords
  /** The version of non-conforming meshes from which the place between two parents is stated. */
  #hasScales = false
  #rank = 0
  #parents: Float64Array | null = null
  readonly #vertices: number[] = []
  #elements: Start | null = null
  #boundary: Start | null = null
  /** The beginning of another mesh in the same text. */
  next: Start | null = null

  constructor(file: MeshFile, cursor: TextCursor, options: ReadOptions) {
    this.#mesh = new MfemMesh(file.name)
    this.#cursor = cursor
    this.#records = new TextRecords(file, cursor, this.#mesh.builder, options, {
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
    if (this.#mesh.vertexCount === null)
      this.#cursor.refuse(
        `the ${this.#mesh.isNonConforming ? 'coordinates' : 'vertices'} were expected; the file ends without them.`,
      )
    if (this.#elements === null) this.#cursor.refuse('the elements were expected; there are none.')
    this.#cursor.goTo(this.#elements)
    if (this.#mesh.isNonConforming) this.#readLeaves()
    else this.#readElements('elements')
    if (this.#boundary !== null) {
      this.#cursor.goTo(this.#boundary)
      this.#readElements('boundary elements')
    }
    return this.#mesh.finished()
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
      this.#mesh.isNonConforming = kind === 'NC'
      this.#hasScales = this.#mesh.isNonConforming && version === '1.1'
      const isKnown = this.#mesh.isNonConforming
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
    else if (name === 'coordinates' && this.#mesh.isNonConforming) this.#readVertices()
    else if (name === 'nodes') this.#readNodes()
    else if (name === 'attribute_sets') this.#readSets()
    else if (name === 'rank') this.#rank = cursor.count('a rank')
    else if (name === 'vertex_parents' && this.#mesh.isNonConforming) this.#readParents()
    else this.#records.passSection()
  }

  #readVertices(): void {
    if (this.#mesh.vertexCount !== null) this.#cursor.refuse('there are vertices twice.')
    const cursor = this.#cursor
    const records = this.#records
    const count = cursor.count('the number of vertices')
    this.#mesh.vertexCount = count
    // "nodes" follows where a grid function has the places.
    if (records.next('vertices') !== 'record' || count === 0) return
    const dimension = cursor.count('the dimension of the space')
    if (dimension !== 3) cursor.refuse(`the vertices have ${dimension} coordinates; 3 were expected.`)
    this.#mesh.mayLackVertices = records.points(count, 'vertices', id => this.#readVertex(id))
  }

  #readVertex(id: number): boolean {
    const point = this.#records.coordinates()
    if (point === null) return false
    this.#records.endLine('a vertex')
    if (this.#mesh.isNonConforming) this.#mesh.builder.pointWithId(id, ...point)
    else this.#mesh.builder.point(...point)
    return true
  }

  /** A grid function: the lines that say what it is, then its numbers. */
  #readNodes(): void {
    const cursor = this.#cursor
    if (this.#mesh.isNonConforming) cursor.refuse('a non-conforming mesh with curved elements is not read.')
    if (this.#mesh.vertexCount === null) cursor.refuse('the number of vertices was expected before the nodes.')
    if (this.#mesh.builder.pointCount > 0) cursor.refuse('there are vertices and nodes.')
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
      this.#mesh.builder.digits.see(value, cursor.digits)
      values.push(value)
      if (cursor.hasMoreOnLine()) continue
      this.#records.onRecord()
      if (this.#records.next('nodes') !== 'record') break
    } while (!this.#records.isElided)
    if (this.#records.isElided) cursor.refuse('the text leaves nodes out: whose the others are cannot be told.')
    this.#mesh.setNodes(cursor, space, values)
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
      for (const attribute of attributes) this.#mesh.nameAttribute(attribute, name)
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
    records.all(cursor.count(`the number of ${what}`), what, () => {
      const attribute = cursor.number('an attribute')
      if (!records.hasField('a geometry')) return false
      const geometry = this.#geometry()
      if (!this.#readIds(geometry.nodes)) return false
      if (what !== 'elements' || !this.#mesh.elementByNodes(geometry.kind, attribute))
        this.#mesh.element(cursor, geometry.kind, attribute, this.#vertices)
      return true
    })
    this.#mesh.checkNodes(cursor)
  }

  #geometry(number = this.#cursor.number('a geometry')): (typeof GEOMETRIES)[number] {
    const known = GEOMETRIES[number]
    if (known !== undefined) return known
    const which = Number.isFinite(number) ? `geometry ${number}` : 'a geometry that is no number'
    return this.#cursor.refuse(`an element has ${which}; 0 to 7 were expected.`)
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

  /** Elements of a tree: rank, attribute, geometry, type of refinement, then vertices where it is 0, else children. */
  #readLeaves(): void {
    const cursor = this.#cursor
    const records = this.#records
    placeNonConforming(cursor, this.#mesh.builder, this.#parents ?? new Float64Array(0))
    let others = 0
    records.all(cursor.count('the number of elements'), 'elements', () => {
      const rank = cursor.number('a rank')
      const attribute = cursor.number('an attribute')
      const number = cursor.number('a geometry')
      if (number === -1) {
        cursor.skipLine()
        return true
      }
      const geometry = this.#geometry(number)
      const refinement = cursor.count('a type of refinement')
      if (refinement !== 0 || rank !== this.#rank) {
        if (refinement === 0) others++
        cursor.skipLine()
        return true
      }
      if (!this.#readIds(geometry.nodes)) return false
      this.#mesh.element(cursor, geometry.kind, attribute, this.#vertices)
      return true
    })
    this.#mesh.builder.note('The mesh is non-conforming: its leaves are read.')
    if (others > 0) this.#mesh.builder.note(`${others} elements belong to other ranks: they are not read.`)
  }
}

function isSection(line: string): boolean {
  return SECTION.test(line) || HEADER.test(line)
}
