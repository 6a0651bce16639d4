/** Checksums of compressed streams: Adler-32 (zlib), CRC-32 (gzip, xz) and CRC-64 (xz). */

const LARGEST_PRIME = 65_521
/** Bytes for which the second sum stays below 2^32. */
const ADLER_RUN = 5552

export function adler32(bytes: Uint8Array): number {
  let a = 1
  let b = 0
  for (let i = 0; i < bytes.length; ) {
    const to = Math.min(i + ADLER_RUN, bytes.length)
    // Four bytes at once: b grows by the four sums a has on the way.
    for (; i + 4 <= to; i += 4) {
      const x = bytes[i] as number
      const y = bytes[i + 1] as number
      const z = bytes[i + 2] as number
      const w = bytes[i + 3] as number
      b += 4 * a + 4 * x + 3 * y + 2 * z + w
      a += x + y + z + w
    }
    for (; i < to; ++i) {
      a += bytes[i] as number
      b += a
    }
    a %= LARGEST_PRIME
    b %= LARGEST_PRIME
  }
  return ((b << 16) | a) >>> 0
}

/** Table k takes a byte through k further bytes of zeros, so that four bytes are done at once. */
const CRC32_TABLES = Array.from({ length: 4 }, () => new Int32Array(256))
for (let i = 0; i < 256; ++i) {
  let crc = i
  for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1
  ;(CRC32_TABLES[0] as Int32Array)[i] = crc
}
for (let k = 1; k < 4; ++k) {
  const [first, before, table] = [CRC32_TABLES[0], CRC32_TABLES[k - 1], CRC32_TABLES[k]] as [
    Int32Array,
    Int32Array,
    Int32Array,
  ]
  for (let i = 0; i < 256; ++i)
    table[i] = ((before[i] as number) >>> 8) ^ (first[(before[i] as number) & 255] as number)
}

/** The CRC-32 of bytes [from, to). */
export function crc32(bytes: Uint8Array, from = 0, to = bytes.length): number {
  const [t0, t1, t2, t3] = CRC32_TABLES as [Int32Array, Int32Array, Int32Array, Int32Array]
  let crc = -1
  let i = from
  for (; i + 4 <= to; i += 4) {
    crc ^=
      (bytes[i] as number) |
      ((bytes[i + 1] as number) << 8) |
      ((bytes[i + 2] as number) << 16) |
      ((bytes[i + 3] as number) << 24)
    crc =
      (t3[crc & 255] as number) ^
      (t2[(crc >>> 8) & 255] as number) ^
      (t1[(crc >>> 16) & 255] as number) ^
      (t0[crc >>> 24] as number)
  }
  for (; i < to; ++i) crc = (crc >>> 8) ^ (t0[(crc ^ (bytes[i] as number)) & 255] as number)
  return ~crc >>> 0
}

const CRC64_POLYNOMIAL = 0xc96c5795d7870f42n
let crc64Tables: { low: Int32Array; high: Int32Array } | null = null

/** The CRC-64 of all bytes: its low and its high half. */
export function crc64(bytes: Uint8Array): readonly [low: number, high: number] {
  if (crc64Tables === null) {
    crc64Tables = { low: new Int32Array(256), high: new Int32Array(256) }
    for (let i = 0; i < 256; ++i) {
      let crc = BigInt(i)
      for (let bit = 0; bit < 8; ++bit) crc = crc & 1n ? (crc >> 1n) ^ CRC64_POLYNOMIAL : crc >> 1n
      crc64Tables.low[i] = Number(crc & 0xffffffffn)
      crc64Tables.high[i] = Number(crc >> 32n)
    }
  }
  const tables = crc64Tables
  let low = -1
  let high = -1
  for (let i = 0; i < bytes.length; ++i) {
    const at = (low ^ (bytes[i] as number)) & 255
    low = ((low >>> 8) | (high << 24)) ^ (tables.low[at] as number)
    high = (high >>> 8) ^ (tables.high[at] as number)
  }
  return [~low >>> 0, ~high >>> 0]
}
