/** Finds points by the ids that a file gives them, however large these are: a table where they are dense, else maps. */

const LEAST_TABLE = 65_536
/** A table has at most so many places an id. */
const SPARSEST = 4
/** A Map of JavaScript holds at most 2^24 entries. */
const MOST_IN_MAP = 2 ** 23

export class NodeIds {
  /** The index of the point plus one. */
  #table = new Uint32Array(1024)
  #count = 0
  readonly #sparse: Map<number, number>[] = []

  /** False if the id is there already: then nothing changes. */
  add(id: number, index: number): boolean {
    if (this.indexOf(id) >= 0) return false
    this.#count++
    if (id >= this.#table.length && id < Math.max(LEAST_TABLE, SPARSEST * this.#count)) {
      const longer = new Uint32Array(Math.max(2 * this.#table.length, id + 1))
      longer.set(this.#table)
      this.#table = longer
    }
    if (id < this.#table.length) this.#table[id] = index + 1
    else {
      let map = this.#sparse.at(-1)
      if (!map || map.size >= MOST_IN_MAP) {
        map = new Map()
        this.#sparse.push(map)
      }
      map.set(id, index)
    }
    return true
  }

  /** -1 if no point has the id. */
  indexOf(id: number): number {
    const place = id < this.#table.length ? (this.#table[id] as number) : 0
    if (place > 0) return place - 1
    for (const map of this.#sparse) {
      const index = map.get(id)
      if (index !== undefined) return index
    }
    return -1
  }
}
