/**
 * .xz files (the container of liblzma) with the one filter LZMA2, as VTK and meshio write them, into memory of the declared size. The
 * decoder follows the specification of LZMA: a binary range decoder with adaptive probabilities of eleven bits.
 */
import { crc32, crc64 } from './checksums'
import { DamagedStream } from './inflate'

const MAGIC = [0xfd, 0x37, 0x7a, 0x58, 0x5a, 0]
/** Bytes of a check by its number in the header. */
const CHECK_SIZES = [0, 4, 4, 4, 8, 8, 8, 16, 16, 16, 32, 32, 32, 64, 64, 64]
const [CRC32, CRC64] = [1, 4]
const LZMA2_FILTER = 0x21

/** Fills `output` from an .xz stream that must have just so many bytes. */
export function unxz(input: Uint8Array, output: Uint8Array): void {
  if (input.length < 32) throw new DamagedStream('ends early')
  if (MAGIC.some((byte, i) => input[i] !== byte)) throw new DamagedStream('is no .xz stream')
  const check = (input[7] as number) & 15
  checkCrc32(input, 6, 8)
  let at = 12
  let length = 0
  // An index begins with a zero where a block has the size of its header.
  while (at < input.length && input[at] !== 0) {
    const headerSize = 4 * ((input[at] as number) + 1)
    if (at + headerSize > input.length) throw new DamagedStream('ends early')
    checkCrc32(input, at, at + headerSize - 4)
    checkFilter(input, at)
    const lzma = new Lzma2(input, at + headerSize, output, length)
    lzma.decode()
    // Blocks are padded to four bytes; a block begins at a multiple of four.
    const end = (lzma.at + 3) & ~3
    const checkSize = CHECK_SIZES[check] as number
    if (end + checkSize > input.length) throw new DamagedStream('ends early')
    verify(check, input, end, output.subarray(length, lzma.length))
    length = lzma.length
    at = end + checkSize
  }
  if (at >= input.length) throw new DamagedStream('ends early')
  if (length < output.length) throw new DamagedStream(`holds ${length} of the ${output.length} bytes that are declared`)
}

function checkCrc32(input: Uint8Array, from: number, to: number): void {
  if (uint32At(input, to) !== crc32(input, from, to))
    throw new DamagedStream('has a header that does not match its checksum')
}

function uint32At(input: Uint8Array, at: number): number {
  return new DataView(input.buffer, input.byteOffset).getUint32(at, true)
}

function checkFilter(input: Uint8Array, from: number): void {
  const flags = input[from + 1] as number
  let at = from + 2
  const passSize = () => {
    while ((input[at++] as number) >= 128);
  }
  if (flags & 64) passSize()
  if (flags & 128) passSize()
  if ((flags & 3) !== 0 || input[at] !== LZMA2_FILTER || input[at + 1] !== 1)
    throw new DamagedStream('has a filter other than LZMA2')
}

function verify(check: number, input: Uint8Array, at: number, decoded: Uint8Array): void {
  let matches = true
  if (check === CRC32) matches = uint32At(input, at) === crc32(decoded)
  else if (check === CRC64) {
    const [low, high] = crc64(decoded)
    matches = uint32At(input, at) === low && uint32At(input, at + 4) === high
  }
  if (!matches) throw new DamagedStream('does not match its checksum')
}

const HALF = 1024
const LENGTH_CODER = 2 + 16 * 8 + 16 * 8 + 256

/** Indices at which the probabilities of each kind begin in one array. */
const IS_MATCH = 0
const IS_REP = IS_MATCH + 12 * 16
const IS_REP_0 = IS_REP + 12
const IS_REP_1 = IS_REP_0 + 12
const IS_REP_2 = IS_REP_1 + 12
const IS_REP_0_LONG = IS_REP_2 + 12
const SLOTS = IS_REP_0_LONG + 12 * 16
const SPECIAL = SLOTS + 4 * 64
const ALIGN = SPECIAL + 128
const MATCH_LENGTH = ALIGN + 16
const REP_LENGTH = MATCH_LENGTH + LENGTH_CODER
const LITERALS = REP_LENGTH + LENGTH_CODER

