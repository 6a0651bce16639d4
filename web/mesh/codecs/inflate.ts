/**
 * Deflate streams (RFC 1951) and their zlib wrapping (RFC 1950), into memory that the caller limits: nothing is written, and no work done,
 * beyond it. The codes of a block are looked up in a first table of ten bits, longer ones in tables behind it.
 */
import { adler32 } from './checksums'

/** Compressed bytes that end early, or that no compressor writes; the message is a clause without its subject: "ends early". */
export class DamagedStream extends Error {}

const ENDS_EARLY = 'ends early'

export interface Inflated {
  /** The caller's memory, or what `more` gave in its place. */
  readonly output: Uint8Array
  /** Bytes that are filled. */
  readonly length: number
  /** The byte of the input behind the stream. */
  readonly end: number
  /** False if there was no memory for the rest. */
  readonly isWhole: boolean
}

const FIRST_BITS = 10
const NO_CODE = (0xfff << 4) | 1
const FIRST_MASK = (1 << FIRST_BITS) - 1
const LENGTH_BASE = Uint16Array.of(
  ...[
    3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258,
  ],
)
const LENGTH_BITS = Uint8Array.of(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0)
const DISTANCE_BASE = Uint16Array.from({ length: 30 }, (_, i) =>
  i < 2 ? i + 1 : ((2 + (i & 1)) << ((i >> 1) - 1)) + 1,
)
const DISTANCE_BITS = Uint8Array.from({ length: 30 }, (_, i) => (i < 2 ? 0 : (i >> 1) - 1))
const CODE_LENGTH_ORDER = Uint8Array.of(16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15)

/**
 * A code's table: entry = symbol * 16 + bits, or for codes longer than ten bits -(index of a second table * 16 + its bits). What is no code
 * stands for a symbol beyond all.
 */
class Code {
  table = new Int32Array(1 << FIRST_BITS)
  readonly #counts = new Uint16Array(16)
  readonly #next = new Uint16Array(16)

  /** Sets the code by its lengths; throws unless it is complete, or has a single symbol. */
  set(lengths: Uint8Array, from: number, to: number): void {
    const counts = this.#counts.fill(0)
    let longest = 0
    for (let i = from; i < to; ++i) {
      const length = lengths[i] as number
      counts[length] = (counts[length] as number) + 1
      if (length > longest) longest = length
    }
    counts[0] = 0
    let left = 1
    let codes = 0
    for (let bits = 1; bits <= 15; ++bits) {
      left = 2 * left - (counts[bits] as number)
      if (left < 0) throw new DamagedStream('has a code that no compressor writes')
      this.#next[bits] = bits === 1 ? 0 : ((this.#next[bits - 1] as number) + (counts[bits - 1] as number)) << 1
      codes += counts[bits] as number
    }
    if (left > 0 && codes > 1) throw new DamagedStream('has a code that no compressor writes')
    this.#fill(lengths, from, to, longest)
  }

  #fill(lengths: Uint8Array, from: number, to: number, longest: number): void {
    const secondBits = Math.max(0, longest - FIRST_BITS)
    let used = 1 << FIRST_BITS
    let table = this.table.fill(NO_CODE)
    for (let symbol = 0; symbol < to - from; ++symbol) {
      const length = lengths[from + symbol] as number
      if (length === 0) continue
      const code = this.#next[length] as number
      this.#next[length] = code + 1
      let reversed = 0
      for (let bit = 0; bit < length; ++bit) reversed |= ((code >> bit) & 1) << (length - 1 - bit)
      const entry = (symbol << 4) | length
      if (length <= FIRST_BITS) {
        for (let i = reversed; i <= FIRST_MASK; i += 1 << length) table[i] = entry
        continue
      }
      const first = reversed & FIRST_MASK
      if (table[first] === NO_CODE) {
        if (table.length < used + (1 << secondBits)) {
          this.table = new Int32Array(2 * table.length + (1 << secondBits))
          this.table.set(table)
          table = this.table
        }
        table.fill(NO_CODE, used, used + (1 << secondBits))
        table[first] = -((used << 4) | secondBits)
        used += 1 << secondBits
      }
      const second = -(table[first] as number) >> 4
      for (let i = reversed >> FIRST_BITS; i < 1 << secondBits; i += 1 << (length - FIRST_BITS))
        table[second + i] = entry
    }
  }
}

const literals = new Code()
const distances = new Code()
const codeLengths = new Code()
const lengths = new Uint8Array(320)

/**
 * Inflates the stream that begins at byte `at` of `input` into `output`, from its byte `length` on; what lies before is not part of the
 * stream. Where the memory is full, `more` gives a longer one with the same beginning, or null.
 */
