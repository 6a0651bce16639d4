/** Puts a mesh together from what a reader meets: points by the file's ids or in a row, cells of any type, names. */
import type { Vertices } from '../model/hexahedron'
import type { FileRows } from './file-rows'
import { IdIndex } from './id-index'
import { type Block, type CoordinatePlaces, type Mesh, MeshRefusal, NOTHING_NOT_TRILINEAR } from './mesh'
import { areAtMiddles } from './middles'
import { PrintedDigits } from './precision'
import { type Runs, runsOf } from './runs'
import type { TextCursor } from './text-cursor'
import { TokenList } from './token-list'
import { TypedList } from './typed-list'

/** Names of other cells, and their number of nodes, if that is fixed. */
export type OtherCell =
  | 'vertex'
  | 'line'
  | 'triangle'
  | 'quadrilateral'
  | 'polygon'
  | 'tetrahedron'
  | 'pyramid'
  | 'wedge'
  | 'polyhedron'
  | 'other'

export class MeshBuilder {
  readonly #format: string
  readonly #fileName: string
  readonly #points = new TypedList(Float64Array)
  readonly #cells = new TypedList(Uint32Array)
  /** So many of their numbers, from the first on, are points that are there. */
  #known = 0
  readonly #corners = new TypedList(Uint32Array)
  readonly #tokens = new TokenList()
  readonly #ids = new TypedList(Float64Array)
  /** All ids so far, if one of them is no number. */
  #names: string[] | null = null
  readonly #blocks = new Map<string, Runs>()
  readonly #other = new Map<string, number>()
  readonly #notes: string[] = []
  readonly #pointOfId = new IdIndex()
  /** Digits of coordinates in text; they become a note if printing has rounded. */
  readonly digits = new PrintedDigits()
  #straight: number | null = null
  isOrderStated = true
  isCutOff = false
  coordinatePlaces: CoordinatePlaces | null = null
  /** True if the coordinates stand in another file than the one that is read. */
  areCoordinatesElsewhere = false
  steps: readonly string[] = []
  isSteady = false

  constructor(format: string, fileName: string) {
    this.#format = format
    this.#fileName = fileName
  }

  refuse(what: string): never {
    throw new MeshRefusal(`${this.#fileName}: ${what}`)
  }

  get pointCount(): number {
    return this.#points.length / 3
  }

  get cellCount(): number {
    return this.#cells.length / 8
  }

  /** The next coordinate's text in the file; with all they become `coordinatePlaces`. */
  coordinateToken(from: number, length: number): void {
    this.#tokens.put(this.#tokens.length, from, length)
  }

  /** The texts of the three coordinates with which a row ends. */
  coordinateTokens(rows: FileRows, row: number): void {
    this.#tokens.putRow(this.#tokens.length, rows, row)
  }

  /** Reads the next coordinate, and keeps where and with how many digits it is written. */
  readCoordinate(cursor: TextCursor): number {
    const value = cursor.number('a coordinate')
    this.coordinateToken(cursor.numberFrom, cursor.position - cursor.numberFrom)
    this.digits.see(value, cursor.digits)
    return value
  }

  /** Reads the next three coordinates. */
  readPoint(cursor: TextCursor): readonly [number, number, number] {
    return [this.readCoordinate(cursor), this.readCoordinate(cursor), this.readCoordinate(cursor)]
  }

  /** Coordinate 0, 1 or 2 of a point that is there. */
  coordinate(point: number, axis: number): number {
    return this.#points.values[3 * point + axis] as number
  }

  /** Makes place for so many more points and cells, where the size of the file allows them. */
  reserve(points: number, cells: number): void {
    this.#pointOfId.expect(this.pointCount + points)
    this.#points.reserve(this.#points.length + 3 * points)
    this.#cells.reserve(this.#cells.length + 8 * cells)
  }

  /** Makes place for the rows of nodes or hexahedra that may be ahead. */
  expectRows({ count, ahead }: FileRows, what: 'nodes' | 'hexahedra'): void {
    if (what === 'hexahedra') {
      this.#cells.reserveMore(8 * count, 8 * ahead)
      this.#ids.reserveMore(count, ahead)
      return
    }
    this.#pointOfId.expect(this.pointCount + ahead)
    this.#points.reserveMore(3 * count, 3 * ahead)
    this.#tokens.reserve(3 * (this.pointCount + count), 3 * (this.pointCount + ahead))
  }

