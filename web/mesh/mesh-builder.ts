/** Puts a mesh together from what a reader meets: points by the file's ids or in a row, cells of any type, names. */
import type { Vertices } from '../model/hexahedron'
import { type Block, type CoordinatePlaces, type Mesh, MeshRefusal, NOTHING_NOT_TRILINEAR } from './mesh'
import { NodeIds } from './node-ids'

/** What other cells are called, and how many nodes they have, where that is fixed. */
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

/** A list of numbers that grows. */
class Growing<T extends Float64Array | Uint32Array | Uint16Array> {
  #list: T
  #length = 0
  constructor(private readonly make: (length: number) => T) {
    this.#list = make(1024)
  }
  push(value: number): void {
    if (this.#length === this.#list.length) {
      const longer = this.make(2 * this.#length)
      longer.set(this.#list as never)
      this.#list = longer
    }
    this.#list[this.#length++] = value
  }
  get length(): number {
    return this.#length
  }
  at(index: number): number {
    return this.#list[index] as number
  }
  /** Makes place for so many more; nobody may ask for more than the size of the file allows. */
  reserve(more: number): void {
    if (this.#length + more <= this.#list.length) return
    const longer = this.make(this.#length + more)
    longer.set(this.#list.subarray(0, this.#length) as never)
    this.#list = longer
  }
  whole(): T {
    return (this.#length === this.#list.length ? this.#list : this.#list.slice(0, this.#length)) as T
  }
}

export class MeshBuilder {
  readonly #format: string
  readonly #fileName: string
  readonly #points = new Growing(length => new Float64Array(length))
  readonly #cells = new Growing(length => new Uint32Array(length))
  readonly #corners = new Growing(length => new Uint32Array(length))
  readonly #tokensFrom = new Growing(length => new Float64Array(length))
  readonly #tokenLengths = new Growing(length => new Uint16Array(length))
  readonly #ids: (number | string)[] = []
  readonly #blocks = new Map<string, number[]>()
  readonly #other = new Map<string, number>()
  readonly #notes: string[] = []
  readonly #pointOfId = new NodeIds()
  #straight: number | null = null
  isOrderStated = true
  isCutOff = false
  coordinatePlaces: CoordinatePlaces | null = null
  steps: readonly string[] = []

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

  /** Where the next coordinate's text begins in the file, and its length; if all points have three, they become `coordinatePlaces`. */
  coordinateToken(from: number, length: number): void {
    this.#tokensFrom.push(from)
    this.#tokenLengths.push(length)
  }

  /** Coordinate 0, 1 or 2 of a point that is there. */
  coordinate(point: number, axis: number): number {
    return this.#points.at(3 * point + axis)
  }

  /** Makes place for so many more points and cells, where the size of the file allows them. */
  reserve(points: number, cells: number): void {
    this.#points.reserve(3 * points)
    this.#cells.reserve(8 * cells)
  }

  /** The next point in a row; returns its index. */
  point(x: number, y: number, z: number): number {
    this.#points.push(x)
    this.#points.push(y)
    this.#points.push(z)
    return this.pointCount - 1
  }

  /** A point that the file calls `id`. Refuses an id that is there already with other coordinates. */
  pointWithId(id: number, x: number, y: number, z: number): void {
    if (!this.#pointOfId.add(id, this.pointCount)) this.refuse(`node ${id} is defined twice.`)
    this.point(x, y, z)
  }

  hasPointWithId(id: number): boolean {
    return this.#pointOfId.indexOf(id) >= 0
  }

  /** The point of this id, -1 if there is none. */
  findId(id: number): number {
    return this.#pointOfId.indexOf(id)
  }

  /** Refuses an id that no point has. */
  indexOfId(id: number, where: string): number {
    const index = this.findId(id)
    if (index < 0) this.refuse(`${where} names node ${id}, which is not defined.`)
    return index
  }

  /** A cell of eight nodes, indices of points in VTK_HEXAHEDRON order; its id may be null. Returns its index. */
  hexahedron(indices: readonly number[], id: number | string | null = null): number {
    for (const index of indices) this.#cells.push(index)
    if (id !== null) this.#ids.push(id)
    return this.cellCount - 1
  }

  /** The eight corners of a cell that is not trilinear; whether its further nodes lie at the middles, or null if that was not looked at. */
  notTrilinear(corners: readonly number[], isStraight: boolean | null = null): void {
    for (const index of corners) this.#corners.push(index)
    if (isStraight !== null) this.#straight = (this.#straight ?? 0) + (isStraight ? 1 : 0)
  }

  otherCell(type: OtherCell, count = 1): void {
    if (count > 0) this.#other.set(type, (this.#other.get(type) ?? 0) + count)
  }

  /** Puts a cell into the block, part or set of this name. */
  inBlock(name: string, cell: number): void {
    const cells = this.#blocks.get(name)
    if (cells) cells.push(cell)
    else this.#blocks.set(name, [cell])
  }

  note(sentence: string): void {
    if (!this.#notes.includes(sentence)) this.#notes.push(sentence)
  }

  #tokens(): CoordinatePlaces | null {
    if (this.#tokensFrom.length !== this.#points.length || this.pointCount === 0) return null
    return { kind: 'tokens', from: this.#tokensFrom.whole(), lengths: this.#tokenLengths.whole() }
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
    for (const list of [cells, corners]) {
      const bad = list.findIndex(index => index >= count)
      if (bad >= 0)
        this.refuse(`cell ${Math.floor(bad / 8)} names point ${list[bad]}; the points are 0 to ${count - 1}.`)
    }
    const ids = this.#ids.length === this.cellCount && this.cellCount > 0 ? this.#ids : null
    const areNumbers = ids?.every(id => typeof id === 'number') ?? false
    const blocks: Block[] = [...this.#blocks].map(([name, list]) => ({
      name,
      cells: isAscending(list) ? Uint32Array.from(list) : Uint32Array.from(new Set(list)).sort(),
    }))
    return {
      format: this.#format,
      points,
      cells,
      ids: ids === null ? null : areNumbers ? Float64Array.from(ids as number[]) : ids.map(String),
      blocks,
      notTrilinear: corners.length > 0 ? { corners, straight: this.#straight } : NOTHING_NOT_TRILINEAR,
      other: this.#other,
      notes: this.#notes,
      isOrderStated: this.isOrderStated,
      isCutOff: this.isCutOff,
      coordinatePlaces: this.coordinatePlaces ?? this.#tokens(),
      steps: this.steps,
    }
  }
}

function isAscending(list: readonly number[]): boolean {
  for (let i = 1; i < list.length; ++i) if ((list[i] as number) <= (list[i - 1] as number)) return false
  return true
}
