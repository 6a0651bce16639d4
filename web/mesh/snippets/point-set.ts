/** Tables of numbers that are points, and their columns of x, y and z. */
import type { MeshBuilder } from '../mesh-builder'
import { shown } from '../text-cursor'
import {
  areAllIntegers,
  areDistinct,
  column,
  countsUp,
  inRowsOf,
  isConstant,
  type NumberTable,
  transposed,
  widthOf,
} from './number-table'
import { CELL_NAME, isNamed, LIST_MAKER, NO_CELL_NAME, POINT_NAME, TRIANGLE_NAME } from './table-names'

/** Points, with what the text calls them. */
export interface PointSet {
  readonly points: readonly (readonly number[])[]
  readonly ids: readonly number[] | null
  readonly labels: readonly (string | null)[] | null
  readonly table: NumberTable
}

export const EIGHT = 8

const COORDINATES = 24

/** Three lists of equal length that are called x, y and z are one of points. */
export function withAxesJoined(tables: readonly NumberTable[]): NumberTable[] {
  const joined: NumberTable[] = []
  for (const table of tables) {
    joined.push(table)
    const three = joined.slice(-3)
    const nameOf = ({ names }: NumberTable) => names.findLast(name => !LIST_MAKER.test(name)) ?? ''
    const ends = three.map(own => nameOf(own).toLowerCase().replace(/s$/, '').at(-1)).join('')
    const [width] = three.map(widthOf)
    const areAlike = three.every(other => other.rows.length === 1 && widthOf(other) === width)
    if (ends !== 'xyz' || !areAlike || (width ?? 0) < EIGHT) continue
    joined.splice(-3, 3, {
      ...table,
      names: ['points'],
      rows: transposed(three.map(({ rows }) => rows[0] as readonly number[])),
      integers: [false, false, false],
      isCut: three.some(({ isCut }) => isCut),
      digits: Math.max(...three.map(({ digits }) => digits)),
    })
  }
  return joined
}

/** A list of different integers, as many as the points in the list behind it, has their ids, if cells follow. */
export function withIdsJoined(tables: readonly NumberTable[]): readonly NumberTable[] {
  const i = tables.findIndex(table => numberCount(table) >= COORDINATES)
  const [before, points] = [tables[i - 1], tables[i]]
  if (before === undefined || points === undefined || before.rows.length !== 1 || !areAllIntegers(before)) return tables
  const ids = before.rows[0] as readonly number[]
  const areCellsBehind = tables.slice(i + 1, i + 4).some(other => areAllIntegers(other) && numberCount(other) >= EIGHT)
  if (numberCount(points) !== 3 * ids.length || points.ids !== null || !areDistinct(ids) || !areCellsBehind)
    return tables
  const joined = { ...points, rows: inRowsOf(points.rows.flat(), 3), integers: [false, false, false], ids }
  return [...tables.slice(0, i - 1), joined, ...tables.slice(i + 1)]
}

function numberCount({ rows }: NumberTable): number {
  return rows.reduce((count, row) => count + row.length, 0)
}

/** The points that a table may be; null if it is no table of points. */
export function pointSetOf(table: NumberTable, builder: MeshBuilder): PointSet | null {
  const set = anyPointSetOf(table, builder)
  return set === null || set.points.length < EIGHT ? null : set
}

