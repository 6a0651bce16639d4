/** VTK's legacy format of version 5.1, with offsets and connectivity, in bytes, the most significant first. */
import type { MeshWriter } from './mesh-form'
import { cellArrays, type MeshPart, PIECE, WHOLE_ARRAYS } from './mesh-part'
import { type PutNumber, records } from './records'

const VTK_HEXAHEDRON = 12

export const vtk: MeshWriter = {
  chunks,
  count: ({ points, cells }) =>
    2 * (WHOLE_ARRAYS + 4) + Math.ceil((3 * points + (8 + 2 + WHOLE_ARRAYS) * cells) / PIECE),
}

const double: PutNumber = (view, at, value) => view.setFloat64(at, value)
const long: PutNumber = (view, at, value) => view.setBigInt64(at, BigInt(value))
const int: PutNumber = (view, at, value) => view.setInt32(at, value)

function* chunks(part: MeshPart): Generator<string | Uint8Array> {
  const { points, cells } = part
  const count = cells.length / 8
  const numbers = (length: number, size: number, put: PutNumber, numberOf: (i: number) => number) =>
    records(length, size, (view, at, i) => put(view, at, numberOf(i)))
  const arrays = cellArrays(part)
  yield '# vtk DataFile Version 5.1\nHexahedra, decided by Hexlens\nBINARY\nDATASET UNSTRUCTURED_GRID\n'
  yield `POINTS ${points.length / 3} double\n`
  yield* numbers(points.length, 8, double, i => points[i] as number)
  yield `\nCELLS ${count + 1} ${cells.length}\nOFFSETS vtktypeint64\n`
  yield* numbers(count + 1, 8, long, i => 8 * i)
  yield '\nCONNECTIVITY vtktypeint64\n'
  yield* numbers(cells.length, 8, long, i => cells[i] as number)
  yield `\nCELL_TYPES ${count}\n`
  yield* numbers(count, 4, int, () => VTK_HEXAHEDRON)
  yield `\nCELL_DATA ${count}\nFIELD FieldData ${arrays.length}\n`
  for (const { name, numberOf } of arrays) {
    // Of bytes that have no sign meshio does not know the name.
    yield `${name} 1 ${count} double\n`
    yield* numbers(count, 8, double, numberOf)
    yield '\n'
  }
}
