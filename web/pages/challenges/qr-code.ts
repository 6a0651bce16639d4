/** A text as a QR code (ISO/IEC 18004) for paper. What makes its matrix comes when a code is asked for. */

/** What the largest QR code holds at the lowest level of error correction. */
export const MOST_BYTES = 2953
/** The same at the next level, which stands 15 % of damage instead of 7 %. */
const MOST_BYTES_MEDIUM = 2331
/** Modules of white that the standard wants on each side. */
const QUIET_ZONE = 4

export interface QrCode {
  /** Modules of a side, the quiet zone included: the side of the picture in the units of `path`. */
  readonly side: number
  /** The dark modules as the path of an SVG. */
  readonly path: string
}

/** Null if the text is too long for one. */
export async function qrCode(text: string): Promise<QrCode | null> {
  const { length } = new TextEncoder().encode(text)
  if (length > MOST_BYTES) return null
  const { encode } = await import('uqr')
  const { data } = encode(text, {
    ecc: length > MOST_BYTES_MEDIUM ? 'L' : 'M',
    boostEcc: true, // where the same size has room for more
    border: QUIET_ZONE,
  })
  return { side: data.length, path: data.map(runs).join('') }
}

/** The dark modules of a row, each run of them one rectangle. */
function runs(row: readonly boolean[], y: number): string {
  let path = ''
  for (let x = 0; x < row.length; x++) {
    if (!row[x]) continue
    const from = x
    while (row[x + 1]) x++
    path += `M${from} ${y}h${x + 1 - from}v1h${from - x - 1}z`
  }
  return path
}
