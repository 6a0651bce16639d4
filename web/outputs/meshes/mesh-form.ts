/** A format that checked meshes are written in. */
import type { FormWords } from './form-words'
import type { MeshPart } from './mesh-part'

export interface MeshWriter {
  /** The file, in short pieces; `say` gets sentences for people. Throws a Refusal where there is no such file. */
  chunks(part: MeshPart, say: (sentence: string) => void): Iterable<string | Uint8Array>
  /** How many pieces, about. */
  count(size: PartSize): number
}

export interface MeshForm extends FormWords, MeshWriter {
  /** How its files end, without the point. */
  readonly id: string
}

export interface PartSize {
  readonly points: number
  readonly cells: number
}
