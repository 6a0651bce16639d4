/** Cells in which vertices lie at the same position, whatever their ids. */

/** Vertices 0 and 6, 1 and 7, 2 and 4, 3 and 5. */
const DIAGONALS = [0, 6, 1, 7, 2, 4, 3, 5]
const PAIRS = Array.from({ length: 64 }, (_, i) => [i >> 3, i & 7] as const)
  .filter(([a, b]) => a < b)
  .flat()

interface Cells {
  readonly points: Float64Array
  /** Eight indices a cell; without, each has its own eight points. */
  readonly cells: Uint32Array | null
  readonly valid: Uint8Array
}

/**
 * Puts 1 for each cell with coincident vertices, else 0. `valid` is the verdict of each cell and saves most of the work: where the
 * ends of an edge or of a face's diagonal coincide, two columns of the jacobian at a vertex are dependent and jacdet is 0
 * there, so in a valid cell only the four diagonals through the middle are left to compare.
 */
export function putCoincident({ points, cells, valid }: Cells, found: Uint8Array): void {
  for (let cell = 0; cell < found.length; ++cell) {
    const pairs = valid[cell] === 1 ? DIAGONALS : PAIRS
    found[cell] = 0
    for (let i = 0; i < pairs.length; i += 2) {
      const [v, w] = [8 * cell + (pairs[i] as number), 8 * cell + (pairs[i + 1] as number)]
      const a = 3 * (cells ? (cells[v] as number) : v)
      const b = 3 * (cells ? (cells[w] as number) : w)
      if (points[a] !== points[b] || points[a + 1] !== points[b + 1] || points[a + 2] !== points[b + 2]) continue
      found[cell] = 1
      break
    }
  }
}
