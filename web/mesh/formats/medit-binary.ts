/** Medit's .meshb: keywords by number, each with the place of the next, of 4 bytes up to version 2 and of 8 from 3 on. */
import { BinaryCursor } from '../binary-cursor'
import type { Mesh } from '../mesh'
import { float32Note } from '../precision'
import type { MeshFile, ReadOptions } from '../source'
import {
  DIMENSION,
  END,
  FLOATING_POINT_PRECISION,
  meditCellsByCode,
  meditCountedByCode,
  meditOrderings,
  VERTICES,
} from './medit-keywords'
import { MeditMesh } from './medit-mesh'

const AT_ONCE = 32_768
const LAST_VERSION = 4

/** The integer 1 in either order of bytes, then the version. */
export function isMeditBinary(head: Uint8Array): boolean {
  const [a, b, c, d, e, f, g, h] = head
  return (
    (a === 1 && !b && !c && !d && isVersion(e) && !f && !g && !h) ||
    (!a && !b && !c && d === 1 && !e && !f && !g && isVersion(h))
  )
}

function isVersion(byte: number | undefined): boolean {
  return byte !== undefined && byte >= 1 && byte <= LAST_VERSION
}

interface Section {
  readonly code: number
  readonly position: number
}

export function readMeditBinary(file: MeshFile, options: ReadOptions): Mesh {
  const cursor = new BinaryCursor(file, 4, file.read(0, 1)[0] === 1)
  const version = cursor.int32('the version')
  const positionBytes = version < 3 ? 4 : 8
  const sections = sectionsOf(cursor, file.size, positionBytes)
  const mesh = new MeditMesh(file.name)
  const intBytes = version < LAST_VERSION ? 4 : 8
  const go = (section: Section) => {
    options.throwIfCancelled()
    options.onProgress(section.position / file.size)
    cursor.jumpTo(section.position)
  }
  const of = (code: number) => sections.filter(section => section.code === code)
  let floatBytes: 4 | 8 = version === 1 ? 4 : 8
  for (const section of of(FLOATING_POINT_PRECISION)) {
    go(section)
    floatBytes = cursor.int(intBytes, 'the precision') === 32 ? 4 : 8
  }
  for (const section of of(DIMENSION)) {
    go(section)
    const dimension = cursor.int32('the dimension')
    if (dimension === 2) cursor.refuse('the mesh is two-dimensional: there are no hexahedra.')
    if (dimension !== 3) cursor.refuse(`the dimension is ${dimension}; 3 was expected.`)
  }
  const vertices = of(VERTICES)
  if (vertices.length !== 1) cursor.refuse(`one list of vertices was expected; there are ${vertices.length}.`)
  for (const section of vertices) {
    go(section)
    readVertices(cursor, mesh, floatBytes, intBytes)
  }
  for (const [code, nodes] of meditOrderings) {
    for (const section of of(code)) {
      go(section)
      const count = cursor.count(intBytes, 'the number of nodes')
      if (count !== nodes) cursor.refuse(`an order of ${count} nodes is stated; ${nodes} were expected.`)
      const numbers = cursor.ints(3 * nodes, intBytes, 'the order of nodes')
      mesh.orderNodes(
        cursor,
        Array.from({ length: nodes }, (_, i) => [...numbers.subarray(3 * i, 3 * i + 3)]),
      )
    }
  }
  for (const section of sections) {
    const counted = meditCountedByCode.get(section.code)
    if (counted) {
      go(section)
      mesh.builder.otherCell(counted, cursor.count(intBytes, 'a number of cells'))
    }
    const cells = meditCellsByCode.get(section.code)
    if (!cells) continue
    go(section)
    const count = cursor.count(intBytes, `the number of ${cells.name}`)
    const length = cells.nodes + 1
    cursor.need(count, length * intBytes, cells.name)
    if (cells.kind === 'hexahedron') mesh.builder.reserve(0, count)
    const most = Math.floor((16 * AT_ONCE) / length)
    for (let done = 0; done < count; ) {
      const some = Math.min(most, count - done)
      const numbers = cursor.ints(some * length, intBytes, cells.name)
      for (let at = 0; at < numbers.length; at += length)
        mesh.cell(cursor, cells, numbers, at, numbers[at + cells.nodes] as number)
      done += some
      options.throwIfCancelled()
      options.onProgress(cursor.position / file.size)
    }
  }
  mesh.finish()
  return mesh.builder.mesh()
}

/** Follows the places from keyword to keyword, which must lead on. */
function sectionsOf(cursor: BinaryCursor, size: number, positionBytes: 4 | 8): Section[] {
  const sections: Section[] = []
  while (cursor.left > 0) {
    const code = cursor.int32('a keyword')
    if (code === END) return sections
    const next = cursor.count(positionBytes, 'the place of the next keyword')
    sections.push({ code, position: cursor.position })
    if (next === 0) return sections
    if (next > size) cursor.refuse(`the next keyword is at byte ${next}; the file ends at byte ${size}.`)
    if (next < cursor.position) cursor.refuse(`the next keyword is at byte ${next}, which is before this one.`)
    cursor.jumpTo(next)
  }
  return cursor.refuse('the keyword End was expected; the file ends without it.')
}

function readVertices(cursor: BinaryCursor, mesh: MeditMesh, floatBytes: 4 | 8, intBytes: 4 | 8): void {
  const count = cursor.count(intBytes, 'the number of vertices')
  const stride = 3 * floatBytes + intBytes
  cursor.need(count, stride, 'vertices')
  mesh.builder.reserve(count, 0)
  const little = cursor.isLittleEndian
  let largest = 0
  for (let done = 0; done < count; ) {
    const some = Math.min(AT_ONCE, count - done)
    const bytes = cursor.bytes(some * stride, 'vertices')
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
    for (let at = 0; at < bytes.length; at += stride) {
      if (floatBytes === 8) {
        mesh.builder.point(
          view.getFloat64(at, little),
          view.getFloat64(at + 8, little),
          view.getFloat64(at + 16, little),
        )
      } else {
        const x = view.getFloat32(at, little)
        const y = view.getFloat32(at + 4, little)
        const z = view.getFloat32(at + 8, little)
        mesh.builder.point(x, y, z)
        for (const value of [x, y, z]) if (Number.isFinite(value)) largest = Math.max(largest, Math.abs(value))
      }
    }
    done += some
  }
  const note = floatBytes === 4 ? float32Note(largest) : null
  if (note !== null) mesh.builder.note(note)
}
