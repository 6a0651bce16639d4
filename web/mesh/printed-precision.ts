/** What the digits that a text prints leave open. */

/** Fewer digits are a number that somebody typed, not one that was rounded. */
const FEWEST_ROUNDED = 5
const ENOUGH = 17

/** A sentence for coordinates that are printed with at most `digits` significant digits; null where that loses nothing. */
export function precisionNote(digits: number, points: Float64Array): string | null {
  if (digits < FEWEST_ROUNDED || digits >= ENOUGH) return null
  let largest = 0
  for (const value of points) if (Math.abs(value) > largest && Number.isFinite(value)) largest = Math.abs(value)
  if (largest === 0) return null
  const half = 0.5 * 10 ** (Math.floor(Math.log10(largest)) - digits + 1)
  return `Coordinates are printed with ${digits} digits, which may move the largest by ${half.toPrecision(1)}.`
}
