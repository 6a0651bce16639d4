/**
 * FLAC3D's grids in bytes, little-endian: gridpoints, then zones and after them faces, each with their groups behind. A zone has its id, the count of
 * its gridpoints, and their ids; a group has two names, that of the slot last, and ids of zones.
 */
import { BinaryCursor } from '../binary-cursor'
import { IdIndex } from '../id-index'
import type { Mesh } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { type MeshFile, progressOf, type ReadOptions } from '../source'

const MAGIC = 1_375_135_718
const VERSION = 3
const BYTES_OF_GRIDPOINT = 28
/** An id and a count. */
const LEAST_BYTES_OF_ZONE = 8
/** Lengths of two names and a count. */
const LEAST_BYTES_OF_GROUP = 8
/** Zones by their count of gridpoints; a brick of seven is cut off at a corner. */
const KINDS: ReadonlyMap<number, OtherCell> = new Map([
  [7, 'other'],
  [6, 'wedge'],
  [5, 'pyramid'],
  [4, 'tetrahedron'],
])
const BRICK = 8
const MOST_IN_FACE = 4

export function isBinaryFlac3d(head: Uint8Array): boolean {
  return head.length >= 8 && new DataView(head.buffer, head.byteOffset).getUint32(0, true) === MAGIC
}

/** `order` has the place in the file of each corner. */
export function binaryFlac3d(file: MeshFile, options: ReadOptions, order: readonly number[]): Mesh {
  const cursor = new BinaryCursor(file, 4, true)
  const builder = new MeshBuilder('FLAC3D', file.name)
  const onSome = progressOf(file, options)
  const whole = (what: string) => cursor.int32(what) >>> 0
  const counted = (what: string, bytes: number) => {
    const count = whole(`the number of ${what}`)
    cursor.need(count, bytes, what)
    return count
  }
  const name = () => {
    const length = cursor.bytes(2, 'the length of a name')
    const bytes = (length[0] as number) + 256 * (length[1] as number)
    return new TextDecoder().decode(cursor.bytes(bytes, 'a name'))
  }
  const version = whole('the version')
  if (version !== VERSION) cursor.refuse(`the version is ${version}; ${VERSION} is read.`)

  const points = counted('gridpoints', BYTES_OF_GRIDPOINT)
  builder.reserve(points, 0)
  for (let i = 0; i < points; ++i) {
    const id = whole('the number of a gridpoint')
    const [x, y, z] = cursor.float64s(3, 'coordinates') as unknown as [number, number, number]
    builder.pointWithId(id, x, y, z)
    onSome(cursor.position)
  }

  const cellOfId = new IdIndex()
  const zones = counted('zones', LEAST_BYTES_OF_ZONE)
  for (let i = 0; i < zones; ++i) {
    const id = whole('the number of a zone')
    const count = whole('the number of its gridpoints')
    const kind = KINDS.get(count)
    if (kind === undefined && count !== BRICK)
      cursor.refuse(`zone ${id} has ${count} gridpoints; 4 to 8 were expected.`)
    const nodes = Array.from(cursor.int32s(count, 'gridpoints of a zone'), node => node >>> 0)
    if (kind !== undefined) builder.otherCell(kind)
    else {
      if (cellOfId.get(id) >= 0) cursor.refuse(`zone ${id} is defined twice.`)
      const corners = order.map(at => builder.indexOfId(nodes[at] as number, `zone ${id}`))
      cellOfId.set(id, builder.hexahedron(corners, id))
    }
    onSome(cursor.position)
  }
  for (let groups = counted('groups of zones', LEAST_BYTES_OF_GROUP); groups > 0; --groups) {
    const group = name()
    name()
    for (let left = counted('zones of a group', 4); left > 0; --left) {
      const cell = cellOfId.get(whole('the number of a zone'))
      if (cell >= 0) builder.inBlock(group, cell)
    }
  }
  for (let faces = counted('faces', LEAST_BYTES_OF_ZONE); faces > 0; --faces) {
    const id = whole('the number of a face')
    const count = whole('the number of its gridpoints')
    if (count !== MOST_IN_FACE && count !== 3)
      cursor.refuse(`face ${id} has ${count} gridpoints; 3 or 4 were expected.`)
    cursor.int32s(count, 'gridpoints of a face')
  }
  return builder.mesh()
}
