/** Makes a Mesh of what VTK's files hold: points, nodes of cells in a row, where each cell ends and its type; one grid or several. */
import { inParts } from '../in-parts'
import { type Block, type CoordinatePlaces, type Mesh, MOST_IMPLIED_CELLS } from '../mesh'
import { float32Note, largestOf, printedDigits } from '../precision'
import type { KnownIndices } from '../source'
import { sameMeshNote, stepNote } from '../step-note'
import type { CellData } from './vtk-cell-data'
import { VOXEL_ORDER, VTK_HEXAHEDRON, VTK_POLYHEDRON, vtkCellTypes } from './vtk-cells'
import { areNodesAtMiddles, type Precision, toleranceOf } from './vtk-middles'
import { NotBoxes } from './vtk-voxels'

export interface VtkGrid {
  /** Points that are there: fewer than declared if the text leaves some out. */
  readonly points: Float64Array
  readonly declaredPoints: number
  /** The points of all cells, one after the other; it is used up. */
  readonly connectivity: Uint32Array
  /** Of `connectivity`, and of `ends` as they are in the file, where they are known beforehand. */
  readonly known?: { readonly connectivity: KnownIndices | null; readonly ends: KnownIndices | null }
  /** The index in `connectivity` behind each cell's last point. */
  readonly ends: Uint32Array
  readonly types: Uint8Array
  readonly declaredCells: number
  /** True if a polyhedron's nodes are its faces as a row of numbers, as in legacy files. */
  readonly hasFaceStreams: boolean
  readonly precision: Precision
  readonly cellData: CellData | null
}

export class VtkMesh {
  readonly #format: string
  readonly #refuse: (what: string) => never
  readonly #points: Float64Array[] = []
  readonly #cells: Uint32Array[] = []
  readonly #corners: Uint32Array[] = []
  /** Indices of cells by the name of their block. */
  readonly #blocks = new Map<string, number[]>()
  readonly #grids: Block[] = []
  #ids: number[] | null = []
  readonly #other = new Map<string, number>()
  readonly #notes: string[] = []
  #pointCount = 0
  #cellCount = 0
  #straight: number | null = null
  #missingPoints = 0
  #missingCells = 0
  readonly #notBoxes = new NotBoxes()
  #isFloat32 = false
  #digits = 0
  coordinatePlaces: CoordinatePlaces | null = null
  steps: readonly string[] = []
  isSteady = false
  /** True if the file ends before it should, or leaves cells out. */
  isCutOff = false

  constructor(format: string, refuse: (what: string) => never) {
    this.#format = format
    this.#refuse = refuse
  }

  note(sentence: string): void {
    this.#notes.push(sentence)
  }

  /** Says which of its steps was read, or that all are the same. */
  noteSteps(step: number | 'last'): void {
    const { length } = this.steps
    if (length > 1) this.note(this.isSteady ? sameMeshNote(length) : stepNote(this.steps, step))
  }

  /** Adds a grid, with its cells as a block of this name if there is one. Refuses cells that name points that do not exist. */
  add(grid: VtkGrid, block: string | null = null): void {
    const before = this.#cellCount
    const places: number[] | null = grid.cellData === null ? null : []
    const cells = this.#convert(grid, places)
    this.#append(grid.points, cells, grid.precision)
    this.#addCellData(grid.cellData, places ?? [], before, cells.length / 8)
    if (block !== null)
      this.#grids.push({ name: block, cells: Uint32Array.from({ length: cells.length / 8 }, (_, i) => before + i) })
  }

