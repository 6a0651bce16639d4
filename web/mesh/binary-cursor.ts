/**
 * Numbers of a binary file, one after the other or in bulk, of either byte order: read in chunks.
 * Refuses what lies beyond the end.
 */
import { MACHINE_IS_LITTLE_ENDIAN, swapBytes } from './endian'
import { FileChunk } from './file-chunk'
import { MeshRefusal } from './mesh'
import type { MeshFile } from './source'

/** Chunks begin small and grow, so that whoever reads little reads little. */
const FIRST_CHUNK = 4096
const LARGEST_CHUNK = 1024 * 1024
const TWO_32 = 2 ** 32
const INTS_AT_ONCE = 32_768
const NOTHING = new Uint8Array(0)

export class BinaryCursor {
  readonly #file: MeshFile
  readonly isLittleEndian: boolean
  #view: DataView = new DataView(new ArrayBuffer(0))
  #bytes: Uint8Array = new Uint8Array(0)
  #chunk = FIRST_CHUNK
  readonly #few = new Int32Array(64)
  readonly #memory = new FileChunk()
  #aligned = new Uint8Array(0)
  #start: number
  #at = 0

  constructor(file: MeshFile, from: number, isLittleEndian: boolean) {
    this.#file = file
    this.#start = from
    this.isLittleEndian = isLittleEndian
  }

  /** The byte of the file that is next. */
  get position(): number {
    return this.#start + this.#at
  }

  get left(): number {
    return this.#file.size - this.position
  }

  /** Throws: "part.msh, byte 120: ...". */
  refuse(what: string): never {
    throw new MeshRefusal(`${this.#file.name}, byte ${this.position}: ${what}`)
  }

  /** Refuses if fewer than `count` times `bytes` bytes are left: to be asked before anything is allocated. */
  need(count: number, bytes: number, what: string): void {
    if (count * bytes > this.left)
      this.refuse(`${count * bytes} bytes of ${what} were expected, the file ends after ${Math.max(0, this.left)}.`)
  }

  jumpTo(position: number): void {
    if (position >= this.#start && position <= this.#start + this.#bytes.length) {
      this.#at = position - this.#start
      return
    }
    this.#start = position
    this.#at = 0
    this.#bytes = new Uint8Array(0)
  }

  #ahead(count: number, what: string): number {
    if (this.#at + count > this.#bytes.length) {
      this.need(1, count, what)
      const from = this.position
      this.#chunk = Math.min(2 * this.#chunk, LARGEST_CHUNK)
      const to = Math.min(this.#file.size, from + Math.max(this.#chunk, count))
      this.#bytes = this.#memory.next(this.#file, NOTHING, from, to)
      this.#view = new DataView(this.#bytes.buffer, this.#bytes.byteOffset, this.#bytes.length)
      this.#start = from
      this.#at = 0
    }
    const at = this.#at
    this.#at += count
    return at
  }

  int32(what: string): number {
    return this.#past(4, what).getInt32(this.#at - 4, this.isLittleEndian)
  }

  float32(what: string): number {
    return this.#past(4, what).getFloat32(this.#at - 4, this.isLittleEndian)
  }

  float64(what: string): number {
    return this.#past(8, what).getFloat64(this.#at - 8, this.isLittleEndian)
  }

  /** An integer from -2^53 to 2^53. */
  int64(what: string): number {
    const view = this.#past(8, what)
    const at = this.#at - 8
    const high = view.getInt32(this.isLittleEndian ? at + 4 : at, this.isLittleEndian)
    const low = view.getUint32(this.isLittleEndian ? at : at + 4, this.isLittleEndian)
    const value = high * TWO_32 + low
    if (!Number.isSafeInteger(value)) this.refuse(`${what} is too large: ${value}.`)
    return value
  }

  /** An integer of 4 or 8 bytes. */
  int(bytes: 4 | 8, what: string): number {
    return bytes === 8 ? this.int64(what) : this.int32(what)
  }

  /** An integer of 4 or 8 bytes that is not negative. */
  count(bytes: 4 | 8, what: string): number {
    const value = this.int(bytes, what)
    if (value < 0) this.refuse(`${what} is negative: ${value}.`)
    return value
  }

  /** The view after `bytes` bytes, which are passed. */
  #past(bytes: number, what: string): DataView {
    this.#ahead(bytes, what)
    return this.#view
  }

  /** The next bytes, at a multiple of 8 in their buffer; valid until the next call. */
  bytes(count: number, what: string): Uint8Array {
    const at = this.#ahead(count, what)
    const isOrdered = this.isLittleEndian === MACHINE_IS_LITTLE_ENDIAN
    if (isOrdered && (this.#bytes.byteOffset + at) % 8 === 0) return this.#bytes.subarray(at, at + count)
    if (count > this.#aligned.length) this.#aligned = new Uint8Array(count)
    this.#aligned.set(this.#bytes.subarray(at, at + count))
    return this.#aligned.subarray(0, count)
  }

  /** The next integers; valid until the next call. */
  int32s(count: number, what: string): Int32Array {
    if (count <= this.#few.length) {
      const at = this.#ahead(4 * count, what)
      for (let i = 0; i < count; ++i) this.#few[i] = this.#view.getInt32(at + 4 * i, this.isLittleEndian)
      return this.#few.subarray(0, count)
    }
    const { buffer, byteOffset } = this.#inOrder(this.bytes(4 * count, what), 4)
    return new Int32Array(buffer, byteOffset, count)
  }

  /** The next doubles; valid until the next call. */
  float64s(count: number, what: string): Float64Array {
    const { buffer, byteOffset } = this.#inOrder(this.bytes(8 * count, what), 8)
    return new Float64Array(buffer, byteOffset, count)
  }

  /** Integers of 4 or 8 bytes as doubles. */
  ints(count: number, bytes: 4 | 8, what: string): Float64Array {
    const values = new Float64Array(count)
    for (let done = 0; done < count; ) {
      const some = Math.min(count - done, INTS_AT_ONCE)
      if (bytes === 4) values.set(this.int32s(some, what), done)
      else this.#putInt64s(some, values, done, what)
      done += some
    }
    return values
  }

  #putInt64s(count: number, values: Float64Array, from: number, what: string): void {
    const { buffer, byteOffset } = this.#inOrder(this.bytes(8 * count, what), 8)
    const [low, high] = MACHINE_IS_LITTLE_ENDIAN ? [0, 1] : [1, 0]
    const words = new Uint32Array(buffer, byteOffset, 2 * count)
    for (let i = 0; i < count; ++i) {
      const value = ((words[2 * i + high] as number) | 0) * TWO_32 + (words[2 * i + low] as number)
      if (!Number.isSafeInteger(value)) this.refuse(`${what} has a number that is too large: ${value}.`)
      values[from + i] = value
    }
  }

  /** The bytes in the order of this machine; they are turned around in place, so they must be copies. */
  #inOrder(bytes: Uint8Array, size: 4 | 8): Uint8Array {
    if (this.isLittleEndian !== MACHINE_IS_LITTLE_ENDIAN) swapBytes(bytes, size)
    return bytes
  }
}
