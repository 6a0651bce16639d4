/** Parts of a file's compressed blocks, unpacked by whoever is free. */
import type { ReadingCore } from '../core/reading-interface'
import { decodedBase64 } from '../mesh/byte-source'
import type { PackedBlocks } from '../mesh/source'

/** Some blocks. */
export interface PackedPart {
  /** Bytes of the file. */
  readonly from: number
  readonly to: number
  readonly isBase64: boolean
  /** Bytes before the first block, and all that the text stands for. */
  readonly skipped: number
  readonly packedBytes: number
  readonly sizes: Float64Array
  readonly blockSize: number
  /** What it is unpacked. */
  readonly bytes: number
  readonly isLong: boolean
  /** Its first number in the list. */
  readonly first: number
}

export interface UnpackedPart {
  readonly list: Float64Array<ArrayBuffer> | Uint32Array<ArrayBuffer>
  /** As of LowHalves. */
  readonly high: number
}

/** Blocks of a part: as VTK writes them, 4 MB. */
const BLOCKS = 128

/** The parts of a list. */
export function packedParts({ from, isBase64, sizes, blockSize, bytes }: PackedBlocks, isLong: boolean): PackedPart[] {
  const parts: PackedPart[] = []
  let at = 0
  for (let block = 0; block < sizes.length; block += BLOCKS) {
    const own = sizes.slice(block, block + BLOCKS)
    const end = own.reduce((sum, size) => sum + size, at)
    const [first, last] = isBase64 ? [Math.floor(at / 3), Math.ceil(end / 3)] : [at, end]
    const isLast = block + BLOCKS >= sizes.length
    parts.push({
      from: from + (isBase64 ? 4 : 1) * first,
      to: from + (isBase64 ? 4 : 1) * last,
      isBase64,
      skipped: isBase64 ? at - 3 * first : 0,
      packedBytes: isBase64 ? (isLast ? end : 3 * last) - 3 * first : end - at,
      sizes: own,
      blockSize,
      bytes: Math.min(bytes - block * blockSize, BLOCKS * blockSize),
      isLong,
      first: (block * blockSize) / 8,
    })
    at = end
  }
  return parts
}

/** Null where the blocks are damaged: whoever reads the file says what is wrong. */
export function unpackedPart(text: ArrayBuffer, part: PackedPart, core: ReadingCore): UnpackedPart | null {
  const { isBase64, skipped, packedBytes, sizes, blockSize, bytes, isLong } = part
  const given = new Uint8Array(text)
  const packed = isBase64 ? decodedOrNull(given, packedBytes) : given
  if (packed === null) return null
  const unpacked = new Uint8Array(bytes)
  let at = skipped
  for (let i = 0; i < sizes.length; ++i) {
    const end = at + (sizes[i] as number)
    if (!core.unzlib(packed.subarray(at, end), unpacked.subarray(i * blockSize, (i + 1) * blockSize))) return null
    at = end
  }
  if (!isLong) return { list: new Float64Array(unpacked.buffer), high: 0 }
  const { list, high } = core.lowHalves(unpacked)
  return { list, high }
}

function decodedOrNull(text: Uint8Array, count: number): Uint8Array | null {
  try {
    return decodedBase64(text, count)
  } catch {
    return null
  }
}
