/**
 * Places of ids that a file chose: an array where the ids lie close together, as most do, maps for the others. Memory is linear in the
 * number of ids, however large these are.
 */

/** A map of JavaScript holds 2^24 entries. */
const SHARDS = 64

export class IdIndex {
  /** The array begins at the first id that came. */
  #base = -1
  /** One more than the place; 0 for an id that is not there. */
  #near = new Uint32Array(1024)
  #far: Map<number, number>[] | null = null
  #count = 0

  get count(): number {
    return this.#count
  }

  /** The place of an id, or -1. */
  get(id: number): number {
    const at = id - this.#base
    if (at >= 0 && at < this.#near.length) {
      const place = this.#near[at] as number
      if (place !== 0) return place - 1
    }
    return this.#far === null ? -1 : (this.#far[id % SHARDS]?.get(id) ?? -1)
  }

  /** `id` must be an integer from 0 to 2^53, and not be there yet. */
  set(id: number, place: number): void {
    if (this.#base < 0) this.#base = id
    this.#count++
    const at = id - this.#base
    if (at >= 0 && at < 4 * this.#count + 1024) {
      if (at >= this.#near.length) {
        const longer = new Uint32Array(Math.max(at + 1, 2 * this.#near.length))
        longer.set(this.#near)
        this.#near = longer
      }
      this.#near[at] = place + 1
      return
    }
    this.#far ??= Array.from({ length: SHARDS }, () => new Map())
    this.#far[id % SHARDS]?.set(id, place)
  }
}
