/** Places in a file, in 32 bits as long as these are enough. */

export class PlaceList {
  #values: Uint32Array | Float64Array = new Uint32Array(1024)
  length = 0

  put(index: number, place: number): void {
    if (index >= this.#values.length) this.#grow(index + 1)
    if (place > 0xffffffff && this.#values instanceof Uint32Array) this.#values = new Float64Array(this.#values)
    this.#values[index] = place
    if (index >= this.length) this.length = index + 1
  }

  push(place: number): void {
    this.put(this.length, place)
  }

  /** The first of them. */
  upTo(count: number): Uint32Array | Float64Array {
    if (count > this.#values.length) this.#grow(count)
    return this.#values.subarray(0, count)
  }

  /** Room for `count` in all, and where there is none for `expected`. */
  reserve(count: number, expected: number): void {
    if (count > this.#values.length) this.#grow(Math.max(count, expected))
  }

  #grow(count: number): void {
    const length = Math.max(count, 2 * this.#values.length)
    const longer = this.#values instanceof Uint32Array ? new Uint32Array(length) : new Float64Array(length)
    longer.set(this.#values)
    this.#values = longer
  }
}
