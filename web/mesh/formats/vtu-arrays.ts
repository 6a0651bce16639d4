/**
 * The DataArrays of VTK's XML files: numbers in text, in base64 or in raw bytes, in the array's place or appended, as they are or in
 * compressed blocks. Blocks become numbers one by one, so that no array is ever there twice.
 */

import type { ReadingCore } from '../../core/reading-interface'
import { DamagedStream, unzlib } from '../codecs/inflate'
import { unlz4 } from '../codecs/lz4'
import { unxz } from '../codecs/xz'
import { copySwapped, MACHINE_IS_LITTLE_ENDIAN, swapBytes, swappedWord } from '../endian'
import { FileChunk } from '../file-chunk'
import { MeshRefusal } from '../mesh'
import { lineAt, NumberRun } from '../number-run'
import { isEllipsis } from '../snippet-text'
import type { MeshFile, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'

export type NumberType =
  | 'Int8'
  | 'UInt8'
  | 'Int16'
  | 'UInt16'
  | 'Int32'
  | 'UInt32'
  | 'Int64'
  | 'UInt64'
  | 'Float32'
  | 'Float64'

export const NUMBER_SIZES: Readonly<Record<NumberType, number>> = wordTable({
  Int8: 1,
  UInt8: 1,
  Int16: 2,
  UInt16: 2,
  Int32: 4,
  UInt32: 4,
  Int64: 8,
  UInt64: 8,
  Float32: 4,
  Float64: 8,
})

/** Properties of all arrays of a file. */
export interface Storage {
  readonly file: MeshFile
  readonly options: ReadOptions
  readonly isLittleEndian: boolean
  readonly headerType: 'UInt32' | 'UInt64'
  readonly decompress: ((input: Uint8Array, output: Uint8Array) => void) | null
  /** The byte behind the underscore, and whether what follows is base64; null if the file has no appended data. */
  readonly appended: { readonly from: number; readonly isBase64: boolean } | null
}

export interface DataArray {
  readonly name: string
  readonly type: NumberType
  readonly format: 'ascii' | 'binary' | 'appended'
  /** Bytes from the beginning of the appended data. */
  readonly offset: number
  /** The beginning of its own text. */
  readonly from: number
  readonly to: number
}

export type NumberList = Float64Array | Uint32Array | Uint8Array

/** The numbers of an array, fewer than expected if the text leaves some out. */
export interface ReadArray<T extends NumberList> {
  readonly list: T
  readonly digits: number
}

/** The decompressor of the blocks of a file; undefined for one that VTK does not have. */
export function decompressorNamed(name: string, core: ReadingCore | null): Storage['decompress'] | undefined {
  if (name === 'vtkLZ4DataCompressor') return unlz4
  if (name === 'vtkLZMADataCompressor') return unxz
  if (name !== 'vtkZLibDataCompressor') return undefined
  // The codec of TypeScript finds the fault in a stream.
  return (input, output) => core?.unzlib(input, output) || unzlib(input, output)
}

/** Bytes that become numbers at once; a multiple of all sizes. */
const CHUNK = 256 * 1024
const ALWAYS_ALLOWED = 64 * 1024 * 1024

/**
 * Reads `count` numbers, or in a text that leaves some out at most so many, into a list that `make` makes. Indices must be whole and fit
 * the list, or the file is refused.
 */
export function readArray<T extends NumberList>(
  storage: Storage,
  array: DataArray,
  count: number,
  make: (length: number) => T,
  mayHaveFewer = false,
): ReadArray<T> {
  if (array.format === 'ascii') return readText(storage, array, count, make, mayHaveFewer)
  if (count === 0) return { list: make(0), digits: 0 }
  return { list: new BinaryArray(storage, array, count, make).read(), digits: 0 }
}

/** The text of a number where it stands: for what was expected there. */
function refuseAt(file: MeshFile, position: number, what: string): never {
  throw new MeshRefusal(`${file.name}, line ${lineAt(file, position)}: ${what}`)
}

function readText<T extends NumberList>(
  { file, options }: Storage,
  array: DataArray,
  count: number,
  make: (length: number) => T,
  mayHaveFewer: boolean,
): ReadArray<T> {
  // A number and a blank are two bytes.
  const list = make(Math.min(count, Math.ceil((array.to - array.from) / 2)))
  const run = new NumberRun(file, array.from, array.to, options.core, position => {
    options.throwIfCancelled()
    options.onProgress(position / file.size)
  })
  const filled = list instanceof Float64Array ? run.numbers(list, 0, list.length) : run.indices(list, 0, list.length)
  const name = shown(array.name)
  if (!run.isAtEnd()) {
    const word = run.nextWord()
    if (isEllipsis(word)) return { list: list.slice(0, filled) as T, digits: run.mostDigits }
    if (filled === count)
      refuseAt(file, run.position, `${name} has more than the ${count} numbers that are declared: ${shown(word)}.`)
    const expected = list instanceof Float64Array ? 'a number' : 'an index, a whole number from 0 on,'
    refuseAt(file, run.position, `${shown(word)} in ${name} stands where ${expected} was expected.`)
  }
  if (filled < count && mayHaveFewer) return { list: list.slice(0, filled) as T, digits: run.mostDigits }
  if (filled < count) refuseAt(file, run.position, `${name} has ${filled} numbers; ${count} were expected.`)
  return { list, digits: run.mostDigits }
}

/** Bytes that are read one after the other, from the file as they are or from base64 in it. */
interface ByteSource {
  /** The byte of the file that is next. */
  readonly position: number
  /** The most bytes that may be left. */
  readonly left: number
  /** The next bytes; a view that holds until the next call. */
  take(count: number): Uint8Array
}

class RawBytes implements ByteSource {
  #chunk = new Uint8Array(0)
  constructor(
    private readonly file: MeshFile,
    public position: number,
  ) {}
  get left(): number {
    return this.file.size - this.position
  }
  take(count: number): Uint8Array {
    if (count <= CHUNK && count > this.#chunk.length) this.#chunk = new Uint8Array(count)
    return this.#read(count, count <= CHUNK ? this.#chunk : undefined)
  }
  /** Bytes in memory that nothing else uses. */
  takeAll(count: number): Uint8Array {
    return this.#read(count)
  }
  #read(count: number, into?: Uint8Array): Uint8Array {
    const bytes = this.file.read(this.position, this.position + count, into)
    this.position += count
    return bytes
  }
}

const NO_DIGIT = 255
const PADDING = 254
const BLANK = 253
const BASE64 = new Uint8Array(256).fill(NO_DIGIT)
for (let i = 0; i < 64; ++i)
  BASE64['ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/'.charCodeAt(i)] = i
BASE64[61] = PADDING
for (const blank of [9, 10, 13, 32]) BASE64[blank] = BLANK

/** Four digits are three bytes; one or two with padding, which may stand between streams. */
class Base64Bytes implements ByteSource {
  #text = new Uint8Array(0)
  readonly #memory = new FileChunk()
  #textStart: number
  #at = 0
  /** Bytes of text to read next: short arrays read no more than they need. */
  #chunk = 4096
  /** Bytes that have been decoded and not been taken. */
  #held: Uint8Array = new Uint8Array(0)
  #heldFrom = 0

  constructor(
    private readonly file: MeshFile,
    from: number,
    private readonly to: number,
  ) {
    this.#textStart = from
  }

  get position(): number {
    return this.#textStart + this.#at
  }

  get left(): number {
    return this.#held.length - this.#heldFrom + Math.ceil((3 * (this.to - this.position)) / 4)
  }

  take(count: number): Uint8Array {
    const output = new Uint8Array(count)
    let filled = Math.min(count, this.#held.length - this.#heldFrom)
    output.set(this.#held.subarray(this.#heldFrom, this.#heldFrom + filled))
    this.#heldFrom += filled
    while (filled < count) {
      filled = this.#decode(output, filled)
      if (filled >= count) break
      const last = this.#lastQuantum()
      const used = Math.min(count - filled, last.length)
      output.set(last.subarray(0, used), filled)
      filled += used
      this.#held = last
      this.#heldFrom = used
    }
    return output
  }

  #fill(): void {
    const had = this.#text.length - this.#at
    const from = this.#textStart + this.#text.length
    const more = Math.min(this.#chunk, this.to - from)
    if (had >= 64 || more <= 0) return
    this.#chunk = Math.min(CHUNK, 2 * this.#chunk)
    this.#text = this.#memory.next(this.file, this.#text.subarray(this.#at), from, from + more)
    this.#textStart += this.#at
    this.#at = 0
  }

  /** Whole quanta, as long as there is room and neither blanks nor padding are among them. */
  #decode(output: Uint8Array, from: number): number {
    this.#fill()
    const text = this.#text
    let at = this.#at
    let filled = from
    for (const last = text.length - 4; at <= last && filled + 3 <= output.length; at += 4) {
      const a = BASE64[text[at] as number] as number
      const b = BASE64[text[at + 1] as number] as number
      const c = BASE64[text[at + 2] as number] as number
      const d = BASE64[text[at + 3] as number] as number
      if ((a | b | c | d) > 63) break
      output[filled] = (a << 2) | (b >> 4)
      output[filled + 1] = (b << 4) | (c >> 2)
      output[filled + 2] = (c << 6) | d
      filled += 3
    }
    this.#at = at
    return filled
  }

  /** One quantum, with blanks between its digits or padding. */
  #lastQuantum(): Uint8Array {
    const digits = [0, 0, 0, 0]
    let padding = 0
    for (let i = 0; i < 4; ++this.#at) {
      this.#fill()
      const byte = this.#text[this.#at]
      const digit = byte === undefined ? NO_DIGIT : (BASE64[byte] as number)
      if (digit === BLANK) continue
      if (digit === NO_DIGIT || (digit !== PADDING && padding > 0) || (digit === PADDING && i < 2))
        throw new DamagedStream(byte === undefined || byte === 60 ? 'ends early' : 'is no base64')
      if (digit === PADDING) padding++
      else digits[i] = digit
      i++
    }
    const [a, b, c, d] = digits as [number, number, number, number]
    return Uint8Array.of((a << 2) | (b >> 4), (b << 4) | (c >> 2), (c << 6) | d).subarray(0, 3 - padding)
  }
}

class BinaryArray<T extends NumberList> {
  readonly #storage: Storage
  readonly #array: DataArray
  readonly #count: number
  readonly #make: (length: number) => T
  readonly #size: number
  readonly #source: ByteSource
  #list: T
  #filled = 0

  constructor(storage: Storage, array: DataArray, count: number, make: (length: number) => T) {
    this.#storage = storage
    this.#array = array
    this.#count = count
    this.#make = make
    this.#size = NUMBER_SIZES[array.type]
    this.#source = this.#open()
    // The bytes that are there allow so much; the list grows if more comes out of them.
    const allowed = Math.floor((ALWAYS_ALLOWED + 8 * this.#source.left) / 8)
    this.#list = make(this.#canBeViewed() ? 0 : Math.min(count, allowed))
  }

  #refuse(what: string): never {
    throw new MeshRefusal(
      `${this.#storage.file.name}, byte ${this.#source.position}: ${shown(this.#array.name)} ${what}`,
    )
  }

  #open(): ByteSource {
    const { file, appended } = this.#storage
    const { format, offset, from, to, name } = this.#array
    if (format === 'binary') return new Base64Bytes(file, from, to)
    if (appended === null)
      throw new MeshRefusal(`${file.name}: ${shown(name)} is in appended data, and the file has none: it is cut off.`)
    const start = appended.from + offset
    if (start >= file.size) {
      const is = `${shown(name)} lies at byte ${start}, the file ends at byte ${file.size}`
      throw new MeshRefusal(`${file.name}: ${is}: it is cut off, or the offset is wrong.`)
    }
    return appended.isBase64 ? new Base64Bytes(file, start, file.size) : new RawBytes(file, start)
  }

  read(): T {
    try {
      if (this.#storage.decompress === null) this.#readPlain()
      else this.#readBlocks(this.#storage.decompress)
    } catch (error) {
      if (error instanceof DamagedStream) this.#refuse(`${error.message}.`)
      throw error
    }
    return this.#list
  }

  /** The next bytes, which the file must have. */
  #take(count: number): Uint8Array {
    if (count > this.#source.left)
      this.#refuse(`needs ${count} more bytes, and the file has ${this.#source.left}: it is cut off.`)
    return this.#source.take(count)
  }

  /** Unsigned integers of the header's type. */
  #header(count: number): Float64Array {
    const size = this.#storage.headerType === 'UInt32' ? 4 : 8
    const bytes = this.#take(size * count)
    const view = new DataView(bytes.buffer, bytes.byteOffset)
    const { isLittleEndian } = this.#storage
    return Float64Array.from({ length: count }, (_, i) =>
      size === 4 ? view.getUint32(4 * i, isLittleEndian) : Number(view.getBigUint64(8 * i, isLittleEndian)),
    )
  }

  #checkLength(bytes: number): void {
    const expected = this.#count * this.#size
    if (bytes !== expected) {
      const has = `says that it has ${bytes} bytes; ${this.#count} numbers of type ${this.#array.type} have ${expected}`
      this.#refuse(`${has}.`)
    }
  }

  /** True if the bytes of the file are the list. */
  #canBeViewed(): boolean {
    const { isLittleEndian, decompress } = this.#storage
    return (
      this.#array.type === 'Float64' &&
      this.#source instanceof RawBytes &&
      isLittleEndian === MACHINE_IS_LITTLE_ENDIAN &&
      decompress === null
    )
  }

  #readPlain(): void {
    const bytes = this.#header(1)[0] as number
    this.#checkLength(bytes)
    if (bytes > this.#source.left)
      this.#refuse(`needs ${bytes} bytes from here on, and the file has ${this.#source.left}: it is cut off.`)
    if (this.#source instanceof RawBytes && this.#canBeViewed()) {
      const { buffer, byteOffset, byteLength } = alignedTo(this.#size, this.#source.takeAll(bytes))
      this.#list = new Float64Array(buffer, byteOffset, byteLength / this.#size) as T
      return
    }
    for (let left = bytes; left > 0; ) {
      const chunk = this.#take(Math.min(left, CHUNK))
      left -= chunk.length
      this.#append(chunk)
      this.#report()
    }
  }

  #readBlocks(decompress: (input: Uint8Array, output: Uint8Array) => void): void {
    const [blocks, blockSize, lastSize] = this.#header(3) as unknown as [number, number, number]
    const whole = lastSize === 0 ? blocks : blocks - 1
    this.#checkLength(blocks === 0 ? 0 : whole * blockSize + lastSize)
    const headerSize = this.#storage.headerType === 'UInt32' ? 4 : 8
    if (blocks * headerSize > this.#source.left)
      this.#refuse(`says that it has ${blocks} blocks, more than the file has room for: it is cut off or damaged.`)
    const packedSizes = this.#header(blocks)
    let scratch = new Uint8Array(0)
    let held = 0
    for (let i = 0; i < blocks; ++i) {
      const size = i < whole ? blockSize : lastSize
      const packed = this.#take(packedSizes[i] as number)
      // A block grows by no more than 1032 times (zlib), 255 (lz4) or some 8000 (lzma).
      if (size > ALWAYS_ALLOWED && size > 8192 * packed.length)
        this.#refuse(`has a block of ${size} bytes in ${packed.length}.`)
      if (held + size > scratch.length) {
        const longer = new Uint8Array(Math.max(held + size, Math.min(CHUNK, (blocks - i) * blockSize + held)))
        longer.set(scratch.subarray(0, held))
        scratch = longer
      }
      decompress(packed, scratch.subarray(held, held + size))
      held += size
      if (held + blockSize <= scratch.length && i + 1 < blocks) continue
      // A number may go on in the next block.
      const ready = held - (held % this.#size)
      this.#append(scratch.subarray(0, ready))
      scratch.copyWithin(0, ready, held)
      held -= ready
      this.#report()
    }
  }

  #report(): void {
    const { file, options } = this.#storage
    options.throwIfCancelled()
    options.onProgress(this.#source.position / file.size)
  }

  /** Whole numbers, which begin at a multiple of eight bytes of their buffer or are copied there. */
  #append(bytes: Uint8Array): void {
    const count = bytes.length / this.#size
    if (this.#filled + count > this.#list.length) {
      const longer = this.#make(Math.min(this.#count, Math.max(2 * this.#list.length, this.#filled + count)))
      longer.set(this.#list as never)
      this.#list = longer
    }
    const aligned = alignedTo(this.#size, bytes)
    const bad = putNumbers(this.#array.type, aligned, !this.#storage.isLittleEndian, this.#list, this.#filled)
    if (bad !== null)
      this.#refuse(`has ${bad.value} as its number ${this.#filled + bad.at}, where an index from 0 on was expected.`)
    this.#filled += count
  }
}

/** The bytes, at a multiple of `size` in their buffer. */
export function alignedTo(size: number, bytes: Uint8Array): Uint8Array {
  return bytes.byteOffset % size === 0 ? bytes : bytes.slice()
}

/**
 * Puts numbers into a list from place `from` on, little-endian ones or, if `isSwapped`, others, whose bytes are then turned around. For a
 * list of whole numbers the first that is negative, not whole or too large is returned, with its place; coordinates may be anything.
 */
export function putNumbers(
  type: NumberType,
  bytes: Uint8Array,
  isSwapped: boolean,
  list: NumberList,
  from: number,
): { at: number; value: string } | null {
  const { buffer, byteOffset, length } = bytes
  const count = length / NUMBER_SIZES[type]
  const isLong = type === 'Int64' || type === 'UInt64'
  if (isLong && list instanceof Uint32Array && putLowHalves(bytes, isSwapped, list, from)) return null
  if (isSwapped && type === 'Float64' && list instanceof Float64Array) {
    copySwapped(
      new Uint32Array(buffer, byteOffset, 2 * count),
      new Uint32Array(list.buffer, list.byteOffset + 8 * from, 2 * count),
    )
    return null
  }
  if (isSwapped) swapBytes(bytes, NUMBER_SIZES[type])
  if (isLong) {
    const halves = new Uint32Array(buffer, byteOffset, 2 * count)
    if (list instanceof Float64Array) {
      const isSigned = type === 'Int64'
      const wholes = isSigned
        ? new BigInt64Array(buffer, byteOffset, count)
        : new BigUint64Array(buffer, byteOffset, count)
      for (let i = 0; i < count; ++i) list[from + i] = Number(wholes[i])
      return null
    }
    const most = list instanceof Uint8Array ? 255 : 0xffffffff
    for (let i = 0; i < count; ++i) {
      const low = halves[2 * i] as number
      if (halves[2 * i + 1] !== 0 || low > most)
        return { at: i, value: String(new BigInt64Array(buffer, byteOffset, count)[i]) }
      list[from + i] = low
    }
    return null
  }
  const numbers = viewOf(type, buffer as ArrayBuffer, byteOffset, count)
  if (list instanceof Float64Array || (type === 'UInt32' && list instanceof Uint32Array) || type === 'UInt8') {
    list.set(numbers, from)
    return null
  }
  const most = list instanceof Uint8Array ? 255 : 0xffffffff
  for (let i = 0; i < count; ++i) {
    const value = numbers[i] as number
    if (!(value >= 0 && value <= most) || !Number.isInteger(value)) return { at: i, value: String(value) }
    list[from + i] = value
  }
  return null
}

/** Takes the low halves of integers of 64 bits; false if one of them has more. */
function putLowHalves(bytes: Uint8Array, isSwapped: boolean, list: Uint32Array, from: number): boolean {
  const halves = new Uint32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4)
  let high = 0
  if (isSwapped)
    for (let i = 0, to = from; i < halves.length; i += 2, ++to) {
      high |= halves[i] as number
      list[to] = swappedWord(halves[i + 1] as number)
    }
  else
    for (let i = 0, to = from; i < halves.length; i += 2, ++to) {
      high |= halves[i + 1] as number
      list[to] = halves[i] as number
    }
  return high === 0
}

function viewOf(type: Exclude<NumberType, 'Int64' | 'UInt64'>, buffer: ArrayBuffer, offset: number, count: number) {
  switch (type) {
    case 'Int8':
      return new Int8Array(buffer, offset, count)
    case 'UInt8':
      return new Uint8Array(buffer, offset, count)
    case 'Int16':
      return new Int16Array(buffer, offset, count)
    case 'UInt16':
      return new Uint16Array(buffer, offset, count)
    case 'Int32':
      return new Int32Array(buffer, offset, count)
    case 'UInt32':
      return new Uint32Array(buffer, offset, count)
    case 'Float32':
      return new Float32Array(buffer, offset, count)
    case 'Float64':
      return new Float64Array(buffer, offset, count)
  }
}