function anyPointSetOf(table: NumberTable, builder: MeshBuilder): PointSet | null {
  if (isCellsAlone(table)) return null
  const width = widthOf(table)
  const count = table.rows.length
  const set = (points: readonly (readonly number[])[], ids: readonly number[] | null = null): PointSet => ({
    points,
    ids,
    labels: points.length === count ? table.labels : null,
    table,
  })
  if (table.header !== null) {
    const elements = titledElements(table.header)
    if (elements !== null) {
      const points = table.rows.flatMap(row => elements.map(columns => columns.map(c => row[c] as number)))
      const id = /^(?:[xyz]|p\d)/i.test(table.header[0] ?? '') ? null : column(table, 0)
      const labels = id && areDistinct(id) ? id.flatMap(own => Array.from({ length: EIGHT }, () => String(own))) : null
      return { points, ids: null, labels, table }
    }
    const columns = titledColumns(table.header)
    if (columns !== null) {
      const id = table.header.findIndex(title => /\b(?:id|node|index|no|nr|number|#)\b/i.test(title))
      const ids = id >= 0 && !columns.includes(id) ? column(table, id) : null
      const points = table.rows.map(row => columns.map(c => row[c] as number))
      return set(points, ids !== null && areDistinct(ids) ? ids : null)
    }
    const polar = table.header.find(title => POLAR.test(title))
    if (polar !== undefined) return builder.refuse(`a column is called ${shown(polar)}: Cartesian x, y and z are read.`)
    if (areComponents(table.header)) return null
  }
  if (width === 3) return set(table.rows, table.ids !== null && areDistinct(table.ids) ? table.ids : null)
  if (count === 3 && width >= EIGHT && (width % COORDINATES !== 0 || isNamed(table, POINT_NAME))) {
    // Coordinates of eight points repeat, numbers of nodes do not.
    const areCells = width === EIGHT && areAllIntegers(table) && table.rows.some(areDistinct)
    return areCells && !isNamed(table, POINT_NAME) ? null : set(transposed(table.rows))
  }
  if (width > 0 && width % COORDINATES === 0) return set(inRowsOf(table.rows.flat(), 3))
  if (count === 1 && width % 3 === 0 && width > 3 && isNamed(table, POINT_NAME))
    return set(inRowsOf(table.rows.flat(), 3))
  if (width === COORDINATES + 1 && table.integers[0] && areDistinct(column(table, 0))) {
    const points = table.rows.flatMap(row => inRowsOf(row.slice(1), 3))
    const labels = table.rows.flatMap(row => Array.from({ length: EIGHT }, () => String(row[0])))
    return { points, ids: null, labels, table }
  }
  if (width === 4 || width === 5) return numberedPoints(table, width, set, builder)
  return null
}

/** Rows of four or five: an index before the coordinates, an element's and an index, or a reference after them. */
function numberedPoints(
  table: NumberTable,
  width: 4 | 5,
  set: (points: readonly (readonly number[])[], ids?: readonly number[] | null) => PointSet,
  builder: MeshBuilder,
): PointSet | null {
  if (table.rows.length < EIGHT) return null
  const columns = Array.from({ length: width }, (_, c) => column(table, c))
  const [first, second] = columns as [number[], number[]]
  const last = columns[width - 1] as number[]
  const isId = (values: readonly number[], c: number) => table.integers[c] === true && isDistinctInEights(values)
  // Points of four coordinates end with 1.
  const isReference = (table.integers[width - 1] || last[0] === 1) === true && (isConstant(last) || countsUp(last))
  const from = (c: number) => table.rows.map(row => row.slice(c, c + 3))
  const named = (ids: readonly number[]) => (areDistinct(ids) ? ids : null)
  if (width === 4) {
    const hasId = isId(first, 0)
    if (hasId && !isReference) return set(from(1), named(first))
    if (isReference && !(hasId && countsUp(first))) return set(from(0), countsUp(last) ? last : null)
    if (areAllIntegers(table) && !table.labels?.some(label => label !== null)) return null
  } else {
    if (
      isId(first, 0) &&
      isReference &&
      !(table.integers[1] && isDistinctInEights(second) && isConstantInEights(first))
    )
      return set(from(1), named(first))
    if (table.integers[0] && isConstantInEights(first) && isId(second, 1)) {
      const labels = first.map(String)
      return { points: from(2), ids: named(second), labels, table }
    }
    // FEAP and Z88 have a number of their own behind that of the node, Gmsh's scripts a size before it.
    if (table.integers[1] && isConstant(second) && isId(first, 0)) return set(from(2), named(first))
    if (isReference && isConstant(columns[3] as number[])) return set(from(0), named(last))
    if (areAllIntegers(table)) return null
  }
  if (table.rows.length % EIGHT !== 0) return null
  return builder.refuse(
    `a table of ${table.rows.length} rows has ${width} columns, and nothing says which three of them are x, y and z.`,
  )
}

/** An index may begin anew with each element. */
function isDistinctInEights(values: readonly number[]): boolean {
  if (areDistinct(values)) return true
  return values.length % EIGHT === 0 && inRowsOf(values, EIGHT).every(areDistinct)
}

function isConstantInEights(values: readonly number[]): boolean {
  return values.length % EIGHT === 0 && inRowsOf(values, EIGHT).every(isConstant)
}

/** True for "UX UY UZ" and their kin: the columns of a vector that is no place. */
export function areComponents(header: readonly string[]): boolean {
  const titles = header.map(title => title.toLowerCase())
  const own = titles.find(title => /^(?:[adefmnrstuvw]|rf|rot)_?x$/.test(title))?.slice(0, -1)
  return own !== undefined && [`${own}y`, `${own}z`].every(title => titles.includes(title))
}

const POLAR = /^(?:r|rho|radius|theta|phi|lat|latitude|lon|longitude|[θφϕρ])$/i

const AXES = ['x', 'y', 'z'] as const

/** The columns that their titles call x, y and z: "X", "x [m]", "coord_y", "Points:0", "Points_0"; null where there are not three. */
export function titledColumns(header: readonly string[]): readonly number[] | null {
  const titles = header.map(title => title.trim().toLowerCase().slice(0, 40))
  const tests: readonly ((title: string, axis: number) => boolean)[] = [
    (title, axis) => title === `points:${axis}` || title === `points_${axis}` || title === `points:${AXES[axis]}`,
    (title, axis) => title === `points_${AXES[axis]}`,
    (title, axis) => title.replace(/[([{].*$/, '').trim() === AXES[axis],
    (title, axis) =>
      title.length < 16 && /^(?:coord|pos|point|node|vert)/.test(title) && title.endsWith(AXES[axis] as string),
    (title, axis) =>
      title === `${AXES[axis]}0` || title === `${AXES[axis]}-coordinate` || title === `${AXES[axis]} coordinate`,
    (title, axis) => /^(?:coord|pos|point)/.test(title) && new RegExp(`[^\\d]${axis}$`).test(title),
  ]
  for (const test of tests) {
    const found = AXES.map((_, axis) => titles.findIndex(title => test(title, axis)))
    if (found.every(c => c >= 0) && new Set(found).size === 3) return found
  }
  return null
}

/** Columns of each point by 24 titles, "x0" to "z7", "p1_y", "x_3" and their kin, or null. */
function titledElements(header: readonly string[]): number[][] | null {
  const points = new Map<number, number[]>()
  for (const [c, title] of header.entries()) {
    const name = title.trim().toLowerCase()
    const [, axis = '', number = ''] = /^([xyz])[_ ]?\[?(\d{1,2})\]?$/.exec(name) ?? []
    const [, point = '', last = ''] = /^[a-z]{1,8}[_ ]?(\d{1,2})[_. ]?([xyz])$/.exec(name) ?? []
    if (axis === '' && last === '') continue
    const own = points.get(Number(number || point)) ?? []
    own['xyz'.indexOf(axis || last)] = c
    points.set(Number(number || point), own)
  }
  const ordered = [...points].sort(([a], [b]) => a - b).map(([, columns]) => columns)
  return ordered.length === EIGHT && ordered.every(own => own.length === 3 && !own.includes(undefined as never))
    ? ordered
    : null
}

/** Integers that their name says are cells, so they are no points. */
function isCellsAlone(table: NumberTable): boolean {
  const name = table.names.at(-1) ?? ''
  const pattern = widthOf(table) === 3 ? TRIANGLE_NAME : CELL_NAME
  return areAllIntegers(table) && !isNamed(table, NO_CELL_NAME) && pattern.test(name) && !POINT_NAME.test(name)
}

/** Sets of ids, made once however many tables are looked at. */
const knownOf = new WeakMap<readonly number[], ReadonlySet<number>>()

/** True for a number that a point may have: by the ids of the text, or counted from 0 or 1. */
export function knownIds({ ids, points }: PointSet): (id: number) => boolean {
  if (ids === null) return id => id >= 0 && id <= points.length
  const known = knownOf.get(ids) ?? new Set(ids)
  knownOf.set(ids, known)
  return id => known.has(id)
}
