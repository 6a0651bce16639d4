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

export function lowHalves(bytes: ArrayBuffer, list = new Uint32Array(bytes.byteLength / 8)): LowHalves {
  const words = new Int32Array(bytes)
  const own = new Int32Array(list.buffer, list.byteOffset, list.length)
  const ranges = new Int32Array(2 * Math.ceil(list.length / PART))
  let high = 0
  for (let part = 0; 2 * part < ranges.length; ++part) high |= putPart(words, own, part, ranges)
  return { list, high, ranges }
}

function putPart(words: Int32Array, list: Int32Array, part: number, ranges: Int32Array): number {
  const from = PART * part
  const to = Math.min(from + PART, list.length)
  let high = 0
  let least = words[2 * from] as number
  let greatest = least
  for (let i = from; i < to; ++i) {
    const low = words[2 * i] as number
    high |= words[2 * i + 1] as number
    if (low < least) least = low
    if (low > greatest) greatest = low
    list[i] = low
  }
  ranges[2 * part] = least
  ranges[2 * part + 1] = greatest
  return high
}
