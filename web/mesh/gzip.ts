/**
 * Gzipped files (RFC 1952), of one member or of several, whatever is in them: inflated whole, into memory that what is there allows. The
 * first bytes can be had alone, so that nothing is inflated that no format wants.
 */
import { crc32 } from './codecs/checksums'
import { DamagedStream, inflate } from './codecs/inflate'
import { MeshRefusal } from './mesh'
import type { MeshFile } from './source'

const [HAS_CRC, HAS_EXTRA, HAS_NAME, HAS_COMMENT] = [2, 4, 8, 16] as const
/** Meshes are seldom packed to less than a thirtieth; zeros are packed to a thousandth. */
const ALWAYS_ALLOWED = 64 * 1024 * 1024
const ALLOWED_FACTOR = 32
/** Deflate makes no more than this of a byte. */
const MOST_GROWTH = 1032

export function isGzip(head: Uint8Array): boolean {
  return head[0] === 0x1f && head[1] === 0x8b && head[2] === 8
}

/** The first bytes of what is in the file, `count` if there are so many. */
export function gunzippedHead(file: MeshFile, count: number): Uint8Array {
  const packed = file.read(0, Math.min(file.size, 4 * count))
  const output = new Uint8Array(count)
  try {
    const { length } = inflate(packed, memberStart(packed, 0), output)
    return output.subarray(0, length)
  } catch (error) {
    // The head may be cut in the middle of a stream that goes on in the file; what is wrong with it is said when it is read whole.
    if (error instanceof DamagedStream) return output
    throw error
  }
}

/** The contents, named without ".gz". Refuses what is damaged, ends early or unpacks too large. */
export function gunzipped(file: MeshFile): MeshFile {
  const bytes = inflatedMembers(file)
  const name = file.name.replace(/\.gz$/i, '')
  return { name, size: bytes.length, read: (from, to) => bytes.slice(from, to) }
}

function inflatedMembers(file: MeshFile): Uint8Array {
  const packed = file.read(0, file.size)
  const most = ALWAYS_ALLOWED + ALLOWED_FACTOR * file.size
  // The last four bytes say how much the last member has, which is usually the only one.
  const stated = file.size >= 18 ? new DataView(packed.buffer, packed.byteOffset).getUint32(file.size - 4, true) : 0
  let output: Uint8Array = new Uint8Array(Math.min(Math.max(stated, 1024), most, MOST_GROWTH * file.size))
  let length = 0
  let isTooLarge = false
  const more = (full: Uint8Array): Uint8Array | null => {
    isTooLarge = full.length >= most
    if (isTooLarge) return null
    const longer = new Uint8Array(Math.min(most, 2 * full.length))
    longer.set(full)
    return longer
  }
  let at = 0
  try {
    while (at < packed.length && !(at > 0 && isZeros(packed, at))) {
      const from = length
      const inflated = inflate(packed, memberStart(packed, at), output, length, more)
      if (isTooLarge)
        throw new MeshRefusal(`${file.name}: its ${file.size} bytes unpack to more than ${most}, which no mesh does.`)
      output = inflated.output
      length = inflated.length
      at = inflated.end
      if (at + 8 > packed.length) throw new DamagedStream('ends early')
      const trailer = new DataView(packed.buffer, packed.byteOffset + at, 8)
      if (trailer.getUint32(0, true) !== crc32(output, from, length))
        throw new DamagedStream('does not match its checksum')
      if (trailer.getUint32(4, true) !== (length - from) % 2 ** 32) throw new DamagedStream('does not match its length')
      at += 8
    }
  } catch (error) {
    if (!(error instanceof DamagedStream)) throw error
    const isCut = error.message === 'ends early'
    throw new MeshRefusal(
      isCut
        ? `${file.name}, byte ${file.size}: the gzip file is cut off: its stream goes on behind the end of the file.`
        : `${file.name}, byte ${at}: the gzip stream from here on ${error.message}.`,
    )
  }
  return output.subarray(0, length)
}

function isZeros(bytes: Uint8Array, from: number): boolean {
  for (let i = from; i < bytes.length; ++i) if (bytes[i] !== 0) return false
  return true
}

/** The beginning of the deflated bytes of the member at byte `at`. */
function memberStart(bytes: Uint8Array, at: number): number {
  if (at + 10 > bytes.length) throw new DamagedStream('ends early')
  if (!isGzip(bytes.subarray(at, at + 3))) throw new DamagedStream('is no gzip stream')
  const flags = bytes[at + 3] as number
  let start = at + 10
  if (flags & HAS_EXTRA) start += 2 + ((bytes[start] ?? 0) | ((bytes[start + 1] ?? 0) << 8))
  for (const flag of [HAS_NAME, HAS_COMMENT]) {
    if ((flags & flag) === 0) continue
    const end = bytes.indexOf(0, start)
    if (end < 0) throw new DamagedStream('ends early')
    start = end + 1
  }
  if (flags & HAS_CRC) start += 2
  if (start >= bytes.length) throw new DamagedStream('ends early')
  return start
}
