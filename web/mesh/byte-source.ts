/** Bytes of a file one after the other, read in chunks: as they are, or as what stands there in base64. */
import { DamagedStream } from './codecs/inflate'
import { FileChunk } from './file-chunk'
import type { MeshFile } from './source'

/** Bytes that are read at once at the most, unless more are asked for; a multiple of the sizes of all numbers. */
export const CHUNK = 256 * 1024

export interface ByteSource {
  /** The byte of the file that is next. */
  readonly position: number
  /** The most bytes that may be left. */
  readonly left: number
  /** The next bytes; a view that holds until the next call. */
  take(count: number): Uint8Array
}

export class RawBytes implements ByteSource {
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

/** Decodes four digits at a time from `at` on, up to blanks, padding, or an end; returns the bytes that came out of it. */
function decodeDigits(text: Uint8Array, at: number, output: Uint8Array, from: number): number {
  let filled = from
  for (let i = at; i + 4 <= text.length && filled + 3 <= output.length; i += 4) {
    const a = BASE64[text[i] as number] as number
    const b = BASE64[text[i + 1] as number] as number
    const c = BASE64[text[i + 2] as number] as number
    const d = BASE64[text[i + 3] as number] as number
    if ((a | b | c | d) > 63) break
    output[filled] = (a << 2) | (b >> 4)
    output[filled + 1] = (b << 4) | (c >> 2)
    output[filled + 2] = (c << 6) | d
    filled += 3
  }
  return filled - from
}

/** The first `count` bytes of a text that is base64 from beginning to end. Throws a DamagedStream. */
export function decodedBase64(text: Uint8Array, count: number): Uint8Array<ArrayBuffer> {
  const output = new Uint8Array(count)
  const done = decodeDigits(text, 0, output, 0)
  const at = (4 * done) / 3
  if (done === count && at === text.length) return output
  const rest = new Base64Bytes(
    { name: '', size: text.length, read: (from, to) => text.subarray(from, to) },
    at,
    text.length,
  )
  output.set(rest.take(count - done), done)
  if (rest.position < text.length) throw new DamagedStream('is no base64')
  return output
}

/** Four digits of base64 are three bytes; one or two with padding, which may stand between streams. */
export class Base64Bytes implements ByteSource {
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
    const done = decodeDigits(this.#text, this.#at, output, from)
    this.#at += (4 * done) / 3
    return from + done
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
