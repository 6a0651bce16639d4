/** An open mesh with the answers of all its cells, in its worker: what the page shows of it is asked here. */
import type { CheckId } from '../core/report'
import { CHECKS, CLASSES } from '../core/unpack'
import { CheckedCells, columnsOf } from '../mesh/checked-cells'
import { FACES } from '../mesh/face-loops'
import { histogramOf } from '../mesh/histogram'
import type { MeshCheck } from '../mesh/mesh-check'
import { Joining, type Neighbours } from '../mesh/neighbours'
import { verticesOf } from '../mesh/vertices-of'
import { FEW } from '../mesh/worst'
import type { Vec3 } from '../model/hexahedron'
import type { NodeOrder } from '../model/node-orders'
import { arranged } from './arrange'
import type { Faced } from './faced'
import { facesOf } from './faces'
import { boundsOf, overviewOf } from './overview'
import { type Conditioned, SelectionRun } from './selection'
import type {
  Arrangement,
  Bounds,
  CellDetail,
  FaceList,
  Histogram,
  Neighbour,
  Overview,
  Place,
  Row,
  Scaled,
  Selected,
  Selection,
  ShownCells,
} from './survey-jobs'

const NOT_LISTED = 0xffffffff

export class Survey {
  #check: MeshCheck
  readonly #conditioned: Conditioned
  #cells: CheckedCells
  readonly #bounds: Bounds | null
  readonly #origin: Vec3
  /** All cells in the present order. */
  #order: Uint32Array
  #selection: SelectionRun
  /** The list and the rank of each cell in it, until order or selection change. */
  #listed: { readonly cells: Uint32Array; readonly ranks: Uint32Array } | null = null
  #joining: Joining | null = null
  #neighbours: Neighbours | null = null
  #middles: Float32Array | null = null

  /**
   * Of a check with minima and volumes, whole or with no more than its worst cells in order: `complete` then brings the rest. Of a mesh that
   * takes the place of its earlier step, which is `before`, the picture stays where it is.
   */
  constructor(check: MeshCheck, conditioned: Conditioned, before: Survey | null = null) {
    this.#check = check
    this.#conditioned = conditioned
    this.#cells = new CheckedCells(columnsOf(check))
    this.#bounds = boundsOf(check)
    this.#origin = before ? before.#origin : middleOf(this.#bounds)
    if (before?.check.mesh.cells === check.mesh.cells) this.#neighbours = before.#neighbours
    this.#order = check.worst
    this.#selection = new SelectionRun(check, conditioned, ALL)
  }

  get check(): MeshCheck {
    return this.#check
  }

  /** The same check with all of its lists and all cells in order, before anything else than its worst cells is asked for. */
  complete(check: MeshCheck): void {
    this.#check = check
    this.#cells = new CheckedCells(columnsOf(check))
    this.#order = check.worst
    this.#selection = new SelectionRun(check, this.#conditioned, ALL)
    this.#listed = null
  }

  /** The same check with more lists. */
  accept({ acceptedBy, minima }: Pick<MeshCheck['answers'], 'acceptedBy' | 'minima'>): void {
    this.#check = { ...this.#check, answers: { ...this.#check.answers, acceptedBy, minima } }
  }

  /** True if all rows up to this rank are known. */
  hasRows(to: number): boolean {
    return to <= this.check.worst.length
  }

