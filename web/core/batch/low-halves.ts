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
/** Bytes that are read at once: always into the same memory, as fresh memory costs more than what is done with it. */
const CHUNK = 1024 * 1024
const BYTES = 8 * PART

/** Of all of a blob, into a list of as many numbers. */
export async function readLowHalves(blob: Blob, list = new Uint32Array(blob.size / 8)): Promise<LowHalves> {
  const ranges = rangesFor(list.length)
  const reader = byteReader(blob)
  if (!reader) return lowHalves(await blob.arrayBuffer(), list)
  let [high, part, held] = [0, 0, 0]
  let buffer = new ArrayBuffer(CHUNK)
  for (;;) {
    const { value, done } = await reader.read(new Uint8Array(buffer, held))
    if (value) buffer = value.buffer
    held += value?.length ?? 0
    const whole = done ? held : held - (held % BYTES)
    for (let from = 0; from < whole; from += BYTES)
      high |= putPart(new Int32Array(buffer, from, Math.min(BYTES, whole - from) / 4), list, part++, ranges)
    if (done) return { list, high, ranges }
    new Uint8Array(buffer).copyWithin(0, whole, held)
    held -= whole
  }
}

/** Null where the browser has none. */
function byteReader(blob: Blob): ReadableStreamBYOBReader | null {
  try {
    return blob.stream().getReader({ mode: 'byob' })
  } catch {
    return null
  }
}

export function lowHalves(bytes: ArrayBuffer, list = new Uint32Array(bytes.byteLength / 8)): LowHalves {
  const ranges = rangesFor(list.length)
  let high = 0
  for (let part = 0; BYTES * part < bytes.byteLength; ++part) {
    const from = BYTES * part
    high |= putPart(new Int32Array(bytes, from, Math.min(BYTES, bytes.byteLength - from) / 4), list, part, ranges)
  }
  return { list, high, ranges }
}

function rangesFor(count: number): Int32Array<ArrayBuffer> {
  return new Int32Array(2 * Math.ceil(count / PART))
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
