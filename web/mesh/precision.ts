/** What the way in which coordinates are stored can move: the notes about Float32 and about printed digits. */

const MOST_DIGITS = 17
/** Coordinates with fewer digits than this are round numbers, not doubles that were printed. */
const FEWEST_DIGITS = 5

export class PrintedDigits {
  #digits = 0
  #largest = 0

  /** A coordinate with the number of significant digits it is written with. */
  see(value: number, digits: number): void {
    const size = Math.abs(value)
    if (size > this.#largest && size < Infinity) this.#largest = size
    if (digits > this.#digits && !isExact(size, digits)) this.#digits = digits
  }

  /** Null where all of a double is printed, or where the numbers are round or doubles. */
  note(): string | null {
    if (this.#digits >= MOST_DIGITS || this.#digits < FEWEST_DIGITS || this.#largest === 0) return null
    const lastPlace = Math.floor(Math.log10(this.#largest)) - this.#digits + 1
    return `Coordinates are printed with at most ${this.#digits} digits: that can move one by up to 5e${lastPlace - 1}.`
  }
}

/**
 * Whether a decimal number of so many digits is a double, so that nothing was lost when it was printed: with n digits behind the point
 * it is one only if 2^n times it is an integer.
 */
function isExact(size: number, digits: number): boolean {
  if (size === 0 || !Number.isFinite(size)) return true
  return digits < MOST_DIGITS && Number.isInteger(size * 2 ** Math.max(0, digits - 1 - Math.floor(Math.log10(size))))
}

/** Half a unit in the last place of the largest coordinate, which has 24 bits. */
export function float32Note(largest: number): string {
  const half = largest > 0 ? 2 ** (Math.floor(Math.log2(largest)) - 24) : 0
  return `Coordinates are stored as Float32: that can move one by up to ${half.toPrecision(2)}.`
}
