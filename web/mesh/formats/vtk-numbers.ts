/** The numbers of VTK's files in their binary types, of either byte order, as lists of doubles or of indices. */
import { copySwapped, copySwappedWords, swapBytes, swappedWord } from '../endian'
import { wordTable } from '../word-table'

const ARRAYS = wordTable({
  Int8: Int8Array,
  UInt8: Uint8Array,
  Int16: Int16Array,
  UInt16: Uint16Array,
  Int32: Int32Array,
  UInt32: Uint32Array,
  Int64: BigInt64Array,
  UInt64: BigUint64Array,
  Float32: Float32Array,
  Float64: Float64Array,
})

export type NumberType = keyof typeof ARRAYS

export function isNumberType(word: string): word is NumberType {
  return word in ARRAYS
}

/** Bytes of a number. */
export function sizeOf(type: NumberType): number {
  return ARRAYS[type].BYTES_PER_ELEMENT
}

export type NumberList = Float64Array | Uint32Array | Uint8Array

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
  const count = length / sizeOf(type)
  const view = new ARRAYS[type](buffer as ArrayBuffer, byteOffset, count)
  const most = list instanceof Uint8Array ? 255 : 0xffffffff
  const isLong = view instanceof BigInt64Array || view instanceof BigUint64Array
  if (isLong && list instanceof Uint32Array && putLowHalves(bytes, isSwapped, list, from)) return null
  if (isSwapped && type === 'Float64' && list instanceof Float64Array) {
    copySwapped(
      new Uint32Array(buffer, byteOffset, 2 * count),
      new Uint32Array(list.buffer, list.byteOffset + 8 * from, 2 * count),
    )
    return null
  }
  if (isSwapped && (type === 'Int32' || type === 'UInt32') && list instanceof Uint32Array) {
    const signs = copySwappedWords(new Uint32Array(buffer, byteOffset, count), list.subarray(from, from + count))
    if (type === 'UInt32' || signs >= 0) return null
  }
  if (isSwapped) swapBytes(bytes, sizeOf(type))
  if (isLong) {
    if (list instanceof Float64Array) {
      for (let i = 0; i < count; ++i) list[from + i] = Number(view[i])
      return null
    }
    const halves = new Uint32Array(buffer, byteOffset, 2 * count)
    for (let i = 0; i < count; ++i) {
      const low = halves[2 * i] as number
      if (halves[2 * i + 1] !== 0 || low > most)
        return { at: i, value: String(new BigInt64Array(buffer, byteOffset, count)[i]) }
      list[from + i] = low
    }
    return null
  }
  if (list instanceof Float64Array || (type === 'UInt32' && list instanceof Uint32Array) || type === 'UInt8') {
    list.set(view, from)
    return null
  }
  for (let i = 0; i < count; ++i) {
    const value = view[i] as number
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
