/** A format that checked meshes are written in. */
import type { MeshPart } from './mesh-part'

export interface MeshForm {
  /** How its files end, without the point. */
  readonly id: string
  readonly name: string
  /** What is in the file of a whole mesh, for people. */
  readonly what: string
  /** The same of a file that has the invalid cells alone. */
  readonly whatOfPart: string
  readonly mediaType: string
  /** The file, in short pieces; `say` gets sentences for people. Throws a Refusal where there is no such file. */
  chunks(part: MeshPart, say: (sentence: string) => void): Iterable<string | Uint8Array>
  /** How many pieces, about. */
  count(size: PartSize): number
}

export interface PartSize {
  readonly points: number
  readonly cells: number
}
