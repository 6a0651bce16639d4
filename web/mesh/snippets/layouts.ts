/**
 * 24 numbers without more may be eight points one after the other, or eight x, then eight y, then eight z. Where the usual reading has not
 * one element with J > 0 at its corners, and the other has nothing else, it is the other.
 */
import { digitRows } from '../digit-rows'
import { inRowsOf, type NumberTable, transposed, widthOf } from './number-table'

const EIGHT = 8
const COORDINATES = 24
/** The ends of the three edges at each vertex, in the order of a right-handed frame. */
const NEIGHBOURS = digitRows('134 205 316 027 750 461 572 643')

type Points = readonly (readonly number[])[]

/** The points of the table in the other layout, if they are likelier so; else null. */
export function likelierLayout(points: Points, table: NumberTable): Points | null {
  const other = otherLayout(table)
  if (other === null || other.length !== points.length || table.header !== null) return null
  if (inRowsOf(points, EIGHT).some(hasPositiveCorners)) return null
  return inRowsOf(other, EIGHT).every(hasPositiveCorners) ? other : null
}

export function hasPositiveCorners(element: Points): boolean {
  return NEIGHBOURS.every((_, v) => cornerDeterminant(element, v) > 0)
}

/** The corners at which J has the same sign, + or -, whichever has more. */
export function alikeCorners(element: Points): number {
  const signs = NEIGHBOURS.map((_, v) => Math.sign(cornerDeterminant(element, v)))
  return Math.max(...[1, -1].map(sign => signs.filter(own => own === sign).length))
}

function otherLayout(table: NumberTable): Points | null {
  const { rows } = table
  const width = widthOf(table)
  if (width === COORDINATES) return rows.flatMap(row => transposed(inRowsOf(row, EIGHT)))
  return rows.length === 3 && width === EIGHT ? inRowsOf(rows.flat(), 3) : null
}

function cornerDeterminant(element: Points, v: number): number {
  const [px = 0, py = 0, pz = 0] = element[v] ?? []
  const [a, b, c] = (NEIGHBOURS[v] ?? []).map(n => {
    const [x = 0, y = 0, z = 0] = element[n] ?? []
    return [x - px, y - py, z - pz] as const
  })
  if (a === undefined || b === undefined || c === undefined) return 0
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}
