/** The section CELLS of VTK's legacy files: how many points each cell has and these, or since version 5 offsets and all points. */
import { shown } from '../text-cursor'
import type { LegacyStream } from './vtk-legacy-stream'
import { firstFall } from './vtk-mesh'

/** The cells of an unstructured grid, as far as they are there. */
export interface LegacyCells {
  readonly connectivity: Uint32Array
  readonly ends: Uint32Array
  readonly declared: number
}

/** Reads the text after the word CELLS. */
export function readCells(stream: LegacyStream): LegacyCells {
  const { cursor } = stream
  const first = stream.count()
  const second = stream.count()
  if (Math.max(first, second) > 0xffffffff) stream.refuse('more than 2^32 cells or numbers of cells are not read.')
  const line = cursor.position
  // Version 5 has offsets. In binary files these must begin on the next line, or the numbers do.
  const isEnded = cursor.nextLine()?.trim() === ''
  if (!stream.isBinary) cursor.skipBlanks(false)
  if (isEnded && /^o/i.test(String.fromCharCode(Math.max(0, cursor.peek())))) {
    const before = cursor.position
    if (cursor.word().toUpperCase() === 'OFFSETS') return cellsByOffsets(stream, first, second)
    cursor.goTo({ position: before })
  }
  cursor.goTo({ position: line })
  return cellsByCounts(stream, first, second)
}

/** Cells before version 5: the number of points of each, and these. */
function cellsByCounts(stream: LegacyStream, declared: number, size: number): LegacyCells {
  const list = stream.list(size, 'Int32', Uint32Array, 'number')
  const isElided = list.length < size
  const ends = new Uint32Array(Math.min(declared, list.length))
  let at = 0
  let filled = 0
  let cell = 0
  for (; cell < declared && at < list.length; ++cell) {
    const count = list[at++] as number
    if (at + count > list.length) break
    if (filled + count !== at + count) list.copyWithin(filled, at, at + count)
    at += count
    filled += count
    ends[cell] = filled
  }
  if (!isElided && (cell < declared || at < size)) {
    const have = `the ${size} numbers of CELLS hold ${cell} whole cells${at < size ? ` and ${size - at} more numbers` : ''}`
    stream.refuse(`${have}; ${declared} cells were expected.`)
  }
  return { connectivity: list.subarray(0, filled), ends: ends.subarray(0, cell), declared }
}

/** Cells from version 5 on: offsets of each and of the end, then all points. */
function cellsByOffsets(stream: LegacyStream, count: number, size: number): LegacyCells {
  const declared = Math.max(0, count - 1)
  const offsets = stream.list(count, stream.type(), Uint32Array, 'offset')
  const keyword = stream.cursor.word()
  if (keyword.toUpperCase() !== 'CONNECTIVITY')
    stream.refuse(`${shown(keyword)} stands where CONNECTIVITY was expected.`)
  const connectivity = stream.list(size, stream.type(), Uint32Array, 'index')
  if (offsets.length > 0 && offsets[0] !== 0) stream.refuse(`the first offset is ${offsets[0]}, where 0 was expected.`)
  const falling = firstFall(offsets)
  if (falling > 0)
    stream.refuse(`offset ${falling} is ${offsets[falling]}, less than ${offsets[falling - 1]}, the one before.`)
  const isElided = offsets.length < count || connectivity.length < size
  let cells = Math.max(0, offsets.length - 1)
  if (!isElided && (offsets[cells] ?? 0) !== size)
    stream.refuse(`the offsets end at ${offsets[cells] ?? 0}, where ${size}, the number of indices, was expected.`)
  while (cells > 0 && (offsets[cells] as number) > connectivity.length) cells--
  return { connectivity, ends: offsets.subarray(1, cells + 1), declared }
}
