/**
 * The meaning of tables of numbers: which are points, which are cells that name them. Cells that
 * are there are used, or the text is refused; only where there are none are points taken in their
 * order, eight for each element, and then the order is not stated.
 */
import { hexahedronOfFaces } from '../hexahedron-of-faces'
import type { Mesh } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { printedDigits } from '../precision'
import { orderOfText } from '../snippet-text'
import { shown } from '../text-cursor'
import { type CellRows, cellRowsOf } from './cell-rows'
import { hasPositiveCorners, likelierLayout } from './layouts'
import { pairs } from './named-points'
import { areAllIntegers, areDistinct, inRowsOf, type NumberTable, transposed, widthOf } from './number-table'
import { EIGHT, type PointSet, pointSetOf, withAxesJoined, withIdsJoined } from './point-set'
import { CELL_NAME, isNamed, LIST_MAKER, NO_POINT_NAME } from './table-names'

export interface Origin {
  readonly format: string
  readonly fileName: string
  /** True for a text of a program with its own order of a cell's points. */
  readonly hasOwnOrder?: boolean
  /** True for a mesh of scikit-fem. */
  readonly isScikitFem?: boolean
}

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
  const tables = withIdsJoined(withAxesJoined(all))
  const builder = new MeshBuilder(origin.format, origin.fileName)
  const sets = tables.flatMap(table => pointSetOf(table, builder) ?? [])
  const parts = pairs(tables, sets, builder)
  if (parts.length > 0) {
    let isKnownOrder = false
    for (const { set, cells } of parts) {
      const own = origin.isScikitFem ? inOrderOfScikitFem(set, cells) : null
      addCells(set, own ?? cells, builder)
      isKnownOrder ||= own !== null
    }
    if (isKnownOrder) builder.note('The nodes of each cell are in scikit-fem’s order.')
    else if (origin.hasOwnOrder) {
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

/** Scikit-fem's node of each vertex. */
const SCIKIT_FEM = [0, 3, 6, 2, 1, 5, 7, 4]

/** Cells of scikit-fem, a column or a row for each, in VTK's order; null if in its order not one has J > 0 at its corners. */
function inOrderOfScikitFem({ points }: PointSet, tables: readonly NumberTable[]): NumberTable[] | null {
  for (const rowsOf of [transposed, (rows: readonly number[][]) => rows]) {
    const ordered = tables.map(table => ({
      ...table,
      rows: rowsOf(table.rows as number[][]).map(row => SCIKIT_FEM.map(at => row[at] as number)),
    }))
    const isPositive = (row: readonly number[]) => hasPositiveCorners(row.map(id => points[id] ?? []))
    if (ordered.every(({ rows }) => rows.some(isPositive))) return ordered
  }
  return null
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
    if (!table.rows.every(row => row.every(id => id >= 0))) continue
    // Collapsed cells repeat nodes.
    if (2 * table.rows.filter(row => areDistinct(row.slice(-EIGHT))).length <= table.rows.length) continue
    builder.refuse(
      `beside the points stands a table of ${width} integers a row that seems to name points, but not those that are there.`,
    )
  }
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

/** The point that a number names: by ids, else from 0 or 1, whichever all cells agree with. */
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
  // Gmsh's HEXAS20 and HEXAS27 for MATLAB end with a tag.
  if ([20, 27].includes(isNamed(table, /hexas2[07]$/i) ? width - 1 : width)) {
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
    builder.cellCount === 0 && faces.length % 6 === 0 ? inRowsOf(faces, 6).map(six => hexahedronOfFaces(six)) : []
  if (cells.length > 0 && cells.every(cell => cell !== null)) {
    for (const cell of cells) builder.hexahedron(cell)
    builder.note('The order of the points comes from the six faces of each hexahedron.')
  } else builder.otherCell('quadrilateral', faces.length)
}

/** The number of elements that were added. */
function addEights(sets: readonly PointSet[], builder: MeshBuilder): number {
  let count = 0
  for (const { points: usual, labels, table } of sets) {
    const other = likelierLayout(usual, table)
    const points = other ?? usual
    if (other !== null)
      builder.note(
        widthOf(table) === EIGHT
          ? 'The three rows of eight were taken as eight points one after the other: as x, y and z they make no element.'
          : 'The 24 numbers were taken as eight x, eight y and eight z: as eight points one after the other they make no element.',
      )
    if (points.length < EIGHT || (points.length % EIGHT !== 0 && !table.isCut)) continue
    const whole = Math.floor(points.length / EIGHT)
    for (let i = 0; i < whole; i++) {
      const first = builder.pointCount
      for (const [x, y, z] of points.slice(EIGHT * i, EIGHT * (i + 1)))
        builder.point(x as number, y as number, z as number)
      const name = table.names.findLast(word => !LIST_MAKER.test(word))
      const label = labels?.[EIGHT * i] ?? (name === undefined ? null : whole === 1 ? name : `${name}, ${i}`)
      const index = STRAIGHT.map(v => first + v)
      builder.hexahedron(index, label !== null && /^\d{1,15}$/.test(label) ? Number(label) : label)
    }
    count += whole
    if (table.isCut) cutOff(builder)
  }
  return count
}
