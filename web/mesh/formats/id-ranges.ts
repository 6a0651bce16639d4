/** Ids of a set as a file gives them, one by one or from one to another by steps; ranges are not written out until cells are looked for. */

export interface IdRange {
  readonly first: number
  readonly last: number
  readonly step: number
}

export class IdRanges {
  /** First, last and step of each. */
  readonly #ranges: number[] = []

  add(id: number): void {
    const last = this.#ranges.length - 2
    if (last > 0 && this.#ranges[last + 1] === 1 && (this.#ranges[last] as number) + 1 === id) this.#ranges[last] = id
    else this.#ranges.push(id, id, 1)
  }

  /** first, first + step, ... up to last. */
  addRange(first: number, last: number, step: number): void {
    this.#ranges.push(first, last, step)
  }

  /** The number of all ids, those that come twice counted twice. */
  get count(): number {
    let count = 0
    for (const range of this) count += countOf(range)
    return count
  }

  *[Symbol.iterator](): Iterator<IdRange> {
    for (let i = 0; i < this.#ranges.length; i += 3)
      yield {
        first: this.#ranges[i] as number,
        last: this.#ranges[i + 1] as number,
        step: this.#ranges[i + 2] as number,
      }
  }
}

export function countOf({ first, last, step }: IdRange): number {
  return Math.floor((last - first) / step) + 1
}

/** Finds what has the ids of ranges, in a time that is bounded by what there is. */
export class IdOrder {
  readonly #ids: Float64Array
  readonly #count: number
  /** Places by ascending id; null where they ascend anyway. */
  readonly #order: Uint32Array | null

  constructor(ids: Float64Array, count: number) {
    this.#ids = ids
    this.#count = count
    let isAscending = true
    for (let i = 1; i < count && isAscending; ++i) isAscending = (ids[i - 1] as number) <= (ids[i] as number)
    this.#order = isAscending
      ? null
      : Uint32Array.from({ length: count }, (_, i) => i).sort((a, b) => (ids[a] as number) - (ids[b] as number))
  }

  #placeAt(rank: number): number {
    return this.#order === null ? rank : (this.#order[rank] as number)
  }

  /** Gives each place whose id is in the ranges to `found`, once. */
  forEachIn(ranges: Iterable<IdRange>, found: (place: number) => void): void {
    const places: number[] = []
    for (const { first, last, step } of mergedRanges(ranges)) {
      for (let rank = this.#firstFrom(first); rank < this.#count; ++rank) {
        const place = this.#placeAt(rank)
        const id = this.#ids[place] as number
        if (id > last) break
        if ((id - first) % step === 0) places.push(place)
      }
    }
    const sorted = Uint32Array.from(places).sort()
    for (let i = 0; i < sorted.length; ++i) if (i === 0 || sorted[i] !== sorted[i - 1]) found(sorted[i] as number)
  }

  /** The first rank whose id is not less. */
  #firstFrom(id: number): number {
    let [low, high] = [0, this.#count]
    while (low < high) {
      const middle = (low + high) >>> 1
      if ((this.#ids[this.#placeAt(middle)] as number) < id) low = middle + 1
      else high = middle
    }
    return low
  }
}

/** Ranges of step 1 joined where they overlap or touch; the same range of another step but once. */
export function mergedRanges(ranges: Iterable<IdRange>): IdRange[] {
  const sorted = [...ranges].sort((a, b) => a.step - b.step || a.first - b.first || a.last - b.last)
  const merged: { first: number; last: number; step: number }[] = []
  for (const range of sorted) {
    const before = merged.at(-1)
    const joins =
      before !== undefined &&
      before.step === range.step &&
      (range.step === 1 ? range.first <= before.last + 1 : range.first === before.first)
    if (joins && before) before.last = Math.max(before.last, range.last)
    else merged.push({ ...range })
  }
  return merged
}
