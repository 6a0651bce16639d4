/**
 * Places of ids that a file chose, in any order: an array where they lie close together, as most do, maps for the others. Memory is linear in
 * the number of ids, however large these are.
 */

/** A map of JavaScript holds 2^24 entries. */
const SHARDS = 64
/** An array has at most so many places an id, and some more. */
const SPARSEST = 4
const SOME = 1024

export class IdIndex {
  /** One more than the place, of ids from `#base` on; 0 for an id that is not there. No id of these is in the maps. */
  #near = new Uint32Array(0)
  #base = 0
  #nearCount = 0
  /** The array may reach as far as if there were so many ids already. */
  #expected = 0
  #nearLeast = Number.POSITIVE_INFINITY
  #nearMost = -1
  #far: Map<number, number>[] | null = null
  #farCount = 0
  #farLeast = Number.POSITIVE_INFINITY
  #farMost = -1
  /** Ids in the maps at which it is checked if all of them lie close together by now. */
  #farLook = SOME

  get count(): number {
    return this.#nearCount + this.#farCount
  }

  /** Expects up to so many ids: no more than there is memory for, 16 bytes each. */
  expect(count: number): void {
    this.#expected = Math.max(this.#expected, count)
  }

  /** The place of an id, or -1. */
  get(id: number): number {
    const at = id - this.#base
    if (at >= 0 && at < this.#near.length) return (this.#near[at] as number) - 1
    return this.#far === null ? -1 : (this.#far[id % SHARDS]?.get(id) ?? -1)
  }

  /** The places of `count` ids, from `ids[from]` on, into `places` from `to` on. False at the first that is not there. */
  getEach(ids: ArrayLike<number>, from: number, count: number, places: Uint32Array, to: number): boolean {
    const near = this.#near
    const base = this.#base
    for (let i = 0; i < count; ++i) {
      const id = ids[from + i] as number
      const at = id - base
      const place = at >= 0 && at < near.length ? (near[at] as number) - 1 : this.get(id)
      if (place < 0) return false
      places[to + i] = place
    }
    return true
  }

  /** `id` must be an integer from 0 to 2^53, and not be there yet. */
  set(id: number, place: number): void {
    const at = id - this.#base
    if (!(at >= 0 && at < this.#near.length)) {
      const least = Math.min(this.#nearLeast, id)
      const most = Math.max(this.#nearMost, id)
      if (most - least >= SPARSEST * Math.max(this.#nearCount, this.#expected) + SOME) {
        this.#setFar(id, place)
        return
      }
      this.#cover(least, most)
    }
    this.#setNear(id, place)
  }

  #setNear(id: number, place: number): void {
    this.#near[id - this.#base] = place + 1
    this.#nearCount++
    if (id < this.#nearLeast) this.#nearLeast = id
    if (id > this.#nearMost) this.#nearMost = id
  }

  #setFar(id: number, place: number): void {
    this.#far ??= Array.from({ length: SHARDS }, () => new Map())
    this.#far[id % SHARDS]?.set(id, place)
    this.#farCount++
    if (id < this.#farLeast) this.#farLeast = id
    if (id > this.#farMost) this.#farMost = id
    if (this.#farCount < this.#farLook) return
    this.#farLook = 2 * this.#farCount
    const least = Math.min(this.#nearLeast, this.#farLeast)
    const most = Math.max(this.#nearMost, this.#farMost)
    if (most - least < SPARSEST * this.count + SOME) this.#cover(least, most)
  }

  /** Makes the array reach from `least` to `most`, and as far again where it grows; what is in the maps of these goes there. */
  #cover(least: number, most: number): void {
    const span = most - least + 1
    const end = this.#base + this.#near.length
    const base = least < this.#base || end === 0 ? Math.max(0, least - span) : this.#base
    const longer = new Uint32Array(Math.max(end, most + 1 + span) - base)
    if (end > 0) longer.set(this.#near, this.#base - base)
    this.#near = longer
    this.#base = base
    for (const map of this.#far ?? [])
      for (const [id, place] of map) {
        if (id < base || id - base >= longer.length) continue
        map.delete(id)
        this.#farCount--
        this.#setNear(id, place)
      }
    if (this.#farCount === 0) this.#far = null
  }
}
