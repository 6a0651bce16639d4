/** Notes about coordinates that are stored as Float32 or with few printed digits. */

/** So many digits tell a double from all others. */
const MOST_DIGITS = 17
/** Decimals of one or two digits are steps that somebody typed; with three, thirds are already rounded ones. */
const FEWEST_DIGITS = 3

/** Digits of printed coordinates; `isRounded` if one is no double: printing has rounded it. */
export class PrintedDigits {
  digits = 0
  isRounded = false
  /** The size of the largest coordinate that was seen. */
  largest = 0

  /** A coordinate with the number of significant digits it is written with; those that are doubles do not count. */
  see(value: number, digits: number): void {
    const size = Math.abs(value)
    if (size > this.largest && size < Infinity) this.largest = size
    if (digits <= this.digits || isExact(size, digits)) return
    this.digits = digits
    this.isRounded = true
  }

  /** `see` for many coordinates: the most digits of one that is no double, the largest size. */
  seeRounded(mostRounded: number, largest: number): void {
    if (largest > this.largest) this.largest = largest
    if (mostRounded <= this.digits) return
    this.digits = mostRounded
    this.isRounded = true
  }

  /** All coordinates of rows, whose numbers were read as doubles with the most digits of all of them. */
  seeAll({ mostDigits, mostRounded }: { readonly mostDigits: number; readonly mostRounded: number }): void {
    if (mostDigits > this.digits) this.digits = mostDigits
    if (mostRounded > 0) this.isRounded = true
  }

  /** Half a unit of the last place of the largest coordinate; 0 if the text has every digit of its doubles. */
  movement(): number {
    return Number(this.#movement() ?? 0)
  }

  /** Null where printing has moved nothing. */
  note(): string | null {
    const movement = this.#movement()
    if (movement === null) return null
    return `Coordinates are printed with at most ${this.digits} digits: that can move one by up to ${movement}.`
  }

  #movement(): string | null {
    const { digits, isRounded, largest } = this
    if (!isRounded || digits < FEWEST_DIGITS || digits >= MOST_DIGITS || !(largest > 0 && largest < Infinity))
      return null
    return `5e${Math.floor(Math.log10(largest)) - digits}`
  }
}

/** The digits of coordinates that are all there, where the most digits alone are known. */
export function printedDigits(digits: number, points: Float64Array): PrintedDigits {
  const printed = new PrintedDigits()
  printed.largest = largestOf(points)
  printed.digits = digits
  printed.isRounded = digits >= FEWEST_DIGITS && points.some(value => !isExact(Math.abs(value), digits))
  return printed
}

/**
 * True if a decimal number of so many digits is a double, so that nothing was lost when it was
 * printed: with n digits behind the point it is one only if 2^n times it is an integer.
 */
function isExact(size: number, digits: number): boolean {
  if (size === 0 || !Number.isFinite(size)) return true
  return digits < MOST_DIGITS && Number.isInteger(size * 2 ** Math.max(0, digits - 1 - Math.floor(Math.log10(size))))
}

/** Half a unit in the last place of the largest number, which has 24 bits; null where all are 0. */
export function float32Note(largest: number, what = 'Coordinates'): string | null {
  if (!(largest > 0)) return null
  const half = 2 ** (Math.floor(Math.log2(largest)) - 24)
  return `${what} are stored as Float32: that can move one by up to ${half.toPrecision(2)}.`
}

/** The size of the largest coordinate that is finite. */
export function largestOf(points: Float64Array): number {
  let largest = 0
  for (let i = 0; i < points.length; ++i) {
    const size = Math.abs(points[i] as number)
    if (size > largest && size < Infinity) largest = size
  }
  return largest
}
