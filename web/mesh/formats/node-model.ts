/**
 * Nodes and elements as finite element codes write them: both have ids, an element may come before its nodes, and ids hold within a part.
 * One pass: an id that an element names first gets its place then, and its coordinates when they come.
 */

import type { FileRows } from '../file-rows'
import { IdIndex } from '../id-index'
import { type CoordinatePlaces, MeshRefusal } from '../mesh'
import type { OtherCell } from '../mesh-builder'
import type { PrintedDigits } from '../precision'
import { Runs, runsOf } from '../runs'
import { shown } from '../text-cursor'
import { TokenList } from '../token-list'
import { TypedList } from '../typed-list'
import type { TextLines } from './text-lines'

/** A slot without a node, of an element of 20 nodes that has fewer. */
export const NO_NODE = 0xffffffff

/** Slots of an element that is not trilinear: corners, edges in VTK order, faces -xi, +xi, -eta, +eta, -zeta, +zeta, centre. */
export const QUADRATIC_SLOTS = 27

/** The order in which most codes write the nodes of an element of 20: bottom edges, top edges, upright edges, as VTK. */
export const ORDER_OF_20: readonly number[] = Array.from({ length: 20 }, (_, i) => i)

const NAMED = 0
const DEFINED = 1
const SHORT = 2

/** Moves a point in place: coordinates at `at`, `at + 1`, `at + 2`. */
export type Move = (points: Float64Array, at: number) => void

export class NodeModel {
  readonly #index = new IdIndex()
  readonly nodeIds = new TypedList(Float64Array)
  readonly points = new TypedList(Float64Array)
  readonly #state = new TypedList(Uint8Array)
  /** Lines of nodes with too few coordinates, by slot. */
  readonly #shortLines = new Map<number, { lines: TextLines; line: number; has: number }>()
  /** Coordinates in the file, three for each slot. */
  readonly #tokens = new TokenList()
  /** The one file that all coordinates stand in, each as a token. */
  #placesIn: TextLines | null = null
  #hasPlaces = true

  readonly cells = new TypedList(Uint32Array)
  readonly cellIds = new TypedList(Float64Array)
  readonly quadratic = new TypedList(Uint32Array)
  readonly quadraticIds = new TypedList(Float64Array)
  readonly others = new Map<OtherCell, number>()
  readonly blocks = new Map<string, Runs>()

  get cellCount(): number {
    return this.cellIds.length
  }

  get nodeCount(): number {
    return this.nodeIds.length
  }

  get isEmpty(): boolean {
    return this.nodeCount === 0 && this.cellCount === 0 && this.others.size === 0
  }

  /** The slot of the node that the file calls `id`. */
  slot(id: number): number {
    const found = this.#index.get(id)
    if (found >= 0) return found
    return this.#addNode(id, NAMED, Number.NaN, Number.NaN, Number.NaN)
  }

