/**
 * The DataArrays of VTK's XML files: numbers in text, in base64 or in raw bytes, in the array's place or appended, as they are or in
 * compressed blocks. Blocks become numbers one by one, so that no array is ever there twice.
 */

import type { ReadingCore } from '../../core/reading-interface'
import { Base64Bytes, type ByteSource, CHUNK, RawBytes } from '../byte-source'
import { DamagedStream, unzlib } from '../codecs/inflate'
import { unlz4 } from '../codecs/lz4'
import { unxz } from '../codecs/xz'
import { MACHINE_IS_LITTLE_ENDIAN } from '../endian'
import { MeshRefusal } from '../mesh'
import { lineAt, NumberRun } from '../number-run'
import { isEllipsis } from '../snippet-text'
import type { FileList, KnownIndices, MeshFile, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { alignedTo, type NumberList, type NumberType, putNumbers, sizeOf } from './vtk-numbers'

/** Properties of all arrays of a file. */
export interface Storage {
  readonly file: MeshFile
  readonly options: ReadOptions
  readonly isLittleEndian: boolean
  readonly headerType: 'UInt32' | 'UInt64'
  readonly decompress: ((input: Uint8Array, output: Uint8Array) => void) | null
  readonly isZlib: boolean
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

/** The numbers of an array, fewer than expected if the text leaves some out. */
export interface ReadArray<T extends NumberList> {
  readonly list: T
  readonly digits: number
  /** Of indices, where they are known beforehand. */
  readonly known?: KnownIndices | null
}

export const ZLIB = 'vtkZLibDataCompressor'

/** The decompressor of the blocks of a file; undefined for one that VTK does not have. */
export function decompressorNamed(name: string, core: ReadingCore | null): Storage['decompress'] | undefined {
  if (name === 'vtkLZ4DataCompressor') return unlz4
  if (name === 'vtkLZMADataCompressor') return unxz
  if (name !== ZLIB) return undefined
  // The codec of TypeScript finds the fault in a stream.
  return (input, output) => core?.unzlib(input, output) || unzlib(input, output)
}

const ALWAYS_ALLOWED = 64 * 1024 * 1024

/**
 * Reads `count` numbers, or in a text that leaves some out at most so many, into a list. Indices must be whole and fit
 * the list, or the file is refused.
 */
export function readArray<T extends NumberList>(
  storage: Storage,
  array: DataArray,
  count: number,
  List: new (length: number) => T,
  mayHaveFewer = false,
): ReadArray<T> {
  if (array.format === 'ascii') return readText(storage, array, count, List, mayHaveFewer)
  if (count === 0) return { list: new List(0), digits: 0 }
  return new BinaryArray(storage, array, count, List).read()
}

/** The piece of an array, and the bytes from its header to that of the array behind it; infinite for the last one. */
export interface Surroundings {
  readonly points: number
  readonly cells: number
  readonly room: number
}

/** The place of an array's list, if it has doubles or integers of 64 bits in memory's order; else none. */
export function listOf(storage: Storage, array: DataArray, around: Surroundings): FileList[] {
  const isLong = array.type === 'Int64' || array.type === 'UInt64'
  const isFitting = isLong || array.type === 'Float64'
  if (!isFitting || !storage.isLittleEndian || !MACHINE_IS_LITTLE_ENDIAN) return []
  const place = placeOf(storage, array)
  const found =
    place && (storage.decompress === null ? plainList(storage, place, array, around) : packedList(storage, place))
  if (!found) return []
  const bytes = found.packed ? found.packed.bytes : found.to - found.from
  if (bytes % 8 !== 0) return []
  const isOfHexahedra = array.name === 'connectivity' && isLong && bytes === 64 * around.cells
  const holds = array.name === 'Points' && !isLong ? 'points' : isOfHexahedra ? 'hexahedra' : null
  return [{ ...found, isLong, holds }]
}

/** Behind the blocks of an array in its own place, by their sizes alone; null where these are not known. */
export function endOfBlocks(storage: Storage, from: number): number | null {
  const { isLittleEndian, file } = storage
  return isLittleEndian ? (packedList(storage, { from, to: file.size, isBase64: true })?.to ?? null) : null
}

interface Place {
  /** Where the header begins. */
  readonly from: number
  readonly to: number
  readonly isBase64: boolean
}

function placeOf({ file, appended }: Storage, { format, offset, from, to }: DataArray): Place | null {
  if (format === 'binary') return { from, to, isBase64: true }
  if (format !== 'appended' || appended === null || appended.from + offset >= file.size) return null
  return { from: appended.from + offset, to: file.size, isBase64: appended.isBase64 }
}

type FoundList = Pick<FileList, 'from' | 'to' | 'packed'>

/** The length stands before the list, which may be far from all that is read so far; where the room is that of hexahedra, it is no question. */
function plainList(
  { file, headerType }: Storage,
  { from: at, isBase64 }: Place,
  { name }: DataArray,
  { points, cells, room }: Surroundings,
): FoundList | null {
  const from = at + sizeOf(headerType)
  if (isBase64 || from > file.size) return null
  const likely = name === 'Points' ? 24 * points : name === 'connectivity' ? 64 * cells : 8 * cells
  const bytes =
    from + likely === at + room ? likely : (headerNumbers(file.read(at, from), headerType, true)[0] as number)
  return from + bytes <= file.size ? { from, to: from + bytes, packed: null } : null
}

/** The most that zlib makes of a byte, and memory that is not too much to begin with. */
const MOST_OF_A_BYTE = 1032
const MOST_BYTES = 1024 * 1024 * 1024

function packedList({ file, headerType, isZlib }: Storage, { from, to, isBase64 }: Place): FoundList | null {
  if (!isZlib) return null
  const source = isBase64 ? new Base64Bytes(file, from, to) : new RawBytes(file, from)
  const header = (count: number) => {
    const bytes = count * sizeOf(headerType)
    return bytes <= source.left ? headerNumbers(source.take(bytes), headerType, true) : new Float64Array(0)
  }
  const [blocks = 0, blockSize = 0, lastSize = 0] = header(3)
  const sizes = header(blocks)
  if (blocks === 0 || sizes.length < blocks || blockSize % 1024 !== 0) return null
  // Header and blocks are two texts.
  if (isBase64 && source.left !== Math.ceil((3 * (to - source.position)) / 4)) return null
  const bytes = lastSize === 0 ? blocks * blockSize : (blocks - 1) * blockSize + lastSize
  const packedBytes = sizes.reduce((sum, size) => sum + size, 0)
  const end = source.position + (isBase64 ? 4 * Math.ceil(packedBytes / 3) : packedBytes)
  if (end > to || lastSize > blockSize) return null
  if (bytes > MOST_BYTES || bytes > MOST_OF_A_BYTE * packedBytes) return null
  return { from, to: end, packed: { from: source.position, isBase64, sizes, blockSize, bytes } }
}

/** Unsigned integers of the header's type. */
function headerNumbers(bytes: Uint8Array, type: Storage['headerType'], isLittleEndian: boolean): Float64Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset)
  const size = sizeOf(type)
  return Float64Array.from({ length: bytes.length / size }, (_, i) =>
    size === 4 ? view.getUint32(4 * i, isLittleEndian) : Number(view.getBigUint64(8 * i, isLittleEndian)),
  )
}

