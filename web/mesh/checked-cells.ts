/** The cells of a checked mesh as a list, worst first, for whoever shows them: all of them, as columns that a worker hands over. */

import type { Vertices } from '../model/hexahedron'
import { type NodeOrder, nodeOrders } from '../model/node-orders'
import { readNumber } from '../model/number-text'
import { firstBlocks, type Mesh } from './mesh'
import { type MeshCheck, STANDINGS, type Standing } from './mesh-check'
import { shown } from './shown'
import { verticesOf } from './vertices-of'

/** Names one after the other in UTF-8; name i ends where `ends[i]` says. */
export interface PackedNames {
  readonly bytes: Uint8Array<ArrayBuffer>
  readonly ends: Uint32Array<ArrayBuffer>
}

export interface CheckedColumns extends Pick<Mesh, 'points' | 'cells' | 'isOrderStated'> {
  readonly ids: Float64Array | PackedNames | null
  readonly blockNames: readonly string[]
  readonly blocks: Uint32Array | null
  /** Indices into STANDINGS. */
  readonly standings: Uint8Array
  readonly relativeMinima: Float64Array
  /** Cells, worst first: all of them. */
  readonly worst: Uint32Array
  /** Ids of node orders in which cells are valid whose own is not stated. */
  readonly openOrders: ReadonlyMap<number, string>
}

export interface ListedCell {
  /** Counted from 0 in the file's order. */
  readonly cell: number
  /** The id in the file, or the cell's index if it has no ids; safe to show. */
  readonly id: string
  readonly block: string | null
  readonly standing: Standing
  /** NaN where the volume is 0, or there is no answer. */
  readonly relativeMinimum: number
  /** Why there is no answer; null where there is one. */
  readonly why: string | null
}

/** In the worker: all cells must be among the check's worst. */
export function columnsOf(check: MeshCheck): CheckedColumns {
  const { mesh, answers, worst, openOrders } = check
  return {
    points: mesh.points,
    cells: mesh.cells,
    isOrderStated: mesh.isOrderStated,
    ids: mesh.ids === null || mesh.ids instanceof Float64Array ? mesh.ids : packedNames(mesh.ids),
    blockNames: mesh.blocks.map(({ name }) => shown(name).slice(1, -1)),
    blocks: firstBlocks(mesh),
    standings: check.standings,
    relativeMinima: answers.relativeMinima,
    worst,
    openOrders: new Map([...openOrders].map(([cell, { id }]) => [cell, id])),
  }
}

export class CheckedCells {
  readonly #columns: CheckedColumns

  constructor(columns: CheckedColumns) {
    this.#columns = columns
  }

  get count(): number {
    return this.#columns.worst.length
  }

  get hasIds(): boolean {
    return this.#columns.ids !== null
  }

  get hasBlocks(): boolean {
    return this.#columns.blockNames.length > 0
  }

  get isOrderStated(): boolean {
    return this.#columns.isOrderStated
  }

  /** The cell of a rank in the list, from 0, the worst. */
  at(rank: number): ListedCell {
    return this.named(this.#columns.worst[rank] as number)
  }

  named(cell: number): ListedCell {
    const { blocks, blockNames, standings, relativeMinima } = this.#columns
    return {
      cell,
      id: shown(this.#idOf(cell)).slice(1, -1),
      block: blockNames[blocks?.[cell] ?? blockNames.length] ?? null,
      standing: STANDINGS[standings[cell] as number] as Standing,
      relativeMinimum: relativeMinima[cell] as number,
      why: this.#whyUnanswered(cell),
    }
  }

  rankOf(cell: number): number {
    return this.#columns.worst.indexOf(cell)
  }

  /**
   * The next cell after `after` that the file calls so, from the first again behind the last; null if
   * there is none. Where ids are numbers, `id` is one however it is written.
   */
  find(id: string, after = -1): number | null {
    const { ids } = this.#columns
    const count = this.count
    const isIt =
      ids === null || ids instanceof Float64Array ? isNumber(ids, id) : isName(ids, new TextEncoder().encode(id))
    for (let step = 1; step <= count; ++step) {
      const cell = (after + step) % count
      if (isIt(cell)) return cell
    }
    return null
  }

  /** 24 coordinates; null where one is not finite. */
  verticesOf(cell: number): Vertices | null {
    const vertices = verticesOf(this.#columns, cell)
    return vertices.every(Number.isFinite) ? vertices : null
  }

  /** The order in which the cell is valid, where its own is not stated and it is not valid in that of the text. */
  openOrderOf(cell: number): NodeOrder | null {
    const id = this.#columns.openOrders.get(cell)
    return nodeOrders.find(order => order.id === id) ?? null
  }

  #idOf(cell: number): string {
    const { ids } = this.#columns
    if (ids === null) return String(cell)
    if (ids instanceof Float64Array) return String(ids[cell])
    return new TextDecoder().decode(ids.bytes.subarray(cell === 0 ? 0 : ids.ends[cell - 1], ids.ends[cell]))
  }

  #whyUnanswered(cell: number): string | null {
    if (STANDINGS[this.#columns.standings[cell] as number] !== 'unanswered') return null
    const order = this.openOrderOf(cell)
    if (order) return `order not stated; valid in the order “${order.name}”`
    const vertices = verticesOf(this.#columns, cell)
    const bad = vertices.findIndex(value => !Number.isFinite(value))
    return bad < 0 ? 'not answered' : `vertex ${Math.floor(bad / 3)} ${'xyz'[bad % 3]} is ${vertices[bad]}`
  }
}

/** Without ids the index is the number. */
function isNumber(ids: Float64Array | null, id: string): (cell: number) => boolean {
  const wanted = readNumber(id)
  return cell => wanted.ok && (ids === null ? cell : ids[cell]) === wanted.value
}

function isName({ bytes, ends }: PackedNames, wanted: Uint8Array): (cell: number) => boolean {
  return cell => {
    const from = cell === 0 ? 0 : (ends[cell - 1] as number)
    return (ends[cell] as number) - from === wanted.length && wanted.every((byte, i) => bytes[from + i] === byte)
  }
}

function packedNames(names: readonly string[]): PackedNames {
  const encoder = new TextEncoder()
  const encoded = names.map(name => encoder.encode(name))
  const ends = new Uint32Array(names.length)
  let end = 0
  for (const [i, { length }] of encoded.entries()) {
    end += length
    ends[i] = end
  }
  const bytes = new Uint8Array(end)
  for (const [i, name] of encoded.entries()) bytes.set(name, (ends[i] as number) - name.length)
  return { bytes, ends }
}