  #addNode(id: number, state: number, x: number, y: number, z: number): number {
    const slot = this.nodeIds.length
    this.#index.set(id, slot)
    this.nodeIds.push(id)
    this.#state.push(state)
    const at = this.points.length
    this.points.reserve(at + 3)
    const { values } = this.points
    values[at] = x
    values[at + 1] = y
    values[at + 2] = z
    this.points.length = at + 3
    return slot
  }

  /** The slot of a node that has coordinates, or -1. */
  definedSlot(id: number): number {
    const slot = this.#index.get(id)
    return slot >= 0 && this.#state.values[slot] !== NAMED ? slot : -1
  }

  /** Refuses a node that is there already, elsewhere. */
  defineNode(lines: TextLines, id: number, x: number, y: number, z: number, line = lines.number): number {
    const slot = this.#index.get(id)
    if (slot < 0) return this.#addNode(id, DEFINED, x, y, z)
    const points = this.points.values
    const at = 3 * slot
    if (this.#state.values[slot] === DEFINED) {
      if (!same(points[at], x) || !same(points[at + 1], y) || !same(points[at + 2], z))
        lines.refuse(`node ${id} is defined again, with other coordinates.`, line)
      return slot
    }
    points[at] = x
    points[at + 1] = y
    points[at + 2] = z
    this.#state.values[slot] = DEFINED
    return slot
  }

  /** A node whose line has fewer than three coordinates: no hexahedron may use it. */
  defineShortNode(lines: TextLines, id: number, coordinates: readonly number[], line = lines.number): number {
    const slot = this.slot(id)
    if (this.#state.values[slot] === NAMED) {
      for (let axis = 0; axis < 3; ++axis) this.points.values[3 * slot + axis] = coordinates[axis] ?? 0
      this.#state.values[slot] = SHORT
      this.#shortLines.set(slot, { lines, line, has: coordinates.length })
    }
    this.#hasPlaces = false
    return slot
  }

  /** Nodes of rows that begin with the id and end with the coordinates; `onSlot` is given their slots. */
  defineRows(lines: TextLines, rows: FileRows, onSlot?: (slot: number) => void): void {
    const { pattern, count, numbers, line, ahead } = rows
    const width = pattern.numberCount
    this.#index.expect(this.nodeCount + ahead)
    this.points.reserveMore(3 * count, 3 * ahead)
    this.nodeIds.reserveMore(count, ahead)
    if (this.#keepsPlaces(lines)) this.#tokens.reserve(3 * (this.nodeCount + count), 3 * (this.nodeCount + ahead))
    for (let row = 0; row < count; ++row) {
      const at = width * (row + 1) - 3
      const id = numbers[width * row] as number
      const x = numbers[at] as number
      const y = numbers[at + 1] as number
      const z = numbers[at + 2] as number
      const slot = this.defineNode(lines, id, x, y, z, line + pattern.lineCount * row)
      if (this.#hasPlaces) this.#tokens.putRow(3 * slot, rows, row)
      onSlot?.(slot)
    }
  }

  /** Hexahedra of rows that begin with the id and end with the eight nodes; returns the index of the first. */
  addRows({ pattern, count, numbers, ahead }: FileRows): number {
    const first = this.cellCount
    this.cells.reserveMore(8 * count, 8 * ahead)
    this.cellIds.reserveMore(count, ahead)
    const width = pattern.numberCount
    const [cells, ids] = [this.cells.values, this.cellIds.values]
    let next = this.cells.length
    for (let row = 0; row < count; ++row) {
      const at = width * (row + 1) - 8
      if (!this.#index.getEach(numbers, at, 8, cells, next))
        for (let v = 0; v < 8; ++v) cells[next + v] = this.slot(numbers[at + v] as number)
      next += 8
      ids[first + row] = numbers[width * row] as number
    }
    this.cells.length = next
    this.cellIds.length = first + count
    return first
  }

  /** Keeps the position in the file of a node's coordinate; the mesh has places only with all. */
  place(lines: TextLines, slot: number, axis: number, from: number, length: number): void {
    if (length <= 0 || length > 0xffff) this.#hasPlaces = false
    if (this.#keepsPlaces(lines)) this.#tokens.put(3 * slot + axis, from, length)
  }

  /** True as long as all coordinates stand in one file. */
  #keepsPlaces(lines: TextLines): boolean {
    this.#placesIn ??= lines
    if (this.#placesIn !== lines) this.#hasPlaces = false
    return this.#hasPlaces
  }

  /** Keeps the positions of three coordinates, which stand in neighbouring fields of the line. */
  placeFields(lines: TextLines, slot: number, first: number): void {
    for (let axis = 0; axis < 3; ++axis) {
      const from = lines.fieldFrom(first + axis)
      this.place(lines, slot, axis, lines.placeOf(from), lines.fieldTo(first + axis) - from)
    }
  }

  /** Defines a node by the coordinates in fields 1 to 3, which are 0 where they are blank; true if none is. */
  defineFields(lines: TextLines, id: number, precision: PrintedDigits): boolean {
    const x = lines.real(1, precision)
    const y = lines.real(2, precision)
    const slot = this.defineNode(lines, id, x, y, lines.real(3, precision))
    const isWhole = !lines.isFieldBlank(1) && !lines.isFieldBlank(2) && !lines.isFieldBlank(3)
    if (isWhole) this.placeFields(lines, slot, 1)
    else this.forgetPlaces()
    return isWhole
  }

  forgetPlaces(): void {
    this.#hasPlaces = false
  }

  /** Returns the cell's index. */
  addHexahedron(id: number, slots: ArrayLike<number>, from = 0): number {
    for (let v = 0; v < 8; ++v) this.cells.push(slots[from + v] as number)
    this.cellIds.push(id)
    return this.cellIds.length - 1
  }

  /** The slots of an element of 20 or 27 nodes: `order[i]` is where the file has the node of slot i, -1 for one it has not. */
  addQuadratic(id: number, slots: ArrayLike<number>, order: readonly number[]): void {
    for (let i = 0; i < QUADRATIC_SLOTS; ++i) {
      const at = order[i] ?? -1
      this.quadratic.push(at < 0 ? NO_NODE : (slots[at] as number))
    }
    this.quadraticIds.push(id)
  }

  addOther(type: OtherCell, count = 1): void {
    if (count > 0) this.others.set(type, (this.others.get(type) ?? 0) + count)
  }

  block(name: string): Runs {
    return runsOf(this.blocks, name)
  }

  /** The first element that names a node without three coordinates, as a sentence; null if there is none. */
  #fault(isFatal: (slot: number) => boolean): { sentence: string; shortSlot: number } | null {
    const lists = [
      { slots: this.cells, ids: this.cellIds, width: 8 },
      { slots: this.quadratic, ids: this.quadraticIds, width: QUADRATIC_SLOTS },
    ]
    for (const { slots, ids, width } of lists) {
      const { values, length } = slots
      for (let i = 0; i < length; ++i) {
        const slot = values[i] as number
        if (slot === NO_NODE || !isFatal(slot)) continue
        const element = ids.values[Math.floor(i / width)]
        return {
          sentence: `element ${element} names node ${this.nodeIds.values[slot]}, which is not defined.`,
          shortSlot: this.#state.values[slot] === SHORT ? slot : -1,
        }
      }
    }
    return null
  }

  /**
   * Refuses elements of 8 and more nodes whose nodes are not there. Where the text leaves lines out, such elements are left out
   * instead; returns how many were.
   */
  check(fileName: string, isCutOff: boolean): number {
    const state = this.#state.values
    const fault = this.#fault(slot => state[slot] === SHORT || (!isCutOff && state[slot] !== DEFINED))
    if (fault !== null) {
      const short = this.#shortLines.get(fault.shortSlot)
      const id = this.nodeIds.values[fault.shortSlot]
      if (short) short.lines.refuse(`node ${id} has ${short.has} coordinates, not 3.`, short.line)
      throw new MeshRefusal(`${shown(fileName).slice(1, -1)}: ${fault.sentence}`)
    }
    return isCutOff ? this.#leaveOutUnfinished() : 0
  }

  #leaveOutUnfinished(): number {
    const state = this.#state.values
    const isWhole = (values: Uint32Array, from: number, width: number) => {
      for (let i = from; i < from + width; ++i) {
        const slot = values[i] as number
        if (slot !== NO_NODE && state[slot] !== DEFINED) return false
      }
      return true
    }
    const newIndex = new Int32Array(this.cellCount).fill(-1)
    let [cells, left] = [0, 0]
    for (let cell = 0; cell < this.cellCount; ++cell) {
      if (!isWhole(this.cells.values, 8 * cell, 8)) {
        left++
        continue
      }
      this.cells.values.copyWithin(8 * cells, 8 * cell, 8 * cell + 8)
      this.cellIds.values[cells] = this.cellIds.values[cell] as number
      newIndex[cell] = cells++
    }
    if (left > 0) {
      this.cells.length = 8 * cells
      this.cellIds.length = cells
      for (const [name, runs] of this.blocks) {
        const kept = new Runs()
        for (const cell of runs) if ((newIndex[cell] as number) >= 0) kept.add(newIndex[cell] as number)
        this.blocks.set(name, kept)
      }
    }
    let quadratic = 0
    for (let cell = 0; cell < this.quadraticIds.length; ++cell) {
      const at = QUADRATIC_SLOTS * cell
      if (!isWhole(this.quadratic.values, at, QUADRATIC_SLOTS)) {
        left++
        continue
      }
      this.quadratic.values.copyWithin(QUADRATIC_SLOTS * quadratic, at, at + QUADRATIC_SLOTS)
      this.quadraticIds.values[quadratic] = this.quadraticIds.values[cell] as number
      quadratic++
    }
    this.quadratic.length = QUADRATIC_SLOTS * quadratic
    this.quadraticIds.length = quadratic
    return left
  }

  coordinatePlaces(): CoordinatePlaces | null {
    return this.#hasPlaces ? this.#tokens.places(3 * this.nodeCount) : null
  }
}

/** True if two of the first eight nodes are the same: as a hexahedron, the element has J <= 0 somewhere. */
export function isRepeating(nodes: ArrayLike<number>): boolean {
  for (let i = 0; i < 8; ++i) for (let j = 0; j < i; ++j) if (nodes[i] === nodes[j]) return true
  return false
}

function same(a = Number.NaN, b = Number.NaN): boolean {
  return a === b || (Number.isNaN(a) && Number.isNaN(b))
}
