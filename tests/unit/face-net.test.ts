import { describe, expect, it } from 'vitest'
import { edgeVertices, faces, vertexReference } from '../../web/model/hexahedron'
import {
  edgePlaces,
  NET_COLUMNS,
  NET_ROWS,
  netCells,
  netCorners,
  placeOnFace,
  placesOf,
  pointInCell,
} from '../../web/panels/face-maps/net'

const CORNERS = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
] as const

const vertexAt = (face: number, x: number, y: number) =>
  vertexReference.findIndex(point => point.every((value, axis) => value === pointInCell(face, x, y)[axis]))

describe('the net of the cube', () => {
  it('has six cells of their own in 4 x 3', () => {
    const taken = new Set(netCells.map(({ column, row }) => `${column} ${row}`))
    expect(taken.size).toBe(faces.length)
    for (const { column, row } of netCells) {
      expect(column).toBeLessThan(NET_COLUMNS)
      expect(row).toBeLessThan(NET_ROWS)
    }
  })

  it('has each face’s own vertices at the corners of its cell, and its own numbers there', () => {
    faces.forEach(({ vertices }, face) => {
      const { column, row } = netCells[face] as (typeof netCells)[number]
      const found = CORNERS.map(([x, y]) => vertexAt(face, x, y))
      expect(found.toSorted()).toEqual(vertices.toSorted())
      CORNERS.forEach(([x, y], i) => {
        const numbers = netCorners.filter(corner => corner.x === column + x && corner.y === row + y)
        expect(numbers.map(({ vertex }) => vertex)).toEqual([found[i]])
      })
    })
  })

  it('lets neighbouring cells share the points of their edge', () => {
    let shared = 0
    netCells.forEach((a, i) => {
      netCells.forEach((b, j) => {
        const isRight = b.column === a.column + 1 && b.row === a.row
        const isBelow = b.column === a.column && b.row === a.row + 1
        if (!isRight && !isBelow) return
        shared++
        for (const along of [0, 0.25, 1]) {
          const ours = isRight ? pointInCell(i, 1, along) : pointInCell(i, along, 1)
          const theirs = isRight ? pointInCell(j, 0, along) : pointInCell(j, along, 0)
          expect(ours).toEqual(theirs)
        }
      })
    })
    expect(shared).toBe(5)
  })

  it('is seen from outside: x to the right, y up, and out of the page towards the reader', () => {
    faces.forEach(({ axis, side }, face) => {
      const [at, right, up] = [pointInCell(face, 0, 1), pointInCell(face, 1, 1), pointInCell(face, 0, 0)]
      const x = right.map((value, i) => value - (at[i] as number))
      const y = up.map((value, i) => value - (at[i] as number))
      const [j, k] = [(axis + 1) % 3, (axis + 2) % 3]
      const outwards = (x[j] as number) * (y[k] as number) - (x[k] as number) * (y[j] as number)
      expect(outwards).toBe(side === 1 ? 1 : -1)
    })
  })

  it('finds points where they are drawn', () => {
    faces.forEach((_, face) => {
      const { column, row } = netCells[face] as (typeof netCells)[number]
      expect(placeOnFace(face, pointInCell(face, 0.25, 0.75))).toEqual({ x: column + 0.25, y: row + 0.75 })
    })
    expect(placesOf([0.5, 0.5, 0.5])).toEqual([])
    expect(placesOf([0.5, 0.25, 1])).toHaveLength(1)
    expect(netCorners).toHaveLength(14)
    for (const { towards } of netCorners) expect([Math.abs(towards.x), Math.abs(towards.y)]).toEqual([1, 1])
  })

  it('has every edge on both of its faces', () => {
    edgeVertices.forEach((_, edge) => {
      expect(edgePlaces(edge)).toHaveLength(2)
    })
  })
})
