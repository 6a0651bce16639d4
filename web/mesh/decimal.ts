/**
 * Doubles from more decimal digits than one operation rounds rightly: the value is computed as a sum of two doubles, with a relative error
 * below 2^-100, and rounded where that error cannot change to which double. The sums are those of T. J. Dekker (1971).
 */

const [DOT, ZERO, NINE] = [46, 48, 57] as const

/** Powers of ten that are doubles exactly. */
export const POWERS_OF_TEN = Float64Array.from({ length: 23 }, (_, i) => Number(`1e${i}`))
const LARGEST_POWER = 22
/** Numbers of so many digits are below 2^53. */
const DIGITS_OF_HIGH = 15
const DIGITS_OF_LOW = 7
/** Beyond, the sums might leave the range in which doubles have 53 bits. */
const MOST_POWER = 88
/** Above the relative error of a few operations in sums of two doubles, 2^-106 each. */
const ERROR = 2 ** -96
const SPLITTER = 2 ** 27 + 1

/** The error of the rounded product `product` of a and b, exactly. */
function productError(a: number, b: number, product: number): number {
  const ta = SPLITTER * a
  const aHigh = ta - (ta - a)
  const aLow = a - aHigh
  const tb = SPLITTER * b
  const bHigh = tb - (tb - b)
  const bLow = b - bHigh
  return aLow * bLow - (product - aHigh * bHigh - aLow * bHigh - aHigh * bLow)
}

/**
 * The double nearest to the number that the digits (and a point among them) in bytes [from, to) make, taken as one integer, times
 * 10^power; NaN where it is not certain, or for more than 22 digits.
 */
export function doubleOfDigits(bytes: Uint8Array, from: number, to: number, power: number): number {
  let high = 0
  let low = 0
  let digits = 0
  for (let at = from; at < to; ++at) {
    const byte = bytes[at] as number
    if (byte === DOT) continue
    if (byte < ZERO || byte > NINE) break
    if (digits > 0 || byte !== ZERO) digits++
    if (digits <= DIGITS_OF_HIGH) high = 10 * high + (byte - ZERO)
    else low = 10 * low + (byte - ZERO)
  }
  const lowDigits = Math.max(0, digits - DIGITS_OF_HIGH)
  if (digits === 0 || lowDigits > DIGITS_OF_LOW || power > MOST_POWER || power < -MOST_POWER) return Number.NaN
  const shift = POWERS_OF_TEN[lowDigits] as number
  const shifted = high * shift
  // The number is value + rest.
  let value = shifted + low
  let rest = productError(high, shift, shifted) + (low - (value - shifted))
  for (let left = power; left < 0; left += LARGEST_POWER) {
    const divisor = POWERS_OF_TEN[Math.min(-left, LARGEST_POWER)] as number
    const quotient = value / divisor
    const back = quotient * divisor
    rest = (value - back - productError(quotient, divisor, back) + rest) / divisor
    value = quotient
  }
  for (let left = power; left > 0; left -= LARGEST_POWER) {
    const factor = POWERS_OF_TEN[Math.min(left, LARGEST_POWER)] as number
    const product = value * factor
    rest = productError(value, factor, product) + rest * factor
    value = product
  }
  const error = ERROR * value
  const upper = value + (rest + error)
  return upper === value + (rest - error) ? upper : Number.NaN
}
