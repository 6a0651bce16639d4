/** Best places on the page Mesh: the cells around a vertex, what holds it, and jacdet over the volume there. */
import { describe, expect, it } from 'vitest'
import { bestPlaces, certificateOf, limitingCells, proved, starOf } from '../../web/pages/mesh/vertex-star'
import type { Around, CellAround, Row } from '../../web/survey/survey-jobs'
import { checked } from './certificate-checker'
import { core } from './core-fixtures'
import { cellsAt, MIDDLE, noisyStars, type PointStar, presentOf, repairCore } from './stars'

/** What the survey says of the first cell of a star, whose vertex 6 is the middle one. */
function aroundOf(star: PointStar): Around {
  const points = Array.from({ length: 8 }, (_, v) => star.cells[v] as number)
  const cells = cellsAt(star, presentOf(star)).map((vertices, cell): CellAround => {
    const report = core.analyze(vertices)
    if (!report.ok) throw new Error(report.error.message)
    const row = { cell, id: `c${cell}`, relativeMinimum: report.value.relativeMinimum ?? Number.NaN } as Row
    const shared = Array.from({ length: 8 }, (_, v) => points.indexOf(star.cells[8 * cell + v] as number))
    return { row, vertices, shared }
  })
  return { points, onBoundary: [0, 1, 2, 3, 4, 5, 7], moved: [], cells }
}

describe('the best place of a vertex of a mesh', () => {
  const around = aroundOf(noisyStars(41, 0.1, 0.6)())
  const places = bestPlaces(repairCore, around)
  const held = proved(places[6] as NonNullable<(typeof places)[number]>)

  it('is for all cells that have the vertex', () => {
    expect(around.points[6]).toBe(MIDDLE)
    expect(places.map(own => own?.cells.length)).toEqual([1, 2, 4, 2, 2, 4, 8, 4])
    expect(starOf(around, 6).star.moving).toEqual([[6], [7], [5], [4], [2], [3], [1], [0]])
  })

  it('is held by points at which jacdet over the volume is the bound', () => {
    expect(held.proof).toMatchObject({ isProved: true, isImpossible: false })
    expect(held.holds.length).toBeGreaterThan(1)
    expect(held.holds.reduce((sum, { weight }) => sum + (weight as number), 0)).toBeCloseTo(1, 12)
    for (const { there, now } of held.holds) {
      expect(there).toBeCloseTo(held.place.value, 4)
      expect(now).toBeGreaterThanOrEqual((held.place.presentRelativeMinimum as number) - 1e-12)
    }
    expect(held.present).toEqual(around.cells[0]?.vertices.slice(18, 21))
  })

  it('names the cells that limit it now', () => {
    const least = Math.min(...held.cells.map(({ row }) => row.relativeMinimum))
    expect(limitingCells(held).map(({ row }) => row.relativeMinimum)).toEqual([least])
    expect(least).toBe(held.place.presentRelativeMinimum)
  })

  it('has a proof that holds, with the names of the cells', () => {
    const text = certificateOf(held, 'vertex 6') as string
    expect(checked(text).status).toBe(0)
    const names = JSON.parse(text)[0].cells.map(({ name }: { name: string }) => name)
    expect(names).toEqual([...new Set(held.holds.map(({ cell }) => cell?.row.id))].sort())
  })

  it('moves nodes of a cell that are the same point together', () => {
    const [first] = around.cells as readonly [CellAround]
    const points = around.points.with(3, around.points[0] as number)
    const wedge = { ...first, shared: first.shared.with(3, 0) }
    const star = starOf({ ...around, points, cells: [wedge] }, 3)
    expect(star.star.moving).toEqual([[0, 3]])
  })
})
