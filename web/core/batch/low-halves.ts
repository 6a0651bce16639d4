/** Integers of 64 bits in a file, little-endian, as their low halves. */
export interface LowHalves {
  readonly list: Uint32Array<ArrayBuffer>
  /** 0 if no high half is anything else. */
  readonly high: number
}

/** Numbers that become halves at a time: engines make fast code of a function that is called again. */
const PART = 8192

export function lowHalves(bytes: ArrayBuffer, list = new Uint32Array(bytes.byteLength / 8)): LowHalves {
  const words = new Int32Array(bytes)
  const own = new Int32Array(list.buffer, list.byteOffset, list.length)
  let high = 0
  for (let from = 0; from < own.length; from += PART) high |= putPart(words, own, from)
  return { list, high }
}

function putPart(words: Int32Array, list: Int32Array, from: number): number {
  const to = Math.min(from + PART, list.length)
  let high = 0
  for (let i = from; i < to; ++i) {
    high |= words[2 * i + 1] as number
    list[i] = words[2 * i] as number
  }
  return high
}
