/** Whole numbers that mostly count up, kept as runs: cells of a block. */

export class Runs {
  /** First and last of each run. */
  readonly #bounds: number[] = []

  get isEmpty(): boolean {
    return this.#bounds.length === 0
  }

  add(value: number): void {
    this.addRange(value, value)
  }

  addRange(from: number, to: number): void {
    const last = this.#bounds.length - 1
    if (last > 0 && (this.#bounds[last] as number) + 1 === from) this.#bounds[last] = to
    else this.#bounds.push(from, to)
  }

  addAll(other: Runs): void {
    const count = other.#bounds.length
    for (let i = 0; i < count; ++i) this.#bounds.push(other.#bounds[i] as number)
  }

  get count(): number {
    let count = 0
    for (let i = 0; i < this.#bounds.length; i += 2)
      count += (this.#bounds[i + 1] as number) - (this.#bounds[i] as number) + 1
    return count
  }

  *[Symbol.iterator](): Iterator<number> {
    for (let i = 0; i < this.#bounds.length; i += 2)
      for (let value = this.#bounds[i] as number; value <= (this.#bounds[i + 1] as number); ++value) yield value
  }

  /** All of them once, ascending. */
  sorted(): Uint32Array {
    let isAscending = true
    for (let i = 2; i < this.#bounds.length; i += 2)
      if ((this.#bounds[i] as number) <= (this.#bounds[i - 1] as number)) isAscending = false
    const all = new Uint32Array(this.count)
    let next = 0
    for (let i = 0; i < this.#bounds.length; i += 2)
      for (let value = this.#bounds[i] as number; value <= (this.#bounds[i + 1] as number); ++value) all[next++] = value
    if (isAscending) return all
    all.sort()
    let kept = 0
    for (let i = 0; i < all.length; ++i) if (i === 0 || all[i] !== all[i - 1]) all[kept++] = all[i] as number
    return all.slice(0, kept)
  }
}

/** The runs of this key, which begin empty. */
export function runsOf<K>(all: Map<K, Runs>, key: K): Runs {
  let runs = all.get(key)
  if (runs === undefined) {
    runs = new Runs()
    all.set(key, runs)
  }
  return runs
}
