/**
 * Nothing but numbers: 24 for each element, in lines of any length, or points by lines. Read from bytes, so that a text of any size is read;
 * a line that is shorter or longer than the others is refused with its place, for it would shift all that follows.
 */
import type { Mesh } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import { orderOfText } from '../snippet-text'
import { type MeshFile, progressOf, type ReadOptions } from '../source'
import { TextCursor } from '../text-cursor'

const COORDINATES = 24
const [LF, SPACE, TAB, CR, COMMA, SEMICOLON] = [10, 32, 9, 13, 44, 59] as const

/** Throws a MeshRefusal with the line where something else stands, or where the numbers are no elements. */
export function meshOfNumbers(file: MeshFile, options: ReadOptions): Mesh {
  const cursor = new TextCursor(file)
  const builder = new MeshBuilder('numbers', file.name)
  const onNumber = progressOf(file, options)
  const point: number[] = []
  let count = 0
  let width = 0
  let onLine = 0
  let lines = 0
  let short = 0
  const endLine = () => {
    if (onLine === 0) return
    if (short > 0)
      cursor.refuse(`line ${short} has another number of numbers than the ${width} of the lines before it.`)
    if (lines === 0) width = onLine
    else if (onLine !== width) short = cursor.line
    lines++
    onLine = 0
  }
  for (let byte = cursor.peek(); byte !== -1; byte = cursor.peek()) {
    if (byte === LF) {
      endLine()
      cursor.skip()
    } else if (byte === SPACE || byte === TAB || byte === CR || byte === COMMA || byte === SEMICOLON) cursor.skip()
    else {
      point.push(cursor.number())
      onLine++
      count++
      if (point.length === 3) builder.point(...(point.splice(0) as [number, number, number]))
      onNumber(cursor.position)
    }
  }
  endLine()
  if (width !== 3 && COORDINATES % width !== 0 && width % COORDINATES !== 0 && lines > 1 && width > 1)
    builder.refuse(`its lines have ${width} numbers each: 3 or 24 are needed, or one list of 24 for each element.`)
  if (count % COORDINATES !== 0)
    builder.refuse(`${count} numbers were found; elements of 24 each need a multiple of 24.`)
  for (let first = 0; first < count / 3; first += 8) builder.hexahedron([0, 1, 2, 3, 4, 5, 6, 7].map(v => first + v))
  builder.isOrderStated = false
  builder.note(orderOfText(builder.cellCount))
  return builder.mesh()
}
