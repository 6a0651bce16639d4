/** A part of an Abaqus model: its nodes and elements, its sets, and what is generated from them. */

import { IdIndex } from '../id-index'
import { MOST_IMPLIED_CELLS } from '../mesh'
import type { OtherCell } from '../mesh-builder'
import { Runs } from '../runs'
import { shown } from '../text-cursor'
import { TypedList } from '../typed-list'
import { countOf, IdOrder, type IdRange, IdRanges, mergedRanges } from './id-ranges'
import { type Move, NodeModel } from './node-model'
import type { TextLines } from './text-lines'

interface NodeSet {
  readonly ids: IdRanges
  /** Other sets that are in this one. */
  readonly names: string[]
}

interface ElementSet extends NodeSet {
  readonly name: string
  readonly cells: Runs
  /** True if a program made it for itself. */
  readonly isInternal: boolean
}

export interface Direction {
  readonly count: number
  readonly nodeStep: number
  readonly elementStep: number
}

const OTHER_CELLS: OtherCell[] = []

export class AbaqusPart {
  readonly model = new NodeModel()
  readonly #nodeSets = new Map<string, NodeSet>()
  readonly #elementSets = new Map<string, ElementSet>()
  readonly #otherIds = new TypedList(Float64Array)
  readonly #otherTypes = new TypedList(Uint8Array)
  readonly #cellOfId: Indexed = { index: new IdIndex(), count: 0 }
  readonly #otherOfId: Indexed = { index: new IdIndex(), count: 0 }
  #implied = 0

  nodeSetWithNames(name: string): NodeSet {
    const key = name.toUpperCase()
    let set = this.#nodeSets.get(key)
    if (set === undefined) {
      set = { ids: new IdRanges(), names: [] }
      this.#nodeSets.set(key, set)
    }
    return set
  }

  /** Null without a name. */
  nodeSet(name: string | undefined): IdRanges | null {
    return name === undefined ? null : this.nodeSetWithNames(name).ids
  }

  elementSet(name: string, isInternal = false): ElementSet {
    const key = name.toUpperCase()
    let set = this.#elementSets.get(key)
    if (set === undefined) {
      set = { name, ids: new IdRanges(), cells: new Runs(), names: [], isInternal }
      this.#elementSets.set(key, set)
    }
    return set
  }

  addOther(type: OtherCell, id: number): void {
    this.model.addOther(type)
    if (!OTHER_CELLS.includes(type)) OTHER_CELLS.push(type)
    this.#otherIds.push(id)
    this.#otherTypes.push(OTHER_CELLS.indexOf(type))
  }

  // Sets

  /** The nodes of a set, or the one node of this number, ascending. */
  sortedNodes(lines: TextLines, name: string): number[] {
    if (/^\d{1,15}$/.test(name) && !this.#nodeSets.has(name)) return [Number(name)]
    const ranges = rangesOf(this.#nodeSets, name)
    if (ranges === null) lines.refuse(`the set of nodes ${shown(name)} is not defined.`)
    return this.#distinct(lines, ranges)
  }

  #distinct(lines: TextLines, ranges: readonly IdRange[]): number[] {
    const merged = mergedRanges(ranges)
    this.#imply(
      lines,
      merged.reduce((sum, range) => sum + countOf(range), 0),
    )
    const ids = new Set<number>()
    for (const { first, last, step } of merged) for (let id = first; id <= last; id += step) ids.add(id)
    return [...ids].sort((a, b) => a - b)
  }

  /** Makes blocks of the sets of elements that have cells. */
  finishSets(): void {
    for (const [name, cells] of this.cellsOfSets(this)) this.model.block(name).addAll(cells)
    this.#elementSets.clear()
  }

