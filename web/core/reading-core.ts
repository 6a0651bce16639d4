/** Loads hexlens-reading.wasm, and is the only place that sees its memory. The contracts are those of wasm/src/reading. */
import {
  KNOWN_OF_PART,
  type LowHalves,
  PART,
  type ReadingCore,
  type RowPattern,
  type Taken,
  type TakenRows,
} from './reading-interface'

interface ReadingExports {
  readonly memory: WebAssembly.Memory
  _initialize?(): void
  start(): void
  input_address(): number
  input_length(): number
  output_address(): number
  output_length(): number
  pattern_address(): number
  pattern_length(): number
  places_address(): number
  places_length(): number
  taken_address(): number
  parts_address(): number
  part_length(): number
  numbers(limit: number, length: number, most: number): void
  indices(limit: number, length: number, most: number, largest: number): void
  rows(length: number, parts: number, most: number): void
  halves(count: number): void
  unzlib(length: number, unpacked: number): number
}

/** Longer words are for others. */
const LONGEST_NUMBER = 1024
/** Bytes of a number and the blank behind it; short windows are followed by others. */
const USUAL_NUMBER = 24

/** Null where WebAssembly may not run, or the bytes do not arrive: readers then do without. */
export async function readingCoreOf(bytes: () => Promise<BufferSource>): Promise<ReadingCore | null> {
  try {
    return await loadReadingCore(await bytes())
  } catch {
    return null
  }
}

/** Rejects with the engine's own error where WebAssembly is missing, forbidden, or the bytes are others. */
export async function loadReadingCore(bytes: BufferSource): Promise<ReadingCore> {
  const { instance } = await WebAssembly.instantiate(bytes, {})
  const wasm = instance.exports as unknown as ReadingExports
  wasm._initialize?.()
  wasm.start()
  const { buffer } = wasm.memory
  const input = new Uint8Array(buffer, wasm.input_address(), wasm.input_length())
  const output = new Uint8Array(buffer, wasm.output_address(), wasm.output_length())
  const doubles = new Float64Array(buffer, output.byteOffset, output.length / 8)
  const wholes = new Uint32Array(buffer, output.byteOffset, output.length / 4)
  const places = new Uint32Array(buffer, wasm.places_address(), wasm.places_length())
  const parts = new Uint8Array(buffer, wasm.pattern_address(), wasm.pattern_length())
  const taken = new Uint32Array(buffer, wasm.taken_address(), 4)
  /** Four numbers each: hl_halves. */
  const halves = new Int32Array(buffer, wasm.parts_address(), (4 * input.length) / 8 / wasm.part_length())
  if (wasm.part_length() !== PART) throw new Error('The core for reading is of another version.')
  const rowNumbers = new Float64Array(doubles.length)
  const rowPlaces = new Uint32Array(places.length)

  /** Bytes [at, end) of a text go in, and what ends a word behind its end. */
  function put(bytes: Uint8Array, at: number, end: number): void {
    input.set(bytes.subarray(at, end))
  }

  /** Window after window, as long as each is used up. */
  function run(
    bytes: Uint8Array,
    at: number,
    limit: number,
    wanted: number,
    atOnce: number,
    take: (limit: number, length: number, most: number) => void,
    keep: (done: number, count: number) => void,
  ): Taken {
    let [count, from, mostDigits, mostRounded] = [0, at, 0, 0]
    while (count < wanted && from < limit) {
      const most = Math.min(wanted - count, atOnce)
      const end = Math.min(bytes.length, from + Math.min(input.length, 2 * LONGEST_NUMBER + USUAL_NUMBER * most))
      put(bytes, from, end)
      const ownLimit = Math.min(limit, end === bytes.length ? end : end - LONGEST_NUMBER) - from
      take(ownLimit, end - from, most)
      const [own, used, digits, rounded] = taken as unknown as [number, number, number, number]
      if (own === 0) break
      keep(count, own)
      count += own
      from += used
      if (digits > mostDigits) mostDigits = digits
      if (rounded > mostRounded) mostRounded = rounded
    }
    return { count, bytes: from - at, mostDigits, mostRounded }
  }

  function numbers(bytes: Uint8Array, at: number, limit: number, list: Float64Array, from: number, to: number): Taken {
    return run(bytes, at, limit, to - from, doubles.length, wasm.numbers, (done, count) =>
      list.set(doubles.subarray(0, count), from + done),
    )
  }

  function indices(
    bytes: Uint8Array,
    at: number,
    limit: number,
    list: Uint32Array | Uint8Array,
    from: number,
    to: number,
  ): Taken {
    const largest = list instanceof Uint8Array ? 0xff : 0xffffffff
    return run(
      bytes,
      at,
      limit,
      to - from,
      wholes.length,
      (ownLimit, length, most) => wasm.indices(ownLimit, length, most, largest),
      (done, count) => list.set(wholes.subarray(0, count), from + done),
    )
  }

  function rows(bytes: Uint8Array, at: number, end: number, pattern: RowPattern): TakenRows {
    const { numberCount, realCount } = pattern
    const last = Math.min(end, at + input.length)
    put(bytes, at, last)
    parts.set(pattern.bytes)
    const most = Math.min(
      Math.floor(doubles.length / Math.max(1, numberCount)),
      Math.floor(places.length / Math.max(1, realCount)),
    )
    wasm.rows(last - at, pattern.bytes.length, most)
    const [count, used, mostDigits, mostRounded] = taken as unknown as [number, number, number, number]
    rowNumbers.set(doubles.subarray(0, count * numberCount))
    rowPlaces.set(places.subarray(0, count * realCount))
    return { count, bytes: used, mostDigits, mostRounded, numbers: rowNumbers, places: rowPlaces }
  }

  function lowHalves(bytes: Uint8Array, list = new Uint32Array(bytes.length / 8)): LowHalves {
    const parts = new Int32Array(KNOWN_OF_PART * Math.ceil(list.length / PART))
    const most = input.length / 8
    let high = 0
    for (let from = 0; from < list.length; from += most) {
      const count = Math.min(most, list.length - from)
      put(bytes, 8 * from, 8 * (from + count))
      wasm.halves(count)
      list.set(wholes.subarray(0, count), from)
      for (let part = 0; part * PART < count; ++part) {
        high |= halves[4 * part] as number
        parts.set(halves.subarray(4 * part + 1, 4 * part + 4), KNOWN_OF_PART * (from / PART + part))
      }
    }
    return { list, high, parts }
  }

  function unzlib(packed: Uint8Array, unpacked: Uint8Array): boolean {
    if (packed.length > input.length || unpacked.length > output.length) return false
    put(packed, 0, packed.length)
    if (wasm.unzlib(packed.length, unpacked.length) === 0) return false
    unpacked.set(output.subarray(0, unpacked.length))
    return true
  }

  return { numbers, indices, rows, lowHalves, unzlib }
}
