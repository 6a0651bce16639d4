/** Points that the cells of a text name: those before them, else those after. */
import type { MeshBuilder } from '../mesh-builder'
import { isCells } from './cell-rows'
import type { NumberTable } from './number-table'
import type { PointSet } from './point-set'
import { isNamed, NO_POINT_NAME, POINT_NAME } from './table-names'

interface Part {
  readonly set: PointSet
  readonly cells: readonly NumberTable[]
}

/** Cells with the points that they name: those before them, else those after. */
export function pairs(tables: readonly NumberTable[], sets: readonly PointSet[], builder: MeshBuilder): Part[] {
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
