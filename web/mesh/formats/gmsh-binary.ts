/** The binary sections of Gmsh's files, MSH 2 to 4.1: nodes, elements and entities. */
import type { BinaryCursor } from '../binary-cursor'
import type { GmshMesh } from './gmsh-mesh'
import { type GmshType, gmshTypes } from './gmsh-types'

/** The format's version: 4.0 and 4.1 differ. */
export type Version = 1 | 2 | 4 | 4.1

export interface BinarySection {
  readonly cursor: BinaryCursor
  readonly mesh: GmshMesh
  readonly version: Version
  /** Bytes of a size_t: 4.1 states it. */
  readonly sizeBytes: 4 | 8
  readonly onRecord: (position: number) => void
}

const AT_ONCE = 32_768

/** Nodes of MSH 2, after their count: 28 bytes each, and parameters if the section has them. */
export function readNodes2({ cursor, mesh, onRecord }: BinarySection, count: number, isParametric: boolean): void {
  cursor.need(count, 28, 'nodes')
  mesh.builder.reserve(count, 0)
  if (isParametric) mesh.hasPlaces = false
  else mesh.block(cursor, count, cursor.position + 4, 28)
  for (let done = 0; done < count; ) {
    const some = isParametric ? 1 : Math.min(AT_ONCE, count - done)
    const bytes = cursor.bytes(28 * some, 'nodes')
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
    for (let at = 0; at < bytes.length; at += 28) {
      const little = cursor.isLittleEndian
      const id = view.getInt32(at, little)
      if (id < 0) cursor.refuse(`a node has the id ${id}.`)
      mesh.node(
        cursor,
        id,
        view.getFloat64(at + 4, little),
        view.getFloat64(at + 12, little),
        view.getFloat64(at + 20, little),
      )
    }
    if (isParametric) {
      const dimension = cursor.int32('the dimension of an entity')
      cursor.int32('an entity')
      for (let i = 0; i < (dimension === 1 || dimension === 2 ? dimension : 0); ++i) cursor.float64('a parameter')
    }
    done += some
    onRecord(cursor.position)
  }
}

/** Elements of MSH 2, after the line with the count: groups of one type. */
export function readElements2({ cursor, mesh, onRecord }: BinarySection, count: number): void {
  cursor.need(count, 12, 'elements')
  for (let done = 0; done < count; ) {
    const type = typeOf(cursor, cursor.int32('a type of elements'))
    const group = cursor.count(4, 'a number of elements')
    const tags = cursor.count(4, 'a number of tags')
    if (group === 0 || group > count - done)
      cursor.refuse(`a group has ${group} elements where ${count - done} are left of ${count}.`)
    const length = 1 + tags + type.nodes
    cursor.need(group, 4 * length, 'elements')
    for (let read = 0; read < group; ) {
      const some = Math.max(1, Math.min(group - read, Math.floor((2 * AT_ONCE) / length)))
      const numbers = cursor.int32s(some * length, 'elements')
      for (let at = 0; at < numbers.length; at += length) {
        const blocks = mesh.blocksOfElement(
          tags > 0 ? (numbers[at + 1] as number) : 0,
          tags > 1 ? (numbers[at + 2] as number) : 0,
        )
        mesh.element(cursor, type, numbers[at] as number, numbers, at + 1 + tags, blocks)
      }
      read += some
      onRecord(cursor.position)
    }
    done += group
  }
}

