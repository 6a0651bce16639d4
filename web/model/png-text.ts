/** Text inside a PNG, as a tEXt chunk before the image data: PNG specification, sections 5.3 and 11.3.3. */

/** The keyword of a picture's permalink fragment. */
export const PNG_KEYWORD = 'hexlens'

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]
/** Length, type and CRC of a chunk; its data lie between type and CRC. */
const FRAME = 12
const HEADER_END = SIGNATURE.length + FRAME + 13

export function isPng(bytes: Uint8Array): boolean {
  return bytes.length >= HEADER_END && SIGNATURE.every((byte, i) => bytes[i] === byte)
}

/** A copy of the PNG with the text in it; keyword and text are ASCII. Throws RangeError for what is no PNG. */
export function withText(png: Uint8Array, keyword: string, text: string): Uint8Array<ArrayBuffer> {
  if (!isPng(png)) throw new RangeError('These bytes are no PNG.')
  const data = asciiBytes(`tEXt${keyword}\0${text}`)
  const chunk = new Uint8Array(data.length + 8)
  const view = new DataView(chunk.buffer)
  view.setUint32(0, data.length - 4)
  chunk.set(data, 4)
  view.setUint32(chunk.length - 4, crc(data))
  const all = new Uint8Array(png.length + chunk.length)
  all.set(png.subarray(0, HEADER_END))
  all.set(chunk, HEADER_END)
  all.set(png.subarray(HEADER_END), HEADER_END + chunk.length)
  return all
}

/** The text of that keyword; null where there is none, or its check sum is wrong. */
export function textOf(png: Uint8Array, keyword: string): string | null {
  if (!isPng(png)) return null
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength)
  for (let at = SIGNATURE.length; at + FRAME <= png.length; ) {
    const length = view.getUint32(at)
    const end = at + 8 + length
    if (end + 4 > png.length) return null
    const [type, content] = [asciiText(png.subarray(at + 4, at + 8)), png.subarray(at + 8, end)]
    const text = type === 'tEXt' ? asciiText(content) : ''
    if (text.startsWith(`${keyword}\0`) && view.getUint32(end) === crc(png.subarray(at + 4, end))) {
      return text.slice(keyword.length + 1)
    }
    at = end + 4
  }
  return null
}

function asciiBytes(text: string): Uint8Array {
  return Uint8Array.from(text, character => character.charCodeAt(0))
}

function asciiText(bytes: Uint8Array): string {
  return Array.from(bytes, byte => String.fromCharCode(byte)).join('')
}

/** CRC-32 bit by bit: a chunk has some hundred bytes. */
function crc(bytes: Uint8Array): number {
  let remainder = 0xffff_ffff
  for (const byte of bytes) {
    remainder ^= byte
    for (let bit = 0; bit < 8; bit++) remainder = (remainder >>> 1) ^ (remainder & 1 ? 0xedb8_8320 : 0)
  }
  return ~remainder >>> 0
}
