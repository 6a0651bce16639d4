/** Tables of numbers that are cells, and the columns of a cell's nodes. */
import type { MeshBuilder } from '../mesh-builder'
import { alikeCorners } from './layouts'
import {
  areAllIntegers,
  areDistinct,
  column,
  inRowsOf,
  isConstant,
  type NumberTable,
  transposed,
  widthOf,
} from './number-table'
import { EIGHT, knownIds, type PointSet } from './point-set'
import { CELL_NAME, HEXAHEDRON_NAME, isNamed, NO_CELL_NAME, OTHER_CELL_NAME } from './table-names'

/** Cells of one table: of eight nodes, or of others. */
export interface CellRows {
  readonly table: NumberTable
  readonly hexahedra: readonly (readonly number[])[]
  readonly others: readonly (readonly number[])[]
  readonly ids: readonly number[] | null
}

/** True if a table names points of `set`: by its name, or if all its integers are such. */
export function isCells(table: NumberTable, set: PointSet | null, mayBePoints: boolean): boolean {
  if (set === null || set.table === table || !areAllIntegers(table)) return false
  if (table.rows.length === 1 && (table.rows[0]?.length ?? 0) < 2) return false
  const isCalledSo = isNamed(table, CELL_NAME) && !isNamed(table, NO_CELL_NAME)
  if (isCalledSo && !mayBePoints) return true
  // Integers under points that are written with decimals are no points if all of them are numbers of points.
  if (mayBePoints && !isCalledSo && areAllIntegers(set.table)) return false
  const width = widthOf(table)
  if (width < 3) return isCalledSo
  const isKnown = knownIds(set)
  const { rows } = table
  if (prefixedCells(rows.flat()) !== null) return true
  const isNode = (row: readonly number[]) => row.every(isKnown) && areDistinct(row)
  if (rows.length === EIGHT && width !== EIGHT && transposed(rows).every(isNode)) return true
  const isCell = (row: readonly number[]) => isNode(row.slice(-Math.min(4, row.length)))
  // If points are left out, some cells name missing ones.
  if (set.table.isCut) return width >= EIGHT && rows.some(isCell)
  // A collapsed cell repeats nodes.
  if (width === EIGHT && 2 * rows.filter(isCell).length > rows.length) return rows.every(row => row.every(isKnown))
  return rows.every(isCell)
}

const VTK_SIZES = new Set([3, 4, 5, 6, 8, 10, 20, 27])

/** VTK's way: how many nodes, then these, for each cell. Null if the numbers are no such list. */
function prefixedCells(values: readonly number[]): number[][] | null {
  const cells: number[][] = []
  let at = 0
  while (at < values.length) {
    const size = values[at] as number
    if (!VTK_SIZES.has(size)) return null
    cells.push(values.slice(at + 1, at + 1 + size))
    at += size + 1
  }
  return at === values.length && cells.length > 0 && cells.every(areDistinct) ? cells : null
}

/** The nodes of each cell, wherever they stand in the rows. */
export function cellRowsOf(table: NumberTable, set: PointSet, builder: MeshBuilder): CellRows {
  const hexahedra = (rows: readonly (readonly number[])[], ids: readonly number[] | null = null): CellRows => ({
    table,
    hexahedra: rows,
    others: [],
    ids,
  })
  const width = widthOf(table)
  const { rows } = table
  if (isNamed(table, OTHER_CELL_NAME)) return { table, hexahedra: [], others: rows, ids: null }
  const isList = rows.length === 1 && width > EIGHT
  const flat = rows.flat()
  const isFlat = isList && width % EIGHT === 0 && inRowsOf(flat, EIGHT).every(areDistinct)
  const prefixed = prefixedCells(flat)
  if (prefixed !== null && isFlat && isList)
    return builder.refuse(
      `${width} integers under the points may be cells of eight, or each cell after its number of nodes.`,
    )
  if (prefixed !== null) {
    const others = prefixed.filter(row => row.length !== EIGHT)
    return { table, hexahedra: prefixed.filter(row => row.length === EIGHT), others, ids: null }
  }
  if (width === EIGHT) return hexahedra(rows)
  if (rows.length === EIGHT && transposed(rows).every(areDistinct)) return hexahedra(transposed(rows))
  if (isFlat && isNamed(table, CELL_NAME)) return hexahedra(inRowsOf(flat, EIGHT))
  if (width < EIGHT || width > WIDEST_ROW) return { table, hexahedra: [], others: rows, ids: null }
  const from = nodesFrom(table, width, set, builder)
  const first = column(table, 0)
  return hexahedra(
    rows.map(row => row.slice(from, from + EIGHT)),
    from > 0 && areDistinct(first) ? first : null,
  )
}

/** Corners with J of the same sign, in all rows, if their eight nodes begin at a column: nodes that are no cell's have few. */
function alikeCornersFrom({ rows }: NumberTable, from: number, { ids, points }: PointSet): number {
  const eights = rows.map(row => row.slice(from, from + EIGHT))
  const base = eights.some(row => row.includes(0)) ? 0 : 1
  const at = ids === null ? null : new Map(ids.map((id, i) => [id, i]))
  const pointOf = (id: number) => points[at === null ? id - base : (at.get(id) ?? -1)] ?? []
  return eights.reduce((sum, row) => sum + alikeCorners(row.map(pointOf)), 0)
}

/** Columns that a row of a cell may have: its id, type, tags and eight nodes. */
const WIDEST_ROW = 14

/** The column at which the eight nodes of a row begin. */
function nodesFrom(table: NumberTable, width: number, set: PointSet, builder: MeshBuilder): number {
  const isKnown = knownIds(set)
  const last = width - EIGHT
  const isCut = set.table.isCut || table.isCut
  const fits = (from: number) =>
    table.rows[isCut ? 'some' : 'every'](row => {
      const eight = row.slice(from, from + EIGHT)
      return eight.every(isKnown) && areDistinct(eight)
    })
  const possible = Array.from({ length: last + 1 }, (_, from) => from).filter(fits)
  const [only] = possible
  const isReference = table.rows.length > 1 && isConstant(column(table, width - 1))
  if (possible.length === 1 && only !== undefined) return only
  if (possible.length > 1) {
    const alike = possible.map(from => alikeCornersFrom(table, from, set))
    const most = Math.max(...alike)
    const at = alike.indexOf(most)
    if (alike.lastIndexOf(most) === at) return possible[at] as number
  }
  if (last === 1 && isReference && (possible.length === 0 || possible.includes(0))) return 0
  const leading = Array.from({ length: last }, (_, c) => column(table, c))
  const areTags = leading.every(values => isConstant(values) || areDistinct(values))
  if (
    areTags &&
    !isReference &&
    (possible.length === 0 ? last === 1 && isNamed(table, HEXAHEDRON_NAME) : possible.includes(last))
  )
    return last
  return builder.refuse(
    `under the points stands a table of ${width} integers a row, and which eight of them are the nodes of a cell is not clear.`,
  )
}
