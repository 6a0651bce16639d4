/** The best finds so far, in two orders: the result is the same however the finds were divided among workers. */
import type { Vertices } from '../../../model/hexahedron'

export interface Find {
  /** Its index in the stream of elements that the seed gives. */
  readonly index: number
  readonly vertices: Vertices
  /** The cost of writing it down: simplicity.ts. */
  readonly complexity: number
  /** The measure of the query. */
  readonly extremeness: number
}

export type Order = 'simplicity' | 'extremeness'

/** Finds that are kept in each order: as many as anyone looks at. */
export const MOST_KEPT = 48

const before: Readonly<Record<Order, (a: Find, b: Find) => number>> = {
  simplicity: (a, b) => a.complexity - b.complexity || a.index - b.index,
  extremeness: (a, b) => compared(b.extremeness, a.extremeness) || a.complexity - b.complexity || a.index - b.index,
}

/** Infinities equal themselves. */
function compared(a: number, b: number): number {
  return a === b ? 0 : a < b ? -1 : 1
}

export class Ranking {
  readonly #order: Order
  readonly #most: number
  #finds: Find[] = []
  readonly #known = new Map<string, number>()

  constructor(order: Order, most = MOST_KEPT) {
    this.#order = order
    this.#most = most
  }

  /** Best first, no element twice. */
  get finds(): readonly Find[] {
    return this.#finds
  }

  /** True if a find with this complexity and at most that extremeness can still come in. */
  mayTake(complexity: number, extremeness: number): boolean {
    const last = this.#finds.at(-1)
    if (!last || this.#finds.length < this.#most) return true
    return this.#order === 'simplicity' ? complexity <= last.complexity : extremeness >= last.extremeness
  }

  /** Takes finds in any order of their indices. False if it is not among the best, or known. */
  add(find: Find): boolean {
    const compare = before[this.#order]
    const last = this.#finds.at(-1)
    if (last && this.#finds.length >= this.#most && compare(find, last) >= 0) return false
    const key = find.vertices.join()
    const known = this.#known.get(key)
    if (known !== undefined && known <= find.index) return false
    const others = known === undefined ? this.#finds : this.#finds.filter(({ index }) => index !== known)
    const at = others.findIndex(other => compare(find, other) < 0)
    const finds = others.toSpliced(at < 0 ? others.length : at, 0, find)
    for (const dropped of finds.slice(this.#most)) this.#known.delete(dropped.vertices.join())
    this.#known.set(key, find.index)
    this.#finds = finds.slice(0, this.#most)
    return true
  }
}