  /** `wholeOrder` is the order in which all cells are valid, if theirs is not. */
  overview(name: string, wholeOrder: NodeOrder | null = null): Overview {
    const worst = [...this.check.worst.subarray(0, FEW)].map(cell => this.#rowOf(cell))
    return overviewOf(name, this.check, { worst, bounds: this.#bounds, wholeOrder })
  }

  rows(from: number, to: number): readonly Row[] {
    return [...this.#list().cells.subarray(from, to)].map(cell => this.#rowOf(cell))
  }

  arrange(order: Arrangement): void {
    this.#order = arranged(this.check, order)
    this.#listed = null
  }

  select(selection: Selection): Selected {
    this.#selection = new SelectionRun(this.check, this.#conditioned, selection)
    return this.selectOn(0)
  }

  selectOn(milliseconds: number): Selected {
    this.#listed = null
    return this.#selection.run(milliseconds)
  }

  find(id: string, after: number): Place | null {
    const { cells } = this.#list()
    const first = after < 0 ? -1 : (cells[after] ?? -1)
    let cell = this.#cells.find(id, first)
    const begun = cell
    while (cell !== null && !this.#selection.isListed(cell)) {
      cell = this.#cells.find(id, cell)
      if (cell === begun) break
    }
    return cell !== null && this.#selection.isListed(cell) ? this.placeOf(cell) : null
  }

  /** The cell that is called as another mesh's is: the one with its index, if that is called so, else the first. */
  sameCell(other: Survey, cell: number): number | null {
    const { id } = other.#cells.named(cell)
    const isHere = cell < this.check.hexahedra && this.#cells.named(cell).id === id
    return isHere ? cell : this.#cells.find(id)
  }

  nextInvalid(rank: number, step: 1 | -1): Place | null {
    const { cells } = this.#list()
    const count = cells.length
    for (let i = 1; i <= count; ++i) {
      const at = (((rank + step * i) % count) + count) % count
      const cell = cells[at] as number
      if (this.check.standingOf(cell) === 'invalid') return { cell, rank: at }
    }
    return null
  }

  placeOf(cell: number): Place {
    const rank = this.#list().ranks[cell] as number
    return { cell, rank: rank === NOT_LISTED ? null : rank }
  }

  histogram(): Histogram {
    return histogramOf(this.check)
  }

  detail(cell: number): CellDetail {
    return {
      row: this.#rowOf(cell),
      vertices: this.#cells.verticesOf(cell),
      openOrder: this.#cells.openOrderOf(cell),
      neighbours: this.#neighboursOf(cell),
    }
  }

  join(milliseconds: number): number {
    if (this.#neighbours) return 1
    const { points, cells } = this.check.mesh
    this.#joining ??= new Joining(cells, points.length / 3)
    const part = this.#joining.run(milliseconds)
    this.#neighbours = this.#joining.neighbours
    if (this.#neighbours) this.#joining = null
    return part
  }

  faces(shown: ShownCells): FaceList {
    return facesOf(this.faced, shown)
  }

  /** What faces are made of. Joins them first, if they are not yet. */
  get faced(): Faced {
    this.join(Infinity)
    const origin = this.#origin
    this.#middles ??= middlesOf(this.check, origin)
    return {
      check: this.check,
      origin,
      neighbours: this.#neighbours as Neighbours,
      middles: this.#middles,
      isListed: cell => this.#selection.isListed(cell),
    }
  }

  #list(): { readonly cells: Uint32Array; readonly ranks: Uint32Array } {
    if (this.#listed) return this.#listed
    const cells = this.#selection.isAll ? this.#order : this.#order.filter(cell => this.#selection.isListed(cell))
    const ranks = new Uint32Array(this.check.hexahedra).fill(NOT_LISTED)
    for (let rank = 0; rank < cells.length; ++rank) ranks[cells[rank] as number] = rank
    this.#listed = { cells, ranks }
    return this.#listed
  }

  #rowOf(cell: number): Row {
    const { minima, volumes, classes } = this.check.answers
    const { id, block, standing, relativeMinimum, why } = this.#cells.named(cell)
    const scaled = (list: { values: Float64Array; exponents: Int16Array } | null): Scaled => ({
      value: why === null ? (list?.values[cell] ?? Number.NaN) : Number.NaN,
      exponent: list?.exponents[cell] ?? 0,
    })
    return {
      cell,
      id,
      block,
      standing,
      class: CLASSES[classes[cell] as number] ?? null,
      relativeMinimum,
      minimum: scaled(minima),
      volume: scaled(volumes),
      acceptedBy: this.#acceptedBy(cell),
      why,
    }
  }

  #acceptedBy(cell: number): readonly CheckId[] {
    const { acceptedBy } = this.check.answers
    if (acceptedBy) return CHECKS.filter((_, c) => ((acceptedBy[cell] as number) >> c) & 1)
    const result = this.#conditioned.core.analyze(verticesOf(this.check.mesh, cell))
    return result.ok ? result.value.checks.filter(({ passes }) => passes).map(({ id }) => id) : []
  }

  #neighboursOf(cell: number): Neighbour[] {
    const across = this.#neighbours?.across
    if (!across) return []
    return Array.from({ length: FACES }, (_, face) => face).flatMap(face => {
      const other = across[FACES * cell + face] as number
      if (other < 0) return []
      const neighbour = Math.floor(other / FACES)
      const isInvalid = this.check.standingOf(neighbour) === 'invalid'
      return [{ cell: neighbour, face, isInvalid, vertices: verticesOf(this.check.mesh, neighbour) }]
    })
  }
}

const ALL: Selection = { condition: null, range: null }

/** The mean of a cell's vertices less the origin, in single precision: for pictures. */
function middlesOf({ mesh: { points, cells }, hexahedra }: MeshCheck, [ox, oy, oz]: Vec3): Float32Array {
  const middles = new Float32Array(3 * hexahedra)
  for (let cell = 0; cell < hexahedra; ++cell) {
    let [x, y, z] = [0, 0, 0]
    for (let v = 8 * cell; v < 8 * cell + 8; ++v) {
      const at = 3 * (cells[v] as number)
      x += (points[at] as number) - ox
      y += (points[at + 1] as number) - oy
      z += (points[at + 2] as number) - oz
    }
    middles[3 * cell] = x / 8
    middles[3 * cell + 1] = y / 8
    middles[3 * cell + 2] = z / 8
  }
  return middles
}

function middleOf(bounds: Bounds | null): Vec3 {
  if (!bounds) return [0, 0, 0]
  const middle = (axis: 0 | 1 | 2) => bounds.least[axis] / 2 + bounds.greatest[axis] / 2
  return [middle(0), middle(1), middle(2)]
}