  /** Points of rows that begin with an id, if `hasIds`, and have the coordinates from number `at` on, usually their last three. */
  pointRows(rows: FileRows, hasIds = false, at = rows.pattern.numberCount - 3): void {
    const { pattern, count, numbers } = rows
    let largest = 0
    this.expectRows(rows, 'nodes')
    for (let row = 0; row < count; ++row) {
      const from = pattern.numberCount * row
      const [x, y, z] = [
        numbers[from + at] as number,
        numbers[from + at + 1] as number,
        numbers[from + at + 2] as number,
      ]
      if (hasIds) this.pointWithId(numbers[from] as number, x, y, z)
      else this.point(x, y, z)
      largest = Math.max(largest, Math.abs(x), Math.abs(y), Math.abs(z))
      this.coordinateTokens(rows, row)
    }
    this.digits.seeRounded(rows.mostRounded, largest)
  }

  /** Calls all points by their places, counted from `first` on. */
  numberPoints(first: number): void {
    this.#pointOfId.expect(this.pointCount)
    for (let point = 0; point < this.pointCount; ++point) this.#pointOfId.set(first + point, point)
  }

  /** The next point in a row; returns its index. */
  point(x: number, y: number, z: number): number {
    this.#points.push(x)
    this.#points.push(y)
    this.#points.push(z)
    return this.pointCount - 1
  }

  /** So many more points, whose coordinates are 0 and are to be put into the list. */
  morePoints(count: number): Float64Array {
    const from = this.#points.length
    this.#points.reserve(from + 3 * count)
    this.#points.length = from + 3 * count
    return this.#points.values.subarray(from, from + 3 * count)
  }

  /** A point that the file calls `id`. Refuses an id that is there already with other coordinates. */
  pointWithId(id: number, x: number, y: number, z: number): void {
    if (!this.newPointWithId(id, x, y, z)) this.refuse(`node ${id} is defined twice.`)
  }

  /** Adds a point that the file calls `id`; false, and nothing is added, if the id is there already. */
  newPointWithId(id: number, x: number, y: number, z: number): boolean {
    if (this.hasPointWithId(id)) return false
    this.#pointOfId.set(id, this.pointCount)
    this.point(x, y, z)
    return true
  }

  hasPointWithId(id: number): boolean {
    return this.#pointOfId.get(id) >= 0
  }

  /** The point of this id, -1 if there is none. */
  findId(id: number): number {
    return this.#pointOfId.get(id)
  }

  /** Refuses an id that no point has. */
  indexOfId(id: number, where: string): number {
    const index = this.findId(id)
    if (index < 0) this.refuse(`${where} names node ${id}, which is not defined.`)
    return index
  }

  /** A cell of the points with the eight ids `nodes[from]` and following; -1, and nothing is added, if one of them is not there. */
  hexahedronByIds(nodes: ArrayLike<number>, from: number, id: number): number {
    const { length } = this.#cells
    this.#cells.reserve(length + 8)
    if (!this.#pointOfId.getEach(nodes, from, 8, this.#cells.values, length)) return -1
    this.#cells.length = length + 8
    this.#addId(id)
    return this.cellCount - 1
  }

  /** A cell of eight nodes, indices of points in VTK_HEXAHEDRON order; its id may be null. Returns its index. */
  hexahedron(indices: readonly number[], id: number | string | null = null): number {
    for (const index of indices) this.#cells.push(index)
    if (id !== null) this.#addId(id)
    return this.cellCount - 1
  }

  /** Cells of eight nodes each, points counted from `base` on, that are there; `ids` has an id for each. Returns the index of the first. */
  hexahedra(nodes: ArrayLike<number>, base: number, ids: ArrayLike<number>): number {
    const first = this.cellCount
    const own = this.#moreCells(nodes.length)
    for (let i = 0; i < own.length; ++i) own[i] = (nodes[i] as number) - base
    this.#addIds(ids, nodes.length / 8)
    return first
  }

  /**
   * Cells of eight nodes each. `fillIndices` puts the indices of their points into the list, or is false; then `fill` puts the numbers of these
   * from 1 on, and `refuseAt` is given the place of one that is not there.
   */
  hexahedraFilled(
    count: number,
    {
      fillIndices,
      fill,
      ids,
      refuseAt,
    }: {
      readonly fillIndices: (indices: Uint32Array) => boolean
      readonly fill: (nodes: Uint32Array) => void
      readonly ids: ArrayLike<number>
      readonly refuseAt: (at: number, node: number) => never
    },
  ): void {
    const own = this.#moreCells(8 * count)
    const isKnown = this.#known === this.#cells.length - own.length
    this.#addIds(ids, count)
    if (!fillIndices(own)) {
      fill(own)
      if (!becameIndices(own, this.pointCount)) {
        const bad = own.findIndex(point => point >= this.pointCount)
        refuseAt(bad, ((own[bad] as number) + 1) % 2 ** 32)
      }
    }
    if (isKnown) this.#known = this.#cells.length
  }

  /** Numbers of cells, to be filled. */
  #moreCells(length: number): Uint32Array {
    const from = this.#cells.length
    this.#cells.reserve(from + length)
    this.#cells.length = from + length
    return this.#cells.values.subarray(from, from + length)
  }

