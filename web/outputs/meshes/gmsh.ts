/** Gmsh's format of version 4.1, in bytes; what is said of cells as ElementData. */
import type { MeshWriter } from './mesh-form'
import { cellArrays, type MeshPart, PIECE, WHOLE_ARRAYS } from './mesh-part'
import { numbering } from './numbering'
import { records } from './records'

const HEXAHEDRON = 5
/** The volume that all belongs to. */
const ENTITY = { dimension: 3, tag: 1 }
/** Tags of elements are 32 bits in ElementData. */
const MOST_TAG = 2 ** 31 - 1

export const gmsh: MeshWriter = {
  chunks,
  count: ({ points, cells }) =>
    2 * (WHOLE_ARRAYS + 4) + Math.ceil((4 * points + (9 + 1.5 * WHOLE_ARRAYS) * cells) / PIECE),
}

function* chunks(part: MeshPart, say: (sentence: string) => void): Generator<string | Uint8Array> {
  const { points, cells } = part
  const [pointCount, cellCount] = [points.length / 3, cells.length / 8]
  const numberOf = numbering(part, MOST_TAG, say)
  const { dimension, tag } = ENTITY
  yield '$MeshFormat\n4.1 1 8\n'
  yield ints(1)
  yield '\n$EndMeshFormat\n$Nodes\n'
  yield longs(pointCount === 0 ? 0 : 1, pointCount, Math.min(1, pointCount), pointCount)
  if (pointCount > 0) {
    yield ints(dimension, tag, 0)
    yield longs(pointCount)
    yield* records(pointCount, 8, (view, at, i) => putLong(view, at, i + 1))
    yield* records(points.length, 8, (view, at, i) => view.setFloat64(at, points[i] as number, true))
  }
  yield '\n$EndNodes\n$Elements\n'
  const tags = bounds(cellCount, numberOf)
  yield longs(cellCount === 0 ? 0 : 1, cellCount, ...tags)
  if (cellCount > 0) {
    yield ints(dimension, tag, HEXAHEDRON)
    yield longs(cellCount)
    yield* records(cellCount, 72, (view, at, cell) => {
      putLong(view, at, numberOf(cell))
      for (let v = 0; v < 8; ++v) putLong(view, at + 8 * (v + 1), (cells[8 * cell + v] as number) + 1)
    })
  }
  yield '\n$EndElements\n'
  for (const array of cellArrays(part)) {
    yield `$ElementData\n1\n"${array.name}"\n1\n0\n3\n0\n1\n${cellCount}\n`
    yield* records(cellCount, 12, (view, at, cell) => {
      view.setInt32(at, numberOf(cell), true)
      view.setFloat64(at + 4, array.numberOf(cell), true)
    })
    yield '\n$EndElementData\n'
  }
}

function bounds(count: number, numberOf: (cell: number) => number): [least: number, greatest: number] {
  let [least, greatest] = count === 0 ? [0, 0] : [Number.POSITIVE_INFINITY, 0]
  for (let cell = 0; cell < count; ++cell) {
    least = Math.min(least, numberOf(cell))
    greatest = Math.max(greatest, numberOf(cell))
  }
  return [least, greatest]
}

/** Whole numbers below 2^53 as eight bytes. */
function putLong(view: DataView, at: number, value: number): void {
  view.setUint32(at, value, true)
  view.setUint32(at + 4, Math.floor(value / 2 ** 32), true)
}

function ints(...values: readonly number[]): Uint8Array {
  const view = new DataView(new ArrayBuffer(4 * values.length))
  for (const [i, value] of values.entries()) view.setInt32(4 * i, value, true)
  return new Uint8Array(view.buffer)
}

function longs(...values: readonly number[]): Uint8Array {
  const view = new DataView(new ArrayBuffer(8 * values.length))
  for (const [i, value] of values.entries()) putLong(view, 8 * i, value)
  return new Uint8Array(view.buffer)
}
