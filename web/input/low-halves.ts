/** Integers of 64 bits in a file, little-endian, as their low halves. */
export interface LowHalves {
  readonly list: Uint32Array<ArrayBuffer>
  /** 0 if no high half is anything else. */
  readonly high: number
  /** The least and the greatest of each `PART` numbers, as integers with a sign. */
  readonly ranges: Int32Array<ArrayBuffer>
}

/** A function that is called for a part at a time becomes fast code soon. */
export const PART = 8192
const BYTES = 8 * PART

export function lowHalves(bytes: ArrayBuffer, list = new Uint32Array(bytes.byteLength / 8)): LowHalves {
  const ranges = new Int32Array(2 * Math.ceil(list.length / PART))
  let high = 0
  for (let part = 0; BYTES * part < bytes.byteLength; ++part) {
    const from = BYTES * part
    high |= putPart(new Int32Array(bytes, from, Math.min(BYTES, bytes.byteLength - from) / 4), list, part, ranges)
  }
  return { list, high, ranges }
}

function putPart(words: Int32Array, list: Uint32Array, part: number, ranges: Int32Array): number {
  const own = new Int32Array(list.buffer, list.byteOffset + 4 * PART * part, words.length / 2)
  let high = 0
  let least = words[0] as number
  let greatest = least
  for (let i = 0; i < own.length; ++i) {
    const low = words[2 * i] as number
    high |= words[2 * i + 1] as number
    if (low < least) least = low
    if (low > greatest) greatest = low
    own[i] = low
  }
  ranges[2 * part] = least
  ranges[2 * part + 1] = greatest
  return high
}
