/** Cells in which vertices lie at the same position, whatever their ids. */

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
  const at = (cell: number, vertex: number) => 3 * (cells ? (cells[8 * cell + vertex] as number) : 8 * cell + vertex)
  const areOne = (a: number, b: number) =>
    points[a] === points[b] && points[a + 1] === points[b + 1] && points[a + 2] === points[b + 2]
  for (let cell = 0; cell < found.length; ++cell) {
    if (valid[cell] === 1) {
      const isOne =
        areOne(at(cell, 0), at(cell, 6)) ||
        areOne(at(cell, 1), at(cell, 7)) ||
        areOne(at(cell, 2), at(cell, 4)) ||
        areOne(at(cell, 3), at(cell, 5))
      found[cell] = Number(isOne)
      continue
    }
    found[cell] = 0
    for (let i = 0; i < PAIRS.length && found[cell] === 0; i += 2)
      found[cell] = Number(areOne(at(cell, PAIRS[i] as number), at(cell, PAIRS[i + 1] as number)))
  }
}