class Lzma2 {
  readonly #input: Uint8Array
  readonly #output: Uint8Array
  at: number
  length: number
  /** The dictionary's beginning in the output: repeats reach back no further. */
  #dictionaryFrom: number
  #inputEnd = 0
  #range = 0
  #code = 0
  #state = 0
  readonly #reps = [0, 0, 0, 0] as [number, number, number, number]
  #lc = 0
  #lp = 0
  #pb = 0
  #probabilities = new Uint16Array(0)

  constructor(input: Uint8Array, at: number, output: Uint8Array, length: number) {
    this.#input = input
    this.at = at
    this.#output = output
    this.length = length
    this.#dictionaryFrom = length
  }

  /** All chunks of a block, and the padding byte after them not. */
  decode(): void {
    for (let isFirst = true; ; isFirst = false) {
      const control = this.#byte()
      if (control === 0) return
      if (isFirst && control !== 1 && control < 0xe0) throw new DamagedStream('begins without a dictionary')
      if (control < 0x80) {
        if (control > 2) throw new DamagedStream('has a chunk of a kind that does not exist')
        if (control === 1) this.#dictionaryFrom = this.length
        this.#copy((this.#byte() << 8) + this.#byte() + 1)
        continue
      }
      const size = ((control & 31) << 16) + (this.#byte() << 8) + this.#byte() + 1
      const packed = (this.#byte() << 8) + this.#byte() + 1
      const reset = (control >> 5) & 3
      if (reset === 3) this.#dictionaryFrom = this.length
      if (reset >= 2) this.#setProperties(this.#byte())
      if (this.#probabilities.length === 0) throw new DamagedStream('has a chunk without properties')
      if (reset >= 1) this.#resetState()
      this.#chunk(size, packed)
    }
  }

  #byte(): number {
    if (this.at >= this.#input.length) throw new DamagedStream('ends early')
    return this.#input[this.at++] as number
  }

  #checkRoom(count: number): void {
    if (this.length + count > this.#output.length)
      throw new DamagedStream(`holds more than the ${this.#output.length} bytes that are declared`)
  }

  #copy(count: number): void {
    if (this.at + count > this.#input.length) throw new DamagedStream('ends early')
    this.#checkRoom(count)
    this.#output.set(this.#input.subarray(this.at, this.at + count), this.length)
    this.at += count
    this.length += count
  }

  #setProperties(properties: number): void {
    this.#lc = properties % 9
    this.#lp = Math.floor(properties / 9) % 5
    this.#pb = Math.floor(properties / 45)
    if (properties > 224 || this.#lc + this.#lp > 4) throw new DamagedStream('has properties that do not exist')
    this.#probabilities = new Uint16Array(LITERALS + (0x300 << (this.#lc + this.#lp)))
  }

  #resetState(): void {
    this.#state = 0
    this.#reps.fill(0)
    this.#probabilities.fill(HALF)
  }

  #bit(index: number): number {
    const probabilities = this.#probabilities
    const probability = probabilities[index] as number
    const bound = (this.#range >>> 11) * probability
    let bit = 0
    if (this.#code < bound) {
      this.#range = bound
      probabilities[index] = probability + ((2048 - probability) >> 5)
    } else {
      this.#range -= bound
      this.#code -= bound
      probabilities[index] = probability - (probability >> 5)
      bit = 1
    }
    if (this.#range < 0x1000000) this.#normalize()
    return bit
  }

  #normalize(): void {
    this.#range = (this.#range << 8) >>> 0
    if (this.at >= this.#inputEnd) throw new DamagedStream('is damaged')
    this.#code = ((this.#code << 8) | (this.#input[this.at++] as number)) >>> 0
  }

  /** `count` bits from a tree of probabilities, the highest first. */
  #tree(from: number, count: number): number {
    let node = 1
    for (let i = 0; i < count; ++i) node = (node << 1) | this.#bit(from + node)
    return node - (1 << count)
  }

  #reverseTree(from: number, count: number): number {
    let node = 1
    let value = 0
    for (let i = 0; i < count; ++i) {
      const bit = this.#bit(from + node)
      node = (node << 1) | bit
      value |= bit << i
    }
    return value
  }

  #directBits(count: number): number {
    let value = 0
    for (let i = 0; i < count; ++i) {
      this.#range >>>= 1
      const bit = this.#code >= this.#range ? 1 : 0
      if (bit === 1) this.#code -= this.#range
      value = (value << 1) | bit
      if (this.#range < 0x1000000) this.#normalize()
    }
    return value >>> 0
  }

  #matchLength(coder: number, positionState: number): number {
    if (this.#bit(coder) === 0) return 2 + this.#tree(coder + 2 + 8 * positionState, 3)
    if (this.#bit(coder + 1) === 0) return 10 + this.#tree(coder + 2 + 128 + 8 * positionState, 3)
    return 18 + this.#tree(coder + 2 + 256, 8)
  }

  #literal(): void {
    const output = this.#output
    const position = this.length - this.#dictionaryFrom
    const before = position > 0 ? (output[this.length - 1] as number) : 0
    const from = LITERALS + 0x300 * (((position & ((1 << this.#lp) - 1)) << this.#lc) + (before >> (8 - this.#lc)))
    let symbol = 1
    if (this.#state >= 7) {
      let match = output[this.length - this.#reps[0] - 1] as number
      do {
        const matchBit = (match >> 7) & 1
        match <<= 1
        const bit = this.#bit(from + ((1 + matchBit) << 8) + symbol)
        symbol = (symbol << 1) | bit
        if (bit !== matchBit) break
      } while (symbol < 256)
    }
    while (symbol < 256) symbol = (symbol << 1) | this.#bit(from + symbol)
    output[this.length++] = symbol & 255
    this.#state = this.#state < 4 ? 0 : this.#state < 10 ? this.#state - 3 : this.#state - 6
  }

  #distance(length: number): number {
    const slot = this.#tree(SLOTS + 64 * Math.min(length - 2, 3), 6)
    if (slot < 4) return slot
    const count = (slot >> 1) - 1
    const base = ((2 | (slot & 1)) << count) >>> 0
    if (slot < 14) return base + this.#reverseTree(SPECIAL + base - slot, count)
    return base + this.#directBits(count - 4) * 16 + this.#reverseTree(ALIGN, 4)
  }

  #chunk(size: number, packed: number): void {
    this.#checkRoom(size)
    this.#inputEnd = this.at + packed
    if (this.#inputEnd > this.#input.length) throw new DamagedStream('ends early')
    if (packed < 5) throw new DamagedStream('is damaged')
    this.at++
    this.#range = 0xffffffff
    this.#code = 0
    for (let i = 0; i < 4; ++i) this.#code = ((this.#code << 8) | this.#byte()) >>> 0
    const end = this.length + size
    const reps = this.#reps
    const positionMask = (1 << this.#pb) - 1
    while (this.length < end) {
      const positionState = (this.length - this.#dictionaryFrom) & positionMask
      const state = this.#state
      if (this.#bit(IS_MATCH + 16 * state + positionState) === 0) {
        this.#literal()
        continue
      }
      let count = 1
      if (this.#bit(IS_REP + state) === 0) {
        reps[3] = reps[2]
        reps[2] = reps[1]
        reps[1] = reps[0]
        count = this.#matchLength(MATCH_LENGTH, positionState)
        reps[0] = this.#distance(count)
        this.#state = state < 7 ? 7 : 10
      } else if (this.#isShortRep(state, positionState)) {
        this.#state = state < 7 ? 9 : 11
      } else {
        count = this.#matchLength(REP_LENGTH, positionState)
        this.#state = state < 7 ? 8 : 11
      }
      this.#repeat(count, end)
    }
    if (this.at !== this.#inputEnd) throw new DamagedStream('is damaged')
  }

  /** True if a byte at the last distance is repeated; else the distance comes to the front. */
  #isShortRep(state: number, positionState: number): boolean {
    const reps = this.#reps
    if (this.#bit(IS_REP_0 + state) === 0) return this.#bit(IS_REP_0_LONG + 16 * state + positionState) === 0
    let distance = reps[1]
    if (this.#bit(IS_REP_1 + state) === 1) {
      distance = reps[2]
      if (this.#bit(IS_REP_2 + state) === 1) {
        distance = reps[3]
        reps[3] = reps[2]
      }
      reps[2] = reps[1]
    }
    reps[1] = reps[0]
    reps[0] = distance
    return false
  }

  #repeat(count: number, end: number): void {
    const output = this.#output
    let from = this.length - this.#reps[0] - 1
    if (from < this.#dictionaryFrom || this.length + count > end) throw new DamagedStream('is damaged')
    for (const to = this.length + count; this.length < to; ) output[this.length++] = output[from++] as number
  }
}
