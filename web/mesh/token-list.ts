/** The tokens in a file that coordinates are: where each begins, in 32 bits as long as these are enough, and how long it is. */
import type { FileRows } from './file-rows'
import type { CoordinatePlaces } from './mesh'

export class TokenList {
  #from: Uint32Array | Float64Array = new Uint32Array(1024)
  #lengths = new Uint16Array(1024)
  length = 0

  put(index: number, from: number, length: number): void {
    if (index >= this.#lengths.length) this.#grow(index + 1)
    if (from > 0xffffffff && this.#from instanceof Uint32Array) this.#from = new Float64Array(this.#from)
    this.#from[index] = from
    this.#lengths[index] = length
    if (index >= this.length) this.length = index + 1
  }

  /** The three coordinates with which a row ends. */
  putRow(index: number, { pattern, places, start }: FileRows, row: number): void {
    const first = pattern.realCount * (row + 1) - 3
    for (let axis = 0; axis < 3; ++axis) {
      const place = places[first + axis] as number
      this.put(index + axis, start + (place & 0xffffff), place >>> 24)
    }
  }

  /** Room for `count` in all, and where there is none for `expected`. */
  reserve(count: number, expected: number): void {
    if (count > this.#lengths.length) this.#grow(Math.max(count, expected))
  }

  /** The places of `count` coordinates; null unless each has its token. */
  places(count: number): CoordinatePlaces | null {
    const lengths = this.#lengths.subarray(0, count)
    if (count === 0 || this.length !== count || lengths.includes(0)) return null
    return { kind: 'tokens', from: this.#from.subarray(0, count), lengths }
  }

  #grow(count: number): void {
    const length = Math.max(count, 2 * this.#lengths.length)
    const from = this.#from instanceof Uint32Array ? new Uint32Array(length) : new Float64Array(length)
    const lengths = new Uint16Array(length)
    from.set(this.#from)
    lengths.set(this.#lengths)
    this.#from = from
    this.#lengths = lengths
  }
}
