/**
 * What tables of numbers mean: which are points, which are cells that name them. Cells that are there are used, or the text is refused;
 * only where there are none are points taken in their order, eight for each element, and then the order is not stated.
 */
import { hexahedronOfFaces } from '../hexahedron-of-faces'
import type { Mesh } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { printedDigits } from '../precision'
import { orderOfText } from '../snippet-text'
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

export interface Origin {
  readonly format: string
  readonly fileName: string
  /** Where the text comes from a program whose order of a cell's points is its own. */
  readonly hasOwnOrder?: boolean
}

/** Points, with what the text calls them. */
interface PointSet {
  readonly points: readonly (readonly number[])[]
  readonly ids: readonly number[] | null
  readonly labels: readonly (string | null)[] | null
  readonly table: NumberTable
}

const EIGHT = 8
const COORDINATES = 24

const POINT_NAME = /point|coord|vert|node|xyz|pos|corner|doflocs|^p$|\.p$|^x$/i
const NO_POINT_NAME = /normal|disp|velo|force|gradient|colou?r|uv|tangent|stress|strain|jacob|weight/i
const CELL_NAME =
  /cell|elem|conn|face|quad|tri|tet|hex|brick|topol|simpli|ien|lnods|index|indic|edge|prism|wedge|pyra|^t$|\.t$/i
const NO_CELL_NAME = /type|tag|material|region|flag|rank|colou?r|cell_?data|size|shape|count|offset/i
const HEXAHEDRON_NAME = /hex|brick|c3d8|q1|cube/i
const TRIANGLE_NAME = /tri|face|index|indic|simpli|^t$|\.t$/i
const OTHER_TYPES: readonly (readonly [RegExp, OtherCell])[] = [
  [/quad|face/i, 'quadrilateral'],
  [/tet/i, 'tetrahedron'],
  [/wedge|prism|penta/i, 'wedge'],
  [/pyra/i, 'pyramid'],
  [/tri/i, 'triangle'],
  [/line|edge|bar/i, 'line'],
]

/** The mesh that the tables are, null if they are none. Throws a MeshRefusal where they cannot be understood with certainty. */
export function meshOfTables(all: readonly NumberTable[], origin: Origin): Mesh | null {
  const tables = withAxesJoined(all)
  const builder = new MeshBuilder(origin.format, origin.fileName)
  const sets = tables.flatMap(table => pointSetOf(table, builder) ?? [])
  const parts = pairs(tables, sets, builder)
  if (parts.length > 0) {
    for (const { set, cells } of parts) addCells(set, cells, builder)
    if (origin.hasOwnOrder) {
      builder.isOrderStated = false
      builder.note('The nodes of each cell are taken in the order of the text.')
    }
  } else {
    refuseLeftCells(tables, sets, builder)
    const bare = sets.filter(({ table }) => !isNamed(table, NO_POINT_NAME))
    refuseMixedIntegers(bare, builder)
    if (addEights(bare, builder) === 0) return null
    builder.isOrderStated = false
    builder.note(orderOfText(builder.cellCount))
  }
  if (builder.cellCount === 0 && parts.length === 0) return null
  const digits = sets.reduce((most, { table }) => Math.max(most, table.digits), 0)
  const mesh = builder.mesh()
  const note = printedDigits(digits, mesh.points).note()
  return note === null ? mesh : { ...mesh, notes: [...mesh.notes, note] }
}