/** Refuses with the line of a byte. */
function refuseAt(file: MeshFile, position: number, what: string): never {
  throw new MeshRefusal(`${file.name}, line ${lineAt(file, position)}: ${what}`)
}

function readText<T extends NumberList>(
  { file, options }: Storage,
  array: DataArray,
  count: number,
  List: new (length: number) => T,
  mayHaveFewer: boolean,
): ReadArray<T> {
  // A number and a blank are two bytes.
  const list = new List(Math.min(count, Math.ceil((array.to - array.from) / 2)))
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

class BinaryArray<T extends NumberList> {
  readonly #storage: Storage
  readonly #array: DataArray
  readonly #count: number
  readonly #List: new (
    length: number,
  ) => T
  readonly #size: number
  readonly #source: ByteSource
  #list: T
  #filled = 0
  #known: KnownIndices | null = null

  constructor(storage: Storage, array: DataArray, count: number, List: new (length: number) => T) {
    this.#storage = storage
    this.#array = array
    this.#count = count
    this.#List = List
    this.#size = sizeOf(array.type)
    this.#source = this.#open()
    this.#list = new List(0)
  }

  #refuse(what: string, at = this.#source.position): never {
    throw new MeshRefusal(`${this.#storage.file.name}, byte ${at}: ${shown(this.#array.name)} ${what}`)
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

  read(): ReadArray<T> {
    try {
      const { file, decompress } = this.#storage
      const known = file.unpacked?.(this.#source.position)?.list
      if (known instanceof this.#List && known.length === this.#count) this.#list = known
      else if (decompress === null) this.#readPlain()
      else this.#readBlocks(decompress)
    } catch (error) {
      if (error instanceof DamagedStream) this.#refuse(`${error.message}.`)
      throw error
    }
    return { list: this.#list, digits: 0, known: this.#known }
  }

  /** The next bytes, which the file must have. */
  #take(count: number): Uint8Array {
    if (count > this.#source.left)
      this.#refuse(`needs ${count} more bytes, and the file has ${this.#source.left}: it is cut off.`)
    return this.#source.take(count)
  }

  #header(count: number): Float64Array {
    const { headerType, isLittleEndian } = this.#storage
    return headerNumbers(this.#take(sizeOf(headerType) * count), headerType, isLittleEndian)
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

  /** The bytes that are there allow so much; the list grows if more comes out of them. */
  #makeRoom(): void {
    const allowed = Math.floor((ALWAYS_ALLOWED + 8 * this.#source.left) / 8)
    this.#list = new this.#List(Math.min(this.#count, allowed))
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
    const known = this.#lowHalves()
    if (known) {
      this.#list = known.list as T
      this.#known = known
      return
    }
    this.#makeRoom()
    for (let left = bytes; left > 0; ) {
      const from = this.#source.position
      const chunk = this.#take(Math.min(left, CHUNK))
      left -= chunk.length
      this.#append(chunk, this.#source instanceof RawBytes ? from : null)
      this.#progress()
    }
  }

  #lowHalves(): KnownIndices | null {
    const { file, isLittleEndian } = this.#storage
    const isLong = this.#array.type === 'Int64' || this.#array.type === 'UInt64'
    if (!isLong || !isLittleEndian || !(this.#list instanceof Uint32Array)) return null
    return file.lowHalves?.(this.#source.position, this.#count) ?? null
  }

  #readBlocks(decompress: (input: Uint8Array, output: Uint8Array) => void): void {
    const [blocks, blockSize, lastSize] = this.#header(3) as unknown as [number, number, number]
    const whole = lastSize === 0 ? blocks : blocks - 1
    this.#checkLength(blocks === 0 ? 0 : whole * blockSize + lastSize)
    const headerSize = this.#storage.headerType === 'UInt32' ? 4 : 8
    if (blocks * headerSize > this.#source.left)
      this.#refuse(`says that it has ${blocks} blocks, more than the file has room for: it is cut off or damaged.`)
    const packedSizes = this.#header(blocks)
    this.#makeRoom()
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
      this.#progress()
    }
  }

  #progress(): void {
    const { file, options } = this.#storage
    options.throwIfCancelled()
    options.onProgress(this.#source.position / file.size)
  }

  /** Whole numbers, which begin at a multiple of eight bytes of their buffer or are copied there; `from` is their byte in the file, if they have one. */
  #append(bytes: Uint8Array, from: number | null = null): void {
    const count = bytes.length / this.#size
    if (this.#filled + count > this.#list.length) {
      const longer = new this.#List(Math.min(this.#count, Math.max(2 * this.#list.length, this.#filled + count)))
      longer.set(this.#list as never)
      this.#list = longer
    }
    const aligned = alignedTo(this.#size, bytes)
    const bad = putNumbers(this.#array.type, aligned, !this.#storage.isLittleEndian, this.#list, this.#filled)
    if (bad !== null)
      this.#refuse(
        `has ${bad.value} as its number ${this.#filled + bad.at}, counted from 0, where an index was expected.`,
        from === null ? this.#source.position : from + bad.at * this.#size,
      )
    this.#filled += count
  }
}
