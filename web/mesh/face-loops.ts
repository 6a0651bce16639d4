/** The faces of cells, numbered `6 * cell + face`, and their vertices. */
import { faces } from '../model/hexahedron'

export const FACES = 6

/** Vertices of a face in cyclic order: 00, 10, 11, 01. */
export const faceLoops: readonly (readonly [number, number, number, number])[] = faces.map(
  ({ vertices: [a, b, c, d] }) => [a, b, d, c] as const,
)

/** The same of faces 0 to 5, flat. */
export const LOOPS = Uint8Array.from(faceLoops.flat())
