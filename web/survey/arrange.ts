/** The list's orders. */
import { CLASSES } from '../core/unpack'
import { firstBlocks } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import { byRisingKey } from '../mesh/rising'
import type { Arrangement, Column } from './survey-jobs'

/** Ties are by the worst first. */
export function arranged(check: MeshCheck, { column, isDescending }: Arrangement): Uint32Array {
  if (column === 'worst') return isDescending ? check.worst.slice().reverse() : check.worst
  const keys = keysOf(check, column)
  if (isDescending) for (let cell = 0; cell < keys.length; ++cell) keys[cell] = -(keys[cell] as number)
  return byRisingKey(check.worst, keys)
}

function keysOf(check: MeshCheck, column: Exclude<Column, 'worst'>): Float64Array {
  const { answers, hexahedra, mesh } = check
  const { minima, volumes, classes, acceptedBy } = answers
  const each = (keyOf: (cell: number) => number) => Float64Array.from({ length: hexahedra }, (_, cell) => keyOf(cell))
  switch (column) {
    case 'id':
      return idKeys(check)
    case 'block': {
      const blocks = firstBlocks(mesh)
      return each(cell => blocks?.[cell] ?? 0)
    }
    case 'minimum':
      return each(cell => scaled(minima, cell))
    case 'volume':
      return each(cell => scaled(volumes, cell))
    case 'class':
      return each(cell => (check.isAnswered(cell) ? (classes[cell] as number) : CLASSES.length))
    case 'accepted-by':
      return each(cell => bitsIn(acceptedBy?.[cell] ?? 0))
  }
}

function idKeys({ mesh: { ids }, hexahedra }: MeshCheck): Float64Array {
  if (ids instanceof Float64Array) return ids.slice()
  const keys = new Float64Array(hexahedra)
  if (ids === null) for (let cell = 0; cell < hexahedra; ++cell) keys[cell] = cell
  else {
    const collator = new Intl.Collator('en', { numeric: true })
    const cells = Uint32Array.from({ length: hexahedra }, (_, cell) => cell)
    cells.sort((a, b) => collator.compare(ids[a] as string, ids[b] as string))
    for (const [rank, cell] of cells.entries()) keys[cell] = rank
  }
  return keys
}

interface ScaledList {
  readonly values: Float64Array
  readonly exponents: Int16Array
}

/** Beyond the doubles' range an infinity or 0: such cells are ties. */
function scaled(list: ScaledList | null, cell: number): number {
  if (!list) return 0
  const half = Math.trunc((list.exponents[cell] as number) / 2)
  return (list.values[cell] as number) * 2 ** half * 2 ** ((list.exponents[cell] as number) - half)
}

function bitsIn(mask: number): number {
  let count = 0
  for (let rest = mask; rest > 0; rest >>= 1) count += rest & 1
  return count
}
