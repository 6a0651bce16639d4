/** The cells around one: what moves with its vertices. */

import type { Neighbours } from '../mesh/neighbours'
import { verticesOf } from '../mesh/vertices-of'
import { faces } from '../model/hexahedron'
import type { Movement } from './movement'
import { cellsWith } from './recheck'
import type { Survey } from './survey'
import type { Around, CellAround } from './survey-jobs'

const VERTICES = [0, 1, 2, 3, 4, 5, 6, 7] as const

/** Null as long as it is not known which cells share a face: the boundary is not, either. */
export function aroundOf(survey: Survey, movement: Movement, cell: number): Around | null {
  if (survey.join(0) < 1) return null
  const { mesh } = survey.check
  const points = VERTICES.map(v => mesh.cells[8 * cell + v] as number)
  const boundary = boundaryPoints(survey.faced.neighbours, mesh.cells, mesh.points.length / 3)
  const cells = Array.from(
    cellsWith(mesh, points),
    (own): CellAround => ({
      row: survey.detail(own).row,
      vertices: verticesOf(mesh, own),
      shared: VERTICES.map(v => points.indexOf(mesh.cells[8 * own + v] as number)),
    }),
  )
  return {
    points,
    onBoundary: VERTICES.filter(v => boundary[points[v] as number] === 1),
    moved: VERTICES.filter(v => movement.isMoved(points[v] as number)),
    cells,
  }
}

const known = new WeakMap<Neighbours, Uint8Array>()

/** 1 for each point of a face that is not shared by two cells. */
function boundaryPoints(neighbours: Neighbours, cells: Uint32Array, pointCount: number): Uint8Array {
  const before = known.get(neighbours)
  if (before) return before
  const found = new Uint8Array(pointCount)
  for (const face of neighbours.boundary) {
    const cell = Math.floor(face / faces.length)
    for (const v of faces[face % faces.length]?.vertices ?? []) found[cells[8 * cell + v] as number] = 1
  }
  known.set(neighbours, found)
  return found
}
