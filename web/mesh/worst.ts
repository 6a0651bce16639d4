/** The order from the worst cell to the best. */
import { byRisingKey } from './rising'

/** Cells are compared by these; all lists have one entry a cell. */
export interface Severity {
  /** The boundary minimum over |volume|; NaN where the volume is 0. */
  readonly relativeMinima: Float64Array
  /** 1 for a cell whose jacdet is 0 everywhere; any other cell of volume 0 has a negative minimum. */
  readonly isCollapsed: (cell: number) => boolean
  readonly isUnanswered: (cell: number) => boolean
}

/** The most cells that are kept in order in one pass; for more all are sorted. */
export const FEW = 64

/**
 * The worst `most` of the cells that `isListed`, worst first: those of volume 0 with a negative minimum, then by rising relative
 * minimum, collapsed cells among the zeros, ties by index; cells that are unanswered come last.
 */
export function worstFirst(
  count: number,
  severity: Severity,
  most: number,
  isListed: (cell: number) => boolean,
): Uint32Array {
  if (most === 0) return new Uint32Array(0)
  const keys = keysOf(count, severity)
  const before = (a: number, b: number) => {
    const [first, second] = [keys[a] as number, keys[b] as number]
    return first < second ? -1 : first > second ? 1 : a - b
  }
  if (most <= FEW) return Uint32Array.from(fewWorst(count, most, isListed, before))
  const all = new Uint32Array(count)
  let listed = 0
  for (let cell = 0; cell < count; ++cell) if (isListed(cell)) all[listed++] = cell
  return byRisingKey(all.subarray(0, listed), keys).slice(0, Math.min(most, listed))
}

/** Rising from the worst on: relative minima are above the least double, and nothing is above an infinity. */
function keysOf(count: number, { relativeMinima, isCollapsed, isUnanswered }: Severity): Float64Array {
  const keys = new Float64Array(count)
  for (let cell = 0; cell < count; ++cell) {
    const relative = relativeMinima[cell] as number
    if (isUnanswered(cell)) keys[cell] = Infinity
    else if (!Number.isNaN(relative)) keys[cell] = relative
    else keys[cell] = isCollapsed(cell) ? 0 : -Infinity
  }
  return keys
}

function fewWorst(
  count: number,
  most: number,
  isListed: (cell: number) => boolean,
  before: (a: number, b: number) => number,
): number[] {
  const worst: number[] = []
  for (let cell = 0; cell < count; ++cell) {
    const last = worst.at(-1)
    if (worst.length === most && (last === undefined || before(cell, last) > 0)) continue
    if (!isListed(cell)) continue
    const at = worst.findIndex(other => before(cell, other) < 0)
    worst.splice(at < 0 ? worst.length : at, 0, cell)
    if (worst.length > most) worst.pop()
  }
  return worst
}
