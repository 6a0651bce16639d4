/** The parts that all texts of the export share. */

import type { PlainWord } from '../words/say'
import { VERTEX_COUNT, type Vec3, type Vertices, vertexOf } from './hexahedron'
import { numberText } from './number-text'

/** A text that an element can be taken away as. Reading it back gives the vertices bit for bit. */
export interface Writer {
  readonly title: string
  /** A few words beside the title. */
  readonly note: PlainWord
  readonly extension: string
  readonly mediaType: string
  /** `name` is that of the element: letters, digits, hyphens. */
  write(vertices: Vertices, name: string): string
}

export function pointsOf(vertices: Vertices): Vec3[] {
  return Array.from({ length: VERTEX_COUNT }, (_, v) => vertexOf(vertices, v))
}

/** The shortest decimal that reads back as the same double, always with a point or an exponent: a bare -0 is an integer to many. */
export function decimalText(value: number): string {
  const text = numberText(value)
  return /[.e]/.test(text) ? text : `${text}.0`
}
