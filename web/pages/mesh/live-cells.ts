/** The cells around the chosen one as a vertex moves: what the list says of them, decided on the page, a fraction of a millisecond for eight. */
import type { Core, Report } from '../../core/report'
import type { Vec3 } from '../../model/hexahedron'
import type { Around, CellAround, Row } from '../../survey/survey-jobs'

interface LiveCell extends Omit<CellAround, 'vertices' | 'row'> {
  row: Row
  vertices: number[]
}

export class LiveCells {
  readonly #core: Core
  readonly #cells: readonly LiveCell[]

  constructor(core: Core, { cells }: Around) {
    this.#core = core
    this.#cells = cells.map(cell => ({ ...cell, vertices: [...cell.vertices] }))
  }

  /** The rows of the cells with one of these vertices of the chosen cell, at their new places. */
  move(places: ReadonlyMap<number, Vec3>): readonly Row[] {
    return this.#cells
      .filter(({ shared }) => shared.some(v => places.has(v)))
      .map(cell => {
        for (const [own, v] of cell.shared.entries()) {
          const place = places.get(v)
          if (place) cell.vertices.splice(3 * own, 3, ...place)
        }
        const result = cell.row.why === null ? this.#core.analyze(cell.vertices) : null
        if (result?.ok) cell.row = rowOf(cell.row, result.value)
        return cell.row
      })
  }

  /** Those to draw around the chosen cell: with a face of it, and any other that is invalid. */
  drawnAround(chosen: number): { readonly vertices: readonly number[]; readonly isInvalid: boolean }[] {
    return this.#cells
      .map(({ row, vertices, shared }) => ({
        vertices,
        isInvalid: row.standing === 'invalid',
        isDrawn:
          row.cell !== chosen && (row.standing === 'invalid' || shared.filter(v => v >= 0).length >= FACE_VERTICES),
      }))
      .filter(({ isDrawn, vertices }) => isDrawn && vertices.every(Number.isFinite))
  }
}

const FACE_VERTICES = 4

/** As the mesh's worker has it. */
export function rowOf(before: Row, report: Report): Row {
  return {
    ...before,
    standing: report.valid ? 'valid' : 'invalid',
    class: report.class,
    relativeMinimum: report.relativeMinimum ?? Number.NaN,
    minimum: { value: report.boundaryMinimum, exponent: report.exponent },
    volume: { value: report.volume, exponent: report.volumeExponent },
    acceptedBy: report.checks.filter(({ passes }) => passes).map(({ id }) => id),
  }
}