  /** The cells of `part` that are in the sets of this one, by name. */
  cellsOfSets(part: AbaqusPart): Map<string, Runs> {
    const found = new Map<string, Runs>()
    let order: IdOrder | null = null
    for (const [key, set] of this.#elementSets) {
      if (set.isInternal) continue
      const cells = new Runs()
      cells.addAll(set.cells)
      const isByTypeOnly = set.names.length === 0 && !set.cells.isEmpty && set.ids.count === 0
      if (!isByTypeOnly) {
        order ??= new IdOrder(part.model.cellIds.values, part.model.cellCount)
        order.forEachIn(this.#elementRanges(key) ?? [], cell => cells.add(cell))
      }
      if (!cells.isEmpty) found.set(set.name, cells)
    }
    return found
  }

  #cellIndex(): IdIndex {
    return indexed(this.#cellOfId, this.model.cellIds)
  }

  // Generated nodes and elements

  #imply(lines: TextLines, count: number): void {
    this.#implied += count
    if (!(this.#implied <= MOST_IMPLIED_CELLS))
      lines.refuse(`more than ${MOST_IMPLIED_CELLS} nodes and elements are generated.`)
  }

  #coordinates(lines: TextLines, id: number): readonly [number, number, number] {
    const slot = this.model.definedSlot(id)
    if (slot < 0) lines.refuse(`node ${id} is not defined yet.`)
    const { values } = this.model.points
    return [values[3 * slot] as number, values[3 * slot + 1] as number, values[3 * slot + 2] as number]
  }

  #between(lines: TextLines, first: number, last: number, step: number, steps: number, id: number): void {
    const [a, b] = [this.#coordinates(lines, first), this.#coordinates(lines, last)]
    const at = (axis: 0 | 1 | 2) => a[axis] + ((b[axis] - a[axis]) * step) / steps
    if (id < 0) lines.refuse(`node ${id} is no number of a node.`)
    this.model.defineNode(lines, id, at(0), at(1), at(2))
  }

  /** *NGEN: nodes first, first + step, ... up to last, equally far from each other. */
  generateLine(lines: TextLines, first: number, last: number, step: number, set: IdRanges | null): void {
    const count = Math.abs(last - first) / step
    if (!Number.isInteger(count) || count === 0)
      lines.refuse(`nodes ${first} to ${last} cannot be reached by steps of ${step}.`)
    this.#imply(lines, count)
    const sign = last > first ? 1 : -1
    for (let i = 0; i <= count; ++i) {
      const id = first + sign * i * step
      if (i > 0 && i < count) this.#between(lines, first, last, i, count, id)
      set?.add(id)
    }
  }

  /** *NFILL: nodes between two sets, each node of one to the node of the other. */
  fill(
    lines: TextLines,
    from: readonly number[],
    to: readonly number[],
    intervals: number,
    step: number,
    set: IdRanges | null,
  ): void {
    if (from.length !== to.length)
      lines.refuse(`the sets have ${from.length} and ${to.length} nodes: as many were expected.`)
    if (intervals < 1) lines.refuse('at least one interval was expected.')
    this.#imply(lines, from.length * intervals)
    for (const [i, first] of from.entries()) {
      const last = to[i] as number
      set?.add(first)
      for (let k = 1; k < intervals; ++k) {
        const id = first + k * step
        this.#between(lines, first, last, k, intervals, id)
        set?.add(id)
      }
      set?.add(last)
    }
  }

  /** *NCOPY */
  copyNodes(lines: TextLines, old: readonly number[], change: number, move: Move, set: IdRanges | null): void {
    this.#imply(lines, old.length)
    const point = new Float64Array(3)
    for (const id of old) {
      point.set(this.#coordinates(lines, id))
      move(point, 0)
      const copy = id + change
      if (copy < 0) lines.refuse(`node ${copy} is no number of a node.`)
      this.model.defineNode(lines, copy, point[0] as number, point[1] as number, point[2] as number)
      set?.add(copy)
    }
  }

  /** *ELGEN: rows, columns and layers of elements like the one that is there. */
  generateElements(lines: TextLines, master: number, directions: readonly Direction[], set: ElementSet | null): void {
    const [row, column, layer] = directions as [Direction, Direction, Direction]
    if (directions.some(({ count }) => count < 1)) lines.refuse('at least one element in each direction was expected.')
    this.#imply(lines, 9 * row.count * column.count * layer.count)
    const cell = this.#cellIndex().get(master)
    if (cell >= 0) set?.cells.add(cell)
    else set?.ids.add(master)
    for (let k = 0; k < layer.count; ++k)
      for (let j = 0; j < column.count; ++j)
        for (let i = 0; i < row.count; ++i) {
          if (i + j + k === 0) continue
          const nodeShift = i * row.nodeStep + j * column.nodeStep + k * layer.nodeStep
          const elementShift = i * row.elementStep + j * column.elementStep + k * layer.elementStep
          this.#repeat(lines, master, cell, elementShift, nodeShift, set)
        }
  }

  /** The ranges of `rangesOf`, with the cells that the sets have by their type. */
  #elementRanges(name: string): IdRange[] | null {
    const idsOfCells = ({ cells }: ElementSet): IdRanges => {
      const ids = new IdRanges()
      for (const cell of cells) ids.add(this.model.cellIds.values[cell] as number)
      return ids
    }
    return rangesOf(this.#elementSets, name, idsOfCells)
  }

  /** *ELCOPY */
  copyElements(lines: TextLines, old: string, elementShift: number, nodeShift: number, set: ElementSet | null): void {
    const ranges = this.#elementRanges(old)
    if (ranges === null) lines.refuse(`the set of elements ${shown(old)} is not defined.`)
    const ids = this.#distinct(lines, ranges)
    this.#imply(lines, 9 * ids.length)
    const index = this.#cellIndex()
    for (const id of ids) this.#repeat(lines, id, index.get(id), elementShift, nodeShift, set)
  }

  #repeat(
    lines: TextLines,
    master: number,
    cell: number,
    elementShift: number,
    nodeShift: number,
    set: ElementSet | null,
  ): void {
    const { model } = this
    const id = master + elementShift
    if (id < 0) lines.refuse(`element ${id} is no number of an element.`)
    if (cell < 0) {
      set?.ids.add(id)
      const other = indexed(this.#otherOfId, this.#otherIds).get(master)
      if (other < 0)
        lines.refuse(`element ${master}, from which others are generated, is no hexahedron of 8 nodes that is defined.`)
      this.addOther(OTHER_CELLS[this.#otherTypes.values[other] as number] as OtherCell, id)
      return
    }
    const slots: number[] = []
    for (let v = 0; v < 8; ++v) {
      const node = (model.nodeIds.values[model.cells.values[8 * cell + v] as number] as number) + nodeShift
      if (node < 0) lines.refuse(`node ${node} is no number of a node.`)
      slots.push(model.slot(node))
    }
    const copy = model.addHexahedron(id, slots)
    set?.cells.add(copy)
  }
}

/** The places of so many ids of a list. */
interface Indexed {
  readonly index: IdIndex
  count: number
}

/** The first place of each id, with those that have come since. */
function indexed(places: Indexed, ids: TypedList<Float64Array>): IdIndex {
  for (; places.count < ids.length; ++places.count) {
    const id = ids.values[places.count] as number
    if (places.index.get(id) < 0) places.index.set(id, places.count)
  }
  return places.index
}

/** The ids of a set and of the sets that it names; null if there is no such set. */
function rangesOf<T extends NodeSet>(
  sets: ReadonlyMap<string, T>,
  name: string,
  further: (set: T) => Iterable<IdRange> = () => [],
): IdRange[] | null {
  const ranges: IdRange[] = []
  const seen = new Set<string>()
  const open = [name.toUpperCase()]
  for (let key = open.pop(); key !== undefined; key = open.pop()) {
    const set = sets.get(key)
    if (set === undefined || seen.has(key)) continue
    seen.add(key)
    for (const range of set.ids) ranges.push(range)
    for (const range of further(set)) ranges.push(range)
    for (const other of set.names) open.push(other.toUpperCase())
  }
  return seen.size > 0 ? ranges : null
}
