/**
 * Nek5000: for each element x, y and z of four corners, then of the other four, in VTK's order; in the text of .rea, or in the bytes of .re2 by axes. Elements
 * share no points here. Sides may be curved, which is told and not read.
 */
import { BinaryCursor } from '../binary-cursor'
import { MeshBuilder } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import { headText } from '../snippet-text'
import { type MeshFile, type MeshFormat, progressOf } from '../source'
import { TextCursor } from '../text-cursor'

const ELEMENT = /^[ \t]*ELEMENT[ \t]+(\d+)\s*\[[^\]\n]{0,20}\][ \t]*GROUP/im
const BYTES = /^#v00\d\s+(\d+)\s+(\d+)\s/
const HEADER_BYTES = 80
/** The number by which the order of bytes is known. */
const TAG = Math.fround(6.54321)
const NO_SOLID = 'a mesh of two dimensions has no hexahedra.'

export const nek: MeshFormat = {
  name: 'Nek5000',
  recognizes(head) {
    const text = headText(head)
    return BYTES.test(text) || /^ *\*\*MESH DATA\*\*/m.test(text) || ELEMENT.test(text) ? 'yes' : 'no'
  },
  read(file, options) {
    const builder = new MeshBuilder('Nek5000', file.name)
    const onElement = progressOf(file, options)
    const header = BYTES.exec(headText(file.read(0, Math.min(HEADER_BYTES, file.size))))
    const curved = header === null ? ofText(file, builder, onElement) : ofBytes(file, header, builder, onElement)
    if (curved > 0) builder.note(`The file curves ${curved} sides of its elements: here they are straight.`)
    return [builder.mesh()]
  },
}

type OnElement = ReturnType<typeof progressOf>

/** Adds an element whose coordinates are all x, all y and all z. */
function add(builder: MeshBuilder, axes: ArrayLike<number>, id: number): void {
  const first = builder.pointCount
  for (let v = 0; v < 8; v++) builder.point(axes[v] as number, axes[v + 8] as number, axes[v + 16] as number)
  builder.hexahedron(
    Array.from({ length: 8 }, (_, v) => first + v),
    id,
  )
}

/** The number of curved sides. */
function ofText(file: MeshFile, builder: MeshBuilder, onElement: OnElement): number {
  const cursor = new TextCursor(file)
  const axes = new Float64Array(24)
  let declared: number | null = null
  for (let line = cursor.nextLine(); line !== null; line = cursor.nextLine()) {
    onElement(cursor.position)
    const [, id] = ELEMENT.exec(line) ?? []
    if (id !== undefined) {
      for (let i = 0; i < 24; i++) {
        const [half, inHalf] = [Math.floor(i / 12), i % 12]
        if (inHalf % 4 === 0 && !/^\s*[-+.\d]/.test(cursor.peekLine()))
          cursor.refuse(i === 8 ? NO_SOLID : `element ${id} has ${i} of 24 coordinates.`)
        const value = cursor.number('a coordinate')
        builder.digits.see(value, cursor.digits)
        axes[8 * Math.floor(inHalf / 4) + 4 * half + (inHalf % 4)] = value
        if (i % 4 === 3) cursor.skipLine()
      }
      add(builder, axes, Number(id))
    } else if (/MESH DATA/i.test(line)) {
      const [count = 0, dimensions] = (cursor.nextLine() ?? '').trim().split(/\s+/).map(Number)
      if (dimensions === 2) cursor.refuse(NO_SOLID)
      if (count < 0) cursor.refuse('its elements are in the file of the same name with .re2: give that one.')
      declared = count
    } else if (/CURVED SIDE/i.test(line)) {
      if (declared !== null && builder.cellCount !== declared)
        cursor.refuse(`${declared} elements are declared, and ${builder.cellCount} are there.`)
      return Number.parseInt(cursor.nextLine() ?? '', 10) || 0
    }
  }
  if (declared !== null) cursor.refuse('the file ends among its elements.')
  return 0
}

/** The number of curved sides. */
function ofBytes(file: MeshFile, header: RegExpExecArray, builder: MeshBuilder, onElement: OnElement): number {
  const [start = '', count, dimensions] = header
  const isSingle = start.startsWith('#v001')
  const isLittleEndian = [true, false].find(
    isLittle => new BinaryCursor(file, HEADER_BYTES, isLittle).float32('') === TAG,
  )
  const cursor = new BinaryCursor(file, HEADER_BYTES + 4, isLittleEndian ?? true)
  if (isLittleEndian === undefined)
    cursor.refuse('the order of its bytes is not known: 6.54321 was expected before this one.')
  if (Number(dimensions) === 2) cursor.refuse(NO_SOLID)
  const value = isSingle ? () => cursor.float32('coordinates') : () => cursor.float64('coordinates')
  cursor.need(Number(count), isSingle ? 100 : 200, 'elements')
  const axes = new Float64Array(24)
  let largest = 0
  for (let id = 1; id <= Number(count); id++) {
    // The number of the element's group.
    value()
    for (let i = 0; i < 24; i++) axes[i] = value()
    largest = Math.max(largest, largestOf(axes))
    add(builder, axes, id)
    onElement(cursor.position)
  }
  const note = isSingle ? float32Note(largest) : null
  if (note !== null) builder.note(note)
  if (cursor.left < 8) return 0
  const sides = isSingle ? cursor.int32('sides') : cursor.float64('sides')
  return Number.isSafeInteger(sides) ? sides : 0
}
