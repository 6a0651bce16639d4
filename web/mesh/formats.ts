/** All formats. The first that is certain of a file reads it, else the first to which it is possible. */
import { text } from './formats/text'
import type { MeshFormat } from './source'

export const formats: readonly MeshFormat[] = [
  text, // last: what no other claims
]