/** Three lists of equal length that are called x, y and z are one of points. */
function withAxesJoined(tables: readonly NumberTable[]): NumberTable[] {
  const joined: NumberTable[] = []
  for (const table of tables) {
    joined.push(table)
    const three = joined.slice(-3)
    const ends = three.map(({ names }) => (names.at(-1) ?? '').toLowerCase().replace(/s$/, '').at(-1)).join('')
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

/** Tables of integers beside one with decimals are no points, whatever they are. */
function refuseMixedIntegers(sets: readonly PointSet[], builder: MeshBuilder): void {
  const whole = sets.filter(({ table }) => areAllIntegers(table))
  // Coordinates repeat, numbers of nodes do not.
  const areIds = whole.some(({ points }) => areDistinct(points.slice(0, EIGHT).flat()))
  if (areIds || (whole.length > 0 && whole.length < sets.length))
    builder.refuse(
      'beside points with decimals stand tables of integers that may name them, but not in a way that is known.',
    )
}

/** Eight or more different integers on a row, which are nobody's coordinates, are cells that are not understood. */
function refuseLeftCells(tables: readonly NumberTable[], sets: readonly PointSet[], builder: MeshBuilder): void {
  if (sets.length === 0) return
  const ofPoints = new Set(sets.map(({ table }) => table))
  for (const table of tables) {
    const width = widthOf(table)
    if (ofPoints.has(table) || !areAllIntegers(table) || width < EIGHT || width > 28) continue
    if (!table.rows.every(row => areDistinct(row.slice(-EIGHT)) && row.every(id => id >= 0))) continue
    builder.refuse(
      `beside the points stands a table of ${width} integers a row that seems to name points, but not those that are there.`,
    )
  }
}

function isNamed({ names }: NumberTable, pattern: RegExp): boolean {
  return names.some(name => pattern.test(name))
}

/** The points that a table may be; null if it is no table of points. */
function pointSetOf(table: NumberTable, builder: MeshBuilder): PointSet | null {
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
    const columns = titledColumns(table.header)
    if (columns !== null) {
      const id = table.header.findIndex(title => /\b(?:id|node|index|no|nr|number|#)\b/i.test(title))
      const ids = id >= 0 && !columns.includes(id) ? column(table, id) : null
      const points = table.rows.map(row => columns.map(c => row[c] as number))
      return set(points, ids !== null && areDistinct(ids) ? ids : null)
    }
  }
  if (width === 3) return set(table.rows, table.ids !== null && areDistinct(table.ids) ? table.ids : null)
  if (count === 3 && width >= EIGHT && (width % COORDINATES !== 0 || isNamed(table, POINT_NAME)))
    return set(transposed(table.rows))
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
  const isReference = table.integers[width - 1] === true && (isConstant(last) || countsUp(last))
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

/** Integers that their name says are cells, so they are no points. */
function isCellsAlone(table: NumberTable): boolean {
  const name = table.names.at(-1) ?? ''
  const pattern = widthOf(table) === 3 ? TRIANGLE_NAME : CELL_NAME
  return areAllIntegers(table) && !isNamed(table, NO_CELL_NAME) && pattern.test(name) && !POINT_NAME.test(name)
}

interface Part {
  readonly set: PointSet
  readonly cells: readonly NumberTable[]
}

/** Cells with the points that they name: those before them, else those after. */
function pairs(tables: readonly NumberTable[], sets: readonly PointSet[], builder: MeshBuilder): Part[] {
  const parts = new Map<PointSet, NumberTable[]>()
  const setOf = new Map(sets.map(set => [set.table, set]))
  const before = new Candidates()
  const waiting: NumberTable[] = []
  let wasCells = false
  for (const table of tables) {
    const set = setOf.get(table)
    const known = before.first
    if (isCells(table, known ?? sets[0] ?? null, set !== undefined)) {
      if (known === null) waiting.push(table)
      else addTo(parts, before.only(builder), table)
      wasCells = true
    } else if (set !== undefined) {
      if (wasCells) before.clear()
      wasCells = false
      before.add(set)
    }
  }
  if (waiting.length > 0 && sets.length > 0) {
    const all = new Candidates()
    for (const set of sets) all.add(set)
    for (const table of waiting) addTo(parts, all.only(builder), table)
  }
  return [...parts].map(([set, cells]) => ({ set, cells }))
}

function addTo(parts: Map<PointSet, NumberTable[]>, set: PointSet, table: NumberTable): void {
  const cells = parts.get(set)
  if (cells) cells.push(table)
  else parts.set(set, [table])
}

/** Tables of points that cells may name: of several, the one whose name says so. */
class Candidates {
  #named: PointSet[] = []
  #others: PointSet[] = []

  add(set: PointSet): void {
    if (isNamed(set.table, NO_POINT_NAME)) return
    if (isNamed(set.table, POINT_NAME)) this.#named.push(set)
    else this.#others.push(set)
  }

  clear(): void {
    this.#named = []
    this.#others = []
  }

  get first(): PointSet | null {
    return this.#named[0] ?? this.#others[0] ?? null
  }

  only(builder: MeshBuilder): PointSet {
    const count = this.#named.length || this.#others.length
    if (count > 1)
      builder.refuse(`${count} tables of points stand before the cells, and nothing says which of them these name.`)
    return this.first as PointSet
  }
}

/** Whether a table names points of `set`: by its name, or because it is of integers that all are numbers of points. */
function isCells(table: NumberTable, set: PointSet | null, mayBePoints: boolean): boolean {
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
  return rows.every(row => isNode(row.slice(-Math.min(4, row.length))))
}

/** Sets of ids, made once however many tables are looked at. */
const knownOf = new WeakMap<readonly number[], ReadonlySet<number>>()

/** Whether a number may be that of a point: by the ids of the text, or counted from 0 or 1. */
function knownIds({ ids, points }: PointSet): (id: number) => boolean {
  if (ids === null) return id => id >= 0 && id <= points.length
  const known = knownOf.get(ids) ?? new Set(ids)
  knownOf.set(ids, known)
  return id => known.has(id)
}

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

const VTK_SIZES = new Set([3, 4, 5, 6, 8, 10, 20, 27])

/** Cells of one table: of eight nodes, or of others. */
interface CellRows {
  readonly table: NumberTable
  readonly hexahedra: readonly (readonly number[])[]
  readonly others: readonly (readonly number[])[]
  readonly ids: readonly number[] | null
}

function addCells(set: PointSet, tables: readonly NumberTable[], builder: MeshBuilder): void {
  const first = builder.pointCount
  for (const [x, y, z] of set.points) builder.point(x as number, y as number, z as number)
  const all = tables.map(table => cellRowsOf(table, set, builder))
  const index = indexOf(set, all, first, builder)
  const isCut = set.table.isCut || tables.some(table => table.isCut)
  const place = (id: number): number => {
    const at = index(id)
    return (
      at ??
      builder.refuse(`cell ${builder.cellCount} names point ${id}, which is not among the ${set.points.length} points.`)
    )
  }
  const quadrilaterals: number[][] = []
  for (const { table, hexahedra, others, ids: own } of all) {
    const ids = own ?? labelIds(table)
    const order = isNamed(table, /voxel/i) ? VOXEL : STRAIGHT
    for (const [i, row] of hexahedra.entries()) {
      if (isCut && row.some(id => index(id) === null)) continue
      const nodes = row.map(place)
      builder.hexahedron(
        order.map(v => nodes[v] as number),
        ids?.[i] ?? null,
      )
    }
    if (others.length > 0) addOthers(table, others, quadrilaterals, place, builder)
  }
  addFaces(quadrilaterals, builder)
  if (isCut) cutOff(builder)
}

/** Which point a number names: by the text's ids, else counted from 0 or from 1, whichever all cells of these points agree with. */
function indexOf(
  { ids, points }: PointSet,
  all: readonly CellRows[],
  first: number,
  builder: MeshBuilder,
): (id: number) => number | null {
  if (ids !== null) {
    const at = new Map(ids.map((id, i) => [id, first + i]))
    return id => at.get(id) ?? null
  }
  let [least, most] = [Number.POSITIVE_INFINITY, 0]
  const hasHexahedra = all.some(({ hexahedra }) => hexahedra.length > 0)
  for (const { hexahedra, others } of all) {
    // Rows of other cells may end with a reference.
    for (const row of hasHexahedra ? hexahedra : others) {
      for (const id of row) {
        least = Math.min(least, id)
        most = Math.max(most, id)
      }
    }
  }
  const said = all.find(({ table }) => table.base !== null)?.table.base ?? null
  const isOpen = least > 0 && most < points.length
  if (isOpen && said === null)
    builder.refuse(
      `the cells name points ${least} to ${most} of ${points.length}, and whether these are counted from 0 or from 1 is not said.`,
    )
  const base = isOpen ? said : least > 0 ? 1 : 0
  if (isOpen) builder.note(`The cells were read as counting the points from ${base}, which the text does not say.`)
  if (base === null) return () => null
  return id => (id >= base && id < points.length + base ? first + id - base : null)
}

/** The elements that a text speaks of, if each cell has one of its own. */
function labelIds({ labels }: NumberTable): number[] | null {
  const ids = labels?.map(Number) ?? []
  return ids.length > 0 && labels?.every(label => label !== null) && areDistinct(ids) ? ids : null
}

function cutOff(builder: MeshBuilder): void {
  builder.isCutOff = true
  builder.note('The text leaves something out: the elements that are whole have been read.')
}

const STRAIGHT = [0, 1, 2, 3, 4, 5, 6, 7]
const VOXEL = [0, 1, 3, 2, 4, 5, 7, 6]

/** The nodes of each cell, wherever they stand in the rows. */
function cellRowsOf(table: NumberTable, set: PointSet, builder: MeshBuilder): CellRows {
  const hexahedra = (rows: readonly (readonly number[])[], ids: readonly number[] | null = null): CellRows => ({
    table,
    hexahedra: rows,
    others: [],
    ids,
  })
  const width = widthOf(table)
  const { rows } = table
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
  const from = nodesFrom(table, width, knownIds(set), builder)
  const first = column(table, 0)
  return hexahedra(
    rows.map(row => row.slice(from, from + EIGHT)),
    from > 0 && areDistinct(first) ? first : null,
  )
}

/** Columns that a row of a cell may have: its id, type, tags and eight nodes. */
const WIDEST_ROW = 14

/** The column at which the eight nodes of a row begin. */
function nodesFrom(table: NumberTable, width: number, isKnown: (id: number) => boolean, builder: MeshBuilder): number {
  const last = width - EIGHT
  const fits = (from: number) =>
    table.rows.every(row => {
      const eight = row.slice(from, from + EIGHT)
      return eight.every(isKnown) && areDistinct(eight)
    })
  const possible = Array.from({ length: last + 1 }, (_, from) => from).filter(fits)
  const [only] = possible
  const isReference = table.rows.length > 1 && isConstant(column(table, width - 1))
  if (possible.length === 1 && only !== undefined) return only
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

/** Cells of other kinds: counted where their name says what they are; quadrilaterals are kept, for they may be a hexahedron's faces. */
function addOthers(
  table: NumberTable,
  rows: readonly (readonly number[])[],
  quadrilaterals: number[][],
  place: (id: number) => number,
  builder: MeshBuilder,
): void {
  const width = rows.every(row => row.length === rows[0]?.length) ? (rows[0]?.length ?? 0) : 0
  const name = table.names.join(' ')
  if (width === 20 || width === 27) {
    for (const row of rows) builder.notTrilinear(row.slice(0, EIGHT).map(place))
    return
  }
  const type = OTHER_TYPES.find(([pattern]) => pattern.test(name))?.[1]
  if (width === 4 && (type === 'quadrilateral' || type === undefined) && isNamed(table, CELL_NAME)) {
    for (const row of rows) quadrilaterals.push(row.map(place))
    return
  }
  if (type !== undefined || (isNamed(table, CELL_NAME) && builder.cellCount > 0)) {
    builder.otherCell(type ?? 'other', rows.length)
    return
  }
  const said = table.names.length > 0 ? `${shown(table.names.at(-1) as string)}, ` : ''
  builder.refuse(
    `under the points stand integers (${said}${rows.length} ${rows.length === 1 ? 'row' : 'rows'} of ${width || 'several lengths'}) that seem to name them, but not eight for each cell.`,
  )
}

/** Six faces for each eight points are a hexahedron; others are quadrilaterals. */
function addFaces(faces: readonly (readonly number[])[], builder: MeshBuilder): void {
  if (faces.length === 0) return
  const cells =
    builder.cellCount === 0 && faces.length % 6 === 0
      ? inRowsOf(faces as never, 6).map(six => hexahedronOfFaces(six as never))
      : []
  if (cells.length > 0 && cells.every(cell => cell !== null)) {
    for (const cell of cells) builder.hexahedron(cell)
    builder.note('The order of the points comes from the six faces of each hexahedron.')
  } else builder.otherCell('quadrilateral', faces.length)
}

/** What makes a list in some language, and names none. */
const IS_LIST = /(?:^|\.)(?:array|matrix|list|vector)$/i

/** How many elements were added. */
function addEights(sets: readonly PointSet[], builder: MeshBuilder): number {
  let count = 0
  for (const { points, labels, table } of sets) {
    if (points.length < EIGHT || (points.length % EIGHT !== 0 && !table.isCut)) continue
    const whole = Math.floor(points.length / EIGHT)
    for (let i = 0; i < whole; i++) {
      const first = builder.pointCount
      for (const [x, y, z] of points.slice(EIGHT * i, EIGHT * (i + 1)))
        builder.point(x as number, y as number, z as number)
      const name = table.names.findLast(word => !IS_LIST.test(word))
      const label = labels?.[EIGHT * i] ?? (name === undefined ? null : whole === 1 ? name : `${name}, ${i}`)
      const index = STRAIGHT.map(v => first + v)
      builder.hexahedron(index, label !== null && /^\d{1,15}$/.test(label) ? Number(label) : label)
    }
    count += whole
    if (table.isCut) cutOff(builder)
  }
  return count
}