export function inflate(
  input: Uint8Array,
  at: number,
  output: Uint8Array,
  length = 0,
  more: (full: Uint8Array) => Uint8Array | null = () => null,
): Inflated {
  return new Inflater(input, at, output, length, more).inflate()
}

class Inflater {
  readonly #input: Uint8Array
  #at: number
  #output: Uint8Array
  #length: number
  readonly #historyFrom: number
  readonly #more: (full: Uint8Array) => Uint8Array | null
  /** The next bits of the input, and how many there are. */
  #held = 0
  #bits = 0

  constructor(
    input: Uint8Array,
    at: number,
    output: Uint8Array,
    length: number,
    more: (full: Uint8Array) => Uint8Array | null,
  ) {
    this.#input = input
    this.#at = at
    this.#output = output
    this.#length = length
    this.#historyFrom = length
    this.#more = more
  }

  inflate(): Inflated {
    for (let isLast = false; !isLast; ) {
      isLast = this.#take(1) === 1
      const kind = this.#take(2)
      if (kind === 3) throw new DamagedStream('has a block of a kind that does not exist')
      if (kind === 1) setFixedCodes()
      else if (kind === 2) this.#readCodes()
      if (!(kind === 0 ? this.#copyStored() : this.#block()))
        return { output: this.#output, length: this.#length, end: this.#at, isWhole: false }
      if (this.#end() > this.#input.length) throw new DamagedStream(ENDS_EARLY)
    }
    return { output: this.#output, length: this.#length, end: this.#end(), isWhole: true }
  }

  /** The byte behind all bits that have been used. */
  #end(): number {
    return this.#at - (this.#bits >> 3)
  }

  /** Beyond the end of the input come zeros, of which none may be used in the end. */
  #take(count: number): number {
    while (this.#bits < count) {
      if (this.#at > this.#input.length + 4) throw new DamagedStream(ENDS_EARLY)
      this.#held |= (this.#input[this.#at++] ?? 0) << this.#bits
      this.#bits += 8
    }
    const value = this.#held & ((1 << count) - 1)
    this.#held >>>= count
    this.#bits -= count
    return value
  }

  #symbol(table: Int32Array): number {
    const ahead = this.#take(15)
    let entry = table[ahead & FIRST_MASK] as number
    if (entry < 0) entry = table[(-entry >> 4) + ((ahead >>> FIRST_BITS) & ((1 << (-entry & 15)) - 1))] as number
    if (entry === NO_CODE) throw new DamagedStream('has a code that stands for nothing')
    // Bits that the symbol did not need go back: 15 bits were taken, so there is room.
    this.#held = (this.#held << (15 - (entry & 15))) | (ahead >>> (entry & 15))
    this.#bits += 15 - (entry & 15)
    return entry >> 4
  }

  #readCodes(): void {
    const literalCount = this.#take(5) + 257
    const count = literalCount + this.#take(5) + 1
    const codeCount = this.#take(4) + 4
    lengths.fill(0, 0, 19)
    for (let i = 0; i < codeCount; ++i) lengths[CODE_LENGTH_ORDER[i] as number] = this.#take(3)
    codeLengths.set(lengths, 0, 19)
    for (let i = 0; i < count; ) {
      const symbol = this.#symbol(codeLengths.table)
      if (symbol < 16) {
        lengths[i++] = symbol
        continue
      }
      if (symbol === 16 && i === 0) throw new DamagedStream('repeats a length before the first')
      const repeated = symbol === 16 ? (lengths[i - 1] as number) : 0
      const times = symbol === 16 ? 3 + this.#take(2) : symbol === 17 ? 3 + this.#take(3) : 11 + this.#take(7)
      if (i + times > count) throw new DamagedStream('has more lengths of codes than codes')
      lengths.fill(repeated, i, i + times)
      i += times
    }
    if (literalCount > 286 || lengths[256] === 0) throw new DamagedStream('has a code that no compressor writes')
    literals.set(lengths, 0, literalCount)
    distances.set(lengths, literalCount, count)
  }

  /** True if there was room. */
  #hasRoom(count: number): boolean {
    while (this.#length + count > this.#output.length) {
      const longer = this.#more(this.#output)
      if (longer === null || longer.length <= this.#output.length) return false
      this.#output = longer
    }
    return true
  }

  #copyStored(): boolean {
    const input = this.#input
    const at = this.#end() + 4
    this.#held = 0
    this.#bits = 0
    if (at > input.length) throw new DamagedStream(ENDS_EARLY)
    const count = (input[at - 4] as number) | ((input[at - 3] as number) << 8)
    if ((count ^ 0xffff) !== ((input[at - 2] as number) | ((input[at - 1] as number) << 8)))
      throw new DamagedStream('has a stored block whose length is damaged')
    this.#at = at + count
    if (this.#at > input.length) throw new DamagedStream(ENDS_EARLY)
    if (!this.#hasRoom(count)) return false
    this.#output.set(input.subarray(at, at + count), this.#length)
    this.#length += count
    return true
  }

  /** The symbols of a block; false if there was no room for them. All is in local variables, for speed. */
  #block(): boolean {
    const input = this.#input
    const literalTable = literals.table
    const distanceTable = distances.table
    const historyFrom = this.#historyFrom
    const lastAt = input.length + 8
    let output = this.#output
    let at = this.#at
    let length = this.#length
    let held = this.#held
    let bits = this.#bits
    try {
      for (;;) {
        // A symbol always moves on, so that a stream without an end is noticed here.
        if (at > lastAt) throw new DamagedStream(ENDS_EARLY)
        // A symbol takes up to 15 bits; up to 30 are held.
        if (bits < 15) {
          held |= ((input[at] as number) | ((input[at + 1] as number) << 8)) << bits
          at += 2
          bits += 16
        }
        let entry = literalTable[held & FIRST_MASK] as number
        if (entry < 0)
          entry = literalTable[(-entry >> 4) + ((held >>> FIRST_BITS) & ((1 << (-entry & 15)) - 1))] as number
        held >>>= entry & 15
        bits -= entry & 15
        const symbol = entry >> 4
        if (symbol < 256) {
          if (length >= output.length) {
            this.#length = length
            if (!this.#hasRoom(1)) return false
            output = this.#output
          }
          output[length++] = symbol
          continue
        }
        if (symbol === 256) return true
        if (symbol > 285) throw new DamagedStream('has a code that stands for nothing')
        if (bits < 15) {
          held |= ((input[at] as number) | ((input[at + 1] as number) << 8)) << bits
          at += 2
          bits += 16
        }
        let extra = LENGTH_BITS[symbol - 257] as number
        const count = (LENGTH_BASE[symbol - 257] as number) + (held & ((1 << extra) - 1))
        held >>>= extra
        bits -= extra
        if (bits < 15) {
          held |= ((input[at] as number) | ((input[at + 1] as number) << 8)) << bits
          at += 2
          bits += 16
        }
        entry = distanceTable[held & FIRST_MASK] as number
        if (entry < 0)
          entry = distanceTable[(-entry >> 4) + ((held >>> FIRST_BITS) & ((1 << (-entry & 15)) - 1))] as number
        if (entry >> 4 > 29) throw new DamagedStream('has a code that stands for nothing')
        held >>>= entry & 15
        bits -= entry & 15
        if (bits < 15) {
          held |= ((input[at] as number) | ((input[at + 1] as number) << 8)) << bits
          at += 2
          bits += 16
        }
        extra = DISTANCE_BITS[entry >> 4] as number
        let from = length - (DISTANCE_BASE[entry >> 4] as number) - (held & ((1 << extra) - 1))
        held >>>= extra
        bits -= extra
        if (from < historyFrom) throw new DamagedStream('repeats what is before its beginning')
        const to = length + count
        if (to > output.length) {
          this.#length = length
          if (!this.#hasRoom(count)) return false
          output = this.#output
        }
        while (length < to) output[length++] = output[from++] as number
      }
    } finally {
      this.#at = at
      this.#length = length
      this.#held = held
      this.#bits = bits
    }
  }
}

function setFixedCodes(): void {
  lengths.fill(8, 0, 144).fill(9, 144, 256).fill(7, 256, 280).fill(8, 280, 288).fill(5, 288, 320)
  literals.set(lengths, 0, 288)
  distances.set(lengths, 288, 320)
}

/** Fills `output` from a zlib stream that must have just so many bytes and its checksum. */
export function unzlib(input: Uint8Array, output: Uint8Array): void {
  const [method = 0, flags = 0] = input
  if (input.length < 6) throw new DamagedStream(ENDS_EARLY)
  if ((method & 15) !== 8 || ((method << 8) | flags) % 31 !== 0 || (flags & 32) !== 0)
    throw new DamagedStream('is no zlib stream')
  const { length, end, isWhole } = inflate(input, 2, output)
  if (!isWhole) throw new DamagedStream(`holds more than the ${output.length} bytes that are declared`)
  if (length < output.length) throw new DamagedStream(`holds ${length} of the ${output.length} bytes that are declared`)
  if (end + 4 > input.length) throw new DamagedStream(ENDS_EARLY)
  const stated = new DataView(input.buffer, input.byteOffset + end).getUint32(0)
  if (adler32(output) !== stated) throw new DamagedStream('does not match its checksum')
}