  #addIds(ids: ArrayLike<number>, count: number): void {
    if (this.#names === null) {
      const before = this.#ids.length
      this.#ids.reserve(before + count)
      for (let i = 0; i < count; ++i) this.#ids.values[before + i] = ids[i] as number
      this.#ids.length = before + count
    } else for (let i = 0; i < count; ++i) this.#addId(ids[i] as number)
  }

  #addId(id: number | string): void {
    if (this.#names === null && typeof id === 'string') this.#names = Array.from(this.#ids.whole(), String)
    if (this.#names === null) this.#ids.push(id as number)
    else this.#names.push(String(id))
  }

  #allIds(): Float64Array | readonly string[] | null {
    const ids = this.#names ?? this.#ids.whole()
    return ids.length === this.cellCount && this.cellCount > 0 ? ids : null
  }

  /** A cell that is not trilinear, by its eight corners; `isStraight` is null if nobody looked whether its further nodes lie at the middles. */
  notTrilinear(corners: readonly number[], isStraight: boolean | null = null): void {
    for (const index of corners) this.#corners.push(index)
    if (isStraight !== null) this.#straight = (this.#straight ?? 0) + (isStraight ? 1 : 0)
  }

  /** A cell of 20, 27 or more nodes: the corners, and nodes that may lie at the middles between them. */
  quadraticCell(corners: readonly number[], others: readonly number[]): void {
    const at = (point: number, axis: number) => this.coordinate(point, axis)
    this.notTrilinear(corners, areAtMiddles(at, corners, others))
  }

  otherCell(type: OtherCell, count = 1): void {
    if (count > 0) this.#other.set(type, (this.#other.get(type) ?? 0) + count)
  }

  /** Puts a cell into the block, part or set of this name. */
  inBlock(name: string, cell: number): void {
    runsOf(this.#blocks, name).add(cell)
  }

  /** Puts all cells from this one on into the block. */
  restInBlock(name: string, from: number): void {
    if (from < this.cellCount) runsOf(this.#blocks, name).addRange(from, this.cellCount - 1)
  }

  /** Says that the text leaves points out, which so many cells name. */
  noteLacking(count: number, points: string, cells: string): void {
    if (count === 0) return
    this.isCutOff = true
    this.note(`The text leaves ${points} out: ${count} ${cells} that name them are not read.`)
  }

  note(sentence: string): void {
    if (!this.#notes.includes(sentence)) this.#notes.push(sentence)
  }

  /** The mesh of one element, in this project's own order. */
  meshOfOne(vertices: Vertices): Mesh {
    for (let v = 0; v < 24; v += 3)
      this.point(vertices[v] as number, vertices[v + 1] as number, vertices[v + 2] as number)
    this.hexahedron([0, 1, 2, 3, 4, 5, 6, 7])
    return this.mesh()
  }

  /** The mesh. Refuses an index out of range. */
  mesh(): Mesh {
    const points = this.#points.whole()
    const cells = this.#cells.whole()
    const corners = this.#corners.whole()
    const count = points.length / 3
    for (const [list, known] of [
      [cells, this.#known],
      [corners, 0],
    ] as const) {
      const bad = firstNot(list, known, count)
      if (bad < list.length)
        this.refuse(`cell ${Math.floor(bad / 8)} names point ${list[bad]}; the points are 0 to ${count - 1}.`)
    }
    const precision = this.digits.note()
    if (precision !== null) this.note(precision)
    const blocks: Block[] = [...this.#blocks].map(([name, runs]) => ({ name, cells: runs.sorted() }))
    return {
      format: this.#format,
      points,
      cells,
      ids: this.#allIds(),
      blocks,
      notTrilinear: corners.length > 0 ? { corners, straight: this.#straight } : NOTHING_NOT_TRILINEAR,
      other: this.#other,
      notes: this.#notes,
      isOrderStated: this.isOrderStated,
      isCutOff: this.isCutOff,
      coordinatePlaces: this.areCoordinatesElsewhere
        ? null
        : (this.coordinatePlaces ?? this.#tokens.places(points.length)),
      steps: this.steps,
      isSteady: this.isSteady,
    }
  }
}

/** Numbers counted from 1 on become indices; true if all are less than `count`, which is below 2^31. */
function becameIndices(list: Uint32Array, count: number): boolean {
  const last = count - 1
  // Of an index from 0 to `last`, it and its difference to `last` are not negative.
  let signs = 0
  for (let i = 0; i < list.length; ++i) {
    const index = ((list[i] as number) - 1) | 0
    signs |= index | (last - index)
    list[i] = index
  }
  return signs >= 0
}

/** The place of the first number from `from` on that is not less than `bound`; the length if there is none. */
function firstNot(list: Uint32Array, from: number, bound: number): number {
  let at = from
  while (at < list.length && (list[at] as number) < bound) ++at
  return at
}
