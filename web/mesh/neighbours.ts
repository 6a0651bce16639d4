/** Which cells share a face, and which faces are the boundary of a mesh. */
import { faces } from '../model/hexahedron'

/** Faces of cells are numbered `6 * cell + face`. */
export interface Neighbours {
  /** The same face in the cell on its other side; -1 on the boundary. */
  readonly across: Int32Array<ArrayBuffer>
  /** The faces of one cell alone, ascending. */
  readonly boundary: Uint32Array<ArrayBuffer>
}

export interface NeighbourOptions {
  /** Called now and then with how many cells are done. */
  readonly onProgress?: (done: number) => void
}

export const FACES = 6
const NONE = -1

/** Vertices of a face in cyclic order: 00, 10, 11, 01. */
export const faceLoops: readonly (readonly [number, number, number, number])[] = faces.map(
  ({ vertices: [a, b, c, d] }) => [a, b, d, c] as const,
)

/** Vertices of faces 0 to 5 in cyclic order, flat. */
const LOOPS = Uint8Array.from(faceLoops.flat())

const CELLS_A_STEP = 65_536

/**
 * Two faces are the same if they have the same points in the same cyclic order, either way round: with another order the four points
 * bound another bilinear face. Of a face that more than two cells have, pairs are made in the file's order. `cells` are eight indices
 * of points each, all below `pointCount`.
 *
 * A face waits in the list of its least point until its other side comes, so that lists are short and a mesh in order is gone through
 * in one pass. Of the remaining three points the opposite one has to be the same, and the two beside it as a pair.
 */
export function neighboursOf(
  cells: Uint32Array,
  pointCount: number,
  { onProgress }: NeighbourOptions = {},
): Neighbours {
  const count = cells.length / 8
  // Of a face that waits: the one behind it in its list, as -2 - face; else as it is returned.
  const across = new Int32Array(FACES * count)
  const waiting = new Int32Array(pointCount).fill(NONE)

  let paired = 0
  for (let cell = 0; cell < count; ++cell) {
    for (let face = 0; face < FACES; ++face) {
      const own = FACES * cell + face
      const first = 8 * cell
      let a = cells[first + (LOOPS[4 * face] as number)] as number
      let b = cells[first + (LOOPS[4 * face + 1] as number)] as number
      let c = cells[first + (LOOPS[4 * face + 2] as number)] as number
      let d = cells[first + (LOOPS[4 * face + 3] as number)] as number
      const least = Math.min(a, b, c, d)
      // Turned until a or b is the least, and by half a turn if it is c or d.
      if (c === least || d === least) {
        const [e, f] = [a, b]
        a = c
        b = d
        c = e
        d = f
      }
      if (a !== least) {
        const e = a
        a = b
        b = c
        c = d
        d = e
      }

      let before = NONE
      let other = waiting[a] as number
      while (other !== NONE && !isLoop(cells, other, a, b, c, d)) {
        before = other
        other = -2 - (across[other] as number)
      }
      if (other === NONE) {
        across[own] = -2 - (waiting[a] as number)
        waiting[a] = own
      } else {
        const behind = across[other] as number
        if (before === NONE) waiting[a] = -2 - behind
        else across[before] = behind
        across[own] = other
        across[other] = own
        paired += 2
      }
    }
    if (cell % CELLS_A_STEP === CELLS_A_STEP - 1) onProgress?.(cell + 1)
  }
  return { across, boundary: boundaryOf(across, FACES * count - paired) }
}

/** True if a face has these points in this cyclic order, either way round. */
function isLoop(cells: Uint32Array, face: number, a: number, b: number, c: number, d: number): boolean {
  const cell = (face / FACES) | 0
  const loop = 4 * (face - FACES * cell)
  const p = cells[8 * cell + (LOOPS[loop] as number)]
  const q = cells[8 * cell + (LOOPS[loop + 1] as number)]
  const r = cells[8 * cell + (LOOPS[loop + 2] as number)]
  const s = cells[8 * cell + (LOOPS[loop + 3] as number)]
  return (
    (p === a && r === c && ((q === b && s === d) || (q === d && s === b))) ||
    (q === a && s === c && ((p === b && r === d) || (p === d && r === b))) ||
    (r === a && p === c && ((q === b && s === d) || (q === d && s === b))) ||
    (s === a && q === c && ((p === b && r === d) || (p === d && r === b)))
  )
}

function boundaryOf(across: Int32Array, count: number): Uint32Array<ArrayBuffer> {
  const boundary = new Uint32Array(count)
  let found = 0
  for (let face = 0; face < across.length; ++face) {
    if ((across[face] as number) >= 0) continue
    across[face] = NONE
    boundary[found++] = face
  }
  return boundary
}
