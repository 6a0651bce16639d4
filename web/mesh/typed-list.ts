/** Numbers in a typed array that grows: for what a reader collects before it knows how much there is. */

type Numbers = Float64Array | Uint32Array | Uint16Array | Uint8Array

export class TypedList<T extends Numbers> {
  /** Longer than `length`: read only what lies below it. */
  values: T
  length = 0

  constructor(private readonly make: new (length: number) => T) {
    this.values = new make(256)
  }

  push(value: number): void {
    if (this.length === this.values.length) this.reserve(this.length + 1)
    this.values[this.length++] = value
  }

  /** Room for so many; what is new is 0. */
  reserve(count: number): void {
    if (count <= this.values.length) return
    const longer = new this.make(Math.max(count, 2 * this.values.length))
    longer.set(this.values)
    this.values = longer
  }

  /** Room for `count` more, and where there is none for `expected`. */
  reserveMore(count: number, expected: number): void {
    if (this.length + count > this.values.length) this.reserve(this.length + Math.max(count, expected))
  }

  /** All of it; the list may no longer be changed then. */
  whole(): T {
    const values = this.values.subarray(0, this.length)
    return (4 * this.length < this.values.length ? values.slice() : values) as T
  }
}