  /** `places` says which of the grid's cells each hexahedron is. Ids count only if all grids have them. */
  #addCellData(data: CellData | null, places: readonly number[], before: number, count: number): void {
    if (data?.ids) for (const place of places) this.#ids?.push(data.ids[place] as number)
    else if (count > 0) this.#ids = null
    if (!data?.blocks) return
    const { name, values } = data.blocks
    for (const [i, place] of places.entries()) {
      const block = `${name} ${values[place]}`
      const cells = this.#blocks.get(block)
      if (cells) cells.push(before + i)
      else this.#blocks.set(block, [before + i])
    }
  }

  /** Adds a grid whose cells are implied by its numbers of points along the axes; a flat one has no hexahedra that need its points. */
  addStructured(pointsOf: () => Float64Array, sizes: readonly [number, number, number], precision: Precision): void {
    const cellsAlong = sizes.filter(size => size > 1).map(size => size - 1)
    const count = cellsAlong.reduce((product, size) => product * size, 1)
    if (count > MOST_IMPLIED_CELLS)
      this.#refuse(`its dimensions imply ${count} cells; at most ${MOST_IMPLIED_CELLS} are read.`)
    if (cellsAlong.length < 3) {
      const flat = ['vertex', 'line', 'quadrilateral'][cellsAlong.length] as string
      this.#other.set(flat, (this.#other.get(flat) ?? 0) + count)
      this.#append(new Float64Array(0), new Uint32Array(0), precision)
      return
    }
    this.#append(pointsOf(), cellsOfLattice(sizes, count), precision)
  }

  #append(points: Float64Array, cells: Uint32Array, precision: Precision): void {
    if (this.#pointCount > 0) for (let i = 0; i < cells.length; ++i) cells[i] = (cells[i] as number) + this.#pointCount
    this.#points.push(points)
    this.#cells.push(cells)
    this.#pointCount += points.length / 3
    this.#cellCount += cells.length / 8
    if (this.#pointCount > 0xffffffff) this.#refuse(`more than 2^32 points are not read.`)
    this.#isFloat32 ||= precision.isFloat32
    this.#digits = Math.max(this.#digits, precision.digits)
  }

  /** The hexahedra of the grid, moved to the front of its connectivity: a cell's place there is never before its new one. */
  #convert(grid: VtkGrid, places: number[] | null): Uint32Array {
    const { points, connectivity, ends, types, declaredPoints } = grid
    const pointCount = points.length / 3
    const counts = new Uint32Array(256)
    const corners: number[] = []
    const tolerance = toleranceOf(grid.precision)
    let filled = 0
    let from = 0
    let missing = grid.declaredCells - types.length
    this.#missingPoints += declaredPoints - pointCount
    if (
      places === null &&
      missing === 0 &&
      areHexahedra(grid) &&
      (grid.known?.connectivity?.greatest ?? largestIn(connectivity)) < pointCount
    )
      return connectivity
    for (let cell = 0; cell < types.length; ++cell) {
      const end = ends[cell] as number
      const type = types[cell] as number
      const size = end - from
      const start = from
      from = end
      if (type === VTK_POLYHEDRON && grid.hasFaceStreams) {
        this.#checkFaceStream(connectivity, start, end, declaredPoints, cell)
        counts[type] = (counts[type] as number) + 1
        continue
      }
      if (type === VTK_HEXAHEDRON && size === 8 && largestOfEight(connectivity, start) < pointCount) {
        if (filled !== start) for (let i = 0; i < 8; ++i) connectivity[filled + i] = connectivity[start + i] as number
        filled += 8
        places?.push(cell)
        continue
      }
      let isWhole = true
      for (let at = start; at < end; ++at) {
        const point = connectivity[at] as number
        if (point < pointCount) continue
        if (point >= declaredPoints) this.#refuseIndex(cell, at - start, point, declaredPoints)
        isWhole = false
      }
      if (!isWhole) {
        missing++
        continue
      }
      const known = vtkCellTypes.get(type)
      if (known === undefined) this.#refuse(`cell ${cell} has type ${type}, which VTK does not have.`)
      if (known.nodes > 0 && size !== known.nodes)
        this.#refuse(`cell ${cell} of type ${type} has ${size} points; it must have ${known.nodes}.`)
      if (known.kind === 'voxel') {
        this.#notBoxes.check(points, connectivity, start, tolerance, this.#cellCount + filled / 8)
        const nodes = VOXEL_ORDER.map(i => connectivity[start + i] as number)
        connectivity.set(nodes, filled)
        filled += 8
        places?.push(cell)
      } else if (known.kind === 'not trilinear') {
        if (size < 8) this.#refuse(`cell ${cell} of type ${type} has ${size} points; it must have at least 8.`)
        const nodes = connectivity.subarray(start, end)
        if (size === 8) {
          // A Lagrange hexahedron of order 1 is trilinear.
          connectivity.copyWithin(filled, start, end)
          filled += 8
          places?.push(cell)
          continue
        }
        for (let i = 0; i < 8; ++i) corners.push((nodes[i] as number) + this.#pointCount)
        const isStraight = areNodesAtMiddles(known, points, nodes, tolerance)
        if (isStraight !== null) this.#straight = (this.#straight ?? 0) + (isStraight ? 1 : 0)
      } else counts[type] = (counts[type] as number) + 1
    }
    if (from !== connectivity.length && missing === 0)
      this.#refuse(`the cells name ${from} points, and ${connectivity.length} are listed.`)
    this.#missingCells += missing
    if (corners.length > 0) this.#corners.push(Uint32Array.from(corners))
    for (const [type, { kind }] of vtkCellTypes) {
      const count = counts[type] as number
      if (count > 0) this.#other.set(kind, (this.#other.get(kind) ?? 0) + count)
    }
    return 2 * filled < connectivity.length ? connectivity.slice(0, filled) : connectivity.subarray(0, filled)
  }

  #refuseIndex(cell: number, vertex: number, point: number, count: number): never {
    const have = count > 0 ? `the points are 0 to ${count - 1}` : 'there are no points'
    this.#refuse(`cell ${cell} names point ${point} as its vertex ${vertex}; ${have}.`)
  }

  /** Number of faces, then for each its number of points and these. */
  #checkFaceStream(stream: Uint32Array, from: number, to: number, pointCount: number, cell: number): void {
    const wrong = (): never =>
      this.#refuse(`cell ${cell} is a polyhedron whose faces do not fill its ${to - from} numbers.`)
    if (from >= to) wrong()
    let at = from + 1
    for (let face = stream[from] as number; face > 0; --face) {
      if (at >= to) wrong()
      const end = at + 1 + (stream[at] as number)
      if (end > to) wrong()
      for (let i = at + 1; i < end; ++i)
        if ((stream[i] as number) >= pointCount) this.#refuseIndex(cell, i - from, stream[i] as number, pointCount)
      at = end
    }
    if (at !== to) wrong()
  }

  #elisionNote(): void {
    const missing = [
      [this.#missingPoints, 'points'],
      [this.#missingCells, 'cells'],
    ]
      .filter(([count]) => (count as number) > 0)
      .map(([count, name]) => `${count} of the declared ${name}`)
    this.note(
      `The text leaves something out: ${missing.join(' and ')} are not there or not whole; the others were read.`,
    )
    if (this.#missingCells > 0) this.isCutOff = true
  }

  #precisionNote(points: Float64Array): void {
    if (!this.#isFloat32 && this.#digits === 0) return
    const note = this.#isFloat32 ? float32Note(largestOf(points)) : printedDigits(this.#digits, points).note()
    if (note !== null) this.note(note)
  }

  mesh(): Mesh {
    const points = joined(this.#points, Float64Array)
    const cells = joined(this.#cells, Uint32Array)
    const corners = joined(this.#corners, Uint32Array)
    const notBoxes = this.#notBoxes.note()
    if (notBoxes !== null) this.note(notBoxes)
    if (this.#missingPoints > 0 || this.#missingCells > 0) this.#elisionNote()
    this.#precisionNote(points)
    return {
      format: this.#format,
      points,
      cells,
      ids: this.#ids !== null && this.#ids.length > 0 ? Float64Array.from(this.#ids) : null,
      blocks: [...[...this.#blocks].map(([name, list]) => ({ name, cells: Uint32Array.from(list) })), ...this.#grids],
      notTrilinear: { corners, straight: this.#straight },
      other: this.#other,
      notes: this.#notes,
      isOrderStated: this.#notBoxes.isOrderCertain,
      isCutOff: this.isCutOff,
      coordinatePlaces: this.#points.length === 1 && points.length > 0 ? this.coordinatePlaces : null,
      steps: this.steps,
      isSteady: this.isSteady,
    }
  }
}

/** True if there are hexahedra and nothing else. */
function areHexahedra({ connectivity, ends, types, known }: VtkGrid): boolean {
  const isAlike = ends.length === types.length && connectivity.length === 8 * types.length
  if (!isAlike || ends[0] !== 8) return false
  return (known?.ends ? known.ends.step === 8 : haveStep(ends, 8)) && areAll(types, VTK_HEXAHEDRON)
}

function haveStep(list: Uint32Array, step: number): boolean {
  let others = 0
  inParts(list.length, (from, to) => {
    for (let i = Math.max(1, from); i < to; ++i) others |= (list[i] as number) ^ ((list[i - 1] as number) + step)
  })
  return others === 0
}

/** Four bytes at a time. */
function areAll(bytes: Uint8Array, value: number): boolean {
  const own = bytes.byteOffset % 4 === 0 ? bytes : bytes.slice()
  const words = new Uint32Array(own.buffer, own.byteOffset, own.length >> 2)
  const wanted = value * 0x01010101
  let others = 0
  inParts(words.length, (from, to) => {
    for (let i = from; i < to; ++i) others |= (words[i] as number) ^ wanted
  })
  return others === 0 && own.subarray(4 * words.length).every(byte => byte === value)
}

function largestIn(list: Uint32Array): number {
  let largest = 0
  inParts(list.length, (from, to) => {
    let own = largest
    for (let i = from; i < to; ++i) if ((list[i] as number) > own) own = list[i] as number
    largest = own
  })
  return largest
}

function largestOfEight(list: Uint32Array, from: number): number {
  let largest = list[from] as number
  for (let at = from + 1; at < from + 8; ++at) if ((list[at] as number) > largest) largest = list[at] as number
  return largest
}

/** The place of the first number that is less than the one before; -1 if there is none. */
export function firstFall(list: Uint32Array): number {
  let fall = -1
  inParts(list.length, (from, to) => {
    for (let i = Math.max(1, from); i < to && fall < 0; ++i) if ((list[i] as number) < (list[i - 1] as number)) fall = i
  })
  return fall
}

function joined<T extends Float64Array | Uint32Array>(lists: T[], List: new (length: number) => T): T {
  if (lists.length === 1) return lists[0] as T
  const whole = new List(lists.reduce((sum, list) => sum + list.length, 0))
  let at = 0
  for (const list of lists.splice(0)) {
    whole.set(list as never, at)
    at += list.length
  }
  lists.push(whole)
  return whole
}

/** The cells between points in rows along x, then y, then z. */
function cellsOfLattice([nx, ny, nz]: readonly [number, number, number], count: number): Uint32Array {
  const cells = new Uint32Array(8 * count)
  const layer = nx * ny
  let at = 0
  for (let k = 0; k + 1 < nz; ++k)
    for (let j = 0; j + 1 < ny; ++j)
      for (let i = 0; i + 1 < nx; ++i) {
        const p = i + nx * j + layer * k
        cells[at] = p
        cells[at + 1] = p + 1
        cells[at + 2] = p + 1 + nx
        cells[at + 3] = p + nx
        cells[at + 4] = p + layer
        cells[at + 5] = p + 1 + layer
        cells[at + 6] = p + 1 + nx + layer
        cells[at + 7] = p + nx + layer
        at += 8
      }
  return cells
}