export function readNodes4(section: BinarySection): void {
  const { cursor, mesh, version, sizeBytes, onRecord } = section
  const blocks = cursor.count(sizeBytes, 'the number of entities')
  const count = cursor.count(sizeBytes, 'the number of nodes')
  if (version === 4.1) cursor.ints(2, sizeBytes, 'the range of nodes')
  cursor.need(count, 24, 'nodes')
  mesh.builder.reserve(count, 0)
  let seen = 0
  for (let block = 0; block < blocks; ++block) {
    const first = cursor.int32('an entity')
    const second = cursor.int32('an entity')
    const dimension = version === 4.1 ? first : second
    const parameters = cursor.int32('whether nodes have parameters') === 0 ? 0 : dimension
    if (parameters < 0 || parameters > 3) cursor.refuse(`an entity of dimension ${dimension} has nodes.`)
    const nodes = cursor.count(sizeBytes, 'a number of nodes')
    seen += nodes
    if (seen > count) cursor.refuse(`there are more nodes than the ${count} that were declared.`)
    const stride = 3 + parameters
    if (version === 4.1) {
      cursor.need(nodes, sizeBytes + 8 * stride, 'nodes')
      const ids = cursor.ints(nodes, sizeBytes, 'the nodes')
      mesh.block(cursor, nodes, cursor.position, 8 * stride)
      for (let done = 0; done < nodes; ) {
        const some = Math.min(AT_ONCE, nodes - done)
        const numbers = cursor.float64s(some * stride, 'coordinates')
        for (let i = 0; i < some; ++i) {
          const id = ids[done + i] as number
          if (id < 0) cursor.refuse(`a node has the id ${id}.`)
          const at = stride * i
          mesh.node(cursor, id, numbers[at] as number, numbers[at + 1] as number, numbers[at + 2] as number)
        }
        done += some
        onRecord(cursor.position)
      }
    } else {
      cursor.need(nodes, 4 + 8 * stride, 'nodes')
      mesh.block(cursor, nodes, cursor.position + 4, 4 + 8 * stride)
      for (let i = 0; i < nodes; ++i) {
        const id = cursor.count(4, 'the id of a node')
        const x = cursor.float64('a coordinate')
        const y = cursor.float64('a coordinate')
        mesh.node(cursor, id, x, y, cursor.float64('a coordinate'))
        for (let p = 0; p < parameters; ++p) cursor.float64('a parameter')
      }
      onRecord(cursor.position)
    }
  }
  if (seen < count) cursor.refuse(`${count} nodes are declared, ${seen} are there.`)
}

export function readElements4(section: BinarySection): void {
  const { cursor, mesh, version, sizeBytes, onRecord } = section
  const blocks = cursor.count(sizeBytes, 'the number of entities')
  const count = cursor.count(sizeBytes, 'the number of elements')
  if (version === 4.1) cursor.ints(2, sizeBytes, 'the range of elements')
  const idBytes = version === 4.1 ? sizeBytes : 4
  cursor.need(count, 2 * idBytes, 'elements')
  let seen = 0
  for (let block = 0; block < blocks; ++block) {
    const first = cursor.int32('an entity')
    const second = cursor.int32('an entity')
    const [dimension, tag] = version === 4.1 ? [first, second] : [second, first]
    const type = typeOf(cursor, cursor.int32('a type of elements'))
    const elements = cursor.count(sizeBytes, 'a number of elements')
    seen += elements
    if (seen > count) cursor.refuse(`there are more elements than the ${count} that were declared.`)
    const length = 1 + type.nodes
    cursor.need(elements, idBytes * length, 'elements')
    if (type.kind === 'hexahedron') mesh.builder.reserve(0, elements)
    const names = dimension === 3 ? mesh.blocksOfVolume(tag) : []
    for (let done = 0; done < elements; ) {
      const some = Math.max(1, Math.min(elements - done, Math.floor((2 * AT_ONCE) / length)))
      const numbers = cursor.ints(some * length, idBytes, 'elements')
      if (type.kind === 'hexahedron') mesh.hexahedra(cursor, type, numbers, names)
      else
        for (let at = 0; at < numbers.length; at += length)
          mesh.element(cursor, type, numbers[at] as number, numbers, at + 1, names)
      done += some
      onRecord(cursor.position)
    }
  }
  if (seen < count) cursor.refuse(`${count} elements are declared, ${seen} are there.`)
}

function typeOf(cursor: BinaryCursor, number: number): GmshType {
  const type = gmshTypes.get(number)
  return type ?? cursor.refuse(`there are elements of type ${number}, which is none of Gmsh's.`)
}
